// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.engine.CollidingEngine;
import dev.carom.internal.engine.Editor;
import dev.carom.internal.engine.Engine;
import dev.carom.internal.engine.Handles;
import dev.carom.internal.engine.IndependentEngine;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.FlightRecorder;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.WorldState;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.Kind;
import java.util.Arrays;
import java.util.Optional;

/**
 * A scene in motion: circles that fly straight, bounce off lines, pegs and bounds, and collide with
 * each other or ignore each other, as the scene says.
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
 * <p>A circle's flight is kept as its start until its next impact; places are computed from it when
 * they are asked for, never accumulated. A step resolves every impact in it, each at its own
 * moment, any number of them; so how a run is cut into steps changes no bit of it. An impact whose
 * time equals the end of a step belongs to that step.
 *
 * <p><b>No jitter, and no threshold against it.</b> What touches without coming nearer is no
 * impact, and the thing just hit cannot be hit again before a velocity changes: it is convex, and
 * the motion after the response does not lead into it, so no later moment of the flight can. Places
 * are computed from a flight's start and are never corrected. So circles in contact stay as they
 * are, to the bit, however long; one that approaches however slowly bounces once.
 *
 * <p><b>It ends.</b> Some scenes would make infinitely many impacts in finite time: a wedge, a gap
 * of exactly one diameter, a ball that comes to rest, two bumpers. A circle is <i>stuck</i> when
 * its own impacts at one place have too much weight, whoever else is there and however time is cut
 * into steps. At one place means: it moved by less than 2^-39 of its coordinates since its last
 * impact, or, if that impact was not elastic, by less than 2^-16 of its radius. 1,024 elastic
 * impacts with obstacles have that weight, or 16,384 with circles; others weigh more, the more
 * energy they take or add, so that speeds fall or grow there by a factor of 2^16 at most.
 *
 * <p>The impacts of a stuck circle have restitution 0, and it and all circles in contact with it
 * are resolved at once: they get the velocities nearest to those before, weighted by the masses,
 * with which no contact approaches (the inelastic shock of J. J. Moreau). Contacts that then
 * approach by no more than rounding are not there for each other, until an impact makes the two
 * approach or part by more. Such rows of the log are {@link Outcome#JAMMED}. The next impact at
 * another place ends it.
 *
 * <p><b>Infinite mass.</b> Nothing deflects a circle of infinite mass; two of them pass through
 * each other, and each approach is one row of the log ({@link Outcome#PASSED}). One that presses a
 * circle against something that cannot give way <i>crushes</i> it: the circle stops where it is,
 * and the infinite mass passes over it; meanwhile others find the circle as if it had infinite
 * mass. Nothing else is pressed through anything.
 *
 * <p><b>Budget.</b> One call of {@link #step step} or {@link #advanceTo advanceTo} does so much
 * work and no more. If circles ignore each other, each may make 1,000 impacts, and all together
 * 2,000,000 besides; if they collide, all together may take 2,000,000 + 1,000 x circles events
 * (impacts, and circles that leave a cell). Exact arithmetic counts too: one impact for each 2,048
 * bits of the numbers that it makes. If that is not enough, the call returns false, unfinished,
 * with the whole world at an earlier time, nothing dropped; the next call goes on.
 *
 * <p><b>Accuracy.</b> Each question is answered exactly on the doubles with which it is asked, and
 * each impact's state is rounded once; a scene multiplies such roundings from impact to impact. The
 * clock has 106 bits: where circles collide so fast that one crosses its own size in less than the
 * last of them, at some 1e31 sizes a unit of time, many meetings come at one time of the clock, and
 * which of them is resolved first may depend on the machinery and on a {@link #restore restore}. A
 * circle so fast that it would leave the bounds between two times of the clock is told to be at the
 * wall. A circle that flies out of the range of doubles has infinite coordinates from then on, and
 * hits nothing; one that an impact would make faster than doubles can tell stops. In the log a
 * coordinate beyond that range is the largest one.
 *
 * <p><b>Between steps</b> it can be edited: what is there can be changed, moved, added and removed,
 * from now on, and after all that has happened: {@link #now()} is a rounded time, and the last
 * impacts may be later by up to half an ulp of it; until then a circle is told to be where such an
 * impact left it. A circle that is edited begins a new flight; any number of edits between two
 * steps cost it one search. To add or move a line or a peg asks every circle once whether its
 * flight meets it. An edit that is refused leaves the world as it was, and no edit changes the log
 * of the last step. The future can be saved and gone back to ({@link #snapshot}), the past be
 * looked at ({@link #record record}).
 *
 * <p>Uses +, -, *, /, sqrt and fma only, in a fixed order: the same run gives the same bits on
 * every Java virtual machine. Not safe for use by several threads; worlds do not share anything
 * mutable.
 */
