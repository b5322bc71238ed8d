// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Line;
import dev.carom.Scene;
import java.util.Arrays;
import java.util.stream.DoubleStream;

/**
 * Which lines does the path of a centre cross? Lines are kept by the cells of a coarse raster that
 * their boxes touch; nothing of the library's own search is used.
 */
final class LineMap {

  private static final int CELLS = 16;

  private final double[] lines;
  private final int[][] cells = new int[CELLS * CELLS][0];
  private final double left;
  private final double bottom;
  private final double right;
  private final double top;

  LineMap(Scene scene) {
    lines = new double[4 * scene.lineCount()];
    for (int i = 0; i < scene.lineCount(); i++) {
      Line line = scene.line(i);
      lines[4 * i] = line.ax();
      lines[4 * i + 1] = line.ay();
      lines[4 * i + 2] = line.bx();
      lines[4 * i + 3] = line.by();
    }
    left = extreme(0, -1);
    right = extreme(0, 1);
    bottom = extreme(1, -1);
    top = extreme(1, 1);
    for (int i = 0; i < scene.lineCount(); i++) {
      put(i);
    }
  }

  /** The largest of the lines' coordinates on an axis, or (sign -1) the least. */
  private double extreme(int axis, int sign) {
    return sign
        * DoubleStream.iterate(axis, k -> k < lines.length, k -> k + 2)
            .map(k -> sign * lines[(int) k])
            .max()
            .orElse(0);
  }

  private void put(int i) {
    int k = 4 * i;
    int lastColumn = column(Math.max(lines[k], lines[k + 2]));
    int lastRow = row(Math.max(lines[k + 1], lines[k + 3]));
    for (int row = row(Math.min(lines[k + 1], lines[k + 3])); row <= lastRow; row++) {
      for (int column = column(Math.min(lines[k], lines[k + 2])); column <= lastColumn; column++) {
        int[] cell = cells[row * CELLS + column];
        cells[row * CELLS + column] = Arrays.copyOf(cell, cell.length + 1);
        cells[row * CELLS + column][cell.length] = k;
      }
    }
  }

  private int column(double x) {
    return cell((x - left) / (right - left));
  }

  private int row(double y) {
    return cell((y - bottom) / (top - bottom));
  }

  private static int cell(double share) {
    return (int) Math.max(0, Math.min(CELLS - 1, share * CELLS));
  }

  /** Whether a straight path crosses some line, from one side strictly to the other. */
  boolean isCrossed(double px, double py, double qx, double qy) {
    int lastColumn = column(Math.max(px, qx));
    int lastRow = row(Math.max(py, qy));
    for (int row = row(Math.min(py, qy)); row <= lastRow; row++) {
      for (int column = column(Math.min(px, qx)); column <= lastColumn; column++) {
        for (int k : cells[row * CELLS + column]) {
          if (crosses(k, px, py, qx, qy)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  private boolean crosses(int k, double px, double py, double qx, double qy) {
    double ax = lines[k];
    double ay = lines[k + 1];
    double bx = lines[k + 2];
    double by = lines[k + 3];
    return cross(ax, ay, bx, by, px, py) * cross(ax, ay, bx, by, qx, qy) < 0
        && cross(px, py, qx, qy, ax, ay) * cross(px, py, qx, qy, bx, by) < 0;
  }

  /** Positive if r is left of the way from p to q. */
  private static double cross(double px, double py, double qx, double qy, double rx, double ry) {
    return (qx - px) * (ry - py) - (qy - py) * (rx - px);
  }
}
