// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Obstacle;
import dev.carom.Scene;
import dev.carom.Timeline;
import dev.carom.Traits;
import dev.carom.UnfinishedException;
import dev.carom.World;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.WorldScene;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * A run of a scene that can be stopped, looked at from its beginning to now, and changed by hand.
 * The moment shown may lie in the past: going on from there replays the recording, and an edit
 * begins another future. Needs no screen; for one thread.
 */
public final class Player {

  /** For how long the past is kept, in frames. */
  private static final double KEPT = 10_000;

  /** How many frames are searched for the next impact. */
  private static final double HORIZON = 1e6;

  /** Frames after which a tick looks at the clock. */
  private static final double CHUNK = 16;

  /** A tick ends after this time, so that the window still answers. */
  private static final long TICK_NANOS = 50_000_000;

  /** The work of a call, in impacts: a tenth of the usual budget, for the window waits. */
  private static final long WORK = 200_000;

  private final double frame;
  private final EditTimes jumps = new EditTimes();
  private RunHistory history = new RunHistory();
  private Scene beginning;
  private World world;
  private Timeline past;
  private World look;
  private double shown;
  private double speed = 1;
  private boolean running;
  private int edits;

  /**
   * Starts with a scene at time 0, at rest.
   *
   * @param frame the time of a frame at speed 1, finite and greater than 0
   */
  public Player(Scene scene, double frame) {
    this.frame = frame;
    load(scene);
  }

  /** Starts anew with another scene. */
  public void load(Scene scene) {
    begin(scene);
    beginning = scene;
  }

  /** Starts anew with the scene that was loaded last. */
  public void restart() {
    begin(beginning);
  }

  private void begin(Scene scene) {
    world = new World(scene);
    past = world.record(KEPT);
    history = new RunHistory();
    jumps.clear();
    shown = 0;
    changed();
  }

  private void changed() {
    look = null;
    edits++;
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

  /** Goes on by one tick, if it runs: less far if that takes too long. */
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
    look = null;
    if (t <= world.now()) {
      shown = t;
      return;
    }
    long end = System.nanoTime() + TICK_NANOS;
    boolean reached = true;
    while (reached && world.now() < t && System.nanoTime() < end) {
      reached = advance(Math.min(t, world.now() + CHUNK * frame));
    }
    shown = world.now();
  }

  /** If the world stops before, it goes on with the next call. */
  private boolean advance(double t) {
    boolean reached = world.advanceTo(t, WORK);
    history.add(world.impacts());
    return reached;
  }

  /**
   * Goes on to the next impact, recorded or new, and stops, and returns whether there is one within
   * a million frames.
   */
  public boolean nextImpact() {
    running = false;
    look = null;
    double recorded = history.next(shown);
    if (recorded < Double.POSITIVE_INFINITY) {
      shown = Math.min(recorded, world.now());
      return true;
    }
    double t = timeOfNextImpact();
    if (t == Double.POSITIVE_INFINITY) {
      return false;
    }
    advance(t);
    shown = world.now();
    return true;
  }

  private long allImpacts() {
    return history.impacts(Double.POSITIVE_INFINITY);
  }

  /** A second world looks ahead: where nothing is hit, this one stays where it is. */
  private double timeOfNextImpact() {
    World ahead = new World(world.scene());
    ahead.restore(world.snapshot());
    try {
      boolean hits = ahead.advanceToImpact(world.now() + HORIZON * frame);
      return hits ? ahead.now() : Double.POSITIVE_INFINITY;
    } catch (UnfinishedException e) {
      return Double.POSITIVE_INFINITY;
    }
  }

  /**
   * Shows another moment, and stops.
   *
   * @param t any number; what lies outside the recording is taken to its nearer end
   */
  public void seek(double t) {
    running = false;
    look = null;
    shown = Math.max(start(), Math.min(end(), t));
  }

  /** The first moment that can be shown: at least 0. */
  public double start() {
    return past.start();
  }

  /** The last moment that can be shown: the time of the world. */
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

  /** Whether the end of the run is shown. */
  private boolean isPresent() {
    return shown() >= world.now();
  }

  /** The impacts up to the moment shown: at least 0. */
  public long impacts() {
    return isPresent() ? allImpacts() : history.impacts(shown());
  }

