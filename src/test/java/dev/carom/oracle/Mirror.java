// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** The symmetries of the plane that are exact on doubles, applied to the numbers of a query. */
final class Mirror {
  private Mirror() {}

  /** One of the eight images of a query; a line also with its ends exchanged. */
  static Query any(Draw d, Query query) {
    double[] n = query.numbers();
    int[] abscissas = abscissas(query);
    if (d.chance(0.5)) {
      negate(n, abscissas, 0);
    }
    if (d.chance(0.5)) {
      negate(n, abscissas, 1);
    }
    if (d.chance(0.5)) {
      exchange(n, abscissas);
    }
    if (query instanceof WallQuery) {
      order(n, 5);
      order(n, 6);
    } else if (query instanceof SegmentQuery && d.chance(0.5)) {
      swap(n, 0, 2);
      swap(n, 1, 3);
    }
    return query.with(n);
  }

  /** Where in the numbers of a query the x coordinates are; each has its y next to it. */
  private static int[] abscissas(Query query) {
    if (query instanceof SegmentQuery) {
      return new int[] {0, 2, 4, 7};
    }
    if (query instanceof MovingLineQuery) {
      return new int[] {0, 2, 4, 7, 9};
    }
    return query instanceof PairQuery ? new int[] {0, 3, 5, 8} : new int[] {0, 3, 5, 7};
  }

  private static void negate(double[] n, int[] abscissas, int axis) {
    for (int i : abscissas) {
      n[i + axis] = -n[i + axis];
    }
  }

  private static void exchange(double[] n, int[] abscissas) {
    for (int i : abscissas) {
      swap(n, i, i + 1);
    }
  }

  /** Puts the minimum of two walls, two places apart, before the maximum. */
  static void order(double[] n, int i) {
    if (n[i] > n[i + 2]) {
      swap(n, i, i + 2);
    }
  }

  private static void swap(double[] n, int i, int j) {
    double kept = n[i];
    n[i] = n[j];
    n[j] = kept;
  }
}
