// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.query.Proximity;
import dev.carom.internal.query.Region;
import dev.carom.internal.query.TracedPath;
import dev.carom.internal.query.Tracer;
import dev.carom.internal.response.SphereResponse;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneDataBuilder;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.KindNumber;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;

/**
 * A {@code Resolver} follows one circle among obstacles for a given time, with all its bounces. It
 * needs no world, and serves game loops of your own and aiming lines. Immutable, safe for use by
 * several threads.
 *
 * <pre>{@code
 * Resolver resolver = Resolver.of(List.of(new Line(0, 0, 100, 0), new Circle(50, 40, 5)));
 * Trajectory path = resolver.trace(new Circle(10, 20, 2), new Vec2(3, -4), 60);
 * System.out.println(path.impacts().size() + " impacts"); // 3 impacts
 * System.out.println(path.at(4.5)); // Vec2[x=23.5, y=2.0]
 * }</pre>
 *
 * <p>For circles that meet each other, {@link SweptCircle#timeToCircle} gives the time, and {@link
 * #respond respond} the velocities afterwards.
 *
 * <p>Impacts are those of {@link SweptCircle}. Among simultaneous ones walls come first, then
 * lines, then pegs, each in their order. {@link #cast cast} compares times exactly; {@link #trace
 * trace}, like {@link World#step World.step}, treats impacts with equal rounded times as
 * simultaneous. Without gravity the thing just hit cannot be hit again before another one is; with
 * it, a circle may fall back on it. A circle that gets stuck follows the <a
 * href="doc-files/rules.html#stuck">rule for stuck circles</a>.
 */
public final class Resolver {

  /** The most impacts of one trace; exact arithmetic counts as in a world's budget. */
  static final int IMPACTS_PER_TRACE = 100_000;

  private final ObstacleIndex index;
  private final Gravity gravity;

  /** The records of the obstacles, by their codes. */
  private final IntFunction<Obstacle> records;

  /**
   * Makes a resolver among the obstacles of a table.
   *
   * @param gravity the acceleration of circles whose path is traced
   * @param records the obstacle that a code stands for
   */
  Resolver(ObstacleTable obstacles, Gravity gravity, IntFunction<Obstacle> records) {
    index = new ObstacleIndex(obstacles);
    if (gravity.acts()) {
      index.beginFalls();
    }
    this.gravity = gravity;
    this.records = records;
  }

  /**
   * Makes a resolver among elastic obstacles.
   *
   * @param obstacles lines, pegs and at most one bounds
   * @return the resolver
   * @throws IllegalArgumentException if there is more than one bounds
   */
  public static Resolver of(List<? extends Obstacle> obstacles) {
    SceneDataBuilder builder = new SceneDataBuilder();
    List<Obstacle> lines = new ArrayList<>();
    List<Obstacle> pegs = new ArrayList<>();
    for (Obstacle obstacle : Check.notNull("obstacles", obstacles)) {
      if (obstacle == null) {
        throw Check.isNull("obstacles[" + obstacles.indexOf(null) + "]");
      } else if (obstacle instanceof Line line) {
        builder.obstacle(KindNumber.LINE, line.ax(), line.ay(), line.bx(), line.by());
        lines.add(line);
      } else if (obstacle instanceof Bounds bounds) {
        add(builder, bounds);
      } else {
        Circle peg = (Circle) obstacle;
        builder.obstacle(KindNumber.PEG, peg.x(), peg.y(), peg.radius());
        pegs.add(peg);
      }
    }
    ObstacleTable table = ObstacleTable.of(builder.build());
    return new Resolver(table, new Gravity(0, 0), code -> record(table, code, lines, pegs));
  }

  private static void add(SceneDataBuilder builder, Bounds bounds) {
    try {
      builder.bounds(bounds.xmin(), bounds.ymin(), bounds.xmax(), bounds.ymax());
    } catch (IllegalStateException second) {
      throw new IllegalArgumentException(
          "obstacles hold a second " + bounds + ": expected one bounds");
    }
  }

  /** Returns the record that was given for a code. */
  private static Obstacle record(
      ObstacleTable table, int code, List<Obstacle> lines, List<Obstacle> pegs) {
    return switch (Codes.kind(code)) {
      case KindNumber.WALL -> PublicRecords.bounds(table.walls);
      case KindNumber.LINE -> lines.get(Codes.index(code));
      default -> pegs.get(Codes.index(code));
    };
  }

