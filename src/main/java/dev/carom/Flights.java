// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The flights of circles that ignore each other. Each circle is alone, so each is advanced to the
 * end of a step at once, without a queue; one comparison tells that nothing happens to it in a
 * step.
 */
final class Flights implements Engine {

  /** Circles that a step may advance before the journal grows. */
  private static final int JOURNAL = 1024;

  /** Impacts in one call, shared by all circles; see {@link World}. */
  static final int IMPACTS_PER_CALL = 4_000_000;

  private static final int LEAST_IMPACTS_PER_CALL = 10_000;

  private final Circles circles;
  private final int allowance;

  /** The grid of each circle's class of radius, null where none is used. */
  private final Grid[] grid;

  private final Model model;
  private final BroadSearch search;
  private final ObstacleResponse response;
  private final ImpactLog log;
  private final Journal journal;
  private boolean unfinished;

  Flights(Scene scene, Machinery machinery, ImpactLog log) {
    this.log = log;
    Obstacles obstacles = Obstacles.of(scene);
    Grids grids = new Grids(scene, obstacles, machinery);
    model = grids.model();
    int count = scene.circleCount();
    allowance = Math.max(LEAST_IMPACTS_PER_CALL, IMPACTS_PER_CALL / Math.max(1, count));
    circles = new Circles(count);
    grid = new Grid[count];
    journal = new Journal(Math.min(count, JOURNAL), Circles.STATE, Circles.CODES);
    search = new BroadSearch(obstacles);
    response = new ObstacleResponse(obstacles, 1_000 + 10 * count);
    for (int i = 0; i < count; i++) {
      circles.start(scene, i);
      grid[i] = grids.of(circles.mover.radius);
      search.extend(circles.mover, grid[i], 0);
      circles.store(i);
    }
  }

  @Override
  public Circles circles() {
    return circles;
  }

  @Override
  public String model() {
    return model.toString();
  }

  /**
   * Advances all circles to the given time, or, if one of them makes as many impacts as allowed
   * before, to the time of the last of these.
   *
   * @return the time reached
   */
  @Override
  public double advance(double end) {
    journal.clear();
    unfinished = false;
    double reached = end;
    double goal;
    do {
      goal = reached;
      reached = pass(goal);
      if (reached < goal) {
        journal.restore(circles.due, circles.jams, circles.state, circles.codes);
        log.clear();
      }
    } while (reached < goal);
    return reached;
  }

  @Override
  public boolean unfinished() {
    return unfinished;
  }

  private double pass(double end) {
    double[] due = circles.due;
    for (int i = 0; i < due.length; i++) {
      if (due[i] <= end) {
        journal.save(i, due[i], circles.jam(i), circles.state, circles.codes);
        circles.load(i);
        boolean spent = fly(circles.mover, grid[i], end);
        circles.store(i);
        if (spent) {
          unfinished = true;
          if (circles.mover.t < end) {
            return circles.mover.t;
          }
        }
      }
    }
    return end;
  }

  /** Resolves the mover's impacts until the given time; tells whether the allowance was spent. */
  private boolean fly(Mover m, Grid grid, double end) {
    int impacts = 0;
    do {
      if (m.next == Mover.NOTHING) {
        search.extend(m, grid, end - m.t);
      } else {
        if (impacts == allowance) {
          return true;
        }
        response.resolve(m, log);
        impacts++;
      }
    } while (m.due() <= end);
    return false;
  }
}
