// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.IntList;

/**
 * Finds the next impact of a flight with an obstacle: among those at rest by {@link StraightSearch}
 * or {@link FallSearch}, then among those that move, which a {@link MotionWindow} indexes.
 */
public final class FlightSearch {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** A window lasts for so many more steps like the one at which it begins. */
  private static final int STEPS_OF_WINDOW = 64;

  private final ObstacleTable obstacles;
  private final CodeSet loose;
  private final StraightSearch straight;
  private final FallSearch falls;
  private final MotionWindow window = new MotionWindow();

  /** Searches among obstacles; those in the given list are in no grid. */
  public FlightSearch(ObstacleTable obstacles, CodeSet loose) {
    this(obstacles, loose, obstacles.extent());
  }

  /** A search among the same obstacles as another one, in its initial state. */
  FlightSearch(FlightSearch other) {
    this(other.obstacles, other.loose, other.straight.extent);
  }

  private FlightSearch(ObstacleTable obstacles, CodeSet loose, double extent) {
    this.obstacles = obstacles;
    this.loose = loose;
    straight = new StraightSearch(obstacles, loose);
    falls = new FallSearch(obstacles, loose);
    straight.extent = extent;
  }

  private CellWalk searchOf(MovingCircle m) {
    return m.isFalling() ? falls : straight;
  }

  // Changes and steps.

  /** Notes that a line or a peg was added, moved or removed. */
  public void lookAgain(int code) {
    window.changed(obstacles.motions(), code);
    if (!obstacles.moves(code)) {
      straight.extent = Math.max(straight.extent, obstacles.extent(code));
    }
  }

  /** Notes that any obstacle may have changed. */
  public void lookAgainAtAll() {
    window.changedAll();
    straight.extent = obstacles.extent();
  }

  /**
   * Prepares for searches from a time on, for a step that ends at a given time. The window lasts
   * for more such steps.
   */
  public void beginStep(double now, double end) {
    if (obstacles.areMoving() && !(now >= window.begin && end < window.end)) {
      double length = Math.max(end - now, Math.ulp(end));
      window.open(now, end + STEPS_OF_WINDOW * length);
    }
  }

  // Questions.

  /**
   * Searches the path of a circle further: up to its next impact, or beyond the time asked for.
   *
   * @param grid the grid of the obstacles, or null to test each of them
   * @param needed the time, from the start of the flight, up to which the path must be known
   */
  public void extend(MovingCircle m, Grid grid, double needed) {
    extend(m, grid, needed, false, false);
  }

  private void extend(
      MovingCircle m, Grid grid, double needed, boolean passesSensors, boolean ordersExactly) {
    if (m.mode == MovingCircle.AWAKE && (passesSensors || !obstacles.haveSensors())) {
      m.clearUpTo(NEVER);
      return;
    }
    CellWalk search = searchOf(m);
    double from = m.cleared;
    search.passesSensors = passesSensors;
    search.ordersExactly = ordersExactly;
    search.start(m);
    double known = NEVER;
    if (isFinite(m)) {
      known =
          search.moving ? searchAmongAll(search, grid, from, needed) : search.search(grid, needed);
    }
    if (search.best <= known && search.best != NEVER) {
      m.predict(search.best, search.bestCode, search.contact());
    } else {
      m.clearUpTo(known);
    }
  }

  private static boolean isFinite(MovingCircle m) {
    return Math.abs(m.x) <= Double.MAX_VALUE && Math.abs(m.y) <= Double.MAX_VALUE;
  }

