// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.ImpactLog;
import dev.carom.Line;
import dev.carom.ObstacleKind;
import dev.carom.Scene;
import dev.carom.Timeline;
import dev.carom.World;
import dev.carom.bench.charts.WorldScene;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;

/**
 * A run of a scene that can be stopped, looked at from its beginning to now, and changed by hand.
 * What is shown may lie in the past: going on from there replays the recording, and an edit begins
 * a new run with what is shown. Needs no screen; for one thread.
 */
public final class Player {

  /** Flights that are kept of each circle. */
  private static final int FLIGHTS = 10_000;

  /** Impacts that are remembered. */
  private static final int MARKS = 100_000;

  /** How many frames are searched for the next impact. */
  private static final double HORIZON = 1e6;

  private final double frame;
  private final Deque<Mark> marks = new ArrayDeque<>();
  private Scene beginning;
  private World world;
  private Timeline past;
  private double shown;
  private double speed = 1;
  private boolean running;
  private long impacts;

  /**
   * Starts with a scene at time 0, at rest.
   *
   * @param scene the scene
   * @param frame the time of a frame at speed 1, finite and greater than 0
   */
  public Player(Scene scene, double frame) {
    this.frame = frame;
    load(scene);
  }

  /**
   * Starts anew with another scene.
   *
   * @param scene the scene
   */
  public void load(Scene scene) {
    beginning = scene;
    begin(scene);
  }

  /** Starts anew with the scene that was loaded last. */
  public void restart() {
    begin(beginning);
  }

  private void begin(Scene scene) {
    world = new World(scene);
    past = world.record(FLIGHTS);
    marks.clear();
    impacts = 0;
    shown = 0;
  }

  /**
   * Lets it run, or stops it.
   *
   * @param running whether {@link #tick} is to go on
   */
  public void setRunning(boolean running) {
    this.running = running;
  }

  /**
   * Whether it runs.
   *
   * @return whether {@link #tick} goes on
   */
  public boolean isRunning() {
    return running;
  }

  /**
   * Sets how fast it runs.
   *
   * @param speed frames a tick, finite and greater than 0
   */
  public void setSpeed(double speed) {
    this.speed = speed;
  }

  /** Goes on by one tick, if it runs. */
  public void tick() {
    if (running) {
      goTo(shown + speed * frame);
    }
  }

  /** Goes on by one frame, and stops. */
  public void stepFrame() {
    running = false;
    goTo(shown + frame);
  }

  private void goTo(double t) {
    if (t > world.now()) {
      advance(t);
      shown = world.now();
    } else {
      shown = t;
    }
  }

  private void advance(double t) {
    world.advanceTo(t); // if it stops before, it goes on with the next tick
    ImpactLog log = world.impacts();
    impacts += log.size();
    for (int row = 0; row < log.size(); row++) {
      marks.add(Mark.of(log, row));
    }
    while (marks.size() > MARKS) {
      marks.remove();
    }
  }

  /**
   * Goes on to the next impact, recorded or new, and stops.
   *
   * @return whether there is one within a million frames
   */
  public boolean nextImpact() {
    running = false;
    for (Mark mark : marks) {
      if (mark.time() > shown) {
        shown = Math.min(mark.time(), world.now());
        return true;
      }
    }
    double t = timeOfNextImpact();
    if (t == Double.POSITIVE_INFINITY) {
      return false;
    }
    long before = impacts;
    advance(t);
    while (impacts == before) { // the log's time is the nearest double, which may be earlier
      advance(Math.nextUp(world.now()));
    }
    shown = world.now();
    return true;
  }

  /** A second world looks ahead, so that this one need not come back. */
  private double timeOfNextImpact() {
    World ahead = new World(world.scene());
    ahead.restore(world.snapshot());
    for (double dt = frame; dt <= HORIZON * frame; dt *= 2) {
      ahead.step(dt);
      if (ahead.impacts().size() > 0) {
        return ahead.impacts().time(0);
      }
    }
    return Double.POSITIVE_INFINITY;
  }

  /**
   * Shows another moment, and stops.
   *
   * @param t any number; what lies outside the recording is taken to its nearer end
   */
  public void seek(double t) {
    running = false;
    shown = Math.max(start(), Math.min(end(), t));
  }

  /**
   * The first moment that can be shown.
   *
   * @return at least 0
   */
  public double start() {
    return past.start();
  }

  /**
   * The last moment that can be shown.
   *
   * @return the time of the world
   */
  public double end() {
    return world.now();
  }

  /**
   * The moment that is shown.
   *
   * @return from {@link #start} to {@link #end}
   */
  public double shown() {
    return Math.max(shown, start());
  }

  /**
   * The impacts so far.
   *
   * @return at least 0
   */
  public long impacts() {
    return impacts;
  }

  /**
   * What is there at the moment shown, to be drawn or saved.
   *
   * @return a scene
   */
  public Scene scene() {
    boolean present = shown() == world.now();
    return present ? WorldScene.of(world) : WorldScene.of(world, past, shown());
  }

  /**
   * The machinery of the world.
   *
   * @return a phrase
   */
  public String engineDescription() {
    return world.engineDescription();
  }

  /** The impacts of the time before the moment shown. */
  List<Mark> marks(double time) {
    return marks.stream().filter(m -> m.time() <= shown() && m.time() > shown() - time).toList();
  }

  /** The time of a frame at speed 1. */
  double frame() {
    return frame;
  }

  /** The recording. */
  Timeline past() {
    return past;
  }

  /** Ids of circles end here. */
  int circles() {
    return world.idLimit(ObstacleKind.CIRCLE);
  }

  // Edits.

  /** A world that stands at what is shown, to be asked only. */
  World look() {
    return shown() < world.now() ? new World(scene()) : world;
  }

  /** The world that goes on, with what is shown as its present: what came later is dropped. */
  World editable() {
    if (shown() < world.now()) {
      begin(scene());
    }
    return world;
  }

  /**
   * Puts a circle elsewhere.
   *
   * @param id the circle
   * @param x the x coordinate of its centre, finite
   * @param y the y coordinate of its centre, finite
   */
  public void moveCircle(int id, double x, double y) {
    editable().setPosition(id, x, y);
  }

  /**
   * Puts a line elsewhere.
   *
   * @param id the line
   * @param to where
   */
  public void moveLine(int id, Line to) {
    editable().moveLine(id, to.ax(), to.ay(), to.bx(), to.by());
  }
}
