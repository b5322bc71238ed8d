// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.Predicates;
import java.util.Comparator;
import java.util.stream.IntStream;

/** Decides exactly how a polygon lies, given as x, y, x, y, ... of its vertices. */
public final class Polygon {

  private Polygon() {}

  /** 1 for a polygon, which does not cross itself, whose vertices run counterclockwise; else -1. */
  public static int winding(double... xy) {
    int n = xy.length / 2;
    int least = 0;
    for (int i = 1; i < n; i++) {
      boolean isLess =
          xy[2 * i] < xy[2 * least]
              || (xy[2 * i] == xy[2 * least] && xy[2 * i + 1] < xy[2 * least + 1]);
      least = isLess ? i : least;
    }
    return turn(xy, (least + n - 1) % n, least, (least + 1) % n);
  }

  /** The sign of the turn at vertex j on the way from i to k: positive to the left. */
  private static int turn(double[] xy, int i, int j, int k) {
    return side(xy, i, j, xy[2 * k], xy[2 * k + 1]);
  }

  /** On which side of the line from vertex i to j a point is: positive left. */
  private static int side(double[] xy, int i, int j, double x, double y) {
    return LineShape.side(xy[2 * i], xy[2 * i + 1], xy[2 * j], xy[2 * j + 1], x, y);
  }

  /** Two sides that meet but for the vertex that neighbours share; null if there are none. */
  public static int[] crossing(double... xy) {
    int n = xy.length / 2;
    int[] byLeft =
        IntStream.range(0, n)
            .boxed()
            .sorted(Comparator.comparingDouble(i -> Math.min(xy[2 * i], xy[2 * ((i + 1) % n)])))
            .mapToInt(i -> i)
            .toArray();
    for (int a = 0; a < n; a++) {
      int i = byLeft[a];
      double right = Math.max(xy[2 * i], xy[2 * ((i + 1) % n)]);
      for (int b = a + 1; b < n; b++) {
        int j = byLeft[b];
        if (Math.min(xy[2 * j], xy[2 * ((j + 1) % n)]) > right) {
          break;
        }
        if (meet(xy, n, Math.min(i, j), Math.max(i, j))) {
          return new int[] {Math.min(i, j), Math.max(i, j)};
        }
      }
    }
    return null;
  }

  /** Whether sides i and j, i below j, meet anywhere but at a vertex that they share. */
  private static boolean meet(double[] xy, int n, int i, int j) {
    if (j == i + 1) {
      return foldsBack(xy, i, j, (j + 1) % n);
    }
    if (i == 0 && j == n - 1) {
      return foldsBack(xy, j, i, 1);
    }
    int iEnd = i + 1;
    int jEnd = (j + 1) % n;
    return isNear(xy, i, iEnd, j, jEnd, 0)
        && isNear(xy, i, iEnd, j, jEnd, 1)
        && turn(xy, i, iEnd, j) * turn(xy, i, iEnd, jEnd) <= 0
        && turn(xy, j, jEnd, i) * turn(xy, j, jEnd, iEnd) <= 0;
  }

  /** Whether the way from vertex i to j to k goes back along itself. */
  private static boolean foldsBack(double[] xy, int i, int j, int k) {
    return turn(xy, i, j, k) == 0
        && Predicates.dot(
                xy[2 * j],
                xy[2 * j + 1],
                xy[2 * i],
                xy[2 * i + 1],
                xy[2 * k],
                xy[2 * k + 1],
                xy[2 * j],
                xy[2 * j + 1])
            < 0;
  }

  private static boolean isNear(double[] xy, int i, int iEnd, int j, int jEnd, int axis) {
    double a = xy[2 * i + axis];
    double b = xy[2 * iEnd + axis];
    double c = xy[2 * j + axis];
    double d = xy[2 * jEnd + axis];
    return Math.max(a, b) >= Math.min(c, d) && Math.max(c, d) >= Math.min(a, b);
  }

  /**
   * Whether a ray from a point to the left crosses the side from a to b: an odd number of the sides
   * of a polygon around it.
   */
  public static boolean isCrossed(double ax, double ay, double bx, double by, double x, double y) {
    return (ay > y) != (by > y) && LineShape.side(ax, ay, bx, by, x, y) * (by > ay ? -1 : 1) > 0;
  }

  /** Whether a point is inside; on the border as it may be. */
  public static boolean contains(double[] xy, double x, double y) {
    boolean inside = false;
    for (int i = 0; i < xy.length / 2; i++) {
      int j = 2 * i + 2 == xy.length ? 0 : i + 1;
      inside ^= isCrossed(xy[2 * i], xy[2 * i + 1], xy[2 * j], xy[2 * j + 1], x, y);
    }
    return inside;
  }
}
