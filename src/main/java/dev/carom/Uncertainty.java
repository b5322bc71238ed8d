// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.query.ErrorSum;
import dev.carom.internal.query.PathError;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.sweep.PegShape;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.Part;
import java.util.Arrays;

/**
 * An {@code Uncertainty} bounds the error of each circle's place: the distance between the place
 * that a world computes and the true one.
 *
 * <p>Each impact rounds, and each bounce off something round multiplies the errors so far. After
 * ten or twenty such bounces a place may mean nothing, in any simulation in doubles. An {@code
 * Uncertainty} tells when that happens.
 *
 * <pre>{@code
 * Scene scene =
 *     Scene.builder().bounds(0, 0, 100, 100).peg(50, 50, 22).circle(15, 20, 2, 1.3, 2.1).build();
 * World world = new World(scene);
 * Uncertainty uncertainty = world.uncertainty(0.01);
 * world.advanceTo(1000);
 * System.out.println(Math.round(uncertainty.lostAt(0))); // 502
 * }</pre>
 *
 * <p>The world keeps it up to date: after each call it takes in the impacts of that call, and
 * changes nothing in the world. A world keeps one, the last that it {@linkplain World#uncertainty
 * gave}. Circles must ignore each other, or there must be one only: errors of circles that collide
 * depend on each other, and such worlds are refused. A world without an {@code Uncertainty} pays
 * nothing for it.
 *
 * <h2>The bound</h2>
 *
 * <p>The bound counts from the state at the beginning. That state, the obstacles and gravity are
 * taken as exact. The bound has two parts. How large each new rounding error can be is proven. How
 * the errors grow from then on is computed with a linear approximation, the derivative of the
 * motion along the computed path. So the bound as a whole is no proof: it leaves out products of
 * errors, a change from the side of a line to its end, and an obstacle that the computed path
 * misses by less than its error. At an impact it takes the growth of the most grazing hit within
 * the error.
 *
 * <p>Under {@linkplain SceneBuilder#gravity gravity} flights are parabolas, and all this holds as
 * well. The derivative then has the acceleration in it: a path that touches the obstacle later has
 * fallen for longer.
 *
 * <p>A small error can also lead to another obstacle. When the error exceeds 2^-10 radii, each
 * flight is checked: a circle that flies beside it by the bound, to the left or to the right, must
 * hit the same obstacle. Otherwise the bound becomes infinite. It also becomes infinite when it
 * exceeds the radius, or the length of a flight between two impacts; under gravity, when the error
 * of the time of an impact exceeds the duration of the flight before it. For a point particle the
 * radius of the smallest peg is used instead of its own: of the pegs that existed when the {@code
 * Uncertainty} was made. If a smaller peg is added, make a new one.
 *
 * <p>The harness compares the bound with runs in arbitrary precision, without gravity and with it
 * ({@code UncertaintyBoundTest}). There the error of a circle never exceeds the bound, as long as
 * the bound is below the radius. At half of the places or more the bound is below 100 times the
 * error.
 *
 * <h2>What is unknown</h2>
 *
 * <p>Restitution, {@link Response#HALT}, one-way lines, filters and sensors are taken into account.
 * The bound of a circle is infinite from the moment when
 *
 * <ul>
 *   <li>it is {@link Outcome#JAMMED}, {@link Outcome#STOPPED} or {@link Outcome#SETTLED}, or an
 *       impact leaves it at rest;
 *   <li>under gravity it comes in <a href="doc-files/rules.html#gravity">contact</a> with something
 *       else than one flat side;
 *   <li>it hits something that it overlaps;
 *   <li>an edit gives it another place or velocity, or adds it, or changes gravity;
 *   <li>the world was {@linkplain World#restore restored} to an earlier flight of it;
 *   <li>it made an impact after the world began another {@code Uncertainty};
 *   <li>any line or peg moves, or moved before;
 *   <li>a second circle comes that it may collide with.
 * </ul>
 *
 * <p>{@link #restart} begins anew with a circle, unless it slides, rests or is in contact.
 */
public final class Uncertainty {

  /** Wider errors, in radii, are checked for other impacts. */
  private static final double WIDE = 0x1p-10;

  private final World world;
  private final double length;

  /** The smallest radius of a peg at the beginning. */
  private double leastPeg = Double.POSITIVE_INFINITY;

  /** The ids of the circles that were there at the beginning or the last restart, ascending. */
  private int[] ids;

  /** The path of each of them; null for one that was never begun with. */
  private PathError[] paths;

  /** For questions about the paths beside that of a circle. */
  private final MovingCircle body = new MovingCircle();

  private final ErrorSum sum = new ErrorSum();