public final class World {

  /** Rows for which a new log has room: one a circle, within these limits. */
  private static final int LOG_LEAST = 16;

  private static final int LOG_MOST = 4096;

  private final Scene scene;
  private final ImpactRows rows;
  private final ImpactLog log;
  private final CircleRegistry registry;
  private final Handles ids;
  private final Engine engine;
  final CircleTable circles;
  private final ObstacleTable obstacles;
  private final Editor editor;
  private final WorldQueries questions;
  private double now;

  /** The id of the circle that spent the budget of the last step, or -1. */
  private int unfinishedCircle = -1;

  /** Null unless flights are recorded. */
  private FlightRecorder recorder;

  /**
   * Sets a scene in motion, at time 0.
   *
   * @param scene what is there
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
    ids = new Handles(registry, obstacles);
    editor = new Editor(data, engine, registry);
    questions = new WorldQueries(engine, registry, data.collide);
  }

  /**
   * The scene from which this world started.
   *
   * @return the scene
   */
  public Scene scene() {
    return scene;
  }

  /**
   * The time at which the world stands.
   *
   * @return at least 0
   */
  public double now() {
    return now;
  }

  /**
   * Goes on for a given time, to the double nearest to {@code now() + dt}.
   *
   * @param dt 0, or more than about 1e-16 of the time now
   * @return whether the world got there; false if its budget of work was spent before
   * @throws IllegalArgumentException if dt is NaN or negative, or the time it leads to is infinite;
   *     or if dt is more than 0 and that time is still now: a loop of such steps would never end
   */
  public boolean step(double dt) {
    if (!(dt >= 0 && now + dt <= Double.MAX_VALUE)) {
      throw Check.refused("dt", dt, "at least 0, and a finite time after " + now);
    }
    if (now + dt == now && dt > 0) {
      throw Check.refused("dt", dt, "0, or enough to move the clock on from " + now);
    }
    return advance(now + dt);
  }

  /**
   * Goes on to a given time, exactly.
   *
   * @param t at least {@link #now()}
   * @return whether the world got there; false if its budget of work was spent before
   * @throws IllegalArgumentException if t is NaN, infinite, or earlier than now
   */
  public boolean advanceTo(double t) {
    checkGoal(t);
    return advance(t + 0.0); // 0 for -0
  }

  private void checkGoal(double t) {
    if (!(t >= now && t <= Double.MAX_VALUE)) {
      throw Check.refused("t", t, "a finite time, at least now, " + now);
    }
  }

  private boolean advance(double end) {
    begin();
    finish(engine.advance(end));
    return now == end && !engine.unfinished;
  }

  /**
   * Advances to the next impact, or to a given time if that is first. The world stops at the first
   * double that is not before the impact on the world's clock of 106 bits, so edits take effect
   * after it. The log holds all impacts up to there; several are possible within one double. A
   * contact that a sensor reports counts as an impact.
   *
   * <p>For paddles, portals and sounds: whatever the program does at an impact happens at its
   * moment. Calls in a row give the same impacts, to the bit, as one call of {@link #advanceTo
   * advanceTo}.
   *
   * <pre>{@code
   * World world =
   *     new World(Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 10, 8, 0).build());
   * while (world.advanceToImpact(10) == StopReason.IMPACT) {
   *   System.out.println(world.impacts().kind(0) + " at " + world.now()); // WALL at 5.0
   * }
   * }</pre>
   *
   * @param t the latest time, at least {@link #now()}
   * @return why the world stopped: at an impact, at the time t, or for want of budget
   * @throws IllegalArgumentException if t is NaN, infinite, or earlier than now
   */
  public StopReason advanceToImpact(double t) {
    checkGoal(t);
    begin();
    finish(engine.advanceToImpact(t + 0.0));
    if (engine.unfinished) {
      return StopReason.BUDGET;
    }
    return rows.size() > 0 ? StopReason.IMPACT : StopReason.TIME;
  }

