// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * The real number {@code x + y sqrt(z)} of three exact numbers, z >= 0. Its sign is exact because
 * squaring keeps order among numbers of one sign: where x and y disagree, {@code |x|} and {@code
 * |y| sqrt(z)} compare as {@code x^2} and {@code y^2 z} do.
 */
public record Surd(Dyadic x, Dyadic y, Dyadic z) {

  /** An exact number as a surd without a root. */
  public static Surd of(Dyadic x) {
    return new Surd(x, Dyadic.ZERO, Dyadic.ZERO);
  }

  /** {@code alpha + beta this}. */
  public Surd linear(Dyadic alpha, Dyadic beta) {
    return new Surd(alpha.plus(beta.times(x)), beta.times(y), z);
  }

  /** The sign of this number: -1, 0 or 1. */
  public int sign() {
    int signX = x.signum();
    int signRoot = z.signum() == 0 ? 0 : y.signum();
    if (signX * signRoot >= 0) {
      return signX != 0 ? signX : signRoot;
    }
    return signX * compareSquares();
  }

  /**
   * Compares {@code x^2} with {@code y^2 z}, all of them not 0; by their leading bits if they do.
   */
  private int compareSquares() {
    // 2^(2k-2) <= x^2 < 2^(2k), and 2^(n-3) <= y^2 z < 2^n.
    int doubled = 2 * x.magnitude();
    int n = 2 * y.magnitude() + z.magnitude();
    if (doubled - 2 >= n) {
      return 1;
    }
    if (doubled <= n - 3) {
      return -1;
    }
    return x.square().compareTo(y.square().times(z));
  }

  /**
   * This number with a relative error below {@code 2^(6-bits)}, also where the sum cancels: then
   * {@code x + y sqrt(z) = (x^2 - y^2 z) / (x - y sqrt(z))}, whose numerator is exact and whose
   * denominator adds two numbers of one sign.
   */
  public Dyadic approximate(int bits) {
    Dyadic yyz = y.square().times(z);
    Dyadic root = y.signum() < 0 ? yyz.sqrt(bits).negate() : yyz.sqrt(bits);
    if (x.signum() * root.signum() >= 0) {
      return x.plus(root);
    }
    return x.square().minus(yyz).over(x.minus(root), bits);
  }
}
