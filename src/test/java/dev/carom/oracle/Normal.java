// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * A unit normal to about 120 bits, each component by itself: also where it is tiny beside the
 * other.
 */
public record Normal(Dyadic x, Dyadic y) {
  private static final int BITS = 128;

  /** The unit vector along a given one. */
  static Normal along(Vector direction) {
    Dyadic length = direction.squared().sqrt(BITS);
    return new Normal(direction.x().over(length, BITS), direction.y().over(length, BITS));
  }

  /** {@code (offset + t velocity) / length}. */
  static Normal at(Moment t, Vector offset, Vector velocity, Dyadic length) {
    return new Normal(
        t.linearDigits(offset.x(), velocity.x()).over(length, BITS),
        t.linearDigits(offset.y(), velocity.y()).over(length, BITS));
  }

  /** The greater of the errors of two given components, NaN if one is. */
  public double error(double nx, double ny) {
    if (!Double.isFinite(nx) || !Double.isFinite(ny)) {
      return Double.NaN;
    }
    double errorX = Dyadic.of(nx).minus(x).abs().near();
    double errorY = Dyadic.of(ny).minus(y).abs().near();
    return Math.max(errorX, errorY);
  }
}
