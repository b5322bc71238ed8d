// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Bounds;
import dev.carom.ObstacleKind;
import dev.carom.Scene;

/** The bounds in float, as the published algorithm meets them; infinite for an open scene. */
final class PosterWalls {

  final float restitution;

  private final float xmin;
  private final float ymin;
  private final float xmax;
  private final float ymax;

  PosterWalls(Scene scene) {
    Bounds bounds = scene.bounds().orElse(null);
    xmin = bounds == null ? Float.NEGATIVE_INFINITY : (float) bounds.xmin();
    ymin = bounds == null ? Float.NEGATIVE_INFINITY : (float) bounds.ymin();
    xmax = bounds == null ? Float.POSITIVE_INFINITY : (float) bounds.xmax();
    ymax = bounds == null ? Float.POSITIVE_INFINITY : (float) bounds.ymax();
    restitution = bounds == null ? 1 : (float) scene.restitution(ObstacleKind.WALL, 0);
  }

  /** The fraction of the motion v at which the circle meets a wall, 0 if it stands beyond. */
  float contact(float px, float py, float vx, float vy, float r) {
    return Math.min(reach(px, vx, xmin + r, xmax - r), reach(py, vy, ymin + r, ymax - r));
  }

  /** Whether, of the walls the circle moves towards at contact, a left or right one is nearer. */
  boolean isVertical(float cx, float cy, float vx, float vy, float r) {
    return reach(cx, vx, xmin + r, xmax - r) <= reach(cy, vy, ymin + r, ymax - r);
  }

  private static float reach(float p, float v, float low, float high) {
    if (v < 0) {
      return Math.max(0, (low - p) / v);
    }
    return v > 0 ? Math.max(0, (high - p) / v) : Float.POSITIVE_INFINITY;
  }
}