  /**
   * Follows an elastic circle along its path, bounces included. It falls if the scene of this
   * resolver has gravity.
   *
   * <p>A path has at most 100,000 impacts, and exact arithmetic counts as in the <a
   * href="doc-files/rules.html#unfinished">budget of a step</a>. One that would go on is not
   * {@linkplain Trajectory#complete complete}.
   *
   * @param circle the circle at the start
   * @param velocity its velocity at the start
   * @param duration how long to follow it, finite and at least 0
   * @return its flights and impacts, with times counted from the start
   * @throws IllegalArgumentException if the duration is NaN, infinite or negative
   */
  public Trajectory trace(Circle circle, Vec2 velocity, double duration) {
    return trace(circle, velocity, 1, duration, Integer.MAX_VALUE);
  }

  /**
   * Follows a circle with a restitution of its own along its path, up to a number of impacts. The
   * limit of 100,000 impacts holds here too.
   *
   * @param circle the circle at the start
   * @param velocity its velocity at the start
   * @param restitution finite and at least 0; that of an impact is its product with the obstacle's
   * @param duration how long to follow it, finite and at least 0
   * @param impacts the number of the impact at which the path ends, at least 0: 1 is the first one,
   *     which a {@link #cast(Circle, Vec2, double) cast} would find without gravity, and 0 the
   *     start
   * @return its flights and impacts, with times counted from the start
   * @throws IllegalArgumentException if the restitution or the duration is NaN, infinite or
   *     negative, or the number of impacts negative
   */
  public Trajectory trace(
      Circle circle, Vec2 velocity, double restitution, double duration, int impacts) {
    Check.notNull("circle", circle);
    Check.notNull("velocity", velocity);
    Check.notNegative("restitution", restitution);
    Check.notNegative("duration", duration);
    Check.notNegative("impacts", impacts);
    MovingCircle body = new SweptCircle(circle, velocity).body(restitution);
    index.expect(1);
    TracedPath path = new Tracer(index, gravity).trace(body, duration, impacts, IMPACTS_PER_TRACE);
    return Trajectory.of(path);
  }

  /**
   * Finds the first impact of a moving circle with the obstacles. A circle of radius 0 is a ray. It
   * flies straight on, also if the scene of this resolver has gravity.
   *
   * <p>It is the earliest of the impacts that {@link SweptCircle#cast SweptCircle.cast} gives for
   * each obstacle, as if in real arithmetic on the given doubles. Among exactly simultaneous ones
   * it is the first in the order above.
   *
   * @param circle the circle at the start
   * @param velocity its velocity
   * @param maxTime the end of the window, at least 0, {@code +infinity} included
   * @return the impact, empty if there is none until maxTime
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public Optional<Impact> cast(Circle circle, Vec2 velocity, double maxTime) {
    Check.notNull("circle", circle);
    Check.notNull("velocity", velocity);
    Check.duration("maxTime", maxTime);
    index.expect(1);
    MovingCircle body = new SweptCircle(circle, velocity).body(1);
    Tracer tracer = new Tracer(index);
    tracer.first(body, maxTime);
    if (body.next == MovingCircle.NOTHING) {
      return Optional.empty();
    }
    int code = body.next;
    Kind kind = Kind.of(Codes.kind(code));
    boolean halts = index.obstacles.halts(code);
    int id = Codes.index(code);
    return Optional.of(Impact.of(body.cleared, kind, id, body.contact, tracer.hit(body), halts));
  }

  /**
   * Finds the first impact of each of many moving circles, as {@link #cast(Circle, Vec2, double)
   * cast} does for one. A call allocates a few small objects, and nothing per cast unless exact
   * arithmetic has to decide.
   *
   * @param casts the circles; they receive the answers
   * @param maxTime the end of the window, at least 0, {@code +infinity} included
   * @throws IllegalArgumentException if maxTime is NaN or negative; the casts keep their answers
   */
  public void cast(Casts casts, double maxTime) {
    Check.notNull("casts", casts);
    Check.duration("maxTime", maxTime);
    index.expect(casts.size());
    Tracer tracer = new Tracer(index);
    MovingCircle body = new MovingCircle();
    for (int i = 0; i < casts.size(); i++) {
      casts.load(i, body);
      tracer.first(body, maxTime);
      if (body.next == MovingCircle.NOTHING) {
        casts.miss(i);
      } else {
        casts.hit(i, body, Codes.index(body.next), tracer.hit(body));
      }
    }
  }

  /**
   * Finds the obstacle that is nearest to a point. Among equally near ones it is the first: walls,
   * then lines, then pegs, each in their order.
   *
   * <p>Distances are computed in plain doubles: to a wall, to a line, or to the rim of a peg.
   * Inside of a peg the distance is 0.
   *
   * @param point the point
   * @return the obstacle, empty if there is none
   */
  public Optional<Obstacle> nearest(Vec2 point) {
    Check.notNull("point", point);
    int nearest =
        new Proximity(index, () -> 0)
            .nearest(
                KindNumber.WALL,
                KindNumber.CIRCLE,
                point.x(),
                point.y(),
                index.obstacles.met(FilterBits.DEFAULT));
    return nearest == Index.NONE ? Optional.empty() : Optional.of(records.apply(nearest));
  }

