// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * The exact distance of a centre from an obstacle, {@code sqrt(numerator / denominator)}, and a
 * radius to compare it with.
 */
public record Distance(Dyadic numerator, Dyadic denominator, Dyadic radius) {
  private static final int BITS = 160;

  /** From a point, with the sum of two radii. */
  public static Distance ofPoint(double x, double y, double cx, double cy, double r1, double r2) {
    Vector d = Vector.of(x, y).minus(Vector.of(cx, cy));
    return new Distance(d.squared(), Dyadic.ONE, Dyadic.of(r1).plus(Dyadic.of(r2)));
  }

  /** From a line, ends included. */
  public static Distance ofLine(
      double x, double y, double r, double ax, double ay, double bx, double by) {
    Vector p = Vector.of(x, y).minus(Vector.of(ax, ay));
    Vector w = Vector.of(bx, by).minus(Vector.of(ax, ay));
    Dyadic along = p.dot(w);
    if (along.signum() <= 0) {
      return new Distance(p.squared(), Dyadic.ONE, Dyadic.of(r));
    }
    if (along.compareTo(w.squared()) >= 0) {
      return new Distance(p.minus(w).squared(), Dyadic.ONE, Dyadic.of(r));
    }
    return new Distance(w.cross(p).square(), w.squared(), Dyadic.of(r));
  }

  /** Whether it is less than the radius, exactly. */
  public boolean isLess() {
    return numerator.compareTo(radius.square().times(denominator)) < 0;
  }

  /** By how much a translation is longer than the radius less the distance. */
  public double excess(double tx, double ty) {
    Dyadic length = Vector.of(tx, ty).squared().sqrt(BITS);
    Dyadic distance =
        numerator.signum() == 0
            ? Dyadic.ZERO
            : numerator.sqrt(BITS).over(denominator.sqrt(BITS), BITS);
    return length.plus(distance).minus(radius).near();
  }
}
