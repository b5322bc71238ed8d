// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.bench.reference.Truth;

/** A circle that meets the end of a line, far from the origin. */
final class OriginMap {

  private static final double RADIUS = 10;
  private static final int FRAMES = 20;
  private static final double BEFORE = 7.4;

  private OriginMap() {}

  static FailureMap map() {
    return new FailureMap(
        "origin",
        "distance from the origin and speed",
        "A ball hits the end of a line, near or far from the origin of coordinates.",
        Axis.decades("distance from the origin, in radii", 0, 12, 1),
        Axis.decades("speed, in radii a frame", -3, 3, 2),
        OriginMap::cell);
  }

  /** At contact the offset from the end to the centre is (-0.8, 0.6) radii. */
  private static Cell cell(double distance, double radiiPerFrame) {
    double endX = 0.8 * distance * RADIUS;
    double endY = 0.6 * distance * RADIUS;
    double speed = radiiPerFrame * RADIUS;
    SceneBuilder setup = Scene.builder().line(endX, endY - 20 * RADIUS, endX, endY);
    setup.circle(endX - 0.8 * RADIUS - BEFORE * speed, endY + 0.6 * RADIUS, RADIUS, speed, 0);
    Scene scene = setup.build();
    return new Cell(scene, Truth.of(scene, FRAMES, () -> {}), Fence.NONE, false);
  }
}
