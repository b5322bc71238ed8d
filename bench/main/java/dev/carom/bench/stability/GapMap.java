// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.bench.reference.Truth;

/** A circle that flies, a little askew, at the gap between two lines. */
final class GapMap {

  private static final double[] GAPS = {
    0.9, 0.93, 0.95, 0.97, 0.98, 0.99, 0.995, 0.998, 1, 1.002, 1.005, 1.01, 1.02, 1.03, 1.05, 1.07,
    1.1
  };

  private static final double RADIUS = 10;

  /** The way across, as a share of the way along. */
  private static final double SLOPE = 0.02;

  /** In radii. */
  private static final double WAY = 24;

  /** The part before the gap, as a share of the way. */
  private static final double BEFORE = 0.3;

  private GapMap() {}

  static FailureMap map() {
    return new FailureMap(
        "gap",
        "gap between two lines and speed",
        "A ball flies at the gap between two lines, a little narrower or wider than itself.",
        Axis.plain("gap, in diameters", GAPS),
        Axis.decades("speed, in radii a frame", -2, 2, 2),
        GapMap::cell);
  }

  private static Cell cell(double gap, double radiiPerFrame) {
    double speed = radiiPerFrame * RADIUS;
    int frames = (int) Math.ceil(WAY / radiiPerFrame);
    double way = frames * speed;
    double half = gap * RADIUS;
    double vx = speed / Math.sqrt(1 + SLOPE * SLOPE);
    double vy = SLOPE * vx;
    double before = BEFORE * way;
    SceneBuilder setup = Scene.builder().line(0, -half, way, -half).line(0, half, way, half);
    setup.circle(-before, -SLOPE * before, RADIUS, vx, vy);
    Scene scene = setup.build();
    Fence fence = (x, y) -> x > 0 && (gap < 1 || Math.abs(y) > half);
    Truth truth;
    try {
      truth = Truth.of(scene, frames, () -> {});
    } catch (IllegalStateException e) {
      truth = null;
    }
    return new Cell(scene, truth, fence, truth == null);
  }
}
