// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.EngineDescription;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.FlightTable;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.TimelineRecorder;
import dev.carom.internal.state.WorldState;

/**
 * Advances the circles of a world. There is one engine for circles that ignore each other and one
 * for circles that collide. Between steps a world may edit the circles; {@link Editor} has then
 * checked the arguments.
 */
public abstract class Engine {

  /** The usual budget of a call, in units of work: of all circles, and for each besides. */
  static final int WORK_PER_CALL = 2_000_000;

  static final int WORK_PER_CIRCLE = 1_000;

  final CircleRegistry registry;
  public final CircleTable circles;
  public final StaticScene staticScene;
  final ObstacleResponse response;
  final ImpactRows log;
  public final Gravity gravity;

  /** The time of the last event, or of the end of the last step. */
  double reached;

  /** Whether the last {@link #advance} exhausted the budget. */
  public boolean unfinished;

  /** The work of all calls. A unit is an impact or another event, or exact work as long. */
  public long spent;

  /** A circle to record. */
  private final MovingCircle changed = new MovingCircle();

  /** Null unless flights are recorded. */
  TimelineRecorder recorder;

  Engine(
      SceneData scene,
      CircleRegistry registry,
      CircleTable circles,
      EngineOptions options,
      ImpactRows log) {
    this.registry = registry;
    this.circles = circles;
    this.log = log;
    staticScene = new StaticScene(scene, options);
    circles.setFilters(registry, staticScene.obstacles);
    gravity = new Gravity(scene.gx, scene.gy);
    response = new ObstacleResponse(staticScene.obstacles, registry, gravity, staticScene::addNear);
    if (gravity.acts()) {
      circles.allowGravity();
    }
  }

  /** Lets a circle fly freely: it falls unless its mass is infinite. */
  final void release(MovingCircle m) {
    if (m.isCarried() && Codes.isCircle(m.last)) {
      m.last = MovingCircle.NOTHING; // relative to that circle it moves otherwise from now on
    }
    if (registry.mass(m.id) < Double.POSITIVE_INFINITY) {
      m.fall(gravity.x, gravity.y);
    } else {
      m.fall(0, 0);
    }
  }

  /** Sets gravity, for flights that begin from now on. */
  public final void setGravity(double gx, double gy) {
    gravity.set(gx, gy);
    if (gravity.acts()) {
      allowContact();
    }
    changeGravity();
  }

  /** Prepares for circles that fall, or are in contact with something that turns. */
  private void allowContact() {
    if (!circles.allowsGravity()) {
      circles.allowGravity();
      staticScene.beginFalls();
      beginGravity();
    }
  }

  /** Prepares for flights that are not straight, the first of this world. */
  void beginGravity() {}

  /** Forgets all that depends on gravity, when no circle is in contact. */
  void changeGravity() {}

  /** The work that a call may do if its caller does not say how much. */
  public final long usualWork() {
    return WORK_PER_CALL + (long) WORK_PER_CIRCLE * registry.count();
  }

  /**
   * Advances all circles to the given time, or to an earlier one if the budget is exhausted.
   * Obstacles that arrive on the way rest from then on. Those that arrive at the given time itself
   * do so once the world goes on: an edit may give them another motion before.
   *
   * @param work the budget
   * @param toImpact whether to go no further than to the first double that is not before the next
   *     impact, or the next event of another kind
   * @return the time reached
   */
  public final double advance(double end, long work, boolean toImpact) {
    long limit = spent + work;
    while (true) {
      double goal = Math.min(end, staticScene.obstacles.nextArrival());
      long rest = limit - spent;
      double time = toImpact ? playToImpact(goal, rest) : play(goal, rest);
      boolean stops = time < goal || unfinished || (toImpact && log.size() > 0);
      if (stops || goal == end) {
        return time;
      }
      arrive(goal);
    }
  }

  /** Lets the obstacles rest that arrive now. All events up to now are done. */
  private void arrive(double now) {
    ObstacleTable obstacles = staticScene.obstacles;
    if (recorder != null) {
      recorder.advance(now); // the flights up to now, before those that begin
    }
    for (int i = 0; i < obstacles.motions().count(); i++) {
      if (obstacles.motions().until(i) == now) {
        setVelocity(obstacles.motions().code(i), 0, 0, now);
        spent++;
      }
    }
    if (recorder != null) {
      stand(now);
    }
  }

  /** Advances all circles to a time before which no obstacle arrives, see {@link #advance}. */
  abstract double play(double end, long work);

  /** The same, no further than to the next impact. */
  abstract double playToImpact(double end, long work);

  /** The slot of the circle that spent most of the work of the last call, if that was too much. */
  public abstract int spender();

  /** The search structures in use. */
  public abstract EngineDescription description();

