// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.FallSweep;
import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.ParabolaWallSweep;
import dev.carom.internal.sweep.SegmentSweep;
import dev.carom.internal.sweep.WallSweep;
import dev.carom.internal.util.Check;
import java.util.Optional;

/**
 * {@code SweptCircle} is the detector: it tells when a moving circle first touches an obstacle or
 * another moving circle. Pure functions, without a world.
 *
 * <pre>{@code
 * // A circle of radius 5 at (-15, 4), 20 a second to the right; a line from (0, 0) to (0, 10).
 * System.out.println(SweptCircle.line(-15, 4, 5, 20, 0, 0, 0, 0, 10, 1)); // 0.5
 * Impact impact =
 *     SweptCircle.cast(new Circle(-15, 4, 5), new Vec2(20, 0), new Line(0, 0, 0, 10), 1).get();
 * System.out.println(impact.feature() + ", " + impact.normal()); // SIDE, Vec2[x=-1.0, y=0.0]
 * }</pre>
 *
 * <p>There are two forms of each question. One takes and returns doubles, {@code +infinity} for never.
 * It allocates nothing, unless a question is so close to a tie that only exact arithmetic decides it.
 * The other, {@code cast}, takes records and returns the {@link Impact}.
 *
 * <p><img src="doc-files/line.svg" alt="A circle that touches the side of a line, and one that
 * touches its end: the normal points from the line to the centre, which lies on a capsule around
 * the line" style="max-width:100%">
 *
 * <p>The <i>distance</i> is that of the circle's centre from the line, the wall or the other centre.
 * The <i>reach</i> is the radius; for a peg or another circle it is the sum of both radii. An impact is
 * the smallest t in the closed window [0, maxTime] at which the distance is at most the reach and
 * falls. If t = 0, it must fall just after that moment; else just before it. So:
 *
 * <ul>
 *   <li>apart and meeting within the window: an impact at the moment of first contact;
 *   <li>touching or overlapping at the start and moving inward: an impact at 0; positions are never
 *       corrected;
 *   <li>touching or overlapping at the start and moving apart, along, or not at all: none;
 *   <li>a graze, which comes as near as the reach with no speed along the normal: none;
 *   <li>the centre exactly on a line, on an endpoint or on a peg's centre at the start: none, since it
 *       cannot come nearer;
 *   <li>a point particle (radius 0) that reaches an obstacle later: an impact.
 * </ul>
 *
 * <p>Whether there is an impact, and which feature or wall is hit, is decided as if in real arithmetic
 * on the given doubles. A projection exactly on an end of a line is that end; a line of zero length is
 * its start. The time is the correctly rounded one. A time beyond the range of doubles exceeds every
 * finite maxTime; with {@code maxTime = +infinity} it is {@code +infinity}, which is a miss too.
 *
 * <p>Lengths share one unit, times another. Coordinates, velocities and accelerations are finite,
 * radii finite and at least 0. The end of the window, maxTime, is at least 0, {@code +infinity}
 * included. Anything else is an {@link IllegalArgumentException} that names it.
 *
 * <h2>Acceleration</h2>
 *
 * <p>The forms with an acceleration (gx, gy), such as gravity, follow the parabola {@code p + v t + g
 * t^2 / 2}. An acceleration of (0, 0) gives the bits of the other forms. With any other, an impact is
 * the first time in the window just after which the distance is at most the radius and falls. For two
 * points, and for a point and a line, it is the first time above 0 at which the distance falls to 0
 * with a speed above 0. Decisions are as exact as above, and times are rounded in the same way.
 *
 * <p>Two starts that are no impact above can then be one:
 *
 * <ul>
 *   <li>touching at the start without speed along the normal: an impact at 0 with approach speed 0 if
 *       the circle is accelerated inward, that is, supported; none if outward;
 *   <li>touching or overlapping at the start and leaving: if the acceleration turns the circle back
 *       while it still overlaps, an impact at the moment at which the distance is greatest, with
 *       approach speed 0; if it has left before, an impact when it touches again.
 * </ul>
 *
 * <p>Exact arithmetic decides ties. It also decides the impacts of a point with a line, an endpoint or
 * another point, and those of a circle that leaves a line that it overlaps at the start. It takes far
 * longer than doubles.
 *
 * <h2>Method</h2>
 *
 * <p>A circle against a segment is a point against a capsule, its Minkowski sum with a disk (C.
 * Ericson, Real-Time Collision Detection, 2005, 5.5). Decisions are signs of polynomials that climb
 * from doubles to exact numbers only in doubt (J. R. Shewchuk, Adaptive Precision
 * Floating-Point Arithmetic, Discrete and Computational Geometry 18, 1997). With an acceleration the
 * polynomials have degree 4. Their first root is isolated by the signs of Bernstein coefficients (G. E.
 * Collins and A. G. Akritas, Polynomial real root isolation using Descartes' rule of signs, SYMSAC
 * 1976). No root is written in closed form.
 */
