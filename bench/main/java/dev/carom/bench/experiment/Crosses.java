// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

import dev.carom.Scene;

/**
 * The canonical scene: in bounds of 800 x 600, crosses of two perpendicular lines of 20 px that
 * meet at their midpoints, turned at random, their centres at least 30 px from the bounds and 45 px
 * from each other; and circles within the bounds that overlap no line (but may overlap each other),
 * with a random direction and a speed uniform in a range.
 *
 * <p>The same numbers give the same bits on every machine: random numbers come from a fixed
 * generator, sine and cosine from {@link StrictMath}. Crosses come first, then circles, each thing
 * at the first place drawn that fits. A thing that fits none of {@value #TRIES} places drawn is
 * given up, and the scene with it.
 *
 * @param circles how many circles, at least 1
 * @param crosses how many crosses, at least 0
 * @param radius of every circle, greater than 0, at most 300
 * @param minSpeed the lowest speed in px a frame, finite, at least 0
 * @param maxSpeed the speed that all stay below, at least minSpeed; equal to it, every circle has
 *     it
 */
public record Crosses(
    int circles, int crosses, double radius, double minSpeed, double maxSpeed, long seed) {

  /** The places drawn for one thing before it is given up. */
  static final int TRIES = 100_000;

  private static final double WIDTH = 800;
  private static final double HEIGHT = 600;

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if a number is outside of its range
   */
  public Crosses {
    check(circles >= 1, "circles", circles, "at least 1");
    check(crosses >= 0, "crosses", crosses, "at least 0");
    check(radius > 0 && radius <= HEIGHT / 2, "radius", radius, "more than 0 and at most 300");
    check(minSpeed >= 0, "lowest speed", minSpeed, "at least 0");
    check(
        maxSpeed >= minSpeed && maxSpeed <= Double.MAX_VALUE,
        "highest speed",
        maxSpeed,
        "a finite number, at least the lowest speed, " + minSpeed);
  }

  private static void check(boolean holds, String name, Object value, String expected) {
    if (!holds) {
      throw new IllegalArgumentException(name + " is " + value + ": expected " + expected);
    }
  }

  /**
   * The published experiment: 100 circles of radius 10 among 50 crosses at 1 to 10 px a frame.
   *
   * @param seed any number
   * @return the numbers of that scene
   */
  public static Crosses canonical(long seed) {
    return new Crosses(100, 50, 10, 1, 10, seed);
  }

  /** The same numbers with another seed: these numbers, their seed replaced. */
  public Crosses withSeed(long other) {
    return new Crosses(circles, crosses, radius, minSpeed, maxSpeed, other);
  }

  /**
   * Generates the scene.
   *
   * @return the scene, in px and frames
   * @throws CannotPlaceException if a cross or a circle finds no place
   */
  public Scene scene() throws CannotPlaceException {
    SplitMix random = new SplitMix(seed);
    CrossField field = new CrossField(WIDTH, HEIGHT, random);
    for (int i = 0; i < crosses; i++) {
      field.addCross(i, crosses);
    }
    for (int i = 0; i < circles; i++) {
      field.addCircle(i, circles, radius, minSpeed, maxSpeed);
    }
    return field.scene();
  }
}
