// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.function.DoublePredicate;
import java.util.function.IntToDoubleFunction;

/** A rectangle that holds most circles, all of them unless a few are far from the others. */
public record BoundingBox(double left, double bottom, double right, double top) {

  /** What is further away is left out: then no area, and no distance from it, overflows. */
  private static final double FAR = 0x1p500;

  /**
   * On each axis the bounds, if half of the circles are between them. Else the range of the
   * centres, cut off where it goes beyond the quartiles by more than their distance. Nothing is cut
   * off if the centres are spread evenly.
   */
  public static BoundingBox of(CircleTable circles, int[] ids, double[] walls, double now) {
    double[] x = range(ids, i -> circles.x(i, now), walls, Codes.LEFT, Codes.RIGHT);
    double[] y = range(ids, i -> circles.y(i, now), walls, Codes.BOTTOM, Codes.TOP);
    return new BoundingBox(x[0], y[0], x[1], y[1]);
  }

  private static double[] range(
      int[] ids, IntToDoubleFunction place, double[] walls, int low, int high) {
    double[] p = Arrays.stream(ids).mapToDouble(place).filter(x -> Math.abs(x) <= FAR).toArray();
    int last = p.length - 1;
    if (last < 0) {
      return new double[2];
    }
    int quarter = p.length / 4;
    if (walls != null
        && count(p, x -> x < walls[low]) <= quarter
        && count(p, x -> x > walls[high]) <= quarter) {
      return new double[] {Math.max(walls[low], -FAR), Math.min(walls[high], FAR)};
    }
    Arrays.sort(p);
    double first = p[quarter];
    double third = p[last - quarter];
    double most = third - first;
    return new double[] {Math.max(p[0], first - most), Math.min(p[last], third + most)};
  }

  private static long count(double[] places, DoublePredicate which) {
    return Arrays.stream(places).filter(which).count();
  }

  public double width() {
    return right - left;
  }

  public double height() {
    return top - bottom;
  }

  /** The longer side. */
  public double side() {
    return Math.max(width(), height());
  }

  public double area() {
    return width() * height();
  }

  /** The largest absolute coordinate. */
  public double farthest() {
    return Math.max(
        Math.max(Math.abs(left), Math.abs(right)), Math.max(Math.abs(bottom), Math.abs(top)));
  }
}
