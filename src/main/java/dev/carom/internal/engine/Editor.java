// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.OutlinePoints;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.SizeLimits;
import dev.carom.internal.state.TraitValues;
import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.sweep.Turn;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.KindNumber;
import dev.carom.internal.util.Refusal;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Edits a world between steps. All arguments are checked before anything changes, so a refused edit
 * leaves the world as it was.
 *
 * <p>An edited circle begins a new flight now. Its next impact is searched for when the next step
 * needs it: any number of edits between two steps cost one search.
 */
public final class Editor {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private final boolean collide;
  private final Engine engine;
  private final CircleTable circles;
  private final CircleRegistry registry;
  private final ObstacleTable obstacles;
  private final MovingCircle body = new MovingCircle();

  /** The limits of size, which edits change. */
  public final SizeLimits limits;

  /** The numbers of the obstacle that is added or moved, as its shape has them. */
  private final double[] numbers = new double[ObstacleTable.MOST_NUMBERS];

  /** Its motion, see {@link ObstacleMotions}. */
  private final double[] motion = new double[ObstacleMotions.SIZE];

  public Editor(SceneData scene, Engine engine, CircleRegistry registry) {
    collide = scene.collide;
    this.engine = engine;
    this.registry = registry;
    circles = engine.circles;
    obstacles = engine.staticScene.obstacles;
    limits = scene.limits();
  }

  // Circles.

  public void setVelocity(int slot, double vx, double vy, double now) {
    checkVelocity(Codes.circle(slot), vx, vy);
    MovingCircle m = restarted(slot, now);
    m.vx = vx;
    m.vy = vy;
    m.forget();
    engine.beginFlight(m);
  }

  public void setPosition(int slot, double x, double y, double now) {
    setCircle(slot, x, y, circles.radius(slot), true, now);
  }

  /** Gives a circle another place, within the doubles, and radius; it keeps its velocity. */
  public void setCircle(int slot, double x, double y, double radius, double now) {
    boolean moves =
        x != Coordinates.within(circles.x(slot, now))
            || y != Coordinates.within(circles.y(slot, now));
    setCircle(slot, x, y, radius, moves, now);
  }

  private void setCircle(int slot, double x, double y, double radius, boolean moves, double now) {
    try {
      if (moves) {
        checkPlace(x, y);
      }
      limits.checkRadius(radius, moves ? x : 0, moves ? y : 0, haveLines());
    } catch (IllegalArgumentException e) {
      throw named(e, Codes.circle(slot));
    }
    MovingCircle m = restarted(slot, now);
    m.radius = radius + 0.0; // 0 for -0
    if (moves) {
      m.x = x;
      m.y = y;
      m.forget();
      limits.keepPlace(x, y);
    } else if (m.isFalling() || obstacles.turns(m.last)) {
      m.last = MovingCircle.NOTHING; // the gap to that is no longer 0
    }
    engine.beginFlight(m);
    limits.keepRadius(radius);
  }

  public int addCircle(
      double x, double y, double radius, double vx, double vy, TraitValues traits, double now) {
    checkId(KindNumber.CIRCLE, registry.idLimit(), CircleRegistry.ID_LIMIT);
    try {
      checkPlace(x, y);
      limits.checkRadius(radius, x, y, haveLines());
      checkVelocity(vx, vy);
      traits.check(KindNumber.CIRCLE, 0);
    } catch (IllegalArgumentException e) {
      throw named(e, KindNumber.CIRCLE, registry.idLimit());
    }
    int slot = registry.add();
    traits.set(registry, slot);
    body.start(slot, x, y, radius + 0.0, vx, vy, traits.restitution()); // 0 for -0
    body.filter = traits.filter();
    body.t = now;
    body.tl = engine.tailOfEdit(body, now);
    engine.release(body);
    engine.beginFlight(body);
    limits.keepPlace(x, y);
    limits.keepRadius(radius);
    return registry.id(slot);
  }

  private void setMass(int slot, double m, double now) {
    boolean passes = (registry.mass(slot) == INFINITE) != (m == INFINITE);
    circles.load(slot, body);
    boolean held = collide && body.isMember();
    engine.noteContact(Codes.circle(slot), now);
    registry.setMass(slot, m);
    if (passes) {
      engine.leaveJamsOf(slot);
    }
    if (held || (passes && (collide || engine.gravity.acts()))) {
      restarted(slot, now).forget();
      engine.beginFlight(body);
    }
    engine.noteChange(slot, now);
  }

