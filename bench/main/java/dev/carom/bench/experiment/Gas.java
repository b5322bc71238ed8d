// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

import dev.carom.Scene;
import dev.carom.SceneBuilder;

/**
 * A gas of circles that collide, in square bounds: one circle in each cell of a square lattice, at
 * a random place in it, with velocities as they are in a gas of temperature 1 (each component
 * normally distributed, its variance 1 / mass).
 *
 * <p>The same numbers give the same bits on every machine: random numbers come from a fixed
 * generator, functions from {@link StrictMath}.
 *
 * @param circles how many circles, at least 1
 * @param packing the part of the bounds that circles cover, more than 0; a lattice of equal circles
 *     has room for less than pi / 4
 * @param spread the largest radius, at least 1; radii are uniform from 1 to it
 * @param heavy whether a circle's mass is its radius squared; else all masses are 1
 */
public record Gas(int circles, double packing, double spread, boolean heavy, long seed) {

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if a number is outside of its range
   */
  public Gas {
    check(circles >= 1, "circles", circles, "at least 1");
    check(packing > 0 && packing < 1, "packing", packing, "more than 0 and less than 1");
    check(spread >= 1 && spread <= 1e6, "spread", spread, "from 1 to 1e6");
  }

  static void check(boolean holds, String name, Object value, String expected) {
    if (!holds) {
      throw new IllegalArgumentException(name + " is " + value + ": expected " + expected);
    }
  }

  /**
   * Generates the scene.
   *
   * @return the scene; its circles collide
   * @throws CannotPlaceException if a circle has no room in a cell of the lattice
   */
  public Scene scene() throws CannotPlaceException {
    SplitMix random = new SplitMix(seed);
    double[] radii = new double[circles];
    double squares = 0;
    for (int i = 0; i < circles; i++) {
      radii[i] = random.between(1, spread);
      squares += radii[i] * radii[i];
    }
    int columns = (int) StrictMath.ceil(StrictMath.sqrt(circles));
    double side = StrictMath.sqrt(StrictMath.PI * squares / packing);
    double cell = side / columns;
    SceneBuilder builder = Scene.builder().bounds(0, 0, side, side);
    for (int i = 0; i < circles; i++) {
      double free = cell / 2 - radii[i];
      if (free < 0) {
        throw new CannotPlaceException(
            "no room for circle %d of %d: its radius is %s, half a cell %s; ask for less packing"
                .formatted(i + 1, circles, radii[i], cell / 2));
      }
      int row = i / columns;
      double x = (i % columns + 0.5) * cell + random.between(-free, free);
      double y = (row + 0.5) * cell + random.between(-free, free);
      double mass = heavy ? radii[i] * radii[i] : 1;
      double speed = speed(random, mass);
      double angle = random.between(0, 2 * StrictMath.PI);
      builder
          .circle(x, y, radii[i], speed * StrictMath.cos(angle), speed * StrictMath.sin(angle))
          .mass(mass);
    }
    return builder.build();
  }

  /**
   * A speed at temperature 1; with a direction at random, two normal deviates from two uniform
   * ones: G. E. P. Box, M. E. Muller, 1958.
   */
  static double speed(SplitMix random, double mass) {
    return StrictMath.sqrt(-2 * StrictMath.log(1 - random.between(0, 1)) / mass);
  }
}
