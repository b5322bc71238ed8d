// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * A scene in motion: circles that fly straight, bounce off lines, pegs and bounds, and collide with
 * each other or ignore each other, as the scene says.
 *
 * <p>A circle's flight is kept as its start until its next impact; places are computed from it when
 * they are asked for, never accumulated. A step resolves every impact in it, each at its own
 * moment, any number of them; so how a run is cut into steps changes no bit of it. An impact whose
 * time equals the end of a step belongs to that step.
 *
 * <p><b>It ends.</b> Restitution other than 1, or clearance below rounding, can make infinitely
 * many impacts in finite time: a wedge, a corridor of exactly one diameter, two bumpers above 1.
 * With N = 1,000 + 10 x circles: a circle that makes N successive impacts while its centre stays
 * within 4 ulps, or while its clock, kept to 106 bits, does not move, loses its motion along each
 * further normal (restitution 0); after N more it is <i>jammed</i>: the things it touches are not
 * there for it any more if it approaches them by no more than rounding, so that it slides along
 * them, else it stops; the log says so, and the next impact with anything else ends that. Steps do
 * not reset the counts. Of two circles that jam each other both are inert for each other; a
 * circle's impacts count as at one place only while what hits it comes from as near. Motion is
 * stopped there, not given: the TC model of Luding and McNamara (Granular Matter 1, 1998) makes
 * impacts elastic that follow each other too fast, which feeds energy back that the scene had taken
 * away.
 *
 * <p>Independently there is a budget of work for one call of {@link #step} or {@link #advanceTo}.
 * If circles ignore each other, each may make 4,000,000 / circles impacts, at least 10,000; if they
 * collide, all together may take 200,000 + 1,000 x circles events (impacts, and circles that leave
 * a cell). If that is not enough, the call returns {@link Outcome#UNFINISHED}, with the whole world
 * at an earlier time, nothing dropped; the next call goes on.
 *
 * <p><b>Accuracy.</b> Each question is answered exactly on the doubles with which it is asked, and
 * each impact's state is rounded once; a scene multiplies such roundings from impact to impact. A
 * circle that flies out of the range of doubles has infinite coordinates from then on, and hits
 * nothing; one that an impact would make faster than doubles can tell stops.
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
  private final ImpactLog log;
  private final Engine engine;
  private final Circles circles;
  private double now;

  /**
   * Sets a scene in motion, at time 0.
   *
   * @param scene what is there
   */
  public World(Scene scene) {
    this(scene, Machinery.choose(scene));
  }

  World(Scene scene, Machinery machinery) {
    this.scene = scene;
    log = new ImpactLog(Math.max(LOG_LEAST, Math.min(LOG_MOST, scene.circleCount())));
    engine =
        scene.collide ? new Collisions(scene, machinery, log) : new Flights(scene, machinery, log);
    circles = engine.circles();
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
   * @param dt at least 0
   * @return {@link Outcome#COMPLETE} if the world got there
   * @throws IllegalArgumentException if dt is NaN or negative, or the time it leads to is infinite
   */
  public Outcome step(double dt) {
    if (!(dt >= 0 && now + dt <= Double.MAX_VALUE)) {
      throw Check.refused("dt", dt, "at least 0, and a finite time after " + now);
    }
    return advance(now + dt);
  }

  /**
   * Goes on to a given time, exactly.
   *
   * @param t at least {@link #now()}
   * @return {@link Outcome#COMPLETE} if the world got there
   * @throws IllegalArgumentException if t is NaN, infinite, or earlier than now
   */
  public Outcome advanceTo(double t) {
    if (!(t >= now && t <= Double.MAX_VALUE)) {
      throw Check.refused("t", t, "a finite time, at least now, " + now);
    }
    return advance(t);
  }

  private Outcome advance(double end) {
    log.clear();
    double reached = engine.advance(end);
    log.sort();
    now = reached;
    return reached == end && !engine.unfinished() ? Outcome.COMPLETE : Outcome.UNFINISHED;
  }

  /**
   * The impacts of the last step.
   *
   * @return always the same log; its rows are valid until the next step
   */
  public ImpactLog impacts() {
    return log;
  }

  /**
   * The number of circles; their ids are 0..circleCount() - 1, in the order of the scene.
   *
   * @return at least 0
   */
  public int circleCount() {
    return circles.count;
  }

  /**
   * The x coordinate of a circle's centre now.
   *
   * @param id the circle
   * @return the coordinate; infinite once the circle has left the range of doubles
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double x(int id) {
    return circles.x(checked(id), now);
  }

  /**
   * The y coordinate of a circle's centre now.
   *
   * @param id the circle
   * @return the coordinate; infinite once the circle has left the range of doubles
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double y(int id) {
    return circles.y(checked(id), now);
  }

  /**
   * The x component of a circle's velocity now.
   *
   * @param id the circle
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double vx(int id) {
    return circles.vx(checked(id));
  }

  /**
   * The y component of a circle's velocity now.
   *
   * @param id the circle
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double vy(int id) {
    return circles.vy(checked(id));
  }

  /**
   * The radius of a circle.
   *
   * @param id the circle
   * @return more than 0
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double radius(int id) {
    return circles.radius(checked(id));
  }

  /**
   * The machinery that this world chose for its scene, in words: the least that is still exact.
   * Results do not depend on it, to the bit; only the cost of a step does.
   *
   * @return a phrase to be read, not to be taken apart
   */
  public String model() {
    return engine.model();
  }

  private int checked(int id) {
    if (id < 0 || id >= circles.count) {
      throw new IndexOutOfBoundsException(
          "circle " + id + " does not exist: the world has " + circles.count + ", from 0");
    }
    return id;
  }
}