  /** Refuses to add an obstacle or a circle when all ids of its kind were given. */
  private static void checkId(int kind, int id, int limit) {
    if (id >= limit) {
      throw new IllegalStateException(
          "%s cannot be added: all ids below %s were given, and none is reused"
              .formatted(KindNumber.nameOf(kind, id), limit));
    }
  }

  private void checkPlace(double x, double y) {
    limits.checkCoordinate("x", x);
    limits.checkCoordinate("y", y);
  }

  private void checkVelocity(int code, double vx, double vy) {
    try {
      checkVelocity(vx, vy);
    } catch (IllegalArgumentException e) {
      throw named(e, code);
    }
  }

  private static void checkVelocity(double vx, double vy) {
    Check.finite("vx", vx);
    Check.finite("vy", vy);
  }

  /**
   * A refusal with the name of the obstacle or circle before its message. A new one is named by the
   * id that it would get.
   */
  private static IllegalArgumentException named(IllegalArgumentException e, int kind, int id) {
    return Refusal.of(kind == KindNumber.WALL ? "bounds" : KindNumber.nameOf(kind, id), e);
  }

  private IllegalArgumentException named(IllegalArgumentException e, int code) {
    return Codes.isCircle(code)
        ? named(e, KindNumber.CIRCLE, registry.id(Codes.slot(code)))
        : named(e, Codes.kind(code), obstacles.id(code));
  }

  /** Loads a circle at the start of a new flight, now, which nothing carries. */
  private MovingCircle restarted(int slot, double now) {
    circles.load(slot, body);
    restart(body, now);
    return body;
  }

  private void restart(MovingCircle m, double now) {
    engine.leaveContact(m, now);
    m.restart(now, engine.tailOfEdit(m, now), obstacles);
    engine.release(m);
  }

  /** Sets the acceleration of all circles of finite mass. */
  public void setGravity(double gx, double gy, double now) {
    Check.finite("gx", gx);
    Check.finite("gy", gy);
    List<MovingCircle> all = new ArrayList<>();
    for (int slot : registry.slots()) {
      MovingCircle m = new MovingCircle();
      circles.load(slot, m);
      engine.leaveContact(m, now);
      m.restart(now, engine.tailOfEdit(m, now), obstacles);
      all.add(m);
    }
    engine.setGravity(gx + 0.0, gy + 0.0); // 0 for -0
    for (MovingCircle m : all) {
      m.forget();
      engine.release(m);
      engine.beginFlight(m);
    }
  }

  // Obstacles.

  /** Adds an obstacle with the numbers of its kind, in the order of its shape. A peg has three. */
  public int add(
      int kind,
      double first,
      double second,
      double third,
      double fourth,
      TraitValues traits,
      double now) {
    set(first, second, third, fourth);
    ObstacleRows rows = obstacles.ofKind(kind);
    checkNew(rows, 1, () -> check(rows), traits, 0);
    int code = obstacles.add(kind, numbers);
    keepPlace(rows);
    return added(code, traits, now);
  }

  /** Adds an outline. */
  public int add(OutlinePoints outline, TraitValues traits, double now) {
    ObstacleRows rows = obstacles.lines;
    Runnable shape = () -> check(outline);
    checkNew(rows, outline.sides(), shape, traits, outline.outside());
    int code = obstacles.add(outline);
    keepPlace(outline);
    return added(code, traits, now);
  }

  private int added(int code, TraitValues traits, double now) {
    traits.set(obstacles, code);
    obstacles.codesOf(code).forEach(each -> engine.appeared(each, now));
    return obstacles.id(code);
  }

  /** Refuses an obstacle of so many rows whose shape or traits cannot be. */
  private void checkNew(
      ObstacleRows rows, int count, Runnable shape, TraitValues traits, int outside) {
    int id = rows.idLimit();
    checkId(rows.kind(), rows.count() + count - 1, Codes.limit(rows.kind()));
    try {
      shape.run();
      traits.check(rows.kind(), outside);
    } catch (IllegalArgumentException e) {
      throw named(e, rows.kind(), id);
    }
    if (rows.kind() == KindNumber.LINE) {
      checkNoPoint(id);
    }
  }

  private boolean haveLines() {
    return obstacles.lines.present().count() > 0;
  }