public final class SweptCircle {

  private SweptCircle() {}

  /**
   * Returns the time at which a moving circle hits a line.
   *
   * @param px the x coordinate of the centre
   * @param py the y coordinate of the centre
   * @param r the radius
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @param ax the x coordinate of the line's start
   * @param ay the y coordinate of the line's start
   * @param bx the x coordinate of the line's end
   * @param by the y coordinate of the line's end
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double line(
      double px, double py, double r, double vx, double vy, double ax, double ay, double bx,
      double by, double maxTime) {
    if (!(0 * (px + py + r + vx + vy + ax + ay + bx + by) == 0 && r >= 0 && maxTime >= 0)) {
      check(px, py, r, vx, vy, maxTime);
      new Line(ax, ay, bx, by);
    }
    int contact = SegmentSweep.contact(px, py, r, vx, vy, ax, ay, bx, by, 0, 0);
    return SegmentSweep.time(contact, px, py, r, vx, vy, ax, ay, bx, by, 0, 0, maxTime);
  }

  /**
   * Returns the time at which a moving circle hits a line that moves, too. The line keeps its
   * direction. The answer depends on the difference of the two velocities, taken exactly.
   *
   * @param px the x coordinate of the centre
   * @param py the y coordinate of the centre
   * @param r the radius
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @param ax the x coordinate of the line's start, at time 0 like all coordinates
   * @param ay the y coordinate of the line's start
   * @param bx the x coordinate of the line's end
   * @param by the y coordinate of the line's end
   * @param ux the x component of the line's velocity
   * @param uy the y component of the line's velocity
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double movingLine(
      double px, double py, double r, double vx, double vy, double ax, double ay, double bx,
      double by, double ux, double uy, double maxTime) {
    if (!(0 * (px + py + r + vx + vy + ax + ay + bx + by + ux + uy) == 0
        && r >= 0
        && maxTime >= 0)) {
      check(px, py, r, vx, vy, maxTime);
      new Line(ax, ay, bx, by);
      Check.finite("ux", ux);
      Check.finite("uy", uy);
    }
    int contact = SegmentSweep.contact(px, py, r, vx, vy, ax, ay, bx, by, ux, uy);
    return SegmentSweep.time(contact, px, py, r, vx, vy, ax, ay, bx, by, ux, uy, maxTime);
  }

  /**
   * Returns the time at which a moving circle hits a peg, or a single endpoint: a peg of radius 0.
   *
   * @param px the x coordinate of the centre
   * @param py the y coordinate of the centre
   * @param r the radius
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @param cx the x coordinate of the peg's centre
   * @param cy the y coordinate of the peg's centre
   * @param R the radius of the peg
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double peg(
      double px, double py, double r, double vx, double vy, double cx, double cy, double R,
      double maxTime) {
    if (!(0 * (px + py + r + vx + vy + cx + cy + R) == 0 && r >= 0 && R >= 0 && maxTime >= 0)) {
      check(px, py, r, vx, vy, maxTime);
      checkPeg(cx, cy, R);
    }
    int contact = DiskSweep.contact(px, py, r, vx, vy, cx, cy, R, 0, 0);
    return DiskSweep.time(contact, px, py, r, vx, vy, cx, cy, R, 0, 0, maxTime);
  }

  /**
   * Returns the time at which a moving circle hits the first of the four walls around it.
   *
   * @param px the x coordinate of the centre
   * @param py the y coordinate of the centre
   * @param r the radius
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @param xmin the x coordinate of the left wall
   * @param ymin the y coordinate of the bottom wall
   * @param xmax the x coordinate of the right wall, greater than xmin
   * @param ymax the y coordinate of the top wall, greater than ymin
   * @param maxTime the end of the window
   * @return the time of the first impact with a wall, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double bounds(
      double px, double py, double r, double vx, double vy, double xmin, double ymin, double xmax,
      double ymax, double maxTime) {
    if (!(0 * (px + py + r + vx + vy + xmin + ymin + xmax + ymax) == 0
        && r >= 0
        && maxTime >= 0
        && xmax > xmin
        && ymax > ymin)) {
      check(px, py, r, vx, vy, maxTime);
      new Bounds(xmin, ymin, xmax, ymax);
    }
    double tx = WallSweep.time(px, r, vx, vx < 0 ? xmin : xmax, maxTime);
    double ty = WallSweep.time(py, r, vy, vy < 0 ? ymin : ymax, maxTime);
    return Math.min(tx, ty);
  }

  /**
   * Returns the time at which two moving circles hit each other.
   *
   * @param x1 the x coordinate of the first circle's centre
   * @param y1 the y coordinate of the first circle's centre
   * @param r1 the radius of the first circle
   * @param vx1 the x component of the first circle's velocity
   * @param vy1 the y component of the first circle's velocity
   * @param x2 the x coordinate of the second circle's centre
   * @param y2 the y coordinate of the second circle's centre
   * @param r2 the radius of the second circle
   * @param vx2 the x component of the second circle's velocity
   * @param vy2 the y component of the second circle's velocity
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double pair(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2, double maxTime) {
    // A number that is not finite makes this sum not finite, and the sweep computes it anyway.
    double b = (vx1 - vx2) * (x1 - x2) + (vy1 - vy2) * (y1 - y2);
    if (!(0 * (b + (r1 + r2)) == 0
        && r1 >= 0
        && r2 >= 0
        && maxTime >= 0)) {
      checkOfTwo("1", x1, y1, r1, vx1, vy1);
      checkOfTwo("2", x2, y2, r2, vx2, vy2);
      Check.duration("maxTime", maxTime);
    }
    int contact = DiskSweep.contact(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2);
    return DiskSweep.time(contact, x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, maxTime);
  }

  /**
   * Returns the time at which a circle with a constant acceleration hits a line. The rules are in the
   * description of this class, under Acceleration.
   *
   * @param px the x coordinate of the centre
   * @param py the y coordinate of the centre
   * @param r the radius
   * @param vx the x component of the velocity at the start
   * @param vy the y component of the velocity at the start
   * @param gx the x component of the constant acceleration
   * @param gy the y component of the constant acceleration
   * @param ax the x coordinate of the line's start
   * @param ay the y coordinate of the line's start
   * @param bx the x coordinate of the line's end
   * @param by the y coordinate of the line's end
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double line(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double maxTime) {
    if (!(0 * (px + py + r + vx + vy + gx + gy + ax + ay + bx + by) == 0
        && r >= 0
        && maxTime >= 0)) {
      check(px, py, r, vx, vy, gx, gy, maxTime);
      new Line(ax, ay, bx, by);
    }
    return FallSweep.time(
        Fall.ofThread().flight(px, py, r, vx, vy, gx, gy).line(ax, ay, bx, by, 0, 0), maxTime);
  }

  /**
   * Returns the time at which a circle with a constant acceleration hits a peg, or a single endpoint:
   * a peg of radius 0. The rules are in the description of this class, under Acceleration.
   *
   * @param px the x coordinate of the centre
   * @param py the y coordinate of the centre
   * @param r the radius
   * @param vx the x component of the velocity at the start
   * @param vy the y component of the velocity at the start
   * @param gx the x component of the constant acceleration
   * @param gy the y component of the constant acceleration
   * @param cx the x coordinate of the peg's centre
   * @param cy the y coordinate of the peg's centre
   * @param R the radius of the peg
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double peg(
      double px, double py, double r, double vx, double vy, double gx, double gy, double cx,
      double cy, double R, double maxTime) {
    if (!(0 * (px + py + r + vx + vy + gx + gy + cx + cy + R) == 0
        && r >= 0
        && R >= 0
        && maxTime >= 0)) {
      check(px, py, r, vx, vy, gx, gy, maxTime);
      checkPeg(cx, cy, R);
    }
    return FallSweep.time(
        Fall.ofThread().flight(px, py, r, vx, vy, gx, gy).disk(cx, cy, R, 0, 0), maxTime);
  }

  /**
   * Returns the time at which a circle with a constant acceleration hits the first of the four walls
   * around it. The rules are in the description of this class, under Acceleration.
   *
   * @param px the x coordinate of the centre
   * @param py the y coordinate of the centre
   * @param r the radius
   * @param vx the x component of the velocity at the start
   * @param vy the y component of the velocity at the start
   * @param gx the x component of the constant acceleration
   * @param gy the y component of the constant acceleration
   * @param xmin the x coordinate of the left wall
   * @param ymin the y coordinate of the bottom wall
   * @param xmax the x coordinate of the right wall, greater than xmin
   * @param ymax the y coordinate of the top wall, greater than ymin
   * @param maxTime the end of the window
   * @return the time of the first impact with a wall, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double bounds(
      double px, double py, double r, double vx, double vy, double gx, double gy, double xmin,
      double ymin, double xmax, double ymax, double maxTime) {
    if (!(0 * (px + py + r + vx + vy + gx + gy + xmin + ymin + xmax + ymax) == 0
        && r >= 0
        && maxTime >= 0
        && xmax > xmin
        && ymax > ymin)) {
      check(px, py, r, vx, vy, gx, gy, maxTime);
      new Bounds(xmin, ymin, xmax, ymax);
    }
    double left = ParabolaWallSweep.time(px, r, vx, gx, xmin, 1, maxTime);
    double right = ParabolaWallSweep.time(px, r, vx, gx, xmax, -1, maxTime);
    double bottom = ParabolaWallSweep.time(py, r, vy, gy, ymin, 1, maxTime);
    double top = ParabolaWallSweep.time(py, r, vy, gy, ymax, -1, maxTime);
    return Math.min(Math.min(left, right), Math.min(bottom, top));
  }

  /**
   * Returns the time at which a circle with a constant acceleration hits one that moves straight on.
   * Two circles with the same acceleration move straight relative to each other: the form without
   * acceleration answers for them. The rules are in the description of this class, under
   * Acceleration.
   *
   * @param x1 the x coordinate of the first circle's centre
   * @param y1 the y coordinate of the first circle's centre
   * @param r1 the radius of the first circle
   * @param vx1 the x component of the first circle's velocity at the start
   * @param vy1 the y component of the first circle's velocity at the start
   * @param gx the x component of the first circle's constant acceleration
   * @param gy the y component of the first circle's constant acceleration
   * @param x2 the x coordinate of the second circle's centre
   * @param y2 the y coordinate of the second circle's centre
   * @param r2 the radius of the second circle
   * @param vx2 the x component of the second circle's velocity
   * @param vy2 the y component of the second circle's velocity
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double pair(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double maxTime) {
    if (!(0 * (x1 + y1 + r1 + vx1 + vy1 + gx + gy + x2 + y2 + r2 + vx2 + vy2) == 0
        && r1 >= 0
        && r2 >= 0
        && maxTime >= 0)) {
      checkOfTwo("1", x1, y1, r1, vx1, vy1);
      checkAcceleration(gx, gy);
      checkOfTwo("2", x2, y2, r2, vx2, vy2);
      Check.duration("maxTime", maxTime);
    }
    return FallSweep.time(
        Fall.ofThread().flight(x1, y1, r1, vx1, vy1, gx, gy).disk(x2, y2, r2, vx2, vy2), maxTime);
  }

  /**
   * Finds the first impact of a moving circle with an obstacle of any kind.
   *
   * @param circle the circle at the start of its motion
   * @param velocity its velocity
   * @param obstacle a line, a peg or bounds; of bounds the wall that is hit first is
   *     reported, as {@link Feature#SIDE}: exactly the earliest one, and the vertical one of two that
   *     are hit at exactly the same time
   * @param maxTime the end of the window
   * @return the impact, empty for a miss
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public static Optional<Impact> cast(
      Circle circle, Vec2 velocity, Obstacle obstacle, double maxTime) {
    Check.notNull("circle", circle);
    Check.notNull("velocity", velocity);
    Check.notNull("obstacle", obstacle);
    Check.duration("maxTime", maxTime);
    if (obstacle instanceof Line line) {
      return CircleCast.line(circle, velocity, line, Vec2.ZERO, maxTime);
    }
    if (obstacle instanceof Bounds bounds) {
      return CircleCast.bounds(circle, velocity, bounds, maxTime);
    }
    Circle peg = (Circle) obstacle;
    return CircleCast.disk(circle, velocity, peg, Vec2.ZERO, Kind.PEG, maxTime);
  }

  /**
   * Finds the impact of a moving circle with a line that moves, too.
   *
   * @param circle the circle at the start of its motion
   * @param velocity its velocity
   * @param line the line at the same moment
   * @param lineVelocity the velocity of the line
   * @param maxTime the end of the window
   * @return the impact; its obstacle is the line as it was given, its point is where the two touch,
   *     and its approach speed is that of the circle relative to the line; empty for a miss
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public static Optional<Impact> cast(
      Circle circle, Vec2 velocity, Line line, Vec2 lineVelocity, double maxTime) {
    Check.notNull("circle", circle);
    Check.notNull("velocity", velocity);
    Check.notNull("line", line);
    Check.notNull("lineVelocity", lineVelocity);
    Check.duration("maxTime", maxTime);
    return CircleCast.line(circle, velocity, line, lineVelocity, maxTime);
  }

  /**
   * Finds the first impact of two moving circles with each other. A peg that moves is the second
   * one.
   *
   * @param first the first circle at the start of its motion
   * @param v1 its velocity
   * @param second the second circle at the start of its motion
   * @param v2 its velocity
   * @param maxTime the end of the window
   * @return the impact, its normal from the second circle to the first; empty for a miss
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public static Optional<Impact> cast(
      Circle first, Vec2 v1, Circle second, Vec2 v2, double maxTime) {
    Check.notNull("first", first);
    Check.notNull("v1", v1);
    Check.notNull("second", second);
    Check.notNull("v2", v2);
    Check.duration("maxTime", maxTime);
    return CircleCast.disk(first, v1, second, v2, Kind.CIRCLE, maxTime);
  }

  /**
   * Finds the first impact of a circle with a constant acceleration with an obstacle of any kind. The
   * rules are in the description of this class, under Acceleration.
   *
   * @param circle the circle at the start of its motion
   * @param velocity its velocity at the start
   * @param acceleration its constant acceleration
   * @param obstacle a line, a peg or bounds; of bounds the wall that is hit first is
   *     reported, as {@link Feature#SIDE}: exactly the earliest one, and the vertical one of two that
   *     are hit at exactly the same time
   * @param maxTime the end of the window
   * @return the impact; its approach speed is the one at the moment of impact; empty for a miss
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public static Optional<Impact> cast(
      Circle circle, Vec2 velocity, Vec2 acceleration, Obstacle obstacle, double maxTime) {
    Check.notNull("circle", circle);
    Check.notNull("velocity", velocity);
    Check.notNull("acceleration", acceleration);
    Check.notNull("obstacle", obstacle);
    Check.duration("maxTime", maxTime);
    return acceleration.x() == 0 && acceleration.y() == 0
        ? cast(circle, velocity, obstacle, maxTime)
        : CircleCast.accelerated(circle, velocity, acceleration, obstacle, maxTime);
  }

  /**
   * Finds the first impact of a circle with a constant acceleration with one that moves straight on.
   * The rules are in the description of this class, under Acceleration.
   *
   * @param first the first circle at the start of its motion
   * @param v1 its velocity at the start
   * @param acceleration its constant acceleration
   * @param second the second circle at the start of its motion
   * @param v2 its velocity, which stays
   * @param maxTime the end of the window
   * @return the impact, its normal from the second circle to the first; empty for a miss
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public static Optional<Impact> cast(
      Circle first, Vec2 v1, Vec2 acceleration, Circle second, Vec2 v2, double maxTime) {
    Check.notNull("first", first);
    Check.notNull("v1", v1);
    Check.notNull("acceleration", acceleration);
    Check.notNull("second", second);
    Check.notNull("v2", v2);
    Check.duration("maxTime", maxTime);
    return acceleration.x() == 0 && acceleration.y() == 0
        ? cast(first, v1, second, v2, maxTime)
        : CircleCast.accelerated(
            first, v1, acceleration, second, v2, Kind.CIRCLE, maxTime);
  }

  private static void check(double px, double py, double r, double vx, double vy, double maxTime) {
    Check.finite("px", px);
    Check.finite("py", py);
    Check.notNegative("r", r);
    Check.finite("vx", vx);
    Check.finite("vy", vy);
    Check.duration("maxTime", maxTime);
  }

  private static void check(
      double px, double py, double r, double vx, double vy, double gx, double gy, double maxTime) {
    check(px, py, r, vx, vy, maxTime);
    checkAcceleration(gx, gy);
  }

  private static void checkAcceleration(double gx, double gy) {
    Check.finite("gx", gx);
    Check.finite("gy", gy);
  }

  private static void checkPeg(double cx, double cy, double R) {
    Check.finite("cx", cx);
    Check.finite("cy", cy);
    Check.notNegative("R", R);
  }

  /** Checks the numbers of a pair's first or second circle. */
  private static void checkOfTwo(
      String which, double x, double y, double r, double vx, double vy) {
    Check.finite("x" + which, x);
    Check.finite("y" + which, y);
    Check.notNegative("r" + which, r);
    Check.finite("vx" + which, vx);
    Check.finite("vy" + which, vy);
  }
}