  /**
   * Searches among the obstacles at rest, then among the moving ones: those in the window of time
   * that the path may meet, no further than the window goes. Outside of the window, all of them.
   */
  private double searchAmongAll(CellWalk search, Grid grid, double from, double needed) {
    MovingCircle m = search.body;
    double start = obstacles.epoch() + m.t;
    double end = window.end - start - m.tl;
    if (!(start + from >= window.begin && from < end)) {
      double known = search.search(grid, needed);
      for (int i = 0; i < obstacles.motions().count(); i++) {
        search.considerMoving(i, known);
      }
      return known;
    }
    m.lookahead = MovingCircle.EDITED_LOOKAHEAD; // no further than the window
    double known = Math.min(search.search(grid, Math.max(needed, end)), end);
    search.findMoving(window, from, known);
    for (int word = 0; word < window.found.length; word++) {
      for (long bits = window.found[word]; bits != 0; bits &= bits - 1) {
        search.considerMoving(word * Long.SIZE + Long.numberOfTrailingZeros(bits), known);
      }
    }
    return known;
  }

  /**
   * Finds the first impact of a circle, sensors ignored, until a time of its flight.
   *
   * @param m receives the impact: {@code next}, {@code contact} and {@code cleared}; {@code next}
   *     is NOTHING if it is later than the end by rounded times
   */
  public void first(MovingCircle m, Grid grid, double end) {
    first(m, grid, end, false);
  }

  /**
   * The same, where impacts of equal rounded times are compared exactly. Among exactly equal times
   * the smallest code is first.
   */
  public void cast(MovingCircle m, Grid grid, double end) {
    first(m, grid, end, true);
  }

  private void first(MovingCircle m, Grid grid, double end, boolean ordersExactly) {
    do {
      extend(m, grid, end, true, ordersExactly);
    } while (m.next == MovingCircle.NOTHING && m.cleared <= end && m.cleared < NEVER);
  }

  /** The exact time of the next impact of a circle. */
  public RealRoot exactTime(MovingCircle m) {
    return searchOf(m).exactTime(m);
  }

  /** Whether a flight, followed for ever from its start, meets a line or a peg. */
  public boolean meets(MovingCircle m, int code) {
    CellWalk search = searchOf(m);
    search.passesSensors = false;
    search.start(m);
    search.forgetHits();
    if (isFinite(m)) {
      int moving = obstacles.motions().indexOf(code);
      if (moving >= 0) {
        search.considerMoving(moving, NEVER);
      } else {
        search.considerOnly(code);
      }
    }
    return search.bestCode == code;
  }

  /**
   * Adds the codes of the obstacles that may be nearer to a circle at its place than a given
   * distance; some may be there more than once.
   *
   * @param now the time at which it is there
   */
  public void addNear(MovingCircle m, Grid grid, double reach, double now, IntList into) {
    double most = m.radius + reach;
    addWalls(m, most, into);
    if (grid == null) {
      for (int kind = 0; kind < obstacles.kinds.size(); kind++) {
        addAll(obstacles.kinds.get(kind).present(), into);
      }
      return;
    }
    for (int k = 0; k < loose.size; k++) {
      into.add(loose.codes[k]);
    }
    grid.addNear(m.x, m.y, reach, into);
    addMoving(m, most, now, into);
  }

  private void addWalls(MovingCircle m, double most, IntList into) {
    double[] walls = obstacles.walls;
    for (int code = 0; walls != null && code < walls.length; code++) {
      double place = Codes.isVertical(code) ? m.x : m.y;
      if (Codes.inwards(code) * (place - walls[code]) <= most) {
        into.add(code);
      }
    }
  }

  private static void addAll(LiveCodes codes, IntList into) {
    for (int k = 0; k < codes.size(); k++) {
      into.add(codes.get(k));
    }
  }

  private void addMoving(MovingCircle m, double most, double now, IntList into) {
    ObstacleMotions motions = obstacles.motions();
    double time = obstacles.epoch() + now;
    boolean isIndexed = time >= window.begin && time < window.end;
    if (isIndexed && motions.count() > 0) {
      window.find(obstacles, m.x - most, m.y - most, m.x + most, m.y + most);
    }
    for (int i = 0; i < motions.count(); i++) {
      if (!isIndexed || (window.found[i / Long.SIZE] >> i & 1) != 0) {
        into.add(motions.code(i));
      }
    }
  }
}