  /** Refuses a line where there is a circle of radius 0. */
  private void checkNoPoint(int line) {
    for (int slot : registry.slots()) {
      if (circles.radius(slot) == 0) {
        String name = "radius of " + KindNumber.nameOf(KindNumber.CIRCLE, registry.id(slot));
        throw named(
            Check.refused(name, 0.0, "more than 0, for a line to be added"), KindNumber.LINE, line);
      }
    }
  }

  /** Moves an obstacle, see {@link #add}. */
  public void move(int code, double first, double second, double third, double fourth, double now) {
    set(first, second, third, fourth);
    ObstacleRows rows = obstacles.of(code);
    check(rows, code);
    engine.forget(code);
    obstacles.move(code, numbers, now);
    keepPlace(rows);
    engine.appeared(code, now);
  }

  /** Gives an outline another place and shape, of as many sides. */
  public void move(int code, OutlinePoints outline, double now) {
    int sides = obstacles.endOf(code) - code;
    boolean isSolid = obstacles.outside(code) != 0;
    if (outline.sides() != sides || outline.isSolid() != isSolid) {
      throw Check.refused(
          "shape of " + KindNumber.nameOf(KindNumber.LINE, obstacles.id(code)),
          text(outline.sides(), outline.isSolid()),
          text(sides, isSolid) + ", as it is now");
    }
    try {
      check(outline);
    } catch (IllegalArgumentException e) {
      throw named(e, code);
    }
    obstacles.codesOf(code).forEach(engine::forget);
    for (int i = 0; i < sides; i++) {
      obstacles.move(code + i, outline.side(i), now);
      obstacles.setOutside(code + i, outline.outside());
    }
    keepPlace(outline);
    obstacles.codesOf(code).forEach(each -> engine.appeared(each, now));
  }

  private static String text(int sides, boolean isSolid) {
    return (isSolid ? "a solid outline of " : "an open outline of ") + sides + " sides";
  }

  private void set(double first, double second, double third, double fourth) {
    numbers[0] = first;
    numbers[1] = second;
    numbers[2] = third;
    numbers[3] = fourth;
  }

  /** Lets a line or a peg move with a velocity, from now on. */
  public void setObstacleVelocity(int code, double vx, double vy, double now) {
    checkVelocity(code, vx, vy);
    int end = obstacles.endOf(code);
    for (int each = code; each < end; each++) {
      engine.setVelocity(each, vx, vy, now);
    }
  }

  /** Lets a line or a peg go straight to a place, be there at a time, and then rest. */
  public void moveTo(int code, double x, double y, double arrival, double now) {
    try {
      checkPlace(x, y);
      checkArrival(arrival, now);
    } catch (IllegalArgumentException e) {
      throw named(e, code);
    }
    if (obstacles.goesTo(code, x, y, arrival)) {
      return;
    }
    obstacles.numbersAt(code, now, 0, numbers);
    double wayX = x - numbers[ObstacleShape.X];
    double wayY = y - numbers[ObstacleShape.Y];
    double ux = wayX / (arrival - now);
    double uy = wayY / (arrival - now);
    checkSpeed(Math.max(Math.abs(ux), Math.abs(uy)), code, arrival, now);
    double fromX = numbers[ObstacleShape.X];
    double fromY = numbers[ObstacleShape.Y];
    ObstacleRows rows = obstacles.of(code);
    int end = obstacles.endOf(code);
    for (int each = code; each < end; each++) {
      obstacles.numbersAt(each, now, 0, numbers);
      bring(rows, fromX, fromY, x, y);
      check(rows, code);
    }
    boolean rests = ux == 0 && uy == 0;
    for (int each = code; each < end; each++) {
      obstacles.numbersAt(each, now, 0, numbers);
      bring(rows, fromX, fromY, x, y);
      double until = rests ? INFINITE : arrival;
      ObstacleMotions.setStraight(motion, 0, each, ux, uy, now, until);
      engine.moveTo(each, numbers, motion, now);
      keepPlace(rows);
    }
  }

  private static void checkArrival(double arrival, double now) {
    if (!(arrival > now && arrival <= Double.MAX_VALUE)) {
      throw Check.refused("arrival", arrival, "a finite time after now, " + now);
    }
  }

  private void checkSpeed(double speed, int code, double arrival, double now) {
    if (!(speed <= Double.MAX_VALUE)) {
      throw named(
          Check.refused("arrival", arrival, "late enough after " + now + " for this way"), code);
    }
  }

