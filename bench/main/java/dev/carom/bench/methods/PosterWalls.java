// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import static dev.carom.bench.methods.RealDouble.real;

import dev.carom.Bounds;
import dev.carom.Kind;
import dev.carom.Scene;

/** The bounds in double, as the published algorithm meets them; infinite for an open scene. */
final class PosterWalls {

  final double restitution;

  private final double xmin;
  private final double ymin;
  private final double xmax;
  private final double ymax;

  PosterWalls(Scene scene) {
    Bounds bounds = scene.bounds().orElse(null);
    xmin = bounds == null ? Double.NEGATIVE_INFINITY : real(bounds.xmin());
    ymin = bounds == null ? Double.NEGATIVE_INFINITY : real(bounds.ymin());
    xmax = bounds == null ? Double.POSITIVE_INFINITY : real(bounds.xmax());
    ymax = bounds == null ? Double.POSITIVE_INFINITY : real(bounds.ymax());
    restitution = bounds == null ? 1 : real(scene.traits(Kind.WALL, 0).restitution());
  }

  /** The fraction of the motion v at which the circle meets a wall, 0 if it stands beyond. */
  double contact(double px, double py, double vx, double vy, double r) {
    return Math.min(reach(px, vx, xmin + r, xmax - r), reach(py, vy, ymin + r, ymax - r));
  }

  /** Whether, of the walls the circle moves towards at contact, a left or right one is nearer. */
  boolean isVertical(double cx, double cy, double vx, double vy, double r) {
    return reach(cx, vx, xmin + r, xmax - r) <= reach(cy, vy, ymin + r, ymax - r);
  }

  private static double reach(double p, double v, double low, double high) {
    if (v < 0) {
      return Math.max(0, (low - p) / v);
    }
    return v > 0 ? Math.max(0, (high - p) / v) : Double.POSITIVE_INFINITY;
  }
}