  /**
   * The circle that spent the budget of the last step: the one with the most impacts in it.
   *
   * @return its id; -1 if that step was finished
   */
  public int unfinishedCircle() {
    return unfinishedCircle;
  }

  private void begin() {
    rows.clear();
    if (registry.isSparse()) {
      engine.compact(now);
    }
  }

  private void finish(double reached) {
    rows.sort();
    now = reached;
    unfinishedCircle = engine.unfinished ? registry.id(engine.spender) : -1;
    if (recorder != null) {
      recorder.advance(now);
    }
  }

  /**
   * The impacts of the last step, which edits leave as they are.
   *
   * @return always the same log; its rows are valid until the next step, or {@link #restore
   *     restore}
   */
  public ImpactLog impacts() {
    return log;
  }

  /**
   * The number of circles. Once one was removed, their ids are no longer 0 to this number less 1:
   * ask {@link #ids ids} for them.
   *
   * @return at least 0
   */
  public int circleCount() {
    return registry.count();
  }

  /**
   * The x coordinate of a circle's centre now.
   *
   * @param id the circle
   * @return the coordinate; infinite once the circle has left the range of doubles
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double x(int id) {
    return circles.x(ids.circle(id), now);
  }

  /**
   * The y coordinate of a circle's centre now.
   *
   * @param id the circle
   * @return the coordinate; infinite once the circle has left the range of doubles
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double y(int id) {
    return circles.y(ids.circle(id), now);
  }

  /**
   * The x component of a circle's velocity now.
   *
   * @param id the circle
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double vx(int id) {
    return circles.vx(ids.circle(id));
  }

  /**
   * The y component of a circle's velocity now.
   *
   * @param id the circle
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double vy(int id) {
    return circles.vy(ids.circle(id));
  }

  /**
   * The radius of a circle.
   *
   * @param id the circle
   * @return more than 0
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double radius(int id) {
    return circles.radius(ids.circle(id));
  }

  /**
   * The mass of a circle.
   *
   * @param id the circle
   * @return 2^-500 to 2^500, or infinity
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double mass(int id) {
    return registry.mass(ids.circle(id));
  }

  /**
   * A line as it is now.
   *
   * @param id the line
   * @return the line
   * @throws IndexOutOfBoundsException if there is no such line
   */
  public Line line(int id) {
    return PublicRecords.line(obstacles, code(ObstacleKind.LINE, id));
  }

  /**
   * A peg as it is now.
   *
   * @param id the peg
   * @return the peg
   * @throws IndexOutOfBoundsException if there is no such peg
   */
  public Circle peg(int id) {
    return PublicRecords.peg(obstacles, code(ObstacleKind.PEG, id));
  }

  /**
   * The restitution of something now; that of an impact is the product of the two parties'
   * restitutions.
   *
   * @param kind its kind; the four walls have the same one
   * @param id its id
   * @return at least 0; 1 is elastic
   * @throws IndexOutOfBoundsException if there is no such thing
   */
  public double restitution(ObstacleKind kind, int id) {
    return questions.restitution(code(kind, id));
  }

  /**
   * What happens now when a circle meets something.
   *
   * @param kind its kind; the four walls have the same response
   * @param id its id
   * @return the response; of a circle, to other circles
   * @throws IndexOutOfBoundsException if there is no such thing
   */
  public Response response(ObstacleKind kind, int id) {
    return questions.response(code(kind, id));
  }

  /**
   * Whether a line is a one-way line now; see {@link SceneBuilder#oneWay}.
   *
   * @param id the line
   * @return whether it is there only for circles that come from its left
   * @throws IndexOutOfBoundsException if there is no such line
   */
  public boolean oneWay(int id) {
    return questions.isOneWay(code(ObstacleKind.LINE, id));
  }