  /** Turns a line or a peg about a pivot by an angle, to end at a time, and then rest. */
  public void turn(
      int code, double pivotX, double pivotY, double angle, double arrival, double now) {
    try {
      limits.checkCoordinate("pivotX", pivotX);
      limits.checkCoordinate("pivotY", pivotY);
      if (!(Math.abs(angle) <= Turn.QUARTER)) {
        throw Check.refused("angle", angle, "at most a quarter turn, +-" + Turn.QUARTER);
      }
      checkArrival(arrival, now);
    } catch (IllegalArgumentException e) {
      throw named(e, code);
    }
    ObstacleRows rows = obstacles.of(code);
    int end = obstacles.endOf(code);
    double x = StrictMath.cos(0.5 * angle);
    double y = StrictMath.sin(0.5 * angle);
    double way = 0;
    double farthest = 0;
    for (int each = code; each < end; each++) {
      obstacles.numbersAt(each, now, 0, numbers);
      way += turnNumbers(rows, pivotX, pivotY, x, y, true);
      check(rows, code);
      farthest = Math.max(farthest, extent(rows));
    }
    checkSpeed(2 * way / (arrival - now), code, arrival, now);
    if (way == 0) {
      ObstacleMotions.setStraight(motion, 0, code, 0, 0, now, INFINITE);
    } else {
      ObstacleMotions.setTurn(motion, pivotX, pivotY, angle, now, arrival);
    }
    for (int each = code; each < end; each++) {
      obstacles.numbersAt(each, now, 0, numbers);
      turnNumbers(rows, pivotX, pivotY, x, y, false);
      engine.moveTo(each, numbers, motion, now);
    }
    limits.keepPlace(farthest, 0);
  }

  /**
   * Turns the places of the numbers about a pivot, and returns how far they move, as a sum.
   *
   * @param x the cosine of half the angle
   * @param y its sine
   * @param toFarthest whether to go no further than to the largest coordinates on the way
   */
  private double turnNumbers(
      ObstacleRows rows, double pivotX, double pivotY, double x, double y, boolean toFarthest) {
    double way = 0;
    for (int k = 0; k < rows.shape.coordinates; k += 2) {
      double fromX = numbers[k];
      double fromY = numbers[k + 1];
      ObstacleMotions.turn(pivotX, pivotY, x, y, numbers, k);
      double toX = numbers[k];
      double toY = numbers[k + 1];
      way += Math.abs(toX - fromX) + Math.abs(toY - fromY);
      if (toFarthest) {
        double reach = StrictMath.hypot(fromX - pivotX, fromY - pivotY);
        numbers[k] = farthest(fromX, toX, pivotX, fromY - pivotY, toY - pivotY, reach);
        numbers[k + 1] = farthest(fromY, toY, pivotY, fromX - pivotX, toX - pivotX, reach);
      }
    }
    return way;
  }

  /**
   * The largest coordinate, or the least if that is larger by its absolute value, on an arc of at
   * most a quarter turn that ends at a place. It lies between its ends, unless the arc crosses the
   * axis through the pivot.
   *
   * @param across the other coordinate at the start of the arc, as seen from the pivot
   * @param toAcross the same at the end
   */
  private static double farthest(
      double from, double to, double pivot, double across, double toAcross, double reach) {
    boolean crosses = across > 0 != toAcross > 0;
    double most = crosses ? pivot + Math.copySign(reach, from - pivot + (to - pivot)) : to;
    return Math.abs(most) > Math.abs(to) ? most : to;
  }

  /**
   * Moves the places of the numbers by the way from one place to another: what is at the first one
   * comes to the other to the bit, and what is equal stays so.
   */
  private void bring(ObstacleRows rows, double fromX, double fromY, double toX, double toY) {
    for (int k = 0; k < rows.shape.coordinates; k += 2) {
      numbers[k + ObstacleShape.X] = toX + (numbers[k + ObstacleShape.X] - fromX);
      numbers[k + ObstacleShape.Y] = toY + (numbers[k + ObstacleShape.Y] - fromY);
    }
  }

  private void check(ObstacleRows rows, int code) {
    try {
      check(rows);
    } catch (IllegalArgumentException e) {
      throw named(e, code);
    }
  }

  private void check(ObstacleRows rows) {
    for (int i = 0; i < rows.shape.coordinates; i++) {
      limits.checkCoordinate(rows.shape.numbers.get(i), numbers[i]);
    }
    rows.shape.checkRadius(numbers);
  }