  /** Begins with the present state of a world: see {@link World#uncertainty}. */
  Uncertainty(World world, double length) {
    this.world = world;
    if (areColliding()) {
      throw Check.refused(
          "collide of a world of several circles", true, "false: circles that ignore each other");
    }
    if (!(length > 0)) {
      throw Check.refused("length", length, "more than 0");
    }
    this.length = length;
    ids = world.ids(Kind.CIRCLE);
    paths = new PathError[ids.length];
    for (int id : ids) {
      restart(id);
    }
    for (int id : world.ids(Kind.PEG)) {
      leastPeg = Math.min(leastPeg, world.peg(id).radius());
    }
  }

  /**
   * Takes the present state of a circle as exact and begins anew with it, as after an edit. Nothing
   * is known of a circle that slides or rests, also after this call. Call it when the circle flies.
   *
   * @param id the id of the circle
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public void restart(int id) {
    double x = world.x(id);
    int slot = world.ids.circle(id);
    PathError path =
        new PathError(
            sum,
            x,
            world.y(id),
            world.vx(id),
            world.vy(id),
            world.circles.gx(slot),
            world.circles.gy(slot),
            world.now(),
            length);
    if (world.circles.isSupported(slot)) {
      path.lose(); // it slides or rests
    }
    if (indexOf(id) < 0) {
      listCircles();
    }
    paths[indexOf(id)] = path;
  }

  /** Makes room for circles that were added, and forgets those that were removed. */
  private void listCircles() {
    int[] present = world.ids(Kind.CIRCLE);
    paths = Arrays.stream(present).mapToObj(this::path).toArray(PathError[]::new);
    ids = present;
  }

  /** The place of a circle in the list; negative if it is not there. */
  private int indexOf(int id) {
    return id < ids.length && ids[id] == id ? id : Arrays.binarySearch(ids, id);
  }

  private boolean areColliding() {
    return world.scene().collide() && world.registry.count() > 1;
  }

  /** Takes in the impacts of the world's last call, before any edit. */
  void update() {
    if (world.obstacles.areMoving() || areColliding()) {
      loseAll();
      return;
    }
    // The rows name circles by their slots: the log would look up the id of each, only to have its
    // slot looked up again.
    ImpactRows rows = world.rows;
    int size = rows.size();
    for (int row = 0; row < size; row++) {
      int slot = rows.circle(row);
      PathError path = followed(slot);
      if (path != null) {
        take(path, slot, rows, row);
      }
    }
    double now = world.now();
    CircleTable circles = world.circles;
    for (int row = 0; row < size; row++) {
      int slot = rows.circle(row);
      PathError path = followed(slot);
      if (path != null) {
        double vx = circles.vx(slot, now);
        double vy = circles.vy(slot, now);
        path.setVelocity(vx, vy, circles.gx(slot), circles.gy(slot), now);
      }
    }
  }

  private void loseAll() {
    for (PathError path : paths) {
      if (path != null) {
        path.lose();
      }
    }
  }

  /** The path of a circle; null for one that was never begun with. */
  private PathError path(int id) {
    int k = indexOf(id);
    return k < 0 ? null : paths[k];
  }

  /** The path of the circle in a slot; null if it is not followed. */
  private PathError followed(int slot) {
    PathError path = path(world.registry.id(slot));
    return path != null && path.isFollowed() ? path : null;
  }

  private void take(PathError path, int slot, ImpactRows rows, int row) {
    boolean isThere = world.registry.contains(slot);
    int outcome = rows.outcome(row);
    if (isThere && outcome == ImpactRows.SENSED) {
      return;
    }
    if (!isThere || (outcome != ImpactRows.BOUNCED && outcome != ImpactRows.HALTED)) {
      path.lose();
      return;
    }
    int code = Codes.of(rows.kind(row), rows.obstacle(row));
    double r = world.circles.radius(slot);
    double nx = rows.nx(row);
    double ny = rows.ny(row);
    double time = rows.time(row);
    if (isWide(path, r, time) && mayHitOther(path, slot, time, code)) {
      path.giveUp();
    }
    double e = world.circles.restitution(slot) * world.obstacles.restitution(code);
    double radius = rows.feature(row) == Part.SIDE ? Double.POSITIVE_INFINITY : r + radius(code);
    double x = rows.x(row) + r * nx;
    double y = rows.y(row) + r * ny;
    path.bounce(time, x, y, nx, ny, radius, e, code);
  }

  /** The radius of a peg; 0 for the end of a line. */
  private double radius(int code) {
    if (Codes.isLine(code)) {
      return 0;
    }
    ObstacleRows pegs = world.obstacles.of(code);
    return pegs.values[pegs.offset(code) + PegShape.RADIUS];
  }

  private boolean isWide(PathError path, double r, double time) {
    return path.isKnown() && path.width(time) > WIDE * size(r);
  }

  /** No obstacle fits between two circles that fly beside each other by less than this. */
  private double size(double r) {
    return r > 0 ? r : leastPeg; // a point particle: its world has no lines
  }