  /** Returns the things at the moment shown, to be drawn or saved. */
  public Scene scene() {
    return WorldScene.of(look());
  }

  /** The ids of the circles of {@link #scene}, in their order there. */
  int[] circleIds() {
    World then = look();
    return Arrays.stream(then.ids(Kind.CIRCLE))
        .filter(id -> Double.isFinite(then.x(id)) && Double.isFinite(then.y(id)))
        .toArray();
  }

  /** The circles of the moment shown; those that hit something in the last frames glow. */
  Still still(Scene scene, double frames) {
    Set<Integer> lately = new HashSet<>();
    marks(frames * frame, Integer.MAX_VALUE).forEach(mark -> lately.add(mark.circle()));
    int[] ids = circleIds();
    return Still.of(scene).glowing(i -> lately.contains(ids[i]));
  }

  /** The impacts of a time before the moment shown, at most so many of the newest, in order. */
  List<Mark> marks(double time, int most) {
    double upTo = isPresent() ? Double.POSITIVE_INFINITY : shown();
    return history.marks(shown() - time, upTo, most);
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
    return world.idLimit(Kind.CIRCLE);
  }

  /** When a circle last jumped, up to the moment shown; minus infinity if it did not. */
  double lastJump(int id) {
    return jumps.last(id, shown());
  }

  /** Grows with each edit, and with each new run. */
  int edits() {
    return edits;
  }

  // Edits.

  /** A world that stands at what is shown, to be asked only. */
  World look() {
    if (isPresent()) {
      return world;
    }
    if (look == null) {
      look = new World(world.scene());
      look.restore(past.snapshot(shown()));
    }
    return look;
  }

  /** The world that goes on, with what is shown as its present: what came later is dropped. */
  private World editable() {
    if (!isPresent()) {
      shown = shown();
      world.restore(past.snapshot(shown));
      history.forgetAfter(shown);
      jumps.forgetAfter(shown);
    }
    changed();
    return world;
  }

  /**
   * Puts a circle elsewhere.
   *
   * @param x the x coordinate of its centre, finite
   * @param y the y coordinate of its centre, finite
   */
  public void moveCircle(int id, double x, double y) {
    editable().setPosition(id, x, y);
    jumps.add(id, world.now());
  }

  /**
   * Gives a circle another velocity.
   *
   * @param vx the x component, finite
   * @param vy the y component, finite
   */
  public void throwCircle(int id, double vx, double vy) {
    editable().setVelocity(id, vx, vy);
  }

  /** Puts a line elsewhere. */
  public void moveLine(int id, Obstacle to) {
    editable().setShape(Kind.LINE, id, to);
  }

  /**
   * Puts a peg elsewhere.
   *
   * @param x the x coordinate of its centre, finite
   * @param y the y coordinate of its centre, finite
   */
  public void movePeg(int id, double x, double y) {
    World now = editable();
    now.setShape(Kind.PEG, id, new Circle(x, y, now.peg(id).radius()));
  }

  /**
   * Sets the gravity.
   *
   * @param gx the x component, finite
   * @param gy the y component, finite
   */
  public void setGravity(double gx, double gy) {
    editable().setGravity(gx, gy);
  }

  /**
   * Adds a circle.
   *
   * @param x the x coordinate of its centre, finite
   * @param y the y coordinate of its centre, finite
   * @param radius finite and greater than 0
   * @param vx the x component of its velocity, finite
   * @param vy the y component of its velocity, finite
   */
  public void addCircle(double x, double y, double radius, double vx, double vy) {
    editable().addCircle(x, y, radius, vx, vy, Traits.DEFAULT);
  }

  /** Adds a line. */
  public void addLine(Line line) {
    editable().addLine(line.ax(), line.ay(), line.bx(), line.by(), Traits.DEFAULT);
  }

  /**
   * Adds a peg.
   *
   * @param x the x coordinate of its centre, finite
   * @param y the y coordinate of its centre, finite
   * @param radius finite and at least 0
   */
  public void addPeg(double x, double y, double radius) {
    editable().addPeg(x, y, radius, Traits.DEFAULT);
  }

  /**
   * Removes something.
   *
   * @param kind not {@link Kind#WALL}
   */
  public void remove(Kind kind, int id) {
    editable().remove(kind, id);
  }
}
