// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Map;
import java.util.TreeMap;

/**
 * The grids of a scene: one for each power of two among its circles' radii, made for the largest
 * radius in it, so that small circles do not search through what only large ones can touch.
 */
final class Grids {

  private final Map<Integer, Grid> byExponent = new TreeMap<>();
  private final Model model;

  Grids(Scene scene, Obstacles obstacles, Machinery machinery) {
    boolean used = machinery.grid() && obstacles.size() > 0;
    if (used) {
      largestRadii(scene)
          .forEach(
              (exponent, radius) ->
                  byExponent.put(exponent, new Grid(obstacles, radius, machinery.cell())));
    }
    int cells = byExponent.values().stream().mapToInt(Grid::cells).sum();
    model = new Model(obstacles.size(), byExponent.size(), cells);
  }

  private static Map<Integer, Double> largestRadii(Scene scene) {
    Map<Integer, Double> largest = new TreeMap<>();
    for (int i = 0; i < scene.circleCount(); i++) {
      double radius = scene.circle(i).radius();
      largest.merge(Math.getExponent(radius), radius, Math::max);
    }
    return largest;
  }

  /** The grid for circles of a given radius, null if none is used. */
  Grid of(double radius) {
    return byExponent.get(Math.getExponent(radius));
  }

  Model model() {
    return model;
  }
}
