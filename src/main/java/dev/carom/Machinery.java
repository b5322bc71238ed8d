// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * How a world finds what is hit first. Chosen by the scene, or forced by a test: it changes the
 * cost and no bit of the result.
 *
 * @param grid whether to use grids
 * @param cell the size of their cells, 0 to have it chosen
 * @param pairCells how many times the largest diameter the cells of circles that collide measure
 */
record Machinery(boolean grid, double cell, double pairCells) {

  /** Up to this many lines and pegs are looked at one by one: measured, a grid gains nothing. */
  private static final int FEW = 8;

  /** Beyond this size of coordinates, products of them with a grid's cells could overflow. */
  private static final double LARGEST = 0x1p400;

  static final Machinery EACH = new Machinery(false, 0, 1);

  static Machinery cells(double cell) {
    return new Machinery(true, cell, 1);
  }

  /** The same with cells of another size for circles that collide. */
  Machinery withPairCells(double diameters) {
    return new Machinery(grid, cell, diameters);
  }

  static Machinery choose(Scene scene) {
    Obstacles obstacles = Obstacles.of(scene);
    boolean ordinary = obstacles.extent() < LARGEST;
    return new Machinery(obstacles.size() > FEW && ordinary, 0, 1);
  }
}
