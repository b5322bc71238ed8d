// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.FlightRecorder;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.SavedFlights;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.util.Index;

/**
 * What moves the circles of a world: one way if they ignore each other, another if they collide.
 * Between steps a world may edit them; what it asks for is checked.
 */
public abstract class Engine {

  final CircleRegistry registry;
  public final CircleTable circles;
  public final StaticScene staticScene;
  final ObstacleResponse response;
  final ImpactRows log;

  /** Whether the budget was spent in the last {@link #advance}. */
  public boolean unfinished;

  /** If so, the slot of the circle that spent it. */
  public int spender = Index.NONE;

  /** Null unless flights are recorded. */
  FlightRecorder recorder;

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
    circles.walls = staticScene.obstacles.walls;
    response = new ObstacleResponse(staticScene.obstacles);
  }

  /**
   * Advances all circles to the given time, or, if the budget of work is spent first, to an earlier
   * one.
   *
   * @return the time reached
   */
  public abstract double advance(double end);

  /**
   * The same up to the first impact: to the first double that is not before it, at most to the
   * given time.
   */
  public abstract double advanceToImpact(double end);

  /** What is used, in words. */
  public abstract String engineDescription();

  /**
   * Begins a new flight of a circle, whose id may be the next one, with what a mover holds.
   *
   * @param m a mover at the start of a flight, now
   */
  abstract void beginFlight(MovingCircle m);

  /**
   * An edit comes after all that happened by now, some of it later than now by what rounding took.
   *
   * @return the tail of the time of an edit of this circle now
   */
  abstract double tailOfEdit(MovingCircle m, double now);

  /** Takes a circle out. */
  abstract void remove(int i);

  /** Stores a circle of which less is known ahead than before. */
  abstract void store(int i, MovingCircle m);

  /** Makes grids anew where edits made them poor. */
  final void prepare() {
    staticScene.prepare(circles, registry);
  }

  // Lines and pegs.

  /** Forgets a line or a peg that is to be elsewhere, otherwise there, or gone. */
  final void forget(int code) {
    int sensed = staticScene.sensedBefore(code);
    LiveCodes present = registry.present();
    for (int k = 0; k < present.size(); k++) {
      int i = present.get(k);
      circles.load(i);
      if (registry.contains(i) && circles.mover.forget(code, sensed)) {
        store(i, circles.mover);
      }
    }
  }

  /**
   * Takes notice that a line or a peg is new, elsewhere, or otherwise there than before: circles
   * whose flight meets it begin a new one now.
   */
  final void appeared(int code, double now) {
    changed(code, now);
    MovingCircle m = circles.mover;
    LiveCodes present = registry.present();
    for (int k = 0; k < present.size(); k++) {
      int i = present.get(k);
      if (registry.contains(i)) {
        circles.load(i);
        if (staticScene.meets(m, code)) {
          m.restart(now, tailOfEdit(m, now), circles.walls);
          beginFlight(m);
        }
      }
    }
  }

  /** Takes notice that a line or a peg is gone, after it was forgotten. */
  final void disappeared(int code, double now) {
    changed(code, now);
  }

  private void changed(int code, double now) {
    staticScene.changed(code);
    if (recorder != null) {
      recorder.noteObstacle(code, staticScene.obstacles, now);
    }
  }

  // Time.

  /** Records new flights, or none for null; those of now first. */
  public final void record(FlightRecorder recorder) {
    this.recorder = recorder;
    if (recorder != null) {
      for (int i : registry.slots()) {
        circles.load(i);
        recorder.add(circles.mover);
      }
    }
  }

  /** The flights of all circles. */
  public SavedFlights save(double now) {
    if (staticScene.obstacles.haveSensors()) {
      staticScene.prepare(circles, registry); // to search for those that were met
    }
    SavedFlights states = new SavedFlights(registry.ids());
    int[] slots = registry.slots();
    for (int k = 0; k < slots.length; k++) {
      circles.load(slots[k]);
      registry.toIds(circles.mover);
      staticScene.save(k, circles.mover, now, states);
    }
    return states;
  }

  /** Takes over other flights: those of all circles that are in the roster by now. */
  public void restore(SavedFlights flights, double now) {
    circles.clear();
    MovingCircle m = circles.mover;
    for (int i = 0; i < flights.count(); i++) {
      circles.add();
      flights.get(i, m);
      m.id = i;
      registry.toSlots(m);
      staticScene.setRadius(i, m.radius);
      store(i, m);
    }
  }

  /** Makes arrays dense anew in which most slots are of circles that were removed. */
  public void compact(double now) {
    SavedFlights flights = save(now);
    registry.set(registry);
    restore(flights, now);
  }
}
