// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.util.Index;
import java.util.Arrays;

/**
 * Half planes {@code n . u >= least} of velocities, and the velocity in all of them nearest to a
 * given one.
 */
final class HalfPlanes {
  private double[] nx = new double[16];
  private double[] ny = new double[16];
  private double[] least = new double[16];
  private int count;

  /** The answer of {@link #nearest}. */
  double x;

  double y;
  private double distance;
  private double slack;

  /** The half planes on whose borders the answer is; the same twice for one, NONE at the start. */
  private int first;

  private int second;

  void clear() {
    count = 0;
  }

  void add(double normalX, double normalY, double bound) {
    if (count == nx.length) {
      nx = Arrays.copyOf(nx, 2 * count);
      ny = Arrays.copyOf(ny, 2 * count);
      least = Arrays.copyOf(least, 2 * count);
    }
    nx[count] = normalX;
    ny[count] = normalY;
    least[count++] = bound;
  }

  /** Whether all half planes hold (vx, vy) but for the two that are left out. */
  private boolean holds(double vx, double vy, int out1, int out2) {
    for (int k = 0; k < count; k++) {
      if (k != out1 && k != out2 && vx * nx[k] + vy * ny[k] < least[k] - slack) return false;
    }
    return true;
  }

  /** Whether all half planes hold (vx, vy), up to a small speed. */
  boolean holds(double vx, double vy, double slack) {
    for (int k = 0; k < count; k++) {
      if (vx * nx[k] + vy * ny[k] < least[k] - slack) return false;
    }
    return true;
  }

  /**
   * Finds the nearest velocity: the given one, its foot on a border, or a corner; false if there is
   * none.
   */
  boolean nearest(double vx, double vy) {
    return nearest(vx, vy, 0);
  }

  /** The same where bounds hold up to a small speed. */
  boolean nearest(double vx, double vy, double noise) {
    slack = noise;
    x = vx;
    y = vy;
    first = Index.NONE;
    second = Index.NONE;
    if (holds(vx, vy, -1, -1)) return true;
    distance = Double.POSITIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      double need = least[i] - vx * nx[i] - vy * ny[i];
      if (need <= 0) continue;
      offer(vx + need * nx[i], vy + need * ny[i], vx, vy, i, i);
      for (int j = 0; j < count; j++) {
        double det = nx[i] * ny[j] - nx[j] * ny[i];
        if (j == i || Math.abs(det) < ContactLaw.FLAT) continue;
        double cx = (least[i] * ny[j] - least[j] * ny[i]) / det;
        double cy = (nx[i] * least[j] - nx[j] * least[i]) / det;
        offer(cx, cy, vx, vy, i, j);
      }
    }
    return distance < Double.POSITIVE_INFINITY;
  }

  private void offer(double cx, double cy, double vx, double vy, int i, int j) {
    double d = (cx - vx) * (cx - vx) + (cy - vy) * (cy - vy);
    if (d >= distance || !holds(cx, cy, i, j)) return;
    distance = d;
    x = cx;
    y = cy;
    first = i;
    second = j;
  }

  /** The factor l of half plane k, with {@code u - v = sum of l n}, for the v that was given. */
  double multiplier(int k, double vx, double vy) {
    if (k != first && k != second) {
      return 0;
    }
    if (first == second) {
      return (x - vx) * nx[k] + (y - vy) * ny[k];
    }
    int o = k == first ? second : first;
    return ((x - vx) * ny[o] - (y - vy) * nx[o]) / (nx[k] * ny[o] - ny[k] * nx[o]);
  }
}
