// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Scene;
import dev.carom.bench.reference.Reference;
import java.util.List;

/**
 * A grid of small scenes.
 *
 * @param name its name in options and files
 * @param heading what varies, in words
 * @param run what is played, in a sentence
 * @param x along the lower edge
 * @param y along the left edge
 * @param maker makes a cell from a value of each
 */
public record FailureMap(String name, String heading, String run, Axis x, Axis y, Maker maker) {

  /** Makes cells. */
  @FunctionalInterface
  interface Maker {

    /** The cell at these values. */
    Cell at(double x, double y);
  }

  /**
   * All maps.
   *
   * @param quick whether every third value of each axis will do
   * @return in the order of the report
   */
  public static List<FailureMap> all(boolean quick) {
    List<FailureMap> all =
        List.of(
            BoxMaps.angles(),
            BoxMaps.frames(),
            CornerMap.map(),
            OriginMap.map(),
            GapMap.map(),
            PairMap.map());
    return quick ? all.stream().map(FailureMap::thinned).toList() : all;
  }

  private FailureMap thinned() {
    return new FailureMap(name, heading, run, x.thinned(), y.thinned(), maker);
  }

  /**
   * The scene of a cell, to be looked at.
   *
   * @param column which value of {@link #x}
   * @param row which value of {@link #y}
   * @return the scene at time 0
   */
  public Scene scene(int column, int row) {
    return cell(row * x.values().length + column).scene();
  }

  /**
   * Returns the true course of a cell.
   *
   * @param column which value of {@link #x}
   * @param row which value of {@link #y}
   * @return its course; null if impacts pile up so that none was found
   */
  public Reference truth(int column, int row) {
    return cell(row * x.values().length + column).truth();
  }

  /** One of its scenes, to be shown: the scene of a cell in the middle. */
  public Scene example() {
    return scene(x.values().length / 2, y.values().length / 2);
  }

  /** How many cells it has. */
  int size() {
    return x.values().length * y.values().length;
  }

  /** One cell, by rows from the lower left. */
  Cell cell(int i) {
    int columns = x.values().length;
    return maker.at(x.values()[i % columns], y.values()[i / columns]);
  }
}
