// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.bench.experiment.Crosses;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/**
 * Which scenes a sweep plays, and how often.
 *
 * @param frames of one replay, at least 1
 * @param replays of each scene by each method, at least 1
 */
public record SweepPlan(int frames, int replays, List<Point> points) {

  /** The quantity in which the scenes differ. */
  public enum Axis {
    /** The number of circles. */
    CIRCLES("circles"),
    /** The radius of all circles, in px. */
    RADIUS("radius"),
    /** The number of lines, two a cross. */
    LINES("lines");

    private final String label;

    Axis(String label) {
      this.label = label;
    }

    /** Its name in files. */
    public String label() {
      return label;
    }
  }

  /**
   * A scene at a place of an axis.
   *
   * @param axis which number of the scene is varied
   * @param at its value
   */
  public record Point(Axis axis, int at, Crosses crosses) {}

  private static final int[] FEW_CIRCLES = {1, 2, 5, 10, 20, 40, 60, 80, 100};
  private static final int[] FEW_RADII = {1, 5, 10, 15, 20};
  private static final int[] LINES = {2, 4, 6, 10, 20, 40, 60, 80, 100, 120, 140, 160, 180, 200};

  /**
   * The published sweep, 1 to 100 circles and radius 1 to 20; and 2 to 200 lines.
   *
   * @param seed of the random scenes
   * @param replays of each scene by each method
   * @param quick whether a few places of each axis will do
   */
  public static SweepPlan of(long seed, int frames, int replays, boolean quick) {
    Crosses base = Crosses.canonical(seed);
    List<Point> points = new ArrayList<>();
    int[] circles = quick ? FEW_CIRCLES : IntStream.rangeClosed(1, base.circles()).toArray();
    add(points, Axis.CIRCLES, circles, n -> new Crosses(n, 50, 10, 1, 10, seed));
    int[] radii = quick ? FEW_RADII : IntStream.rangeClosed(1, 20).toArray();
    add(points, Axis.RADIUS, radii, r -> new Crosses(100, 50, r, 1, 10, seed));
    add(points, Axis.LINES, LINES, n -> new Crosses(100, n / 2, 10, 1, 10, seed));
    return new SweepPlan(frames, replays, points);
  }

  private static void add(List<Point> points, Axis axis, int[] places, IntFunction<Crosses> scene) {
    for (int at : places) {
      points.add(new Point(axis, at, scene.apply(at)));
    }
  }
}
