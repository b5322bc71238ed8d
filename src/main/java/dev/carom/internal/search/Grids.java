// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.EngineDescription;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import java.util.Map;
import java.util.TreeMap;

/**
 * The grids of a world: one for each power of two among the radii of its circles, made for the
 * largest radius of that class. So small circles do not search obstacles that only large ones can
 * touch.
 *
 * <p>Obstacles that are added or moved later are <i>loose</i>: each search tests them all, until
 * they are so many that new grids pay.
 */
public final class Grids {

  /** Up to this many lines and pegs no grid is made: measured, it would gain nothing. */
  private static final int FEW = 8;

  private final ObstacleTable obstacles;
  private final EngineOptions options;
  private final Map<Integer, Grid> byExponent = new TreeMap<>();
  private final CodeSet loose = new CodeSet();
  private boolean isDirty;

  /** The margin of their lists. */
  private double margin = Grid.MARGIN;

  /** Whether some obstacle is neither in the grids nor in the list of loose ones. */
  private boolean isIncomplete;

  public Grids(SceneData scene, ObstacleTable obstacles, EngineOptions options) {
    this.obstacles = obstacles;
    this.options = options;
    if (scene.hasGravity()) {
      margin = Grid.MARGIN_OF_FALLS;
    }
    if (wanted()) {
      largestRadii(scene).forEach(this::make);
    }
  }

  private boolean wanted() {
    int size = obstacles.staticSize();
    boolean chosen = options.cell() == 0;
    return options.grid() && size > (chosen ? FEW : 0) && Grid.serves(obstacles.extent());
  }

  private void make(int exponent, double radius) {
    byExponent.put(exponent, new Grid(obstacles, radius, options.cell(), margin));
  }

  private static Map<Integer, Double> largestRadii(SceneData scene) {
    Map<Integer, Double> largest = new TreeMap<>();
    for (int i = 0; i < scene.circleCount(); i++) {
      double radius = scene.radius(i);
      largest.merge(Math.getExponent(radius), radius, Math::max);
    }
    return largest;
  }

  /** The grid for circles of a given radius, null if none is used. */
  public Grid of(double radius) {
    return byExponent.get(Math.getExponent(radius));
  }

  /**
   * Whether a circle's grid still serves its radius.
   *
   * @param grid its grid, made since {@link #forget}; or null, for a circle that uses none
   */
  public boolean serve(Grid grid, double radius) {
    return grid == null
        ? byExponent.isEmpty() && !wanted()
        : !byExponent.isEmpty()
            && radius <= grid.radius
            && Math.getExponent(radius) == Math.getExponent(grid.radius);
  }

  /** The grid for circles of a radius that may be new, made if need be; null if none is used. */
  public Grid ofNew(double radius) {
    Grid grid = of(radius);
    if (grid != null && radius <= grid.radius) {
      return grid;
    }
    if (!wanted()) {
      return null; // even if smaller circles have a grid
    }
    // Made for the whole class of radii, so that the next circle of that class finds it.
    make(Math.getExponent(radius), Math.scalb(1.0, Math.getExponent(radius) + 1));
    return of(radius);
  }

  /** The obstacles that are in no grid: each search has to test them. */
  public CodeSet loose() {
    return loose;
  }

  /** Notes that a line or a peg was added or moved. */
  public void changed(int code) {
    isDirty = true;
    if (!areTooLoose()) {
      loose.add(code);
    } else {
      isIncomplete = true;
    }
  }

  /**
   * Whether the loose obstacles are so many that the grids have to be made anew. Further ones are
   * then not listed.
   */
  private boolean areTooLoose() {
    return areTooMany(loose.size, obstacles.staticSize());
  }

  /** Whether so many loose obstacles beside an index of so many cost more than a new index. */
  static boolean areTooMany(int loose, int indexed) {
    return loose > FEW + Math.sqrt(indexed);
  }

  /** Prepares for circles that fall: drops all grids. */
  public void beginFalls() {
    margin = Grid.MARGIN_OF_FALLS;
    forget();
  }

  /** Drops all grids: the next search needs new ones. */
  public void forget() {
    byExponent.clear();
    loose.clear();
    isIncomplete = true; // a grid that is made for a single circle does not serve the others
    isDirty = true;
  }

  /** Whether the grids have to be made anew before the next search. */
  public boolean areStale() {
    boolean stale = isDirty && (byExponent.isEmpty() ? wanted() : isIncomplete || areTooLoose());
    isDirty = false;
    return stale;
  }

  /** Makes the grids anew, for the radii of the circles at these slots. */
  public void remake(CircleTable circles, int[] slots) {
    loose.clear();
    isIncomplete = false;
    byExponent.clear();
    for (int slot : slots) {
      ofNew(circles.radius(slot));
    }
  }

  public EngineDescription model(boolean collide) {
    int cells = byExponent.values().stream().mapToInt(Grid::cells).sum();
    int moving = obstacles.motions().count();
    return new EngineDescription(collide, obstacles.staticSize(), moving, byExponent.size(), cells);
  }
}