  /**
   * Whether something is there. The ids of a kind begin at 0, with the things of the scene in its
   * order; each thing that is added gets the next one, and the id of one that was removed is not
   * used again. Ids end at 268,435,452 for lines, 268,435,456 for pegs and 1,610,612,736 for
   * circles: some 300 days of 60 new circles a second.
   *
   * @param kind its kind; walls have the ids 0..3
   * @param id its id, any number
   * @return false if it was removed, or never was
   */
  public boolean contains(ObstacleKind kind, int id) {
    return ids.contains(number(kind), id);
  }

  /**
   * The ids of all things of a kind.
   *
   * @param kind a kind
   * @return those of what is there now, ascending; a new array
   */
  public int[] ids(ObstacleKind kind) {
    Check.notNull("kind", kind);
    return questions.ids(kind);
  }

  /**
   * Where the ids of a kind end: every thing of that kind that is there, or was, has a smaller one.
   *
   * @param kind a kind
   * @return one more than the largest id ever given
   */
  public int idLimit(ObstacleKind kind) {
    return ids.end(number(kind));
  }

  /**
   * The machinery that this world chose for its scene, in words: the least that is still exact.
   * Results do not depend on it, to the bit; only the cost of a step does.
   *
   * @return a phrase to be read, not to be taken apart
   */
  public String engineDescription() {
    return engine.engineDescription();
  }

  /** The code of a thing that is there; any other id is refused. */
  private int code(ObstacleKind kind, int id) {
    return ids.checked(number(kind), id);
  }

  private static int number(ObstacleKind kind) {
    return Check.notNull("kind", kind).ordinal();
  }

  // Questions.

  /**
   * The first impact of a circle that need not be in this world: with what stands still here, and,
   * if circles collide, with the circles as they move now. Nothing moves. Sensors are passed over.
   * A circle of radius 0 is a ray; the centre exactly on that of a circle does not meet it, so one
   * can ask for a circle of this world. Where circles collide it looks at every one of them; it
   * allocates.
   *
   * <p>The earliest impact is found as if in real arithmetic on the given doubles and on the places
   * and velocities that this world tells of its circles. Of exactly simultaneous impacts walls come
   * first, then lines, then pegs, then circles, each by id. A {@link #step step} instead treats
   * impacts with equal rounded times as simultaneous.
   *
   * @param circle the circle now
   * @param velocity its velocity
   * @param maxTime the end of the window from now on, at least 0, {@code +infinity} included
   * @return the impact, its time counted from now; empty if there is none until maxTime
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public Optional<Impact> cast(Circle circle, Vec2 velocity, double maxTime) {
    Check.notNull("circle", circle);
    Check.notNull("velocity", velocity);
    Check.duration("maxTime", maxTime);
    return questions.cast(circle, velocity, maxTime, now);
  }

  /**
   * The way of a circle among what stands still here, with its next bounces: an aiming line.
   * Nothing moves, and other circles are not there; sensors are passed over. It ends at impact
   * 100,000; one that would go on is not {@linkplain Trajectory#complete complete}.
   *
   * @param circle the circle at the start; of radius 0 too
   * @param velocity its velocity at the start
   * @param restitution finite and at least 0; that of an impact is its product with the obstacle's
   * @param duration how long to go on, finite and at least 0
   * @param bounces how many impacts to resolve, at least 0; the way ends where the next one would
   *     come
   * @return its flights and impacts; times count from now
   * @throws IllegalArgumentException if the restitution or the duration is NaN, infinite or
   *     negative, or the number of bounces negative
   */
  public Trajectory trace(
      Circle circle, Vec2 velocity, double restitution, double duration, int bounces) {
    Check.notNull("circle", circle);
    Check.notNull("velocity", velocity);
    Check.notNegative("restitution", restitution);
    Check.notNegative("duration", duration);
    Check.notNegative("bounces", bounces);
    return questions.trace(circle, velocity, restitution, duration, bounces);
  }