  /** Tells whether the true flight may hit another obstacle than the one at its end. */
  private boolean mayHitOther(PathError path, int slot, double time, int code) {
    double width = path.width(time);
    if (width > size(world.circles.radius(slot))) {
      return true;
    }
    for (int side = 0; side < path.sides(); side++) {
      if (isOther(first(path, slot, side, width, path.since(time), code), code)) {
        return true;
      }
    }
    return false;
  }

  /** Tells whether the true flight may have had an impact, other than its next one. */
  private boolean mayHaveHitOther(PathError path, int slot, double now) {
    double width = path.width(now);
    if (width > size(world.circles.radius(slot))) {
      return true;
    }
    int next = MovingCircle.NOTHING;
    for (int side = 0; side < path.sides(); side++) {
      int hit = first(path, slot, side, width, path.since(now), MovingCircle.NOTHING);
      if (hit != MovingCircle.NOTHING && next == MovingCircle.NOTHING) {
        next = first(path, slot, 0, 0, path.horizon(now), MovingCircle.NOTHING);
      }
      if (isOther(hit, next)) {
        return true;
      }
    }
    return false;
  }

  private static boolean isOther(int first, int code) {
    return first != MovingCircle.NOTHING && first != code;
  }

  /**
   * Finds the first obstacle that a circle hits, if it flies beside a path.
   *
   * @param side to which side, of those of the path
   * @param distance how far from it
   * @param duration how long, from the start of the flight
   * @param code an obstacle that is ignored, unless it is a wall; or NOTHING
   * @return its code, or NOTHING
   */
  private int first(
      PathError path, int slot, int side, double distance, double duration, int code) {
    path.load(body, side, distance);
    // A circle that falls can come back to what it hit: nothing is ignored.
    body.last = body.isFalling() ? MovingCircle.NOTHING : code;
    return world.engine.first(body, slot, duration);
  }

  /**
   * Returns a bound of the distance between the place that the world computes for a circle now and
   * its true place.
   *
   * @param id the id of the circle
   * @return the bound in units of the world, at least 0; infinite if nothing is known
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double bound(int id) {
    PathError path = checked(id);
    return path == null ? Double.POSITIVE_INFINITY : path.at(world.now());
  }

  /**
   * Returns the time at which the bound of a circle passed the length that was given at the
   * beginning.
   *
   * @param id the id of the circle
   * @return the time, at most now. It is the start of the flight in which the bound became
   *     infinite; infinite if the place is still known; 0 if the circle was added and never
   *     {@linkplain #restart begun} with
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double lostAt(int id) {
    PathError path = checked(id);
    return path == null ? 0 : path.lostAt(world.now());
  }

  /**
   * Returns the time at which the first of all circles passed the length: up to it all places are
   * known.
   *
   * @return the least of the times that {@link #lostAt(int)} gives: infinite if all places are
   *     known, 0 if a circle was added and never {@linkplain #restart begun} with
   */
  public double lostAt() {
    double first = Double.POSITIVE_INFINITY;
    for (int id : world.ids(Kind.CIRCLE)) {
      first = Math.min(first, lostAt(id));
    }
    return first;
  }

  /**
   * Returns the Lyapunov exponent of a circle's path so far: the mean rate at which the distance to
   * a path nearby grew, by its natural logarithm. It does not depend on the bound.
   *
   * <p>The path nearby starts beside the circle at the same velocity, infinitely near. After many
   * impacts this is the largest exponent of the circle's motion.
   *
   * <p>Without round obstacles and without gravity it is 0 if all impacts are elastic; the ends of
   * lines are round, too. Other restitutions change it: an oblique impact draws the two paths
   * together if its restitution is below 1, and apart if it is above.
   *
   * @param id the id of the circle
   * @return the exponent, in 1 / time unit; NaN at the start, and where the flights are unknown;
   *     {@code -infinity} after an impact of restitution 0, or with {@link Response#HALT}, against
   *     a side or a wall: nearby paths are then one
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double lyapunovExponent(int id) {
    PathError path = checked(id);
    return path == null ? Double.NaN : path.exponent(world.now());
  }

  /** The path of a circle, lost unless the world has it where the log led it. */
  private PathError checked(int id) {
    int slot = world.ids.circle(id);
    PathError path = path(id);
    if (path == null || !path.isFollowed()) {
      return path;
    }
    double now = world.now();
    CircleTable circles = world.circles;
    double vx = circles.vx(slot, now);
    double vy = circles.vy(slot, now);
    double gx = circles.gx(slot);
    double gy = circles.gy(slot);
    path.check(circles.x(slot, now), circles.y(slot, now), vx, vy, gx, gy, now);
    if (world.obstacles.areMoving()) {
      path.lose();
    }
    if (isWide(path, circles.radius(slot), now) && mayHaveHitOther(path, slot, now)) {
      path.giveUp();
    }
    return path;
  }
}