  /**
   * Begins a new flight of a circle, which may be a new one.
   *
   * @param m the state at the start of the flight, now
   */
  abstract void beginFlight(MovingCircle m);

  /**
   * The tail of the time of an edit. An edit comes after all events up to now, and rounding may
   * have placed some of these slightly after now.
   *
   * @return the tail of the time of an edit of this circle now
   */
  abstract double tailOfEdit(MovingCircle m, double now);

  /** Removes a circle. */
  abstract void remove(int i);

  /** Stores a circle whose prediction was shortened. */
  abstract void store(int i, MovingCircle m);

  /** Lets circles that a circle crushed, or that jam with it, hit it again. */
  void leaveJamsOf(int i) {}

  /** Takes a circle that is about to change out of contact; it has its momentum then. */
  abstract void leaveContact(MovingCircle m, double now);

  /** Notes for contact that an obstacle or a circle comes, goes or changes. */
  abstract void noteContact(int code, double now);

  /** Prepares the search structures for a step that ends at a given time. */
  final void prepare(double end) {
    staticScene.prepare(circles, registry);
    staticScene.beginStep(reached, end);
  }

  /**
   * Finds what a circle would hit first on a path of its own, past sensors, while no obstacle
   * moves. It changes nothing.
   *
   * @param m the start of the path, at time 0; it receives the circle's radius and filter
   * @param i the circle
   * @return the code of the obstacle; of several at the same rounded time the smallest one; NOTHING
   *     if there is none until the end
   */
  public final int first(MovingCircle m, int i, double end) {
    staticScene.prepare(circles, registry);
    m.id = i;
    m.radius = circles.radius(i);
    m.filter = registry.filter(i);
    return staticScene.first(m, end);
  }

  // Lines and pegs.

  /** Discards all predictions about a line or a peg that is about to change. */
  final void forget(int code) {
    noteContact(code, reached);
    int sensed = staticScene.sensedBefore(code);
    LiveCodes present = registry.present();
    for (int k = 0; k < present.size(); k++) {
      int i = present.get(k);
      if (registry.contains(i) && circles.mayKnow(i, code)) {
        circles.load(i);
        if (isCarriedBy(circles.body, code)) {
          letGo(circles.body, code);
        } else if (circles.body.forget(code, sensed)) {
          store(i, circles.body);
          noteChange(i, reached);
        }
      }
    }
  }

  /** Whether a circle slides on an obstacle, or will soon. */
  private static boolean isCarriedBy(MovingCircle m, int code) {
    return m.support == code || m.landing == code;
  }

  /** Lets a circle fall, as what holds or presses it is edited. */
  final void letGo(MovingCircle m, int code) {
    leaveContact(m, reached);
    m.restart(reached, tailOfEdit(m, reached), staticScene.obstacles);
    m.forget(code, 0);
    release(m);
    beginFlight(m);
  }

  /**
   * Handles a line or a peg that was added or changed. Circles whose flight hits it begin a new
   * flight now.
   */
  final void appeared(int code, double now) {
    changed(code, now);
    restartWhatMeets(code, now);
  }

  private void restartWhatMeets(int code, double now) {
    MovingCircle m = circles.body;
    LiveCodes present = registry.present();
    for (int k = 0; k < present.size(); k++) {
      int i = present.get(k);
      if (registry.contains(i)) {
        circles.load(i);
        if (staticScene.meets(m, code)) {
          m.restart(now, tailOfEdit(m, now), staticScene.obstacles);
          beginFlight(m);
        }
      }
    }
  }

  /** Lets a line or a peg move with a velocity, from now on. */
  final void setVelocity(int code, double ux, double uy, double now) {
    boolean isInGrids = !staticScene.obstacles.moves(code);
    forget(code); // circles that it lets go search with the grids as they are
    staticScene.obstacles.setVelocity(code, ux, uy, now);
    moved(code, isInGrids, now);
  }

  /** Lets a line or a peg move until it arrives, see {@link ObstacleTable#moveTo}. */
  final void moveTo(int code, double[] numbers, double[] motion, double now) {
    boolean isInGrids = !staticScene.obstacles.moves(code);
    forget(code);
    staticScene.obstacles.moveTo(code, numbers, motion);
    if (staticScene.obstacles.turns(code) && !circles.allowsGravity()) {
      allowContact();
      changeGravity();
    }
    moved(code, isInGrids, now);
  }

  /**
   * Handles a new motion. That of an outline is known when its last side has it: two sides tell
   * whether a vertex is hit.
   */
  private void moved(int code, boolean isInGrids, double now) {
    ObstacleTable obstacles = staticScene.obstacles;
    if (isInGrids && obstacles.moves(code)) {
      staticScene.forgetGrids();
    }
    changed(code, now);
    int first = code + 1 < obstacles.endOf(code) ? code + 1 : obstacles.firstOf(code);
    for (int each = first; each <= code; each++) {
      restartWhatMeets(each, now);
    }
  }

