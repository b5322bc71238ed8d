// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * The rectangle in which the circles of a scene move: its bounds, or without bounds the bounding
 * box of the centres.
 */
public record BoundingBox(double left, double bottom, double right, double top) {

  public static BoundingBox of(CircleTable circles, int[] ids, double[] walls, double now) {
    if (walls != null) {
      return new BoundingBox(
          walls[Codes.LEFT], walls[Codes.BOTTOM], walls[Codes.RIGHT], walls[Codes.TOP]);
    }
    double left = Double.POSITIVE_INFINITY;
    double bottom = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double top = Double.NEGATIVE_INFINITY;
    for (int i : ids) {
      double x = circles.x(i, now);
      double y = circles.y(i, now);
      if (Math.abs(x) + Math.abs(y) < Double.POSITIVE_INFINITY) {
        left = Math.min(left, x);
        bottom = Math.min(bottom, y);
        right = Math.max(right, x);
        top = Math.max(top, y);
      }
    }
    return left > right ? new BoundingBox(0, 0, 0, 0) : new BoundingBox(left, bottom, right, top);
  }

  public double area() {
    return (right - left) * (top - bottom);
  }

  /** The largest absolute coordinate. */
  public double farthest() {
    return Math.max(
        Math.max(Math.abs(left), Math.abs(right)), Math.max(Math.abs(bottom), Math.abs(top)));
  }
}
