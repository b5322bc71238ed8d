// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import java.util.Arrays;

/**
 * Square cells over the lines of a scene, made as this library makes its own: three cells a line,
 * each listing the lines that a circle of at most a given radius could touch while its centre is in
 * the cell, grown by a margin for rounding.
 */
final class LineGrid {

  private static final double CELLS_EACH = 3;
  private static final double MARGIN = 0x1p-8;
  private static final int MOST = 1 << 13;

  final double cell;
  final int columns;
  final int rows;
  final double xmin;
  final double ymin;

  /** Where the list of each cell begins, and at the end where the last one ends. */
  final int[] starts;

  /** The lines of all lists. */
  final int[] listed;

  private final PlainMethod scene;
  private final double reach;

  /** Over at least one line. */
  LineGrid(PlainMethod scene) {
    this.scene = scene;
    double radius = Arrays.stream(scene.radius).max().orElse(0);
    double left = least(scene.ax, scene.bx) - radius;
    double low = least(scene.ay, scene.by) - radius;
    double width = -least(negated(scene.ax), negated(scene.bx)) + radius - left;
    double height = -least(negated(scene.ay), negated(scene.by)) + radius - low;
    double wanted = Math.sqrt(width * height / (CELLS_EACH * scene.lines));
    cell = Math.max(wanted, Math.max(width, height) / (MOST - 4));
    xmin = left - cell;
    ymin = low - cell;
    columns = (int) Math.ceil(width / cell) + 2;
    rows = (int) Math.ceil(height / cell) + 2;
    reach = radius + MARGIN * cell;
    starts = new int[columns * rows + 1];
    for (int c = 0; c < columns * rows; c++) {
      starts[c + 1] = starts[c] + list(c, null, 0);
    }
    listed = new int[starts[columns * rows]];
    for (int c = 0; c < columns * rows; c++) {
      list(c, listed, starts[c]);
    }
  }

  private static double least(double[] a, double[] b) {
    return Math.min(Arrays.stream(a).min().orElseThrow(), Arrays.stream(b).min().orElseThrow());
  }

  private static double[] negated(double[] values) {
    return Arrays.stream(values).map(v -> -v).toArray();
  }

  /** Lists the lines of a cell, if there is a place for them, and tells how many there are. */
  private int list(int c, int[] to, int from) {
    double left = xmin + c % columns * cell - reach;
    int row = c / columns;
    double low = ymin + row * cell - reach;
    double size = cell + 2 * reach;
    int n = 0;
    for (int k = 0; k < scene.lines; k++) {
      if (meets(k, left, low, size)) {
        if (to != null) {
          to[from + n] = k;
        }
        n++;
      }
    }
    return n;
  }

  /** Whether a line and a square have a point in common: clipped by slabs, something is left. */
  private boolean meets(int k, double left, double low, double size) {
    double[] part = {0, 1};
    return clip(part, scene.ax[k], scene.bx[k] - scene.ax[k], left, left + size)
        && clip(part, scene.ay[k], scene.by[k] - scene.ay[k], low, low + size);
  }

  /** Shortens the part of p + t v, from part[0] to part[1], to what is between two places. */
  private static boolean clip(double[] part, double p, double v, double low, double high) {
    if (v == 0) {
      return p >= low && p <= high;
    }
    double a = (low - p) / v;
    double b = (high - p) / v;
    part[0] = Math.max(part[0], Math.min(a, b));
    part[1] = Math.min(part[1], Math.max(a, b));
    return part[0] <= part[1];
  }

  /** Whether a place is in the grid. */
  boolean holds(double x, double y) {
    return x >= xmin && x < xmin + columns * cell && y >= ymin && y < ymin + rows * cell;
  }

  /** When a point from outside enters the grid, infinite if it never does. */
  double entry(double x, double y, double vx, double vy) {
    double[] part = {0, Double.POSITIVE_INFINITY};
    boolean enters =
        clip(part, x, vx, xmin, xmin + columns * cell)
            && clip(part, y, vy, ymin, ymin + rows * cell);
    return enters ? part[0] : Double.POSITIVE_INFINITY;
  }

  int column(double x) {
    return Math.max(0, Math.min(columns - 1, (int) ((x - xmin) / cell)));
  }

  int row(double y) {
    return Math.max(0, Math.min(rows - 1, (int) ((y - ymin) / cell)));
  }
}
