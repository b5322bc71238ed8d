// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.engine.CollidingEngine;
import dev.carom.internal.engine.Editor;
import dev.carom.internal.engine.Engine;
import dev.carom.internal.engine.Handles;
import dev.carom.internal.engine.IndependentEngine;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.TimelineRecorder;
import dev.carom.internal.state.WorldState;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.KindNumber;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * A {@code World} moves the circles of a {@link Scene}. They fly straight, or fall, bounce off
 * lines, pegs and walls, and collide with each other or ignore each other, as the scene says.
 *
 * <pre>{@code
 * World world =
 *     new World(Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 10, 8, 0).build());
 * world.step(6);
 * ImpactLog impacts = world.impacts();
 * for (int i = 0; i < impacts.size(); i++) {
 *   System.out.println(impacts.kind(i) + " at " + impacts.time(i)); // WALL at 5.0
 * }
 * System.out.println(world.x(0) + " at " + world.now()); // 82.0 at 6.0
 * }</pre>
 *
 * <ol>
 *   <li><b>No impact is lost.</b> A step resolves all impacts in it, each at its own moment, at any
 *       speed. Positions are never corrected. Without gravity there is no threshold but at things
 *       that turn, and nothing jitters. With gravity, very low hops end, and heaps come to rest.
 *   <li><b>Steps do not matter.</b> However a run to the same time is cut into steps, it gives the
 *       same bits. The same run gives the same bits on every Java virtual machine.
 *   <li><b>Every call ends.</b> A step throws {@link UnfinishedException} if its budget of work is
 *       spent, and the next one goes on. A circle that would bounce at one place without end stops
 *       bouncing there, and the log says so. Some rare scenes still do not get on: <a
 *       href="doc-files/rules.html#unfinished">what to do</a>.
 * </ol>
 *
 * <p>A step goes on for a time span ({@link #step step}), to a time ({@link #advanceTo(double)
 * advanceTo}) or to the next impact ({@link #advanceToImpact advanceToImpact}). Between steps a
 * world can be edited, asked as a {@link Resolver} (cast, trace, nearest, overlapping), saved
 * ({@link #snapshot}) and recorded ({@link #record record}). It can tell how far its places are
 * right ({@link #uncertainty uncertainty}). A world belongs to one thread at a time. Different
 * worlds share nothing that changes.
 *
 * <p>See <a href="doc-files/rules.html">Rules and limits</a>: contact, edits, questions, budget,
 * stuck circles, moving obstacles, gravity, infinite mass, accuracy. <a
 * href="doc-files/recipes.html">Recipes</a>: frames and netcode, a paddle, a flipper, a piston,
 * pockets, balls that fall, teams, an aiming line, a lidar, periodic cells, Lyapunov exponents.
 */
public final class World implements Resolver {

  /** A new log has room for one row per circle, but for at least and at most so many. */
  private static final int LOG_LEAST = 16;

  private static final int LOG_MOST = 4096;

  private final Scene scene;
  final ImpactRows rows;
  private final ImpactLog log;
  final CircleRegistry registry;
  final Handles ids;
  final Engine engine;
  final CircleTable circles;
  final ObstacleTable obstacles;
  private final Editor editor;
  private final WorldQueries queries;
  final Questions questions;
  private double now;

  /** The time at which calls of {@link #advanceToImpact} share a budget, NaN for none. */
  private double sharedAt = Double.NaN;

  /** The work of all calls with which the shared budget is spent. */
  private long sharedLimit;

  /** Null unless flights are recorded. */
  private TimelineRecorder recorder;

  /** Its edits; null with it. */
  private RecordedEdits edits;

  /** Null unless errors are estimated. */
  private Uncertainty uncertainty;

  /**
   * Sets a scene in motion, at time 0.
   *
   * @param scene the scene at time 0
   */
  public World(Scene scene) {
    this(scene, EngineOptions.CHOSEN);
  }

  World(Scene scene, EngineOptions options) {
    this.scene = Check.notNull("scene", scene);
    SceneData data = scene.data;
    registry = new CircleRegistry(data, options.slack());
    rows = new ImpactRows(Math.max(LOG_LEAST, Math.min(LOG_MOST, data.circleCount())));
    log = new ImpactLog(rows, registry::id);
    engine =
        data.collide
            ? new CollidingEngine(data, registry, options, rows)
            : new IndependentEngine(data, registry, options, rows);
    circles = engine.circles;
    obstacles = engine.staticScene.obstacles;
    rows.of(obstacles);
    ids = new Handles(registry, obstacles);
    editor = new Editor(data, engine, registry);
    queries = new WorldQueries(engine, registry);
    questions = new Questions(engine.staticScene.index, this::now, circles, registry, data.collide);
  }

  /**
   * Returns the scene from which this world started.
   *
   * @return the scene
   */
  public Scene scene() {
    return scene;
  }

  /**
   * Returns the time at which the world stands.
   *
   * @return at least 0
   */
  public double now() {
    return now;
  }

  /**
   * Advances the world by a time span, to the double nearest to {@code now() + dt}.
   *
   * <p>All impacts until then are resolved, and {@link #impacts} lists them. Programs that count
   * frames call {@link #advanceTo(double) advanceTo} instead, whose times do not drift: see <a
   * href="doc-files/recipes.html#frames">frames and netcode</a>.
   *
   * @param dt the time span. It is 0, or large enough to move the clock: more than about 1e-16
   *     times {@link #now}
   * @throws UnfinishedException if the usual budget of work is spent before, as by {@link
   *     #advanceTo(double) advanceTo}
   * @throws IllegalArgumentException if dt is NaN or negative, or the time it leads to is infinite;
   *     or if dt is more than 0 and that time is still now: a loop of such steps would never end
   */
  public void step(double dt) {
    if (!(dt >= 0 && now + dt <= Double.MAX_VALUE)) {
      throw Check.refused("dt", dt, "at least 0, and a finite time after " + now);
    }
    if (now + dt == now && dt > 0) {
      throw Check.refused("dt", dt, "0, or enough to move the clock on from " + now);
    }
    advance(now + dt);
  }

  /**
   * Advances the world to a given time, exactly.
   *
   * <p>All impacts until then are resolved, and {@link #impacts} lists them. The budget of work is
   * 2,000,000 events and 1,000 more for each circle: few scenes ever spend it in a call.
   *
   * @param t the time, finite and at least {@link #now()}
   * @throws UnfinishedException if the budget is spent before. Nothing is dropped: the world stands
   *     at an earlier time, or at the requested one with impacts still to come. The log has the
   *     impacts so far, and another call goes on: see <a
   *     href="doc-files/rules.html#unfinished">unfinished steps</a>
   * @throws IllegalArgumentException if t is NaN, infinite, or earlier than now
   */
  public void advanceTo(double t) {
    checkGoal(t);
    advance(t + 0.0); // 0 for -0
  }

  /**
   * Advances the world towards a given time, with a bounded amount of work. It is for programs that
   * would rather be late than slow: call it again, with the same time or with a later one, to go
   * on.
   *
   * <p>The bound decides how far one call comes. However a run is cut by it, all bits are the same.
   * {@link #impacts} lists the impacts of this call. A world stands still at the time that it
   * reached, at an earlier time or at the requested one with impacts still to come.
   *
   * @param t the time, finite and at least {@link #now()}
   * @param work how many impacts and other events may be resolved, at least 1: see <a
   *     href="doc-files/rules.html#unfinished">unfinished steps</a>. Circles that ignore each other
   *     share it; each makes at least one impact
   * @return true if all impacts until that time are resolved, false if the work was done before
   * @throws IllegalArgumentException if t is NaN, infinite, or earlier than now, or work is less
   *     than 1
   */
  public boolean advanceTo(double t, long work) {
    checkGoal(t);
    if (work < 1) {
      throw Check.refused("work", work, "at least 1");
    }
    begin();
    finish(engine.advance(t + 0.0, work, false));
    return !engine.unfinished;
  }

  private void advance(double t) {
    begin();
    finish(engine.advance(t, engine.usualWork(), false));
    if (engine.unfinished) {
      throw unfinished(t);
    }
  }

  /**
   * Advances the world to the next impact, or to a given time if that is first.
   *
   * <p>With it a program acts at the moment of an impact: it turns a paddle, opens a portal, plays
   * a sound. Calls in a row give the same impacts, to the bit, as one call of {@link
   * #advanceTo(double) advanceTo}. A contact that a sensor reports counts as an impact.
   *
   * <pre>{@code
   * World world =
   *     new World(Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 10, 8, 0).build());
   * while (world.advanceToImpact(10)) {
   *   System.out.println(world.impacts().kind(0) + " at " + world.now()); // WALL at 5.0
   * }
   * }</pre>
   *
   * <p>The clock of a world is finer than a double. The world stops at the first double that is not
   * before the impact: the time in the log, or the double after it. So edits take effect after the
   * impact. The log holds all impacts up to there, sometimes several at one time.
   *
   * @param t the latest time, finite and at least {@link #now()}
   * @return true at an impact, false at the time t without one
   * @throws UnfinishedException if the usual budget of work is spent before, as by {@link
   *     #advanceTo(double) advanceTo}. Calls that do not move the clock share one budget, so a loop
   *     whose edits cause impacts without end is found, too
   * @throws IllegalArgumentException if t is NaN, infinite, or earlier than now
   */
  public boolean advanceToImpact(double t) {
    checkGoal(t);
    if (sharedAt != now) {
      sharedAt = now;
      sharedLimit = engine.spent + engine.usualWork();
    }
    begin();
    do { // a tick or the end of a slide is no impact
      finish(engine.advance(t + 0.0, sharedLimit - engine.spent, true));
    } while (rows.size() == 0 && now < t && !isSharedSpent());
    if (isSharedSpent()) {
      sharedAt = Double.NaN;
      throw unfinished(t);
    }
    return rows.size() > 0;
  }

  private boolean isSharedSpent() {
    return engine.unfinished || engine.spent >= sharedLimit;
  }

  private void checkGoal(double t) {
    if (!(t >= now && t <= Double.MAX_VALUE)) {
      throw Check.refused("t", t, "a finite time, at least now, " + now);
    }
  }

  private UnfinishedException unfinished(double t) {
    return new UnfinishedException(now, t, registry.id(engine.spender()));
  }

  private void begin() {
    rows.clear();
    questions.forget();
    if (registry.isSparse()) {
      engine.compact(now);
    }
    if (recorder != null) {
      engine.standBefore(now);
    }
  }

  private void finish(double reached) {
    rows.sort();
    now = reached;
    if (recorder != null) {
      recorder.advance(now);
      engine.standAfter(now);
    }
    if (uncertainty != null) {
      uncertainty.update();
    }
  }

  /**
   * Returns the log of the last step, with a row for each impact. Edits do not change it.
   *
   * @return always the same log; its rows are valid until the next step or {@link #restore restore}
   */
  public ImpactLog impacts() {
    return log;
  }

  /**
   * Returns the number of things of a kind. Their ids are 0 to this number less 1 until one is
   * removed; from then on {@link #ids ids} lists them.
   *
   * @param kind their kind
   * @return at least 0
   */
  public int count(Kind kind) {
    int number = number(kind);
    return kind == Kind.CIRCLE ? registry.count() : obstacles.count(number);
  }

  /**
   * Returns the x coordinate of a circle's centre now.
   *
   * @param id the id of the circle
   * @return the coordinate; infinite once the circle has left the range of doubles
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double x(int id) {
    return circles.x(ids.circle(id), now);
  }

  /**
   * Returns the y coordinate of a circle's centre now.
   *
   * @param id the id of the circle
   * @return the coordinate; infinite once the circle has left the range of doubles
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double y(int id) {
    return circles.y(ids.circle(id), now);
  }

  /**
   * Returns the x component of a circle's velocity now.
   *
   * @param id the id of the circle
   * @return the component; the largest double if it is beyond their range
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double vx(int id) {
    return circles.vx(ids.circle(id), now);
  }

  /**
   * Returns the y component of a circle's velocity now.
   *
   * @param id the id of the circle
   * @return the component; the largest double if it is beyond their range
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double vy(int id) {
    return circles.vy(ids.circle(id), now);
  }

  /**
   * Returns the radius of a circle.
   *
   * @param id the id of the circle
   * @return at least 0; 0 for a point particle
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double radius(int id) {
    return circles.radius(ids.circle(id));
  }

  /**
   * Returns a line as it is now.
   *
   * @param id the id of the line
   * @return the line; a coordinate that moved beyond the range of doubles is the largest one
   * @throws IndexOutOfBoundsException if there is no such line
   * @throws IllegalArgumentException if it is an {@link Outline}: {@link #shape shape} returns it
   */
  public Line line(int id) {
    int code = code(Kind.LINE, id);
    int sides = obstacles.endOf(code) - code;
    if (sides > 1) {
      String outline = "an outline of " + sides + " sides";
      throw Check.refused(Kind.LINE.nameOf(id), outline, "a single line; shape tells of both");
    }
    return PublicRecords.line(obstacles, code, now);
  }

  /**
   * Returns a peg as it is now.
   *
   * @param id the id of the peg
   * @return the peg; a coordinate that moved beyond the range of doubles is the largest one
   * @throws IndexOutOfBoundsException if there is no such peg
   */
  public Circle peg(int id) {
    return PublicRecords.peg(obstacles, code(Kind.PEG, id), now);
  }

  /**
   * Returns a circle or an obstacle as it is now.
   *
   * @param kind its kind
   * @param id its id
   * @return a {@link Line} for a line, an {@link Outline} for an outline, a {@link Circle} for a
   *     peg or a circle, the {@link Bounds} for a wall. A coordinate that moved beyond the range of
   *     doubles is the largest one. Of an outline that moved so far away that its points round to
   *     ones that make none, it is the first side, a {@link Line}
   * @throws IndexOutOfBoundsException if there is no such thing
   */
  public Obstacle shape(Kind kind, int id) {
    return queries.shape(code(kind, id), now);
  }

  /**
   * Returns the velocity of a circle or an obstacle now.
   *
   * @param kind its kind
   * @param id its id
   * @return the velocity; (0, 0) for a wall, and for a line or a peg that does not move. Of one
   *     that {@linkplain #turn turns} it is the velocity of the start of a line, the first point of
   *     an outline or the centre of a peg: (0, 0) if that is the pivot
   * @throws IndexOutOfBoundsException if there is no such thing
   */
  public Vec2 velocity(Kind kind, int id) {
    return queries.velocity(code(kind, id), now);
  }

  /**
   * Lists what a circle is in contact with under gravity: what holds, carries or presses it, also
   * while it slides or rests. So a program can ask whether something stands on the ground:
   *
   * <pre>{@code
   * Scene scene = Scene.builder().gravity(0, -10).bounds(0, 0, 9, 9).circle(4, 1, 1, 0, 0).build();
   * World world = new World(scene);
   * world.advanceTo(1);
   * System.out.println(world.contacts(0).stream().anyMatch(it -> it.ny() > 0.5)); // true
   * }</pre>
   *
   * @param circle the id of the circle
   * @return the things, by kind and id, sensors never; an immutable list, empty while the circle
   *     flies or bounces, and without gravity but for what turns
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public List<Contact> contacts(int circle) {
    return questions.contacts(ids.circle(circle));
  }

  /**
   * Returns a circle with its motion now, its acceleration included: a circle to start casts and
   * traces from.
   *
   * @param circle the id of the circle
   * @return the circle; of one in contact under gravity its motion up to the next tick
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public SweptCircle flight(int circle) {
    return queries.flight(ids.circle(circle), now);
  }

  /**
   * Tells whether a circle rests under gravity.
   *
   * <p>It stands still, or moves with what carries it, until it would move, something hits it, its
   * load doubles, or an edit frees it. This holds on level ground, in a heap, in a corner, and
   * under something that passes over it. A circle that slides or rolls does not rest. Over a line
   * that moves sideways it slides, even where it stands still. After an edit of what carries it, it
   * rests again some ticks later. A resting circle makes no impacts and costs nothing, see <a
   * href="doc-files/rules.html#gravity">Gravity</a>.
   *
   * @param id the id of the circle
   * @return true if it rests; never without gravity
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public boolean isResting(int id) {
    return queries.isResting(ids.circle(id), now);
  }

  /**
   * Returns the acceleration of circles in free flight now.
   *
   * @return the acceleration; (0, 0) without gravity
   */
  public Vec2 gravity() {
    return new Vec2(engine.gravity.x, engine.gravity.y);
  }

  /**
   * Returns the traits of a circle or an obstacle now: its restitution, mass, response and filter,
   * and whether it is a one-way line.
   *
   * <p>A world keeps some 64 of these records and returns one of them again, so that {@code
   * world.traits(kind, id).mass()} in a loop allocates nothing.
   *
   * @param kind its kind; the four walls share their traits
   * @param id its id
   * @return the traits; {@link Traits#DEFAULT} unless others were set
   * @throws IndexOutOfBoundsException if there is no such thing
   */
  public Traits traits(Kind kind, int id) {
    return queries.traits(code(kind, id));
  }

  /**
   * Tells whether a circle or an obstacle exists.
   *
   * <p>The ids of a kind begin at 0, with the things of the scene in its order. Each thing that is
   * added gets the next id. The id of a removed thing is not used again. A world can give
   * 268,435,452 ids of lines, 268,435,456 of pegs and 1,610,612,736 of circles: some 300 days of 60
   * new circles a second.
   *
   * @param kind its kind; walls have the ids 0..3
   * @param id any number
   * @return false if it was removed, or never existed
   */
  public boolean contains(Kind kind, int id) {
    return ids.contains(number(kind), id);
  }

  /**
   * Returns the ids of all things of a kind.
   *
   * @param kind a kind
   * @return the ids of those that exist now, ascending, in a new array
   */
  public int[] ids(Kind kind) {
    Check.notNull("kind", kind);
    return queries.ids(kind);
  }

  /**
   * Returns one more than the largest id that was ever given to a thing of a kind.
   *
   * @param kind a kind
   * @return the limit: every thing of that kind has, or had, a smaller id
   */
  public int idLimit(Kind kind) {
    return ids.end(number(kind));
  }

  /** Returns the code of a thing that exists; any other id is refused. */
  private int code(Kind kind, int id) {
    return ids.checked(number(kind), id);
  }

  /** Returns the code of a thing that exists and is no wall. */
  private int movable(Kind kind, int id) {
    int code = code(kind, id);
    if (kind == Kind.WALL) {
      throw Check.refused("kind", kind, "LINE, PEG or CIRCLE: walls stay");
    }
    return code;
  }

  private static int number(Kind kind) {
    return Check.notNull("kind", kind).ordinal();
  }

  // Questions.

  @Override
  public Resolver withFilter(Filter filter) {
    return questions.withFilter(filter);
  }

  @Override
  public Optional<Impact> cast(SweptCircle circle, double maxTime) {
    return questions.cast(circle, maxTime);
  }

  @Override
  public void cast(Casts casts, double maxTime) {
    questions.cast(casts, maxTime);
  }

  @Override
  public Trajectory trace(SweptCircle circle, double restitution, double duration, int impacts) {
    return questions.trace(circle, restitution, duration, impacts);
  }

  /**
   * Follows the path that a circle of this world would take from now on with a given velocity:
   * under gravity, with its own radius, restitution, mass and filter. It is not stopped by itself.
   * The world does not change.
   *
   * <p>Otherwise as {@link #trace(SweptCircle, double, double, int) trace}: the path ends at a
   * time, at its impact of a given number, or, if circles collide, at the first circle in the way,
   * whose present motion goes on. It lists the sensors that it passes. See <a
   * href="doc-files/recipes.html#aiming">an aiming line</a>.
   *
   * @param circle the id of the circle
   * @param vx the x component of its velocity at the start, finite
   * @param vy the y component of its velocity at the start, finite
   * @param duration how long to follow it, finite and at least 0
   * @param impacts the number of the impact at which the path ends, at least 0: 1 is the first one,
   *     and 0 the start
   * @return its flights and impacts, with times counted from now
   * @throws IndexOutOfBoundsException if there is no such circle
   * @throws IllegalArgumentException if a component or the duration is NaN or infinite, or the
   *     duration or the number of impacts negative
   */
  public Trajectory trace(int circle, double vx, double vy, double duration, int impacts) {
    return questions.trace(ids.circle(circle), vx, vy, engine.gravity, duration, impacts);
  }

  @Override
  public Optional<Nearest> nearest(double x, double y, Kind... kinds) {
    return questions.nearest(x, y, kinds);
  }

  @Override
  public int[] overlapping(Kind kind, Circle disk) {
    return questions.overlapping(kind, disk);
  }

  @Override
  public int[] overlapping(Kind kind, Bounds box) {
    return questions.overlapping(kind, box);
  }

  // Edits.

  /**
   * Sets gravity, from now on: the acceleration of all circles of finite mass. Circles that slide
   * or rest are set free, and may settle again.
   *
   * @param gx the x component, finite
   * @param gy the y component, finite
   * @throws IllegalArgumentException if a component is NaN or infinite
   * @see SceneBuilder#gravity
   */
  public void setGravity(double gx, double gy) {
    edit().setGravity(gx, gy, now);
    if (edits != null) {
      edits.add(world -> world.setGravity(gx, gy));
    }
  }

  /** Returns the editor; questions forget what they know. */
  private Editor edit() {
    questions.changed();
    if (recorder != null) {
      recorder.noteEdit(engine.unfinished);
    }
    return editor;
  }

  /**
   * Sets the velocity of a circle, from now on. If the circle now approaches something that it
   * touches, it bounces at the very start of the next step. So a loop of {@link #advanceToImpact
   * advanceToImpact} that sets such a velocity at each impact never ends.
   *
   * @param id the id of the circle
   * @param vx the x component, finite
   * @param vy the y component, finite
   * @throws IndexOutOfBoundsException if there is no such circle
   * @throws IllegalArgumentException if a component is NaN or infinite
   */
  public void setVelocity(int id, double vx, double vy) {
    edit().setVelocity(ids.circle(id), vx, vy, now);
    if (edits != null) {
      edits.add(world -> world.setVelocity(id, vx, vy));
    }
  }

  /**
   * Moves a circle to another place at once. It hits nothing on the way.
   *
   * <p>If it overlaps something at the new place, it is not pushed out. If it approaches that
   * thing, it bounces at the very start of the next step; otherwise it flies on. {@link
   * Circle#separation Circle.separation} tells by how much to move it to be clear.
   *
   * @param id the id of the circle
   * @param x the x coordinate of the centre, finite
   * @param y the y coordinate of the centre, finite
   * @throws IndexOutOfBoundsException if there is no such circle
   * @throws IllegalArgumentException if a coordinate is NaN or infinite, or so large that 2^10 ulps
   *     of it exceed the smallest radius above 0 that a circle of this world ever had
   */
  public void setPosition(int id, double x, double y) {
    edit().setPosition(ids.circle(id), x, y, now);
    if (edits != null) {
      edits.add(world -> world.setPosition(id, x, y));
    }
  }

  /**
   * Gives a circle, a line, an outline or a peg another place and shape at once. It teleports: it
   * pushes nothing and hits nothing on the way.
   *
   * <pre>{@code
   * World world = new World(Scene.builder().peg(60, 30, 5).circle(20, 20, 5, 1, 0).build());
   * world.setShape(Kind.PEG, 0, new Circle(80, 20, 5));
   * world.setShape(Kind.CIRCLE, 0, new Circle(world.x(0), world.y(0), 3)); // only the radius
   * System.out.println(world.peg(0).x() + ", " + world.radius(0)); // 80.0, 3.0
   * }</pre>
   *
   * <p>A circle that overlaps the thing then bounces if the two approach each other, and flies on
   * otherwise. To push circles, {@linkplain #setVelocity(Kind, int, double, double) set a
   * velocity}. What moves goes on from the new place.
   *
   * <p>A circle keeps its velocity, and begins a new flight. If its centre stays where it is now,
   * it cannot hit again what it hit last; else it can.
   *
   * @param kind its kind
   * @param id its id
   * @param shape a {@link Line} for a line, an {@link Outline} for an outline: solid or not as it
   *     is now, and with as many sides; a {@link Circle} for a peg or a circle
   * @throws IndexOutOfBoundsException if there is no such thing
   * @throws IllegalArgumentException if the kind is {@link Kind#WALL}, the shape one of another
   *     kind, or a coordinate or a radius refused, as by {@link #addLine addLine}, {@link #addPeg
   *     addPeg} and {@link #addCircle addCircle}
   */
  public void setShape(Kind kind, int id, Obstacle shape) {
    int code = movable(kind, id);
    Check.notNull("shape", shape);
    boolean isOutline = kind == Kind.LINE && obstacles.isOutline(code);
    if (kind == Kind.LINE && shape instanceof Outline outline) {
      edit().move(code, outline.values(), now);
    } else if (kind == Kind.LINE && !isOutline && shape instanceof Line line) {
      edit().move(code, line.ax(), line.ay(), line.bx(), line.by(), now);
    } else if (kind == Kind.PEG && shape instanceof Circle peg) {
      edit().move(code, peg.x(), peg.y(), peg.radius(), 0, now);
    } else if (kind == Kind.CIRCLE && shape instanceof Circle circle) {
      edit().setCircle(Codes.slot(code), circle.x(), circle.y(), circle.radius(), now);
    } else {
      String expected = isOutline ? "an Outline" : kind == Kind.LINE ? "a Line" : "a Circle";
      throw Check.refused("shape of " + kind.nameOf(id), shape, expected);
    }
    if (edits != null) {
      edits.add(world -> world.setShape(kind, id, shape));
    }
  }

  /**
   * Sets the velocity of a line, a peg or a circle, from now on.
   *
   * <p>A line or a peg then moves with this velocity until it is set again. Nothing deflects it: it
   * passes through bounds and other obstacles, and pushes the circles in its way. Their velocity
   * along the normal, relative to it, is reversed and scaled by the restitution. A circle that it
   * squeezes is {@linkplain Outcome#JAMMED jammed}: see <a
   * href="doc-files/rules.html#moving">moving obstacles</a>.
   *
   * <p>To send it to a place, such as a paddle that a player moves, use {@link #moveTo moveTo}.
   *
   * @param kind its kind: {@link Kind#LINE}, {@link Kind#PEG} or {@link Kind#CIRCLE}
   * @param id its id
   * @param vx the x component, finite
   * @param vy the y component, finite
   * @throws IndexOutOfBoundsException if there is no such thing
   * @throws IllegalArgumentException if a component is NaN or infinite, or the kind is {@link
   *     Kind#WALL}: walls stay
   */
  public void setVelocity(Kind kind, int id, double vx, double vy) {
    int code = movable(kind, id);
    if (kind == Kind.CIRCLE) {
      setVelocity(id, vx, vy);
    } else {
      edit().setObstacleVelocity(code, vx, vy, now);
      if (edits != null) {
        edits.add(world -> world.setVelocity(kind, id, vx, vy));
      }
    }
  }

  /**
   * Lets a line or a peg go straight to a place, arrive there at a given time, and then rest.
   *
   * <p>It pushes the circles in its way, as a velocity does: see {@link #setVelocity(Kind, int,
   * double, double) setVelocity}. At the time of arrival its place is the given one, to the bit,
   * and it stops there by itself, also within a step. {@code setVelocity}, a move to another place,
   * or another {@code moveTo} replaces this motion. A {@code moveTo} that asks for the motion that
   * the obstacle already has changes nothing.
   *
   * <p>For a paddle that a player moves, call it before each step, with the end of the step as the
   * arrival: see <a href="doc-files/recipes.html#paddle">a paddle</a>.
   *
   * @param kind its kind: {@link Kind#LINE} or {@link Kind#PEG}
   * @param id its id
   * @param x the x coordinate of its place then, finite: of a line the start, of an outline the
   *     first point, of a peg the centre
   * @param y the y coordinate of its place then, finite
   * @param arrival the time of arrival, finite and after {@link #now}
   * @throws IndexOutOfBoundsException if there is no such thing
   * @throws IllegalArgumentException if the arrival is not a finite time after now, or so soon that
   *     the velocity would be infinite; if a coordinate is refused, as by {@link #addLine addLine};
   *     or if the kind is {@link Kind#WALL} or {@link Kind#CIRCLE}
   */
  public void moveTo(Kind kind, int id, double x, double y, double arrival) {
    int code = driven(kind, id);
    edit().moveTo(code, x, y, arrival, now);
    if (edits != null) {
      edits.add(world -> world.moveTo(kind, id, x, y, arrival));
    }
  }

  /** Returns the code of an obstacle that can be sent somewhere. */
  private int driven(Kind kind, int id) {
    int code = code(kind, id);
    if (kind == Kind.WALL || kind == Kind.CIRCLE) {
      throw Check.refused(
          "kind", kind, "LINE or PEG: walls do not move, and a circle is steered by setVelocity");
    }
    return code;
  }

  /**
   * Turns a line, an outline or a peg about a pivot by an angle, until a given time. Then it rests.
   *
   * <p>The motion is an exact rotation from where the obstacle is now. It pushes the circles in its
   * way with the velocity of its material point at the contact. The rate is nearly even: in the
   * middle it is more than at the ends by {@code tan^2(angle / 4)}, 0.2 % for 10 degrees and 4 %
   * for 45. At the time of arrival the place is the exact one, each coordinate rounded about once,
   * and the obstacle stops there by itself, also within a step. {@link #setVelocity(Kind, int,
   * double, double) setVelocity}, {@link #moveTo moveTo}, a move to another place, or another
   * {@code turn} replaces this motion, from where the obstacle is then.
   *
   * <pre>{@code
   * World world =
   *     new World(Scene.builder().line(0, 0, 30, 0).circle(20, 4, 4, 0, 0).build());
   * world.turn(Kind.LINE, 0, 0, 0, Math.toRadians(50), 0.025); // a flipper
   * }</pre>
   *
   * <p>A circle that was hit can be hit again by the same turn, also without gravity. What is
   * driven is not slowed by a circle: see <a href="doc-files/rules.html#turning">things that
   * turn</a>, and <a href="doc-files/recipes.html#flipper">a flipper</a>.
   *
   * @param kind its kind: {@link Kind#LINE} or {@link Kind#PEG}
   * @param id its id
   * @param pivotX the x coordinate of the pivot, finite; any point, on the obstacle or elsewhere
   * @param pivotY the y coordinate of the pivot, finite
   * @param angle the angle in radians, counterclockwise, at most a quarter turn: from {@code -PI /
   *     2} to {@code PI / 2}
   * @param arrival the time at which it ends, finite and after {@link #now}
   * @throws IndexOutOfBoundsException if there is no such thing
   * @throws IllegalArgumentException if the angle is larger, or NaN; if the arrival is not a finite
   *     time after now, or so soon that the velocity would be infinite; if a coordinate of the
   *     pivot, or one on the way, is refused, as by {@link #addLine addLine}; or if the kind is
   *     {@link Kind#WALL} or {@link Kind#CIRCLE}
   */
  public void turn(Kind kind, int id, double pivotX, double pivotY, double angle, double arrival) {
    int code = driven(kind, id);
    edit().turn(code, pivotX, pivotY, angle, arrival, now);
    if (edits != null) {
      edits.add(world -> world.turn(kind, id, pivotX, pivotY, angle, arrival));
    }
  }

  /**
   * Sets the traits of a circle or an obstacle, from now on. Only what differs has an effect.
   *
   * <pre>{@code
   * World world = new World(Scene.builder().circle(0, 0, 1, 3, 0).build());
   * world.setTraits(Kind.CIRCLE, 0, world.traits(Kind.CIRCLE, 0).withMass(3));
   * }</pre>
   *
   * <ul>
   *   <li>Another restitution changes the next impact, and begins no flight.
   *   <li>Another mass begins no flight either, unless it becomes infinite or finite. Then the
   *       circle can again hit the circle or obstacle that it hit last or passed through. A circle
   *       that rests in a heap or on something round begins one, where circles collide, and so do
   *       those that rest in contact with it. Where circles ignore each other, the mass matters
   *       only under gravity: a circle of infinite mass does not fall.
   *   <li>With another response or filter a circle begins a new flight. If a line or a peg gets
   *       another response or filter, or becomes one-way, every circle whose flight meets it does
   *       so. If the walls get another filter, all circles do so that only one of the two lets meet
   *       them.
   *   <li>Two things that overlap and now meet bounce if they approach each other, and are
   *       otherwise left alone. A sensor that a circle touches or overlaps when its flight begins
   *       is not reported: see {@link Response#SENSOR}.
   * </ul>
   *
   * @param kind its kind; for {@link Kind#WALL} they are set for all four walls
   * @param id its id
   * @param traits its traits from now on
   * @throws IndexOutOfBoundsException if there is no such thing
   * @throws IllegalArgumentException if a thing of its kind cannot have them: a mass other than 1
   *     is of circles only, one-way of lines only, and the walls cannot be a sensor
   */
  public void setTraits(Kind kind, int id, Traits traits) {
    int code = code(kind, id);
    edit().setTraits(code, Check.notNull("traits", traits).values(), now);
    if (edits != null) {
      edits.add(world -> world.setTraits(kind, id, traits));
    }
  }

  /**
   * Adds a circle now.
   *
   * @param x the x coordinate of the centre, finite
   * @param y the y coordinate of the centre, finite
   * @param radius finite, and at least 2^10 ulps of the largest coordinate that a scene or an edit
   *     gave to this world. 0, a point particle, is allowed if this world has no lines
   * @param vx the x component of the velocity, finite
   * @param vy the y component of the velocity, finite
   * @param traits its traits, which cannot be one-way
   * @return its id
   * @throws IllegalArgumentException if a number is NaN or infinite, the radius refused, as by this
   *     method, or a coordinate too large, as by {@link #setPosition setPosition}; or if the traits
   *     are one-way
   * @throws IllegalStateException if this world gave all ids of circles: 1,610,612,736
   */
  public int addCircle(double x, double y, double radius, double vx, double vy, Traits traits) {
    Check.notNull("traits", traits);
    int id = edit().addCircle(x, y, radius, vx, vy, traits.values(), now);
    if (edits != null) {
      edits.add(world -> world.addCircle(x, y, radius, vx, vy, traits));
    }
    return id;
  }

  /**
   * Adds a line now. Circles whose flight meets it begin a new flight.
   *
   * @param ax the x coordinate of the start, finite
   * @param ay the y coordinate of the start, finite
   * @param bx the x coordinate of the end, finite
   * @param by the y coordinate of the end, finite
   * @param traits its traits, of mass 1
   * @return its id
   * @throws IllegalArgumentException if a coordinate is NaN or infinite, or so large that 2^10 ulps
   *     of it exceed the smallest radius above 0 that a circle of this world ever had; if the mass
   *     is not 1; or if there is a circle of radius 0
   * @throws IllegalStateException if this world gave all ids of lines: 268,435,452
   */
  public int addLine(double ax, double ay, double bx, double by, Traits traits) {
    Check.notNull("traits", traits);
    int id = edit().add(KindNumber.LINE, ax, ay, bx, by, traits.values(), now);
    if (edits != null) {
      edits.add(world -> world.addLine(ax, ay, bx, by, traits));
    }
    return id;
  }

  /**
   * Adds an outline now: joined lines with one id, of the kind {@link Kind#LINE}. Circles whose
   * flight meets it begin a new flight.
   *
   * @param outline a polyline or a solid polygon
   * @param traits the traits of each of its sides, of mass 1. Circles pass a one-way polyline where
   *     they come from the right of a side; a solid polygon cannot be one-way
   * @return its id
   * @throws IllegalArgumentException if a coordinate is so large that 2^10 ulps of it exceed the
   *     smallest radius above 0 that a circle of this world ever had; if the mass is not 1; if a
   *     solid one shall be one-way; or if there is a circle of radius 0
   * @throws IllegalStateException if this world gave all ids of lines; each side counts as one
   */
  public int addOutline(Outline outline, Traits traits) {
    Check.notNull("outline", outline);
    Check.notNull("traits", traits);
    int id = edit().add(outline.values(), traits.values(), now);
    if (edits != null) {
      edits.add(world -> world.addOutline(outline, traits));
    }
    return id;
  }

  /**
   * Adds a peg now. Circles whose flight meets it begin a new flight.
   *
   * @param x the x coordinate of the centre, finite
   * @param y the y coordinate of the centre, finite
   * @param radius finite and at least 0
   * @param traits its traits, of mass 1 and not one-way
   * @return its id
   * @throws IllegalArgumentException if a coordinate or the radius is NaN or infinite, the radius
   *     negative, or a coordinate so large that 2^10 ulps of it exceed the smallest radius above 0
   *     that a circle of this world ever had; or if the mass is not 1, or the traits one-way
   * @throws IllegalStateException if this world gave all ids of pegs: 268,435,456
   */
  public int addPeg(double x, double y, double radius, Traits traits) {
    Check.notNull("traits", traits);
    int id = edit().add(KindNumber.PEG, x, y, radius, 0, traits.values(), now);
    if (edits != null) {
      edits.add(world -> world.addPeg(x, y, radius, traits));
    }
    return id;
  }

  /**
   * Removes a circle, a line, an outline or a peg. Its id is not used again.
   *
   * <p>No search finds it any more. A circle leaves nothing behind. A line, a side of an outline or
   * a peg leaves a row in memory, some 50 bytes, and a byte in snapshots.
   *
   * @param kind its kind
   * @param id its id
   * @throws IndexOutOfBoundsException if there is no such thing
   * @throws IllegalArgumentException if the kind is {@link Kind#WALL}
   */
  public void remove(Kind kind, int id) {
    int code = movable(kind, id);
    edit().remove(code, now);
    if (recorder != null && kind == Kind.CIRCLE) {
      recorder.remove(id, now);
    }
    if (edits != null) {
      edits.add(world -> world.remove(kind, id));
    }
  }

  // Time.

  /**
   * Returns a copy of everything that determines the future of this world.
   *
   * @return the snapshot, which no later step or edit changes
   */
  public Snapshot snapshot() {
    return new Snapshot(state());
  }

  private WorldState state() {
    return new WorldState(
        now,
        scene.collide(),
        obstacles.copy(),
        registry.copy(),
        editor.limits.copy(),
        engine.save(now),
        engine.lastTail(now),
        engine.gravity.x,
        engine.gravity.y);
  }

  /**
   * Returns this world to the moment of a snapshot.
   *
   * <p>The snapshot may come from another world and another scene, as long as the bounds are equal
   * and circles collide in both or in neither. Circles, lines, pegs, gravity and the properties of
   * the walls are then those of the snapshot, with its ids; {@link #scene} stays. The log is empty,
   * and a recording begins anew. If the snapshot is refused, nothing changes.
   *
   * @param snapshot the snapshot
   * @throws IllegalArgumentException if it was taken in a world with other bounds, or if circles
   *     collide in only one of the two worlds
   */
  public void restore(Snapshot snapshot) {
    WorldState state = Check.notNull("snapshot", snapshot).state;
    if (!Arrays.equals(state.obstacles().walls, scene.data.obstacles.walls)) {
      throw Check.refused(
          "bounds of the snapshot",
          PublicRecords.describe(state.obstacles().walls),
          "this world's, " + PublicRecords.describe(scene.data.obstacles.walls));
    }
    if (state.collide() != scene.collide()) {
      throw Check.refused(
          "collide of the snapshot", state.collide(), "this world's, " + scene.collide());
    }
    rows.clear();
    questions.changed();
    sharedAt = Double.NaN;
    now = state.now();
    registry.set(state.registry());
    editor.limits.set(state.limits());
    engine.staticScene.restore(state.obstacles());
    engine.setGravity(state.gx(), state.gy());
    engine.restore(state.flights(), now, state.tailOfEdit());
    if (recorder != null) {
      recorder.begin(now);
      edits.clear();
      engine.record(recorder);
    }
  }

  /**
   * Records from now on where each thing is, and returns the timeline that tells it. The timeline
   * goes back as far as the duration, but not beyond this call. A recording that was going on
   * stops, and its timeline stays as it is.
   *
   * <p>Times between {@link Timeline#start} and {@link Timeline#end} are known. The start is the
   * present time at first, and {@code now() - duration} once that is later. An earlier time is
   * refused by all questions of the timeline, except that {@link Timeline#contains contains} is
   * false there. With a duration of 0 the present moment alone is known.
   *
   * <p>What ended before the start is dropped: flights, changes, and removed things. So the memory
   * of a recording is bounded by what happens within the duration; with {@code +infinity} it grows
   * without end. A flight takes 56 bytes, 24 more under gravity, and 24 more where a sensor
   * reported another circle. A change of a circle within a flight counts as one more flight, such
   * as another mass. A circle in contact takes 100 bytes a tick; one at rest takes nothing. An edit
   * takes up to 500 bytes. As long as the recording goes on, each circle takes up to four times
   * what its flights need.
   *
   * @param duration the time to keep, in the unit of {@link #now}, from 0 to {@code +infinity}
   * @return the timeline, which goes on as the world does
   * @throws IllegalArgumentException if the duration is negative or NaN
   */
  public Timeline record(double duration) {
    if (!(duration >= 0)) {
      throw Check.refused("duration", duration, "at least 0");
    }
    stop(recorder);
    recorder =
        new TimelineRecorder(
            duration,
            scene.collide(),
            registry,
            obstacles,
            editor.limits,
            engine.gravity,
            this::state);
    edits = new RecordedEdits(recorder);
    recorder.begin(now);
    engine.record(recorder);
    return new Timeline(this, recorder, edits);
  }

  /** Stops a recording, if it goes on. */
  void stop(TimelineRecorder recording) {
    if (recorder != null && recorder == recording) {
      recorder.stop();
      recorder = null;
      edits = null;
      engine.record(null);
    }
  }

  /**
   * Estimates from now on how far the place of each circle can be trusted. The present state is
   * taken as exact.
   *
   * <p>The world takes in the impacts of each call from now on, whatever they are read for. It
   * keeps one estimate: a further call begins anew, and the earlier one gives up each circle at its
   * next impact.
   *
   * @param length how far off a place may be that still counts as known, in units of the world,
   *     greater than 0; {@link Uncertainty#lostAt(int) lostAt} tells of it
   * @return the estimate, which goes on as the world does
   * @throws IllegalArgumentException if the length is NaN or not positive, or if there are several
   *     circles that collide
   */
  public Uncertainty uncertainty(double length) {
    uncertainty = new Uncertainty(this, length);
    return uncertainty;
  }

  /**
   * Describes the world for a debugger: its time, circles and bounds, the impacts of the last step,
   * and the search structures that it chose.
   *
   * @return a text for people; its form may change
   */
  @Override
  public String toString() {
    return "World[now=%s, %s circles, bounds %s, %s impacts in the last step; %s]"
        .formatted(
            now,
            count(Kind.CIRCLE),
            PublicRecords.describe(scene.data.obstacles.walls),
            log.size(),
            engine.description());
  }
}