  /** Handles a change of a line or a peg that no flight meets, such as its removal. */
  final void changed(int code, double now) {
    staticScene.changed(code);
    noteContact(code, now);
    noteObstacle(code, now);
    if (!gravity.acts() && circles.allowsGravity() && !staticScene.obstacles.areTurning()) {
      endContact(now);
    }
  }

  /** Lets all circles fly that are in contact, as nothing presses them together any more. */
  private void endContact(double now) {
    MovingCircle m = circles.body;
    LiveCodes present = registry.present();
    for (int k = 0; k < present.size(); k++) {
      int i = present.get(k);
      if (registry.contains(i) && circles.isMember(i)) {
        circles.load(i);
        leaveContact(m, now);
        m.restart(now, tailOfEdit(m, now), staticScene.obstacles);
        m.forget();
        release(m);
        beginFlight(m);
      }
    }
  }

  // Time.

  /** Sets the recorder of flights, which first receives the current ones; null to stop. */
  public final void record(TimelineRecorder recorder) {
    this.recorder = recorder;
    if (recorder != null) {
      recorder.noteTail(reached, lastTail(reached));
      for (int i : registry.slots()) {
        circles.load(i);
        saveContact(circles.body);
        recorder.add(circles.body, circles.body.t);
      }
    }
  }

  /** Lets a recording stand here before a step, if the world was edited. */
  public final void standBefore(double now) {
    if (recorder.isStandDue()) {
      stand(now);
      recorder.clearDue();
    }
  }

  /** Lets a recording stand here after a step, if it is time. */
  public final void standAfter(double now) {
    if (!recorder.isAtRest() && (recorder.isLong() || !anyTicks())) {
      stand(now);
    } else if (recorder.isStand(now)) { // a flight in contact does not keep the tail
      recorder.noteTail(now, lastTail(now));
    }
  }

  private boolean anyTicks() {
    boolean any = false;
    LiveCodes present = registry.present();
    for (int k = 0; k < present.size() && !any; k++) {
      int i = present.get(k);
      any = registry.contains(i) && circles.isMember(i) && !circles.isFrozen(i);
    }
    return any;
  }

  /** Tells a recording all that contact knows now. */
  final void stand(double now) {
    int flying = 0;
    LiveCodes present = registry.present();
    for (int k = 0; k < present.size(); k++) {
      int i = present.get(k);
      if (registry.contains(i) && circles.isMember(i)) {
        circles.load(i, changed);
        saveContact(changed);
        recorder.keepContact(changed, now);
        flying += circles.isFrozen(i) ? 0 : 1;
      }
    }
    recorder.stand(now, flying);
    recorder.noteTail(now, lastTail(now));
  }

  /** The tail of the last event of circles that collide if that was now; else 0. */
  public abstract double lastTail(double now);

  /** Records that a line or a peg was added, changed or removed; walls are watched otherwise. */
  final void noteObstacle(int code, double now) {
    if (recorder != null && !Codes.isWall(code)) {
      recorder.noteObstacle(code, now);
    }
  }

  /** Records a circle that something changed within its flight. */
  final void noteChange(int i, double now) {
    if (recorder != null) {
      circles.load(i, changed);
      saveContact(changed);
      recorder.add(changed, now);
    }
  }

  /** The flights of all circles. */
  public FlightTable save(double now) {
    if (staticScene.obstacles.haveSensors()) {
      staticScene.prepare(circles, registry); // the search for met sensors needs the grids
    }
    int[] slots = registry.slots();
    FlightTable states = new FlightTable(slots.length);
    for (int k = 0; k < slots.length; k++) {
      circles.load(slots[k]);
      saveContact(circles.body);
      registry.toIds(circles.body);
      staticScene.forgetPrediction(circles.body, now);
      states.put(k, circles.body);
    }
    return states;
  }

  /** Completes a circle that is in contact, before it is saved. */
  void saveContact(MovingCircle m) {}

  /**
   * Replaces all flights by saved ones, which are those of the circles in the registry.
   *
   * @param tailOfEdit see {@link WorldState#tailOfEdit}
   */
  public void restore(FlightTable flights, double now, double tailOfEdit) {
    reached = now;
    circles.clear();
    if (flights.allowsGravity() || staticScene.obstacles.areTurning()) {
      allowContact();
    }
    MovingCircle m = circles.body;
    for (int i = 0; i < flights.capacity(); i++) {
      circles.add();
      flights.get(i, m);
      m.id = i;
      registry.toSlots(m);
      staticScene.setRadius(i, m.radius);
      store(i, m);
    }
  }

  /** Compacts arrays in which most slots belong to removed circles. */
  public void compact(double now) {
    FlightTable flights = save(now);
    registry.set(registry);
    restore(flights, now, lastTail(now));
  }
}
