// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Tiles;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.ScalePlan.Model;
import java.lang.ref.Reference;
import java.util.List;

/**
 * The memory of a world that is ready for its first step, beside that of its scene, from what the
 * heap holds before and after.
 *
 * @param perCircle bytes for each circle
 * @param perLine bytes for each line
 */
public record Footprint(int circles, double perCircle, double perLine) {

  private static final int COLLECTIONS = 4;

  /**
   * Measures two worlds: circles without lines, and the same with lines.
   *
   * @param side of the scene, see {@link Tiles}
   * @param seed of the scene
   * @return the bytes
   * @throws CannotPlaceException if a scene has no room
   */
  public static Footprint of(int side, long seed) throws CannotPlaceException {
    int n = ScalePlan.circles(side);
    double bare = bytes(new Tiles(side, false, seed).scene());
    double full = bytes(new Tiles(side, true, seed).scene());
    return new Footprint(n, bare / n, (full - bare) / n);
  }

  /**
   * As rows.
   *
   * @param label of the method
   * @return two
   */
  public List<Row> rows(String label) {
    String scene = Scale.SCENE + Model.ALONE.label() + "=" + circles;
    return List.of(
        new Row(scene, label, "", Scale.MEMORY, "circle", perCircle, "bytes", circles, 0),
        new Row(scene, label, "", Scale.MEMORY, "line", perLine, "bytes", circles, 0));
  }

  private static double bytes(Scene scene) {
    long before = used();
    World world = new World(scene);
    try {
      return used() - before;
    } finally {
      Reference.reachabilityFence(world);
      Reference.reachabilityFence(scene);
    }
  }

  /** The used heap after some collections, in bytes. */
  static long used() {
    for (int i = 0; i < COLLECTIONS; i++) {
      System.gc();
    }
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }
}
