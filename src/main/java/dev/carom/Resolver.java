// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.response.SphereResponse;
import dev.carom.internal.util.Check;
import java.util.List;
import java.util.Optional;

/**
 * A {@code Resolver} answers questions about things that a circle can meet: which is hit first,
 * along which path a circle bounces, which is nearest, which overlap. It changes nothing.
 *
 * <p>A {@link World} is a resolver of all its things as they are now. {@link Scene#resolver} is one
 * of the obstacles of a scene, and {@link #of Resolver.of} one of a list; these two are immutable,
 * and safe for use by several threads. The library alone implements this interface; it may get
 * further methods.
 *
 * <pre>{@code
 * Resolver resolver = Resolver.of(List.of(new Line(0, 0, 100, 0), new Circle(50, 40, 5)));
 * Trajectory path = resolver.trace(new SweptCircle(10, 20, 2, 3, -4), 1, 60, 9);
 * System.out.println(path.impacts().size() + " impacts"); // 3 impacts
 * System.out.println(path.at(4.5)); // Vec2[x=23.5, y=2.0]
 * }</pre>
 *
 * <p>Only things count that a circle with the {@linkplain Filter#DEFAULT default filter} can meet.
 * {@link #withFilter withFilter} asks as another one; an editor, which wants to see all, asks
 * {@code world.withFilter(Filter.ALL)}.
 *
 * <p>Questions are about now, and times count from now. Lines, pegs and circles go on with their
 * present velocities and accelerations: their own impacts are ignored. The circle that is asked
 * about moves as it says: without acceleration it flies straight, also in a world with gravity.
 * {@link World#flight World.flight} is a circle of a world with all its motion.
 *
 * <p>Among exactly simultaneous impacts walls come first, then lines, then pegs, then circles, each
 * by id. For circles that meet each other in a program of your own, {@link
 * SweptCircle#timeToCircle} gives the time, and {@link #respond respond} the velocities afterwards.
 */
public interface Resolver {

  /**
   * Makes a resolver among elastic obstacles. An id is a place among the obstacles of one kind: 0
   * is the first line, or the first peg.
   *
   * @param obstacles lines, pegs and at most one bounds
   * @return the resolver
   * @throws IllegalArgumentException if there is more than one bounds
   */
  static Resolver of(List<? extends Obstacle> obstacles) {
    return Questions.of(Check.notNull("obstacles", obstacles));
  }

  /**
   * Returns these same things as a circle with a given filter meets them. It is a view: of a world
   * it sees the things as they are when it is asked.
   *
   * @param filter the filter of the circles that ask
   * @return the view
   */
  Resolver withFilter(Filter filter);

  /**
   * Finds the first impact of a moving circle. A circle of radius 0 is a ray. It meets walls, lines
   * and pegs, and, in a world whose circles collide, the circles too. It passes through sensors.
   *
   * <p>The earliest impact is found as if in real arithmetic, on the given doubles and on the
   * positions, velocities and accelerations that things have. A {@linkplain World#step step}
   * instead treats impacts with equal rounded times as simultaneous. A circle of a world that is
   * asked about does not hit itself, since circles that move alike do not meet.
   *
   * <p>The search uses an <a href="doc-files/rules.html#questions">index</a>. For many casts use
   * {@link #cast(Casts, double) one call}.
   *
   * @param circle the circle now
   * @param maxTime how far to look ahead, at least 0, {@code +infinity} included
   * @return the impact, with its time counted from now; empty if there is none until maxTime
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  Optional<Impact> cast(SweptCircle circle, double maxTime);

  /**
   * Finds the first impact of each of many moving circles, as {@link #cast(SweptCircle, double)
   * cast} does for one. A call allocates a few small objects at most, and nothing per cast unless
   * exact arithmetic has to decide.
   *
   * <p>See <a href="doc-files/recipes.html#lidar">a lidar</a> for an example.
   *
   * @param casts the circles now; they receive the answers
   * @param maxTime how far to look ahead, at least 0, {@code +infinity} included
   * @throws IllegalArgumentException if maxTime is NaN or negative; the casts keep their answers
   */
  void cast(Casts casts, double maxTime);

  /**
   * Follows a circle along its path, bounces included. The path ends at a time, at its impact of a
   * given number, or, in a world whose circles collide, at the first circle that it meets.
   *
   * <p>The circle has the acceleration that it says. Sensors that it passes are listed and do not
   * count; circles that are sensors are not listed. An impact with a circle is the last one: nobody
   * moves by it, and its impulse is 0. A circle that gets stuck follows the <a
   * href="doc-files/rules.html#stuck">rule for stuck circles</a>.
   *
   * <p>A path has at most 100,000 impacts, and exact arithmetic counts as in the <a
   * href="doc-files/rules.html#unfinished">budget of a step</a>. One that would go on is not
   * {@linkplain Trajectory#complete complete}. Places may differ from those of a circle that a
   * world moves in the last digits, as times count from now.
   *
   * @param circle the circle at the start
   * @param restitution finite and at least 0; that of an impact is its product with the obstacle's
   * @param duration how long to follow it, finite and at least 0
   * @param impacts the number of the impact at which the path ends, at least 0: 1 is the first one,
   *     and 0 the start
   * @return its flights and impacts, with times counted from now
   * @throws IllegalArgumentException if the restitution or the duration is NaN, infinite or
   *     negative, or the number of impacts negative
   */
  Trajectory trace(SweptCircle circle, double restitution, double duration, int impacts);

  /**
   * Finds the thing that is nearest to a point. Among equally near ones walls come first, then
   * lines, then pegs, then circles, each by id.
   *
   * <p>Distances are computed in plain doubles: to a wall, to a line, or to the rim of a peg or
   * circle. Inside of a peg or circle the distance is 0. The search uses an <a
   * href="doc-files/rules.html#questions">index</a>.
   *
   * @param x the x coordinate of the point, finite
   * @param y the y coordinate of the point, finite
   * @param kinds the kinds that count; all of them if none is given
   * @return the thing, with its distance and its nearest point; empty if there is none
   * @throws IllegalArgumentException if a coordinate is NaN or infinite
   */
  Optional<Nearest> nearest(double x, double y, Kind... kinds);

  /**
   * Finds the things of a kind that overlap a disk: they have points inside of it, not only on its
   * rim. A disk of radius 0 is a point: it overlaps pegs, circles and walls that hold it inside,
   * and no line. The answer is exact, for circles at the positions that {@link World#x} and {@link
   * World#y} give.
   *
   * @param kind which kind of thing
   * @param disk the disk
   * @return the ids, ascending; a new array
   */
  int[] overlapping(Kind kind, Circle disk);

  /**
   * Finds the things of a kind that overlap a box: they have points inside of it, not only on its
   * edge. The answer is exact.
   *
   * @param kind which kind of thing
   * @param box the box
   * @return the ids, ascending; a new array
   */
  int[] overlapping(Kind kind, Bounds box);

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
  static void respond(
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
