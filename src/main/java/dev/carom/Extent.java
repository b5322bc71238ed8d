// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The rectangle in which the circles of a scene move: its bounds, or if it has none, the one in
 * which their centres start.
 */
record Extent(double left, double bottom, double right, double top) {

  static Extent of(Circles circles, Bounds bounds) {
    if (bounds != null) {
      return new Extent(bounds.xmin(), bounds.ymin(), bounds.xmax(), bounds.ymax());
    }
    double left = Double.POSITIVE_INFINITY;
    double bottom = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double top = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < circles.count; i++) {
      left = Math.min(left, circles.x(i, 0));
      bottom = Math.min(bottom, circles.y(i, 0));
      right = Math.max(right, circles.x(i, 0));
      top = Math.max(top, circles.y(i, 0));
    }
    return circles.count == 0 ? new Extent(0, 0, 0, 0) : new Extent(left, bottom, right, top);
  }

  /** The largest absolute coordinate. */
  double farthest() {
    return Math.max(
        Math.max(Math.abs(left), Math.abs(right)), Math.max(Math.abs(bottom), Math.abs(top)));
  }
}
