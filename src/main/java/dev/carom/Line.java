// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.util.Check;

/**
 * A {@code Line} is a segment of finite length and zero thickness, as in {@code
 * java.awt.geom.Line2D}. It is solid from both sides, unless a scene makes it {@linkplain
 * SceneBuilder#oneWay one-way}. A line of zero length is a point, its start.
 *
 * @param ax the x coordinate of the start, finite
 * @param ay the y coordinate of the start, finite
 * @param bx the x coordinate of the end, finite
 * @param by the y coordinate of the end, finite
 */
public record Line(double ax, double ay, double bx, double by) implements Obstacle {

  /**
   * Checks the components.
   *
   * @param ax the x coordinate of the start
   * @param ay the y coordinate of the start
   * @param bx the x coordinate of the end
   * @param by the y coordinate of the end
   * @throws IllegalArgumentException if a coordinate is NaN or infinite
   */
  public Line {
    Check.finite("ax", ax);
    Check.finite("ay", ay);
    Check.finite("bx", bx);
    Check.finite("by", by);
  }

  /**
   * Makes a line between two points.
   *
   * @param start the start
   * @param end the end
   */
  public Line(Vec2 start, Vec2 end) {
    this(Check.notNull("start", start).x(), start.y(), Check.notNull("end", end).x(), end.y());
  }

  /**
   * Returns the first end of this line.
   *
   * @return the point (ax, ay)
   */
  public Vec2 start() {
    return new Vec2(ax, ay);
  }

  /**
   * Returns the second end of this line.
   *
   * @return the point (bx, by)
   */
  public Vec2 end() {
    return new Vec2(bx, by);
  }

  /**
   * Returns the length of this line.
   *
   * @return {@code |b - a|}, 0 for a line that is a point; infinite if it exceeds the range of a
   *     double
   */
  public double length() {
    return StrictMath.hypot(bx - ax, by - ay);
  }

  /**
   * Returns the point of this segment that is nearest to a given point.
   *
   * <p>It is {@code a + s (b - a)} with {@code s = (p - a).(b - a) / |b - a|^2}, held within 0..1.
   * Computed in plain doubles.
   *
   * @param p any point
   * @return the nearest point; an end itself where s leaves 0..1; the start if this line has length
   *     zero
   */
  public Vec2 closestPoint(Vec2 p) {
    double s = Coordinates.fraction(ax, ay, bx, by, Check.notNull("p", p).x(), p.y());
    return new Vec2(Coordinates.onSegment(s, ax, bx), Coordinates.onSegment(s, ay, by));
  }

  /**
   * Returns the point of the infinite line through both ends that is nearest to a given point.
   *
   * <p>It is the foot of the perpendicular, {@code a + s (b - a)} with {@code s = (p - a).(b - a) /
   * |b - a|^2}. The published algorithm that the benchmark replays starts from this point. Computed
   * in plain doubles.
   *
   * @param p any point
   * @return the foot, also beyond the ends; the start if this line has length zero
   * @throws IllegalArgumentException if the foot is beyond the range of doubles
   */
  public Vec2 closestPointInfinite(Vec2 p) {
    double s = Coordinates.fraction(ax, ay, bx, by, Check.notNull("p", p).x(), p.y());
    if (Double.isNaN(s)) {
      return new Vec2(ax, ay);
    }
    return Double.isInfinite(s)
        ? footFarAway(p)
        : foot(p, Coordinates.between(s, ax, bx), Coordinates.between(s, ay, by));
  }

  /** The foot where it is more than so many lengths of this line away as a double can count. */
  private Vec2 footFarAway(Vec2 p) {
    // Scaled, as the line is tiny; halved, as p may be so far from it that the offset overflows.
    double wx = (bx - ax) * 0x1p600;
    double wy = (by - ay) * 0x1p600;
    double length = StrictMath.hypot(wx, wy);
    double half = (p.x() / 2 - ax / 2) * (wx / length) + (p.y() / 2 - ay / 2) * (wy / length);
    return foot(p, fma(half, 2 * (wx / length), ax), fma(half, 2 * (wy / length), ay));
  }

  private static Vec2 foot(Vec2 p, double x, double y) {
    if (!(Math.abs(x) <= Double.MAX_VALUE && Math.abs(y) <= Double.MAX_VALUE)) {
      throw Check.refused("p", p, "a point whose foot on the line is within the range of doubles");
    }
    return new Vec2(x, y);
  }
}
