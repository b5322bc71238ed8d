// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import java.util.Arrays;

/**
 * Projected Gauss-Seidel with conjugate steps: M. Silcowitz, S. Niebe, K. Erleben, A nonsmooth
 * nonlinear conjugate gradient method for interactive contact force problems, The Visual Computer
 * 26, 2010.
 *
 * <p>Contact c of bodies i, j with the unit normal n, from j to i, wants an opening speed {@code
 * n.(v_i - v_j)} of at least its target, by an impulse {@code l >= 0}, which changes {@code v_i +=
 * w_i l n} and {@code v_j -= w_j l n} for inverse masses w. One contact after the other is solved,
 * up and down in turn: {@code l = max(0, l + (target - n.(v_i - v_j)) / (w_i + w_j))}.
 */
final class Sweeps {

  // The columns of a contact.
  private static final int NX = 0;
  private static final int NY = 1;
  private static final int TARGET = 2;
  private static final int MASS = 3;
  private static final int FIRST = 4;
  private static final int SECOND = 5;
  private static final int IMPULSE = 6;
  private static final int ROW = 8;

  private int count;
  private int bodies;
  private double[] rows = new double[0];

  /** Twice the number of each of the two bodies. */
  private int[] ends = new int[0];

  /** The velocities of the bodies. The last one is what does not take part. */
  private double[] v = new double[0];

  // The conjugate step, and what one sweep changes.
  private double[] stepV = new double[0];
  private double[] lastV = new double[0];
  private double[] step = new double[0];
  private double[] change = new double[0];
  private double worst;
  private double square;

  /** Contacts visited by all sweeps so far: what the work is measured by. */
  long visits;

  /** Starts a problem of at most so many contacts. */
  void clear(int most) {
    count = 0;
    if (step.length < most) {
      int room = Math.max(most, 2 * step.length);
      rows = new double[room * ROW];
      ends = new int[2 * room];
      step = new double[room];
      change = new double[room];
    }
  }

  /** Adds a contact, which starts with an impulse. */
  void add(
      int first,
      int second,
      double nx,
      double ny,
      double target,
      double ofFirst,
      double ofSecond,
      double impulse) {
    int r = count * ROW;
    rows[r + NX] = nx;
    rows[r + NY] = ny;
    rows[r + TARGET] = target;
    rows[r + MASS] = 1 / (ofFirst + ofSecond);
    rows[r + FIRST] = ofFirst;
    rows[r + SECOND] = ofSecond;
    rows[r + IMPULSE] = impulse;
    ends[2 * count] = 2 * first;
    ends[2 * count + 1] = 2 * second;
    count++;
  }

  int size() {
    return count;
  }

  double impulse(int c) {
    return rows[c * ROW + IMPULSE];
  }

  int first(int c) {
    return ends[2 * c] >> 1;
  }

  int second(int c) {
    return ends[2 * c + 1] >> 1;
  }

  /** Lets a contact start anew: with another target, and no impulse. */
  void restart(int c, double target) {
    rows[c * ROW + TARGET] = target;
    rows[c * ROW + IMPULSE] = 0;
  }

  double target(int c) {
    return rows[c * ROW + TARGET];
  }

  double opening(int c) {
    int r = c * ROW;
    int i = ends[2 * c];
    int j = ends[2 * c + 1];
    return (v[i] - v[j]) * rows[r + NX] + (v[i + 1] - v[j + 1]) * rows[r + NY];
  }

  /** Takes the velocities of so many circles, in order, and adds what the first impulses do. */
  void load(int[] order, int n, double[] from) {
    bodies = n;
    if (v.length < 2 * n + 2) {
      v = new double[4 * n + 2];
      stepV = new double[4 * n + 2];
      lastV = new double[4 * n + 2];
    }
    for (int k = 0; k < n; k++) {
      v[2 * k] = from[2 * order[k]];
      v[2 * k + 1] = from[2 * order[k] + 1];
    }
    v[2 * n] = 0;
    v[2 * n + 1] = 0;
    for (int c = 0; c < count; c++) {
      push(c, rows[c * ROW + IMPULSE]);
    }
  }

  void store(int[] order, double[] into) {
    for (int k = 0; k < bodies; k++) {
      into[2 * order[k]] = v[2 * k];
      into[2 * order[k] + 1] = v[2 * k + 1];
    }
  }

  private void push(int c, double impulse) {
    int r = c * ROW;
    int i = ends[2 * c];
    int j = ends[2 * c + 1];
    double p = impulse * rows[r + FIRST];
    double q = impulse * rows[r + SECOND];
    v[i] += p * rows[r + NX];
    v[i + 1] += p * rows[r + NY];
    v[j] -= q * rows[r + NX];
    v[j + 1] -= q * rows[r + NY];
  }

  /** Sweeps with conjugate steps between; the last sweep is plain. */
  void solve(double tolerance, int most) {
    double before = 0;
    stop();
    for (int s = 1; s <= most; s++) {
      System.arraycopy(v, 0, lastV, 0, 2 * bodies);
      sweep((s & 1) == 1);
      if (worst < tolerance && s >= 2) {
        return;
      }
      double beta = before > 0 ? square / before : 0;
      before = square;
      if (beta <= 1 && s + 1 < most) {
        accelerate(beta);
      } else {
        stop(); // also where squares of impulses leave the range of doubles
      }
    }
  }

  /** Sweeps without acceleration: none of them adds energy if no target is above 0. */
  void solvePlainly(double tolerance, int most) {
    worst = Double.POSITIVE_INFINITY;
    for (int s = 1; s <= most && !(worst < tolerance); s++) {
      sweep((s & 1) == 1);
    }
  }

  private void stop() {
    Arrays.fill(step, 0, count, 0);
    Arrays.fill(stepV, 0, 2 * bodies, 0);
  }

  /** Goes on by beta times the last step: impulses and velocities stay consistent. */
  private void accelerate(double beta) {
    for (int c = 0; c < count; c++) {
      double more = beta * step[c];
      step[c] = more + change[c];
      rows[c * ROW + IMPULSE] += more;
    }
    for (int k = 0; k < 2 * bodies; k++) {
      double more = beta * stepV[k];
      stepV[k] = more + v[k] - lastV[k];
      v[k] += more;
    }
  }

  private void sweep(boolean up) {
    final double[] rows = this.rows;
    final int[] ends = this.ends;
    final double[] v = this.v;
    final double[] change = this.change;
    double worst = 0;
    double square = 0;
    int c = up ? 0 : count - 1;
    int d = up ? 1 : -1;
    for (int k = count; k > 0; k--, c += d) {
      int r = c * ROW;
      int i = ends[2 * c];
      int j = ends[2 * c + 1];
      double x = rows[r + NX];
      double y = rows[r + NY];
      double need = rows[r + TARGET] - (v[i] - v[j]) * x - (v[i + 1] - v[j + 1]) * y;
      double l = rows[r + IMPULSE];
      change[c] = 0;
      if (l == 0 && need <= 0) {
        continue;
      }
      double next = Math.max(0, l + need * rows[r + MASS]);
      double delta = next - l;
      rows[r + IMPULSE] = next;
      change[c] = delta;
      double p = delta * rows[r + FIRST];
      double q = delta * rows[r + SECOND];
      v[i] += p * x;
      v[i + 1] += p * y;
      v[j] -= q * x;
      v[j + 1] -= q * y;
      square += delta * delta;
      worst = Math.max(worst, Math.abs(delta) / rows[r + MASS]);
    }
    visits += count;
    this.worst = worst;
    this.square = square;
  }
}
