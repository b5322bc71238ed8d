// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * A scene in motion: circles that fly straight, bounce off lines, pegs and bounds, and ignore each
 * other.
 *
 * <p>A circle's flight is kept as its start until its next impact; places are computed from it when
 * they are asked for, never accumulated. A step resolves every impact in it, each at its own
 * moment, any number of them; so how a run is cut into steps changes no bit of it. An impact whose
 * time equals the end of a step belongs to that step.
 *
 * <p><b>It ends.</b> Restitution other than 1, or clearance below rounding, can make infinitely
 * many impacts in finite time: a wedge, a corridor of exactly one diameter, two bumpers above 1.
 * With N = 1,000 + 10 x circles: a circle that makes N successive impacts while its centre stays
 * within 4 ulps loses its motion along each further normal (restitution 0); after N more it is
 * <i>jammed</i>: the things it touches are not there for it any more if it approaches them by no
 * more than rounding, so that it slides along them, else it stops; the log says so, and the next
 * impact with anything else ends that. Steps do not reset the counts. Independently a circle makes
 * at most {@link #IMPACTS_PER_CALL} / circles impacts, but at least 10,000, in one call of {@link
 * #step} or {@link #advanceTo}: if that is not enough, the call returns {@link Outcome#UNFINISHED},
 * with the whole world at an earlier time, nothing dropped; the next call goes on.
 *
 * <p><b>Accuracy.</b> Each question is answered exactly on the doubles with which it is asked, and
 * each impact's state is rounded once; a scene multiplies such roundings from impact to impact. A
 * circle that flies out of the range of doubles has infinite coordinates from then on, and hits
 * nothing.
 *
 * <p>Uses +, -, *, /, sqrt and fma only, in a fixed order: the same run gives the same bits on
 * every Java virtual machine. Not safe for use by several threads; worlds do not share anything
 * mutable.
 */
public final class World {

  /** What {@link #step} shares among all circles: the impacts in one call. */
  public static final int IMPACTS_PER_CALL = 4_000_000;

  private static final int LEAST_IMPACTS_PER_CALL = 10_000;

  private final Scene scene;
  private final Flights flights;
  private final ImpactLog log = new ImpactLog();
  private final int allowance;
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
    flights = new Flights(scene, machinery, log);
    allowance =
        Math.max(LEAST_IMPACTS_PER_CALL, IMPACTS_PER_CALL / Math.max(1, scene.circleCount()));
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
    double reached = flights.advance(end, allowance);
    log.sort();
    now = reached;
    return reached == end && !flights.unfinished() ? Outcome.COMPLETE : Outcome.UNFINISHED;
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
    return flights.count();
  }

  /**
   * The x coordinate of a circle's centre now.
   *
   * @param id the circle
   * @return the coordinate; infinite once the circle has left the range of doubles
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double x(int id) {
    return flights.x(checked(id), now);
  }

  /**
   * The y coordinate of a circle's centre now.
   *
   * @param id the circle
   * @return the coordinate; infinite once the circle has left the range of doubles
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double y(int id) {
    return flights.y(checked(id), now);
  }

  /**
   * The x component of a circle's velocity now.
   *
   * @param id the circle
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double vx(int id) {
    return flights.vx(checked(id));
  }

  /**
   * The y component of a circle's velocity now.
   *
   * @param id the circle
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double vy(int id) {
    return flights.vy(checked(id));
  }

  /**
   * The radius of a circle.
   *
   * @param id the circle
   * @return more than 0
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double radius(int id) {
    return flights.radius(checked(id));
  }

  /**
   * The machinery that this world chose for its scene, in words: the least that is still exact.
   * Results do not depend on it, to the bit; only the cost of a step does.
   *
   * @return a phrase to be read, not to be taken apart
   */
  public String model() {
    return flights.model().toString();
  }

  private int checked(int id) {
    if (id < 0 || id >= flights.count()) {
      throw new IndexOutOfBoundsException(
          "circle " + id + " does not exist: the world has " + flights.count() + ", from 0");
    }
    return id;
  }
}