  private void check(OutlinePoints outline) {
    for (int i = 0; i < outline.count(); i++) {
      limits.checkCoordinate("points[" + i + "].x", outline.x(i));
      limits.checkCoordinate("points[" + i + "].y", outline.y(i));
    }
  }

  private void keepPlace(OutlinePoints outline) {
    for (int i = 0; i < outline.count(); i++) {
      limits.keepPlace(outline.x(i), outline.y(i));
    }
  }

  private void keepPlace(ObstacleRows rows) {
    limits.keepPlace(extent(rows), 0);
  }

  private double extent(ObstacleRows rows) {
    double extent = 0;
    for (int i = 0; i < rows.shape.coordinates; i++) {
      extent = Math.max(extent, Math.abs(numbers[i]));
    }
    return extent;
  }

  // Obstacles and circles.

  public void remove(int code, double now) {
    if (Codes.isCircle(code)) {
      circles.load(Codes.slot(code), body);
      engine.leaveContact(body, now);
      engine.noteContact(code, now);
      registry.remove(Codes.slot(code));
      engine.remove(Codes.slot(code));
    } else {
      int[] all = obstacles.codesOf(code).toArray();
      for (int each : all) {
        engine.forget(each);
        obstacles.remove(each);
        engine.changed(each, now);
      }
    }
  }

  /** Sets the traits of a thing, those of a wall for all of them; only what differs is an edit. */
  public void setTraits(int code, TraitValues traits, double now) {
    check(traits, code);
    if (Codes.isCircle(code)) {
      setTraitsOfCircle(Codes.slot(code), traits, now);
    } else {
      setTraitsOfObstacle(code, traits, now);
    }
  }

  private void check(TraitValues traits, int code) {
    try {
      traits.check(Codes.kind(code), obstacles.outside(code));
    } catch (IllegalArgumentException e) {
      throw named(e, code);
    }
  }

  /** The old flight ends where its own filter led it. */
  private void setTraitsOfCircle(int slot, TraitValues traits, double now) {
    if (traits.mass() != registry.mass(slot)) {
      setMass(slot, traits.mass(), now);
    }
    if (traits.restitution() != circles.restitution(slot)) {
      circles.setRestitution(slot, traits.restitution());
      engine.noteContact(Codes.circle(slot), now);
      engine.noteChange(slot, now);
    }
    boolean meetsOthers = traits.filter() != registry.filter(slot);
    if (meetsOthers || traits.flags() != registry.traits(slot)) {
      MovingCircle m = restarted(slot, now);
      traits.set(registry, slot);
      m.filter = traits.filter();
      if (meetsOthers) {
        m.forget();
      }
      engine.beginFlight(m);
    }
  }

  /** Walls have their traits together. */
  private void setTraitsOfObstacle(int code, TraitValues traits, double now) {
    int[] all =
        (Codes.isWall(code) ? IntStream.range(0, Codes.WALLS) : obstacles.codesOf(code)).toArray();
    if (traits.restitution() != obstacles.givenRestitution(code)) {
      for (int each : all) {
        setRestitution(each, traits.restitution(), now);
      }
    }
    long before = obstacles.filter(code);
    if (traits.filter() == before && traits.areFlagsOf(obstacles, code)) {
      return;
    }
    if (Codes.isWall(code)) {
      List<MovingCircle> changed = restartedAtWalls(before, traits.filter(), now);
      traits.set(obstacles, code);
      for (int each : all) {
        engine.noteContact(each, now);
      }
      changed.forEach(engine::beginFlight);
    } else {
      for (int each : all) {
        engine.forget(each);
      }
      added(code, traits, now);
    }
  }

  private void setRestitution(int code, double e, double now) {
    obstacles.setRestitution(code, e);
    engine.noteContact(code, now);
    engine.noteObstacle(code, now);
  }

  /** Restarts the circles that can meet walls of one filter, but not of the other. */
  private List<MovingCircle> restartedAtWalls(long before, long after, double now) {
    List<MovingCircle> changed = new ArrayList<>();
    for (int slot : registry.slots()) {
      long its = registry.filter(slot);
      if (FilterBits.meet(its, before) != FilterBits.meet(its, after)) {
        MovingCircle m = new MovingCircle();
        circles.load(slot, m);
        restart(m, now);
        m.forget();
        changed.add(m);
      }
    }
    return changed;
  }
}