  /**
   * The thing of a kind that is nearest to a point; of equally near ones the one of the smallest
   * id. Distances are computed in plain doubles: to a wall, a line, or the rim of a peg or a circle
   * from outside; 0 inside of those. It looks at every thing of the kind, and allocates.
   *
   * @param kind which kind of thing
   * @param x the x coordinate of the point, finite
   * @param y the y coordinate of the point, finite
   * @return its id, -1 if there is none
   * @throws IllegalArgumentException if a coordinate is NaN or infinite
   */
  public int nearest(ObstacleKind kind, double x, double y) {
    Check.notNull("kind", kind);
    Check.finite("x", x);
    Check.finite("y", y);
    return questions.nearest(kind, x, y, now);
  }

  /**
   * What overlaps a disk: has points inside of it, not only on its rim. Decided exactly, for
   * circles on their places as {@link #x} and {@link #y} give them. It looks at every thing of the
   * kind, and allocates.
   *
   * @param kind which kind of thing
   * @param disk the disk
   * @return the ids, ascending; a new array
   */
  public int[] overlapping(ObstacleKind kind, Circle disk) {
    Check.notNull("kind", kind);
    Check.notNull("disk", disk);
    return questions.overlapping(kind, disk, now);
  }

  /**
   * What overlaps a box: has points inside of it, not only on its edge. Decided exactly, as for a
   * disk.
   *
   * @param kind which kind of thing
   * @param box the box
   * @return the ids, ascending; a new array
   */
  public int[] overlapping(ObstacleKind kind, Bounds box) {
    Check.notNull("kind", kind);
    Check.notNull("box", box);
    return questions.overlapping(kind, box, now);
  }

  // Edits.

  /**
   * Sets the velocity of a circle, from now on. What it touches may be hit again at once, if it now
   * moves towards it.
   *
   * @param id the circle
   * @param vx the x component, finite
   * @param vy the y component, finite
   * @throws IndexOutOfBoundsException if there is no such circle
   * @throws IllegalArgumentException if a component is NaN or infinite
   */
  public void setVelocity(int id, double vx, double vy) {
    editor.setVelocity(ids.circle(id), vx, vy, now);
  }

  /**
   * Puts a circle elsewhere; nothing on the way is hit. If it overlaps something there, it hits it
   * at once if it approaches it, and is let go if it does not: see {@link SweptCircle}.
   *
   * @param id the circle
   * @param x the x coordinate of the centre, finite
   * @param y the y coordinate of the centre, finite
   * @throws IndexOutOfBoundsException if there is no such circle
   * @throws IllegalArgumentException if a coordinate is NaN or infinite, or so large that 2^10 ulps
   *     of it exceed the least radius that was ever in this world
   */
  public void setPosition(int id, double x, double y) {
    editor.setPosition(ids.circle(id), x, y, now);
  }

  /**
   * Sets the radius of a circle, from now on; its centre stays.
   *
   * @param id the circle
   * @param radius finite, more than 0, and at least 2^10 ulps of the largest coordinate of anything
   *     that was ever put into this world
   * @throws IndexOutOfBoundsException if there is no such circle
   * @throws IllegalArgumentException if the radius is refused
   */
  public void setRadius(int id, double radius) {
    editor.setRadius(ids.circle(id), radius, now);
  }

  /**
   * Sets the mass of a circle, from now on. It has no effect as long as circles ignore each other.
   * One that becomes infinitely heavy, or ceases to be, begins a new flight: what it hit last, or
   * passed through, can be hit again.
   *
   * @param id the circle
   * @param m a number from 2^-500 to 2^500, or infinity
   * @throws IndexOutOfBoundsException if there is no such circle
   * @throws IllegalArgumentException if m is NaN or out of these limits
   */
  public void setMass(int id, double m) {
    editor.setMass(ids.circle(id), m, now);
  }

  /**
   * Sets the restitution of something, from now on. That of an impact is the product of the two
   * parties' restitutions.
   *
   * @param kind its kind; for {@link ObstacleKind#WALL} it is set for all four walls
   * @param id its id
   * @param e finite and at least 0: 1 is elastic, 0 keeps no motion along the normal, above 1 is a
   *     bumper
   * @throws IndexOutOfBoundsException if there is no such thing
   * @throws IllegalArgumentException if e is NaN, infinite or negative
   */
  public void setRestitution(ObstacleKind kind, int id, double e) {
    editor.setRestitution(code(kind, id), e);
  }

