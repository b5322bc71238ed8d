// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.query.Tracer;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.FallSweep;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.sweep.ParabolaWallSweep;
import dev.carom.internal.sweep.SegmentSweep;
import dev.carom.internal.sweep.Turn;
import dev.carom.internal.sweep.WallSweep;
import dev.carom.internal.util.Check;
import java.util.Optional;

/**
 * A {@code SweptCircle} is a circle in motion from time 0 on, and the detector in one: it tells
 * when it first touches an obstacle or another moving circle. It needs no world.
 *
 * <pre>{@code
 * // A circle of radius 5 at (-15, 4), 20 a second to the right; a line from (0, 0) to (0, 10).
 * SweptCircle circle = new SweptCircle(-15, 4, 5, 20, 0);
 * System.out.println(circle.timeToLine(0, 0, 0, 10, 1)); // 0.5
 * Impact impact = circle.cast(new Line(0, 0, 0, 10), 1).get();
 * System.out.println(impact.feature() + ", " + impact.normal()); // SIDE, Vec2[x=-1.0, y=0.0]
 * }</pre>
 *
 * <p><img src="doc-files/sweep.svg" alt="A circle at time 0 and at its impact with a line: the
 * point of the impact, and the normal, which points from the line to the centre"
 * style="max-width:100%">
 *
 * <p>There are two forms of each question. {@code timeTo} takes and returns doubles, {@code
 * +infinity} for never. It allocates nothing, unless a question is so close to a tie that only
 * exact arithmetic decides it: one circle may be asked about many obstacles. {@code cast} takes a
 * record and returns the {@link Impact}.
 *
 * <p><img src="doc-files/line.svg" alt="A circle that touches the side of a line, and one that
 * touches its end: the normal points from the line to the centre, which lies on a capsule around
 * the line" style="max-width:100%">
 *
 * <p>The <i>distance</i> is that of the circle's centre from the line, the wall or the other
 * centre. The <i>reach</i> is the radius; for a peg or another circle it is the sum of both radii.
 * An impact is the smallest t in the closed window [0, maxTime] at which the distance is at most
 * the reach and falls. If t = 0, it must fall just after that moment; else just before it. So:
 *
 * <ul>
 *   <li>apart and meeting within the window: an impact at the moment of first contact;
 *   <li>touching or overlapping at the start and moving inward: an impact at 0; positions are never
 *       corrected;
 *   <li>touching or overlapping at the start and moving apart, along, or not at all: none;
 *   <li>a graze, which comes as near as the reach with no speed along the normal: none;
 *   <li>the centre exactly on a line, on an endpoint or on a peg's centre at the start: none, since
 *       it cannot come nearer;
 *   <li>a point particle (radius 0) that reaches an obstacle later: an impact.
 * </ul>
 *
 * <p>Whether there is an impact, and which feature or wall is hit, is decided as if in real
 * arithmetic on the given doubles. A projection exactly on an end of a line is that end; a line of
 * zero length is its start. The time is the correctly rounded one. A time beyond the range of
 * doubles exceeds every finite maxTime; with {@code maxTime = +infinity} it is {@code +infinity},
 * which is a miss too.
 *
 * <p>Lengths share one unit, times another. Coordinates, velocities and accelerations are finite,
 * radii finite and at least 0. The end of the window, maxTime, is at least 0, {@code +infinity}
 * included. Anything else is an {@link IllegalArgumentException} that names it.
 *
 * <h2>Acceleration</h2>
 *
 * <p>With an acceleration (gx, gy), such as gravity, the circle follows the parabola {@code p + v t
 * + g t^2 / 2}. An impact is then the first time in the window just after which the distance is at
 * most the reach and falls. For two points, and for a point and a line, it is the first time above
 * 0 at which the distance falls to 0 with a speed above 0. Decisions are as exact as above, and
 * times are rounded in the same way.
 *
 * <p>Two starts that are no impact above can then be one:
 *
 * <ul>
 *   <li>touching at the start without speed along the normal: an impact at 0 with approach speed 0
 *       if the circle is accelerated inward, that is, supported; none if outward;
 *   <li>touching or overlapping at the start and leaving: if the acceleration turns the circle back
 *       while it still overlaps, an impact at the moment at which the distance is greatest, with
 *       approach speed 0; if it has left before, an impact when it touches again.
 * </ul>
 *
 * <p>Exact arithmetic decides ties. It also decides the impacts of a point with a line, an endpoint
 * or another point, and those of a circle that leaves a line that it overlaps at the start. It
 * takes far longer than doubles.
 *
 * <h2>Method</h2>
 *
 * <p>A circle against a segment is a point against a capsule, its Minkowski sum with a disk (C.
 * Ericson, Real-Time Collision Detection, 2005, 5.5). Decisions are signs of polynomials that climb
 * from doubles to exact numbers only in doubt (J. R. Shewchuk, Adaptive Precision Floating-Point
 * Arithmetic, Discrete and Computational Geometry 18, 1997). With an acceleration the polynomials
 * have degree 4. Their first root is isolated by the signs of Bernstein coefficients (G. E. Collins
 * and A. G. Akritas, Polynomial real root isolation using Descartes' rule of signs, SYMSAC 1976).
 * No root is written in closed form.
 *
 * @param x the x coordinate of the centre at time 0
 * @param y the y coordinate of the centre at time 0
 * @param radius the radius; 0 for a point
 * @param vx the x component of the velocity at time 0
 * @param vy the y component of the velocity at time 0
 * @param gx the x component of the constant acceleration
 * @param gy the y component of the constant acceleration
 */
