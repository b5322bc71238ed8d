// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * Options that choose the search structures of a world. The defaults are chosen by the scene; tests
 * force others. They change the cost and no bit of the result.
 *
 * @param grid whether grids may be used
 * @param cell the size of their cells, 0 to have it chosen
 * @param pairCells the width of the cells for circles that collide, in largest diameters
 * @param slack how many removed circles are tolerated before arrays are compacted, as a multiple of
 *     the live ones and a constant
 */
public record EngineOptions(boolean grid, double cell, double pairCells, double slack) {

  /** All options are chosen by the scene. */
  public static final EngineOptions CHOSEN = new EngineOptions(true, 0, 1, 1);

  /** No grid: every obstacle is tested. */
  public static final EngineOptions EACH = new EngineOptions(false, 0, 1, 1);

  public static EngineOptions cells(double cell) {
    return new EngineOptions(true, cell, 1, 1);
  }
}