  /**
   * Finds the obstacles that overlap a disk: they have points inside of it, not only on its rim.
   * The answer is exact. A disk of radius 0 is a point: it overlaps pegs and walls that hold it
   * inside, and no line.
   *
   * @param disk the disk
   * @return the obstacles: the bounds once, however many walls overlap, then lines, then pegs, each
   *     in their order, equal ones too
   */
  public List<Obstacle> overlapping(Circle disk) {
    return overlapping(PublicRecords.region(disk));
  }

  /**
   * Finds the obstacles that overlap a box: they have points inside of it, not only on its edge.
   * The answer is exact.
   *
   * @param box the box
   * @return the obstacles, as for a disk
   */
  public List<Obstacle> overlapping(Bounds box) {
    return overlapping(PublicRecords.region(box));
  }

  private List<Obstacle> overlapping(Region region) {
    return things(
        new Proximity(index, () -> 0)
            .overlapping(
                KindNumber.WALL,
                KindNumber.CIRCLE,
                region,
                index.obstacles.met(FilterBits.DEFAULT)));
  }

  /**
   * Returns the obstacles that codes stand for. Walls come first: those after the first one are the
   * same bounds.
   */
  private List<Obstacle> things(int[] codes) {
    List<Obstacle> things = new ArrayList<>();
    for (int code : codes) {
      if (!Codes.isWall(code) || things.isEmpty()) {
        things.add(records.apply(code));
      }
    }
    return List.copyOf(things);
  }

  /**
   * Computes the velocities of two circles after an impact, in place.
   *
   * <p>Along the line of centres {@code d = c1 - c2} the relative velocity {@code u = v1 - v2} is
   * reversed and scaled by e, with
   *
   * <pre>
   *   J = (1 + e) (u.d) / (d.d),  v1 -= m2 / (m1 + m2) J d,  v2 += m1 / (m1 + m2) J d
   * </pre>
   *
   * It serves loops of your own, which keep their circles where they like. It allocates nothing,
   * unless exact arithmetic has to decide whether the circles approach. {@link SweptSphere#respond
   * SweptSphere.respond} does the same for two spheres.
   *
   * <pre>{@code
   * // Circles of radius 5: the first comes at 4 a second, the second rests 20 to the right.
   * double[] v = {4, 0, 0, 0};
   * SweptCircle first = new SweptCircle(0, 0, 5, v[0], v[1]);
   * double t = first.timeToCircle(new SweptCircle(20, 0, 5, v[2], v[3]), 10);
   * double x1 = 0 + v[0] * t;
   * double x2 = 20 + v[2] * t;
   * Resolver.respond(x1, 0, 1, x2, 0, 3, 1, v);
   * System.out.println(t + ": " + v[0] + ", " + v[2]); // 2.5: -2.0, 2.0
   * }</pre>
   *
   * @param x1 the x coordinate of the first circle's centre at the impact
   * @param y1 the y coordinate of the first circle's centre
   * @param m1 the mass of the first circle, from 2^-500 to 2^500, or infinite
   * @param x2 the x coordinate of the second circle's centre
   * @param y2 the y coordinate of the second circle's centre
   * @param m2 the mass of the second circle, from 2^-500 to 2^500, or infinite
   * @param e the restitution, finite and at least 0: 1 elastic, 0 no bounce
   * @param velocities vx1, vy1, vx2, vy2 before the impact, replaced by those after it, each
   *     rounded once, after d and u were; beyond the range of doubles it is infinite. A circle of
   *     infinite mass goes on as it was; two of them pass through each other. Circles that do not
   *     approach each other, {@code u.d >= 0}, concentric ones among them, keep their velocities
   * @throws IllegalArgumentException if a number is outside its range, or there are not four
   *     velocities
   */
  public static void respond(
      double x1,
      double y1,
      double m1,
      double x2,
      double y2,
      double m2,
      double e,
      double[] velocities) {
    Check.finite("x1", x1);
    Check.finite("y1", y1);
    Check.mass("m1", m1);
    Check.finite("x2", x2);
    Check.finite("y2", y2);
    Check.mass("m2", m2);
    Check.notNegative("e", e);
    double[] v = Check.notNull("velocities", velocities);
    if (v.length != 4) {
      throw Check.refused("velocities.length", v.length, "4");
    }
    Check.finite("vx1", v[0]);
    Check.finite("vy1", v[1]);
    Check.finite("vx2", v[2]);
    Check.finite("vy2", v[3]);
    if (Predicates.dot(v[0], v[1], v[2], v[3], x1, y1, x2, y2) < 0) {
      SphereResponse.respond(x1, y1, 0, m1, x2, y2, 0, m2, 1 + e, v);
    }
  }
}
