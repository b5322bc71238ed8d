// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.state.OutlinePoints;
import dev.carom.internal.sweep.Separation;
import dev.carom.internal.util.Check;

/**
 * The least translation that moves a circle out of an outline. The places where the circle touches
 * are the border of all that is within r of the sides: pieces of lines at a distance r beside them,
 * and of circles around the vertices. The nearest point of that border is the foot of a
 * perpendicular on one of the pieces, or a corner where two of them cross. So those are tried, the
 * nearest one first, and the first one that does not overlap is the answer.
 *
 * <p>The moved centre is rounded, and a place that is rounded inwards overlaps. So places are
 * sought at a distance of r and 0, 1, 2, 4 and 8 ulps of the size, as {@link Separation} does. At
 * sharp corners rounding moves a place by more: if none of these is free, the ulps are doubled
 * until one is.
 */
public final class OutlineSeparation {

  /** Up to so many ulps of the size are added, even if fewer gave a free place. */
  private static final double MOST = 8;

  private final double x;
  private final double y;
  private final double r;
  private final OutlinePoints outline;

  /** The distance at which places are sought. */
  private double reach;

  private double bestX;
  private double bestY;
  private double best;

  private OutlineSeparation(double x, double y, double r, OutlinePoints outline) {
    this.x = x;
    this.y = y;
    this.r = r;
    this.outline = outline;
  }

  public static Separation of(double x, double y, double r, OutlinePoints outline) {
    return outline.overlaps(x, y, r)
        ? new OutlineSeparation(x, y, r, outline).find()
        : new Separation(0, 0);
  }

  private Separation find() {
    double size = Math.max(Math.abs(x), Math.abs(y));
    for (double coordinate : outline.xy()) {
      size = Math.max(size, Math.abs(coordinate));
    }
    size += r;
    if (!(size <= 0x1p500)) {
      throw Check.refused("coordinate and radius together", size, "at most 2^500");
    }
    best = Double.POSITIVE_INFINITY;
    double more = 0;
    while (more <= MOST || best == Double.POSITIVE_INFINITY) {
      reach = r + more * Math.ulp(size);
      tryFeet();
      tryCrossings();
      more = more == 0 ? 1 : 2 * more;
    }
    return new Separation(bestX, bestY);
  }

  /**
   * Takes the place at an offset from the centre if it is nearer than the best one, and free. An
   * offset of NaN, from a quotient by 0 or the root of a negative number, stands for no place.
   */
  private void take(double dx, double dy) {
    double square = dx * dx + dy * dy;
    if (square < best && !outline.overlaps(x + dx, y + dy, r)) {
      best = square;
      bestX = dx;
      bestY = dy;
    }
  }

  private void tryFeet() {
    for (int i = 0; i < outline.sides(); i++) {
      double[] a = outline.side(i);
      double length = StrictMath.hypot(a[2] - a[0], a[3] - a[1]);
      double nx = (a[1] - a[3]) / length;
      double ny = (a[2] - a[0]) / length;
      double height = (x - a[0]) * nx + (y - a[1]) * ny;
      take((reach - height) * nx, (reach - height) * ny);
      take((-reach - height) * nx, (-reach - height) * ny);
    }
    for (int i = 0; i < outline.count(); i++) {
      double dx = x - outline.x(i);
      double dy = y - outline.y(i);
      double d = StrictMath.hypot(dx, dy);
      take((reach - d) * (dx / d), (reach - d) * (dy / d));
    }
  }

  /** Tries where two of the lines beside sides and the circles around vertices cross. */
  private void tryCrossings() {
    int sides = outline.sides();
    for (int i = 0; i < sides; i++) {
      for (int left = -1; left <= 1; left += 2) {
        double[] one = beside(i, left);
        for (int j = i + 1; j < sides; j++) {
          cross(one, beside(j, -1));
          cross(one, beside(j, 1));
        }
        for (int k = 0; k < outline.count(); k++) {
          cross(one, outline.x(k) - x, outline.y(k) - y);
        }
      }
    }
    for (int i = 0; i < outline.count(); i++) {
      for (int k = i + 1; k < outline.count(); k++) {
        cross(outline.x(i) - x, outline.y(i) - y, outline.x(k) - x, outline.y(k) - y);
      }
    }
  }

  /** A line beside side i, from the centre: a point, and the unit vector along it. */
  private double[] beside(int i, int left) {
    double[] a = outline.side(i);
    double length = StrictMath.hypot(a[2] - a[0], a[3] - a[1]);
    double wx = (a[2] - a[0]) / length;
    double wy = (a[3] - a[1]) / length;
    return new double[] {a[0] - x - left * reach * wy, a[1] - y + left * reach * wx, wx, wy};
  }

  /** Two lines. */
  private void cross(double[] one, double[] other) {
    double sine = one[2] * other[3] - one[3] * other[2];
    double s = ((other[0] - one[0]) * other[3] - (other[1] - one[1]) * other[2]) / sine;
    take(one[0] + s * one[2], one[1] + s * one[3]);
  }

  /** A line, and the circle around a vertex. */
  private void cross(double[] line, double vx, double vy) {
    double along = (vx - line[0]) * line[2] + (vy - line[1]) * line[3];
    double footX = line[0] + along * line[2];
    double footY = line[1] + along * line[3];
    double apart = StrictMath.hypot(vx - footX, vy - footY);
    double half = Math.sqrt((reach - apart) * (reach + apart));
    take(footX + half * line[2], footY + half * line[3]);
    take(footX - half * line[2], footY - half * line[3]);
  }

  /** The circles around two vertices. */
  private void cross(double ax, double ay, double bx, double by) {
    double half = 0.5 * StrictMath.hypot(bx - ax, by - ay);
    double up = Math.sqrt((reach - half) * (reach + half)) / (2 * half);
    double middleX = 0.5 * (ax + bx);
    double middleY = 0.5 * (ay + by);
    take(middleX - up * (by - ay), middleY + up * (bx - ax));
    take(middleX + up * (by - ay), middleY - up * (bx - ax));
  }
}