  /**
   * Sets what happens at something, from now on. A circle begins a new flight, and so does one
   * whose flight meets the line or peg: if that becomes a sensor, one that it touches or overlaps
   * now has been met before.
   *
   * @param kind its kind; for {@link ObstacleKind#WALL} it is set for all four walls
   * @param id its id
   * @param response the response; of a circle, to other circles
   * @throws IndexOutOfBoundsException if there is no such thing
   * @throws IllegalArgumentException if the walls would become a {@link Response#SENSOR}
   * @throws NullPointerException if the response is null
   */
  public void setResponse(ObstacleKind kind, int id, Response response) {
    int code = code(kind, id);
    Check.notNull("response", response);
    editor.setResponse(code, response.ordinal(), now);
  }

  /**
   * Makes a line a one-way line, from now on, or an ordinary one; see {@link SceneBuilder#oneWay}.
   *
   * @param id the line
   * @param oneWay whether it is one
   * @throws IndexOutOfBoundsException if there is no such line
   */
  public void setOneWay(int id, boolean oneWay) {
    editor.setOneWay(code(ObstacleKind.LINE, id), oneWay, now);
  }

  /**
   * Adds a circle now: elastic, of mass 1.
   *
   * @param x the x coordinate of the centre, finite
   * @param y the y coordinate of the centre, finite
   * @param radius finite, more than 0, and at least 2^10 ulps of the largest coordinate of anything
   *     that was ever put into this world
   * @param vx the x component of the velocity, finite
   * @param vy the y component of the velocity, finite
   * @return its id
   * @throws IllegalArgumentException if a number is NaN or infinite, the radius too small, or a
   *     coordinate too large, as by {@link #setPosition setPosition}
   * @throws IllegalStateException if this world gave all ids of circles: 1,610,612,736
   */
  public int addCircle(double x, double y, double radius, double vx, double vy) {
    return editor.addCircle(x, y, radius, vx, vy, now);
  }

  /**
   * Adds a line now: elastic, solid from both sides. Circles whose flight would meet it begin a new
   * one.
   *
   * @param ax the x coordinate of the start, finite
   * @param ay the y coordinate of the start, finite
   * @param bx the x coordinate of the end, finite
   * @param by the y coordinate of the end, finite
   * @return its id
   * @throws IllegalArgumentException if a coordinate is NaN or infinite, or so large that 2^10 ulps
   *     of it exceed the least radius that was ever in this world
   * @throws IllegalStateException if this world gave all ids of lines: 268,435,452
   */
  public int addLine(double ax, double ay, double bx, double by) {
    return editor.addLine(ax, ay, bx, by, now);
  }

  /**
   * Puts a line elsewhere; a circle on the way is not hit, see {@link #setPosition setPosition}.
   *
   * @param id the line
   * @param ax the x coordinate of the start, finite
   * @param ay the y coordinate of the start, finite
   * @param bx the x coordinate of the end, finite
   * @param by the y coordinate of the end, finite
   * @throws IndexOutOfBoundsException if there is no such line
   * @throws IllegalArgumentException if a coordinate is refused, as by {@link #addLine addLine}
   */
  public void moveLine(int id, double ax, double ay, double bx, double by) {
    editor.moveLine(code(ObstacleKind.LINE, id), ax, ay, bx, by, now);
  }

  /**
   * Adds a peg now, an elastic one. Circles whose flight would meet it begin a new one.
   *
   * @param x the x coordinate of the centre, finite
   * @param y the y coordinate of the centre, finite
   * @param radius finite and at least 0
   * @return its id
   * @throws IllegalArgumentException if a coordinate or the radius is NaN or infinite, the radius
   *     negative, or a coordinate so large that 2^10 ulps of it exceed the least radius that was
   *     ever in this world
   * @throws IllegalStateException if this world gave all ids of pegs: 268,435,456
   */
  public int addPeg(double x, double y, double radius) {
    return editor.addPeg(x, y, radius, now);
  }