public record SweptCircle(
    double x, double y, double radius, double vx, double vy, double gx, double gy) {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private static final ThreadLocal<Hit> HIT = ThreadLocal.withInitial(Hit::new);

  /**
   * Checks the components.
   *
   * @param x the x coordinate of the centre
   * @param y the y coordinate of the centre
   * @param radius the radius
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @param gx the x component of the acceleration
   * @param gy the y component of the acceleration
   * @throws IllegalArgumentException if a number is not finite, or the radius negative
   */
  public SweptCircle {
    Check.finite("x", x);
    Check.finite("y", y);
    Check.notNegative("radius", radius);
    Check.finite("vx", vx);
    Check.finite("vy", vy);
    Check.finite("gx", gx);
    Check.finite("gy", gy);
  }

  /**
   * Makes a circle that moves straight on.
   *
   * @param x the x coordinate of the centre at time 0
   * @param y the y coordinate of the centre at time 0
   * @param radius the radius
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @throws IllegalArgumentException if a number is not finite, or the radius negative
   */
  public SweptCircle(double x, double y, double radius, double vx, double vy) {
    this(x, y, radius, vx, vy, 0, 0);
  }

  /**
   * Makes a circle that moves straight on.
   *
   * @param circle the circle at time 0
   * @param velocity its velocity
   */
  public SweptCircle(Circle circle, Vec2 velocity) {
    this(
        Check.notNull("circle", circle).x(),
        circle.y(),
        circle.radius(),
        Check.notNull("velocity", velocity).x(),
        velocity.y());
  }

  /**
   * Returns the same circle with another velocity at time 0.
   *
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @return the circle, with the acceleration of this one
   * @throws IllegalArgumentException if a component is not finite
   */
  public SweptCircle withVelocity(double vx, double vy) {
    return new SweptCircle(x, y, radius, vx, vy, gx, gy);
  }

  /**
   * Returns the same circle with another constant acceleration.
   *
   * @param gx the x component of the acceleration
   * @param gy the y component of the acceleration
   * @return the circle, with the velocity of this one
   * @throws IllegalArgumentException if a component is not finite
   */
  public SweptCircle withAcceleration(double gx, double gy) {
    return new SweptCircle(x, y, radius, vx, vy, gx, gy);
  }

  /**
   * Returns the circle at a time, as if it hit nothing.
   *
   * @param t the time, finite; before 0 it is where the circle came from
   * @return the circle around {@code p + v t + g t^2 / 2}; a coordinate beyond the range of doubles
   *     is the largest one
   * @throws IllegalArgumentException if the time is NaN or infinite
   */
  public Circle at(double t) {
    Check.finite("t", t);
    return new Circle(
        Vec2.within(MovingCircle.place(x, vx, gx, t), MovingCircle.place(y, vy, gy, t)), radius);
  }

  /**
   * Returns the time at which this circle hits a line.
   *
   * @param ax the x coordinate of the line's start
   * @param ay the y coordinate of the line's start
   * @param bx the x coordinate of the line's end
   * @param by the y coordinate of the line's end
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public double timeToLine(double ax, double ay, double bx, double by, double maxTime) {
    return timeToLine(ax, ay, bx, by, 0, 0, maxTime);
  }

  /**
   * Returns the time at which this circle hits a line that moves, too. The line keeps its
   * direction. The answer depends on the difference of the two velocities, taken exactly.
   *
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
  public double timeToLine(
      double ax, double ay, double bx, double by, double ux, double uy, double maxTime) {
    if (!(0 * (ax + ay + bx + by + ux + uy) == 0 && maxTime >= 0)) {
      new Line(ax, ay, bx, by);
      Check.finite("ux", ux);
      Check.finite("uy", uy);
      Check.duration("maxTime", maxTime);
    }
    if (falls()) {
      return FallSweep.time(fall().line(ax, ay, bx, by, ux, uy), maxTime);
    }
    int contact = SegmentSweep.contact(x, y, radius, vx, vy, ax, ay, bx, by, ux, uy);
    return SegmentSweep.time(contact, x, y, radius, vx, vy, ax, ay, bx, by, ux, uy, maxTime);
  }

  /**
   * Returns the time at which this circle hits a peg, or a single endpoint: a peg of radius 0.
   *
   * @param cx the x coordinate of the peg's centre
   * @param cy the y coordinate of the peg's centre
   * @param pegRadius the radius of the peg
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public double timeToPeg(double cx, double cy, double pegRadius, double maxTime) {
    if (!(0 * (cx + cy + pegRadius) == 0 && pegRadius >= 0 && maxTime >= 0)) {
      Check.finite("cx", cx);
      Check.finite("cy", cy);
      Check.notNegative("pegRadius", pegRadius);
      Check.duration("maxTime", maxTime);
    }
    if (falls()) {
      return FallSweep.time(fall().disk(cx, cy, pegRadius, 0, 0), maxTime);
    }
    int contact = DiskSweep.contact(x, y, radius, vx, vy, cx, cy, pegRadius, 0, 0);
    return DiskSweep.time(contact, x, y, radius, vx, vy, cx, cy, pegRadius, 0, 0, maxTime);
  }

  /**
   * Returns the time at which this circle hits the first of the four walls around it.
   *
   * @param xmin the x coordinate of the left wall
   * @param ymin the y coordinate of the bottom wall
   * @param xmax the x coordinate of the right wall, greater than xmin
   * @param ymax the y coordinate of the top wall, greater than ymin
   * @param maxTime the end of the window
   * @return the time of the first impact with a wall, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public double timeToBounds(double xmin, double ymin, double xmax, double ymax, double maxTime) {
    if (!(xmax > xmin && ymax > ymin && maxTime >= 0)) {
      Check.bounds(xmin, ymin, xmax, ymax);
      Check.duration("maxTime", maxTime);
    }
    return Math.min(
        timeToWalls(x, radius, vx, gx, xmin, xmax, maxTime),
        timeToWalls(y, radius, vy, gy, ymin, ymax, maxTime));
  }

  /** The time of the first impact with the two walls across one axis. */
  private static double timeToWalls(
      double p, double r, double v, double g, double low, double high, double maxTime) {
    return g == 0
        ? WallSweep.time(p, r, v, v < 0 ? low : high, maxTime)
        : Math.min(
            ParabolaWallSweep.time(p, r, v, g, low, 1, maxTime),
            ParabolaWallSweep.time(p, r, v, g, high, -1, maxTime));
  }

  /**
   * Returns the time at which this circle and another one, or a peg that moves, hit each other.
   *
   * <p>The answer depends on the differences of the velocities and of the accelerations. The first
   * is taken exactly. The second is rounded, but exact if one of the circles moves straight on, or
   * if both fall alike: then they move straight relative to each other.
   *
   * @param other the other circle
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public double timeToCircle(SweptCircle other, double maxTime) {
    SweptCircle o = Check.notNull("other", other);
    Check.duration("maxTime", maxTime);
    if (gx != o.gx || gy != o.gy) {
      return FallSweep.time(fall(o), maxTime);
    }
    int contact = DiskSweep.contact(x, y, radius, vx, vy, o.x, o.y, o.radius, o.vx, o.vy);
    return DiskSweep.time(contact, x, y, radius, vx, vy, o.x, o.y, o.radius, o.vx, o.vy, maxTime);
  }

  /**
   * Finds the first impact of this circle with an obstacle of any kind.
   *
   * @param obstacle a line, an outline, a peg or bounds. Of bounds the wall that is hit first is
   *     reported, as {@link Feature#SIDE}. It is exactly the earliest one; of two that are hit at
   *     exactly the same time it is the vertical one
   * @param maxTime the end of the window
   * @return the impact; its approach speed is the one at the moment of impact; empty for a miss
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public Optional<Impact> cast(Obstacle obstacle, double maxTime) {
    Check.notNull("obstacle", obstacle);
    Check.duration("maxTime", maxTime);
    if (obstacle instanceof Line line) {
      return cast(line, Vec2.ZERO, maxTime);
    }
    if (obstacle instanceof Bounds bounds) {
      return first(bounds, maxTime);
    }
    if (obstacle instanceof Outline outline) {
      return first(outline, maxTime);
    }
    Circle peg = (Circle) obstacle;
    Fall fall = fall().disk(peg.x(), peg.y(), peg.radius(), 0, 0);
    return first(fall, Kind.PEG, 0, 0, 0, maxTime);
  }

  /**
   * Finds the impact of this circle with a line that moves, too. The line keeps its direction.
   *
   * @param line the line at time 0
   * @param lineVelocity its velocity
   * @param maxTime the end of the window
   * @return the impact; its point is where the two touch, and its approach speed is that of this
   *     circle relative to the line; empty for a miss
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public Optional<Impact> cast(Line line, Vec2 lineVelocity, double maxTime) {
    Check.notNull("line", line);
    Check.notNull("lineVelocity", lineVelocity);
    Check.duration("maxTime", maxTime);
    Vec2 u = lineVelocity;
    Fall fall = fall().line(line.ax(), line.ay(), line.bx(), line.by(), u.x(), u.y());
    return first(fall, Kind.LINE, 0, 0, 0, maxTime);
  }

  /**
   * Finds the first impact of this circle with a line that turns about a pivot, and then rests.
   *
   * <p>The line turns rigidly, at an almost even rate. A vector w of it, seen from the pivot, is
   * {@code w c^2 / |c|^2} at a time, where c goes straight from 1 to {@code cos(angle / 2) + i
   * sin(angle / 2)}. So the rate is uneven by {@code tan^2(angle / 4)}: by 0.2 % of a turn over 10
   * degrees, by 4 % over 45. For this motion all that is said above about decisions and times
   * holds.
   *
   * <p>A line that turns accelerates. As with an acceleration of the circle, an impact is the first
   * time just after which the distance is at most the radius and falls; so a circle can be
   * supported by the line, or be caught by it while it still leaves.
   *
   * <p>If there is no impact until the arrival, the circle is asked again from its rounded place at
   * that time, with the line at rest where the turn ends, rounded too.
   *
   * <pre>{@code
   * SweptCircle ball = new SweptCircle(6, 2, 1, 0, 0);
   * Line flipper = new Line(0, 0, 8, 0);
   * Impact impact = ball.cast(flipper, Vec2.ZERO, Math.toRadians(50), 0.025, 1).get();
   * System.out.println(impact.feature() + ", " + Math.round(impact.approachSpeed())); // SIDE, 217
   * }</pre>
   *
   * @param line the line at time 0
   * @param pivot the place about which it turns; it need not be on the line
   * @param angle by how much, in radians, counterclockwise (where y points up); at most a quarter
   *     turn either way, {@code Math.PI / 2}
   * @param arrival when the turn ends, above 0 and finite
   * @param maxTime the end of the window, which may be after the arrival
   * @return the impact; its approach speed is relative to the point of the line where they touch;
   *     empty for a miss
   * @throws IllegalArgumentException if a number is outside its range, or the arrival so near that
   *     the rate of the turn is beyond the range of doubles
   */
  public Optional<Impact> cast(
      Line line, Vec2 pivot, double angle, double arrival, double maxTime) {
    Check.notNull("line", line);
    Check.notNull("pivot", pivot);
    if (!(Math.abs(angle) <= Turn.QUARTER)) {
      throw Check.refused("angle", angle, "at most a quarter turn, +-" + Turn.QUARTER);
    }
    double q1 = Turn.q1(angle, arrival);
    double q2 = Turn.q2(angle, arrival);
    if (!(arrival > 0 && arrival <= Double.MAX_VALUE && Math.abs(q2) <= Double.MAX_VALUE)) {
      throw Check.refused("arrival", arrival, "a finite time above 0, in which the rate is finite");
    }
    Check.duration("maxTime", maxTime);
    Fall fall = fall().line(line.ax(), line.ay(), line.bx(), line.by(), 0, 0);
    fall.turn(pivot.x(), pivot.y(), q1, q2);
    Optional<Impact> impact = first(fall, Kind.LINE, 0, 0, 0, Math.min(arrival, maxTime));
    if (impact.isPresent() || maxTime <= arrival) {
      return impact;
    }
    Vec2 a = turned(line.start(), pivot, angle);
    Vec2 b = turned(line.end(), pivot, angle);
    Vec2 velocity = Vec2.within(vx + gx * arrival, vy + gy * arrival);
    SweptCircle then = new SweptCircle(at(arrival), velocity).withAcceleration(gx, gy);
    Fall rest = then.fall().line(a.x(), a.y(), b.x(), b.y(), 0, 0);
    return first(rest, Kind.LINE, 0, 0, arrival, maxTime - arrival);
  }

  private static Vec2 turned(Vec2 place, Vec2 pivot, double angle) {
    double[] xy = {place.x(), place.y()};
    ObstacleMotions.turn(
        pivot.x(), pivot.y(), StrictMath.cos(0.5 * angle), StrictMath.sin(0.5 * angle), xy, 0);
    return new Vec2(xy[0], xy[1]);
  }

  /**
   * Finds the first impact of this circle with another one, or with a peg that moves. The rules are
   * those of {@link #timeToCircle}.
   *
   * @param other the other circle
   * @param maxTime the end of the window
   * @return the impact, its normal from the other circle to this one; empty for a miss
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public Optional<Impact> cast(SweptCircle other, double maxTime) {
    Check.notNull("other", other);
    Check.duration("maxTime", maxTime);
    return first(fall(other), Kind.CIRCLE, other.gx, other.gy, 0, maxTime);
  }

  /** Loads this circle, of no world, at the start of its flight. */
  MovingCircle load(MovingCircle m, double restitution) {
    m.start(Impact.NO_ID, x, y, radius, vx, vy, restitution);
    m.fall(gx, gy);
    return m;
  }

  private boolean falls() {
    return gx != 0 || gy != 0;
  }

  /** A question about this circle, without an obstacle. */
  private Fall fall() {
    return Fall.ofThread().flight(x, y, radius, vx, vy, gx, gy);
  }

  /**
   * The question whether this circle hits another one, from which the other's fall is taken off.
   */
  private Fall fall(SweptCircle other) {
    double ax = Coordinates.within(gx - other.gx);
    double ay = Coordinates.within(gy - other.gy);
    return Fall.ofThread()
        .flight(x, y, radius, vx, vy, ax, ay)
        .disk(other.x, other.y, other.radius, other.vx, other.vy);
  }

  /**
   * The first impact with a line or a disk.
   *
   * @param ax the x component of the acceleration of the other one, which was taken off
   * @param ay the y component
   * @param start the time of the start
   */
  private static Optional<Impact> first(
      Fall fall, Kind kind, double ax, double ay, double start, double maxTime) {
    boolean isStraight = fall.isStraight();
    int straight = isStraight ? FallSweep.straightContact(fall) : 0;
    double t =
        isStraight
            ? FallSweep.straightTime(fall, straight, maxTime)
            : FallSweep.time(fall, maxTime);
    if (t == NEVER) {
      return Optional.empty();
    }
    int contact = isStraight ? straight : FallSweep.contact(fall, t);
    Hit hit = HIT.get().of(fall, contact, t);
    if (ax != 0 || ay != 0) {
      hit.moved(MovingCircle.place(0, 0, ax, t), MovingCircle.place(0, 0, ay, t));
    }
    return Optional.of(Impact.of(start + t, kind, Impact.NO_ID, contact, hit, false));
  }

  /** The first impact with a side: a solid outline is there from outside only. */
  private Optional<Impact> first(Outline outline, double maxTime) {
    ObstacleTable sides = ObstacleTable.empty(null);
    sides.add(outline.values());
    Tracer tracer = new Tracer(new ObstacleIndex(sides));
    MovingCircle m = load(tracer.body, 1);
    tracer.first(m, maxTime);
    return m.next == MovingCircle.NOTHING
        ? Optional.empty()
        : Optional.of(Impact.of(m, Impact.NO_ID, sides, tracer.hit(m)));
  }

  private Optional<Impact> first(Bounds bounds, double maxTime) {
    int first = -1;
    double time = NEVER;
    for (int id = WallSweep.LEFT; id <= WallSweep.TOP; id++) {
      double t = timeToWall(bounds, id, maxTime);
      if (t < time || (t == time && t < NEVER && isEarlier(bounds, id, first))) {
        first = id;
        time = t;
      }
    }
    if (first < 0) {
      return Optional.empty();
    }
    Hit hit = HIT.get().ofWall(fall(), first, wall(bounds, first), time);
    return Optional.of(Impact.of(time, Kind.WALL, first, 0, hit, false));
  }

  private double timeToWall(Bounds bounds, int id, double maxTime) {
    boolean vertical = id <= WallSweep.RIGHT;
    return ParabolaWallSweep.time(
        vertical ? x : y,
        radius,
        vertical ? vx : vy,
        vertical ? gx : gy,
        wall(bounds, id),
        ParabolaWallSweep.inward(id),
        maxTime);
  }

  /** Tells of two walls with equal rounded times whether the first one is exactly earlier. */
  private boolean isEarlier(Bounds bounds, int id, int other) {
    return exactTimeToWall(bounds, id).compare(exactTimeToWall(bounds, other)) < 0;
  }

  private RealRoot exactTimeToWall(Bounds bounds, int id) {
    boolean vertical = id <= WallSweep.RIGHT;
    return ParabolaWallSweep.exact(
            vertical ? x : y,
            radius,
            vertical ? vx : vy,
            vertical ? gx : gy,
            wall(bounds, id),
            ParabolaWallSweep.inward(id))
        .first(NEVER);
  }

  private static double wall(Bounds bounds, int id) {
    return switch (id) {
      case WallSweep.LEFT -> bounds.xmin();
      case WallSweep.RIGHT -> bounds.xmax();
      case WallSweep.BOTTOM -> bounds.ymin();
      default -> bounds.ymax();
    };
  }
}
