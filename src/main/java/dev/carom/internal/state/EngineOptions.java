// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * How a world finds what is hit first. Chosen by the scene, or forced by a test: it changes the
 * cost and no bit of the result.
 *
 * @param grid whether grids may be used
 * @param cell the size of their cells, 0 to have it chosen
 * @param pairCells how many times the largest diameter the cells of circles that collide measure
 * @param slack how many times as many circles as there are, and some more, may be removed before
 *     arrays are made dense
 * @param budget how much of the usual work a call may do
 */
public record EngineOptions(
    boolean grid, double cell, double pairCells, double slack, double budget) {

  /** Chosen by the scene. */
  public static final EngineOptions CHOSEN = new EngineOptions(true, 0, 1, 1, 1);

  /** Every obstacle is looked at. */
  public static final EngineOptions EACH = new EngineOptions(false, 0, 1, 1, 1);

  public static EngineOptions cells(double cell) {
    return new EngineOptions(true, cell, 1, 1, 1);
  }

  public static EngineOptions budget(double budget) {
    return new EngineOptions(true, 0, 1, 1, budget);
  }
}
