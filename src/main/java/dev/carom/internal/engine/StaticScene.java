// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.search.FlightSearch;
import dev.carom.internal.search.Grid;
import dev.carom.internal.search.Grids;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.EngineDescription;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.util.IntList;
import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/**
 * The static obstacles of a world, the grids over them, and the search for the next impact with
 * them.
 */
public final class StaticScene {

  public final ObstacleTable obstacles;
  private final Grids grids;
  private final FlightSearch search;

  /** The index of questions; steps do not use it. */
  public final ObstacleIndex index;

  /** The grid of each circle, by its class of radii; null for a circle that uses none. */
  private Grid[] ofCircles = new Grid[0];

  public StaticScene(SceneData scene, EngineOptions options) {
    obstacles = ObstacleTable.of(scene);
    grids = new Grids(scene, obstacles, options);
    search = new FlightSearch(obstacles, grids.loose());
    index = new ObstacleIndex(obstacles, options.grid());
    if (scene.hasGravity()) {
      index.beginFalls();
    }
    assign(IntStream.range(0, scene.circleCount()).toArray(), scene::radius);
  }

  private void assign(int[] ids, IntToDoubleFunction radius) {
    ofCircles = new Grid[ids.length == 0 ? 0 : ids[ids.length - 1] + 1];
    for (int i : ids) {
      ofCircles[i] = grids.of(radius.applyAsDouble(i));
    }
  }

  /** The grid of a circle; null if none is used. */
  public Grid grid(int i) {
    return ofCircles[i];
  }

  EngineDescription model(boolean collide) {
    return grids.model(collide);
  }

  /** Extends the prediction of a circle; see {@link FlightSearch#extend}. */
  void extend(MovingCircle m, double needed) {
    search.extend(m, grid(m.id), needed);
  }

  /** Finds the first impact of a circle until a time, see {@link Engine#first}. */
  int first(MovingCircle m, double end) {
    m.lookahead = MovingCircle.EDITED_LOOKAHEAD; // no further than the end
    search.first(m, grid(m.id), end);
    return m.cleared <= end ? m.next : MovingCircle.NOTHING;
  }

  /** Adds the codes of obstacles near a circle, see {@link FlightSearch#addNear}. */
  void addNear(MovingCircle m, double reach, double now, IntList into) {
    search.addNear(m, grid(m.id), reach, now, into);
  }

  /** Whether a flight, if it never ended, would hit a line or a peg. */
  boolean meets(MovingCircle m, int code) {
    return search.meets(m, code);
  }

  /** Registers a circle's radius, which may be new. */
  public void setRadius(int i, double radius) {
    if (i >= ofCircles.length) {
      ofCircles = Arrays.copyOf(ofCircles, 2 * i + 4);
    }
    if (!grids.serve(ofCircles[i], radius)) {
      ofCircles[i] = grids.ofNew(radius);
    }
  }

  /** Updates the grids and the search after a line or a peg was added, changed or removed. */
  public void changed(int code) {
    if (!obstacles.moves(code)) { // what moves is in no grid
      grids.changed(code);
      index.changed(code);
    }
    search.lookAgain(code);
  }

  /** Rebuilds grids that edits have made inefficient. */
  public void prepare(CircleTable circles, CircleRegistry registry) {
    if (grids.areStale()) {
      int[] slots = registry.slots();
      grids.remake(circles, slots);
      assign(slots, circles::radius);
    }
  }

  /** Prepares for circles that fall. */
  void beginFalls() {
    grids.beginFalls();
    index.beginFalls();
    Arrays.fill(ofCircles, null);
  }

  /** Drops all grids and the index of questions: the next step or question makes new ones. */
  void forgetGrids() {
    grids.forget();
    index.changedAll();
    Arrays.fill(ofCircles, null);
  }

  /** Replaces the obstacles. */
  public void restore(ObstacleTable other) {
    if (!obstacles.equals(other)) {
      forgetGrids();
    }
    obstacles.set(other);
    search.lookAgainAtAll();
    index.changedAll();
  }

  /** Prepares the search for a step from now to a given time. */
  void beginStep(double now, double end) {
    search.beginStep(now, end);
  }

  /**
   * Replaces the prediction of a circle by the sensors that were reported: all those met by now, up
   * to the next impact if that is due now. A save must not depend on how far ahead a search went:
   * two equal worlds have equal snapshots, whenever each of them searched last.
   */
  public void forgetPrediction(MovingCircle m, double now) {
    if (!obstacles.haveSensors()) {
      m.forgetPrediction(0, 0);
      return;
    }
    m.lookahead = MovingCircle.EDITED_LOOKAHEAD;
    while (m.next == MovingCircle.NOTHING && m.known() <= now) {
      extend(m, now - m.t);
    }
    if (m.known() > now) {
      m.forgetPrediction(m.latestBy(now), Integer.MAX_VALUE);
    } else {
      m.forgetPrediction(m.cleared, sensedBefore(m.next));
    }
  }

  /**
   * The highest code among the sensors met at the time of the next impact that count as reported.
   *
   * @param code the code of the next impact
   */
  public int sensedBefore(int code) {
    return obstacles.isSensor(code) ? code - 1 : Integer.MAX_VALUE;
  }
}
