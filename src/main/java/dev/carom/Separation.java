// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The least translation that moves a circle out of an obstacle: along the normal n at the nearest
 * point, by {@code r - distance} (the minimum translation of C. Ericson, Real-Time Collision
 * Detection, 2005, 5.5).
 *
 * <p>The moved centre is rounded to doubles, so a bit more may be needed. With s the sum of the
 * largest coordinate and the radii, the length, r less a distance, errs by 3 ulps of s at most, and
 * rounding two coordinates takes less than 1: the tries, by 0, 1, 2 and 4 ulps more, end there.
 */
final class Separation {

  private Separation() {}

  static Vec2 of(Circle circle, Circle other) {
    if (!overlaps(circle.x(), circle.y(), circle.radius(), other)) {
      return Vec2.ZERO;
    }
    double dx = circle.x() - other.x();
    double dy = circle.y() - other.y();
    Vec2 n =
        dx == 0 && dy == 0
            ? new Vec2(1, 0)
            : Directions.unit(circle.x(), circle.y(), other.x(), other.y());
    double distance = dx * n.x() + dy * n.y();
    double r = circle.radius() + other.radius();
    double size = Math.max(size(circle.x(), circle.y()), size(other.x(), other.y()));
    return out(circle, other, n, r - distance, size + r);
  }

  static Vec2 of(Circle circle, Line line) {
    if (!overlaps(circle.x(), circle.y(), circle.radius(), line)) {
      return Vec2.ZERO;
    }
    double x = circle.x();
    double y = circle.y();
    Endpoint nearest = end(x, y, line);
    double fromX = x - (nearest == null ? line.ax() : nearest.x());
    double fromY = y - (nearest == null ? line.ay() : nearest.y());
    Vec2 n = normal(x, y, nearest, line);
    double distance = fromX * n.x() + fromY * n.y();
    double size =
        Math.max(size(x, y), Math.max(size(line.ax(), line.ay()), size(line.bx(), line.by())));
    return out(circle, line, n, circle.radius() - distance, size + circle.radius());
  }

  /**
   * The unit vector from the nearest point of a line to the centre; if it is 0, the left normal.
   */
  private static Vec2 normal(double x, double y, Endpoint nearest, Line line) {
    if (nearest != null && (x != nearest.x() || y != nearest.y())) {
      return Directions.unit(x, y, nearest.x(), nearest.y());
    }
    if (line.ax() == line.bx() && line.ay() == line.by()) {
      return new Vec2(1, 0);
    }
    int side =
        Predicates.cross(line.bx(), line.by(), line.ax(), line.ay(), x, y, line.ax(), line.ay());
    return Directions.normal(side < 0 ? -1 : 1, line.ax(), line.ay(), line.bx(), line.by());
  }

  /** The end beyond which a point projects, null for a point beside the line. */
  private static Endpoint end(double x, double y, Line line) {
    double ax = line.ax();
    double ay = line.ay();
    double bx = line.bx();
    double by = line.by();
    if (Predicates.dot(x, y, ax, ay, bx, by, ax, ay) <= 0) {
      return line.start();
    }
    return Predicates.dot(x, y, bx, by, bx, by, ax, ay) >= 0 ? line.end() : null;
  }

  /** Whether the distance of a centre from an obstacle is less than the radius, exactly. */
  static boolean overlaps(double x, double y, double r, Obstacle obstacle) {
    if (obstacle instanceof Circle circle) {
      return DiskSweep.overlap(x, y, r, circle.x(), circle.y(), circle.radius());
    }
    Line line = (Line) obstacle;
    Endpoint nearest = end(x, y, line);
    if (nearest != null) {
      return DiskSweep.overlap(x, y, r, nearest.x(), nearest.y(), 0);
    }
    double ax = line.ax();
    double ay = line.ay();
    return Predicates.reach(line.bx(), line.by(), ax, ay, x, y, ax, ay, r, 0) > 0;
  }

  private static double size(double x, double y) {
    return Math.max(Math.abs(x), Math.abs(y));
  }

  /** A translation along n of at least the given length, by which the circle comes out. */
  private static Vec2 out(Circle circle, Obstacle obstacle, Vec2 n, double least, double size) {
    if (!(size <= 0x1p1023)) {
      throw Check.refused("coordinate and radius together", size, "at most 2^1023");
    }
    double more = 0;
    double tx = least * n.x();
    double ty = least * n.y();
    while (overlaps(circle.x() + tx, circle.y() + ty, circle.radius(), obstacle)) {
      more = more == 0 ? Math.ulp(size) : 2 * more;
      tx = (least + more) * n.x();
      ty = (least + more) * n.y();
    }
    return new Vec2(tx, ty);
  }
}
