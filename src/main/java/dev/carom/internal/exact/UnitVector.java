// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/** A unit vector in the plane. It can be set anew, so that many are computed without allocation. */
public final class UnitVector {

  /** Bits of a vector's length before a quotient by it is rounded. */
  private static final int BITS = 128;

  private double x;
  private double y;

  /** A vector that is yet to be set. */
  public UnitVector() {}

  public UnitVector(double x, double y) {
    set(x, y);
  }

  /** (x, y) / |(x, y)|, from exact numbers. */
  public static UnitVector of(Dyadic x, Dyadic y) {
    Dyadic length = x.square().plus(y.square()).sqrt(BITS);
    return new UnitVector(quotient(x, length), quotient(y, length));
  }

  private static double quotient(Dyadic a, Dyadic length) {
    return a.sign() == 0 ? 0 : a.sign() * a.abs().over(length, BITS).floor();
  }

  public UnitVector set(double newX, double newY) {
    x = newX;
    y = newY;
    return this;
  }

  public UnitVector set(UnitVector other) {
    return set(other.x, other.y);
  }

  public double x() {
    return x;
  }

  public double y() {
    return y;
  }
}