  /**
   * Puts a peg elsewhere; a circle on the way is not hit, see {@link #setPosition setPosition}.
   *
   * @param id the peg
   * @param x the x coordinate of the centre, finite
   * @param y the y coordinate of the centre, finite
   * @param radius finite and at least 0
   * @throws IndexOutOfBoundsException if there is no such peg
   * @throws IllegalArgumentException if a number is refused, as by {@link #addPeg addPeg}
   */
  public void movePeg(int id, double x, double y, double radius) {
    editor.movePeg(code(ObstacleKind.PEG, id), x, y, radius, now);
  }

  /**
   * Removes a circle, a line or a peg. No search looks at it any more, and of a circle nothing is
   * left but that its id is not used again; the row of a line or a peg stays in memory, some 50
   * bytes, and in snapshots, a byte.
   *
   * @param kind its kind
   * @param id its id, which is not used again
   * @throws IndexOutOfBoundsException if there is no such thing
   * @throws IllegalArgumentException if the kind is {@link ObstacleKind#WALL}
   */
  public void remove(ObstacleKind kind, int id) {
    int code = code(kind, id);
    if (kind == ObstacleKind.WALL) {
      throw Check.refused("kind", kind, "LINE, PEG or CIRCLE: walls stay");
    }
    editor.remove(code, now);
    if (recorder != null && kind == ObstacleKind.CIRCLE) {
      recorder.remove(id, now);
    }
  }

  // Time.

  /**
   * A copy of everything that determines the future.
   *
   * @return the snapshot, which no later step or edit changes
   */
  public Snapshot snapshot() {
    return new Snapshot(
        new WorldState(
            now,
            scene.collide(),
            obstacles.copy(),
            registry.copy(),
            editor.limits(),
            engine.save(now)));
  }

  /**
   * Goes to where a snapshot was taken: of this world, or of another one, whose scene may be
   * another as long as the bounds are equal. Circles, lines and pegs are then those of the
   * snapshot, with its ids; the log is empty, and a timeline begins anew. If the snapshot is
   * refused, nothing changes.
   *
   * @param snapshot the snapshot
   * @throws IllegalArgumentException if it was taken in a world with other bounds, or where circles
   *     collide and here they do not, or the other way round
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
    unfinishedCircle = -1;
    now = state.now();
    registry.set(state.registry());
    editor.restore(state.limits());
    engine.staticScene.restore(state.obstacles());
    engine.restore(state.flights(), now);
    if (recorder != null) {
      recorder.begin(now, obstacles);
      engine.record(recorder);
    }
  }

  /**
   * Records the flights of all circles from now on; without it, none are. A recording that was
   * going on stops, and its timeline stays as it is.
   *
   * <p>What is kept of a circle stays when it is removed, within a budget: all removed circles
   * together have {@code most} flights for each circle of the largest number that was there at one
   * time. Beyond that the circles that were removed first are dropped, and {@link Timeline#start}
   * is later. Changes of removed lines and pegs have a budget by the same rule. So a recording
   * takes no more memory for all that came and went than for what was there.
   *
   * @param most how many flights to keep of each circle, at least 1, and how many changes of each
   *     line and peg; beyond that the oldest ones are dropped. An edit begins a flight: where each
   *     frame edits something, this is a number of frames
   * @return the timeline, which goes on as the world does
   * @throws IllegalArgumentException if most is below 1
   */
  public Timeline record(int most) {
    if (most < 1) {
      throw Check.refused("most", most, "at least 1");
    }
    recorder = new FlightRecorder(most, registry::id);
    recorder.begin(now, obstacles);
    engine.record(recorder);
    return new Timeline(recorder);
  }

  /** Stops to record, if it does; the timeline stays as it is. */
  public void stopRecording() {
    recorder = null;
    engine.record(null);
  }

  /**
   * What is there and when, for a debugger.
   *
   * @return a text to be read, not to be taken apart
   */
  @Override
  public String toString() {
    String form =
        "World[now=%s, %d circles that %s, %d lines, %d pegs, bounds %s,"
            + " %d impacts in the last step]";
    return form.formatted(
        now,
        circleCount(),
        scene.collide() ? "collide" : "ignore each other",
        obstacles.lines.present().count(),
        obstacles.ofKind(Kind.PEG).present().count(),
        PublicRecords.describe(scene.data.obstacles.walls),
        log.size());
  }
}
