// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.util.Index;
import java.util.Arrays;

/**
 * The flights of a tick: momenta, changed until no near pair can meet within it. Bodies are convex
 * and relative flights straight. So a pair with the unit normal n and some gap does not meet in a
 * time h if {@code n.(u_i - u_j) >= -gap / h}: it stays on its sides of two parallel lines.
 */
final class Flights {

  private final Members members;
  private final ContactGraph graph;
  private final Momenta momenta;
  private final double gx;
  private final double gy;
  private final double square;
  private final HalfPlanes planes = new HalfPlanes();

  /** Velocities by circles; the last one is that of what does not take part. */
  final double[] u;

  /** The velocities of what drives each circle: at the worst it flies along with that. */
  final double[] drive;

  /** The places of circles in the order, by their turns. */
  private final long[] turns;

  /** The first pair that each circle has to keep, by circles; then, by pairs, the next one. */
  private final int[] first;

  private int[] next = new int[0];

  // Pairs that are pushed apart: their target, and the impulse so far.
  private int closeCount;
  private int[] close = new int[0];
  private double[] target = new double[0];
  private double[] impulse = new double[0];

  Flights(Members members, ContactGraph graph, Momenta momenta, double gx, double gy) {
    this.gx = gx;
    this.gy = gy;
    square = gx * gx + gy * gy;
    this.members = members;
    this.graph = graph;
    this.momenta = momenta;
    u = new double[2 * members.count + 2];
    drive = new double[2 * members.count];
    turns = new long[members.count];
    first = new int[members.count];
  }

  /** Starts with the momenta; what hits ends where its bounce is at the end of the tick. */
  void start(double h) {
    NearPairs p = graph.pairs;
    double[] v = momenta.v;
    for (int k = 0; k < graph.awake; k++) {
      int i = 2 * graph.order[k];
      u[i] = v[i];
      u[i + 1] = v[i + 1];
    }
    for (int c = 0; c < momenta.count; c++) {
      if (momenta.hit[c] && momenta.sweeps.impulse(c) > 0) {
        int k = momenta.pair[c];
        double opening = p.opening(u, k);
        double gap = Math.max(0, p.gap[k]);
        double end = Math.min(momenta.endGap[c], gap + Math.max(0, opening) * h);
        push(k, (end - gap) / h - opening);
      }
    }
  }

  /** Changes the opening speed of pair k by d. */
  private void push(int k, double d) {
    NearPairs p = graph.pairs;
    int a = p.owner[k];
    int b = p.other[k];
    double[] w = momenta.weight;
    double l = d / (w[a] + w[b]);
    u[2 * a] += l * w[a] * p.nx[k];
    u[2 * a + 1] += l * w[a] * p.ny[k];
    u[2 * b] -= l * w[b] * p.nx[k];
    u[2 * b + 1] -= l * w[b] * p.ny[k];
  }

  /** Pushes apart what is nearer than half a standoff: flights only, momenta never. */
  void part(double h) {
    NearPairs p = graph.pairs;
    if (close.length < p.size) {
      close = new int[p.owner.length];
      target = new double[close.length];
      impulse = new double[close.length];
    }
    closeCount = 0;
    for (int k = 0; k < p.size; k++) {
      double low = p.standoff[k] / 2;
      double goal = p.leaving(low, k, h);
      if (p.felt[k] && (p.gap[k] < 4 * low || p.opening(u, k) < goal)) {
        close[closeCount] = k;
        impulse[closeCount] = 0;
        target[closeCount++] = goal;
      }
    }
    boolean any = true;
    for (int s = 1; s < ContactLaw.TRIES && any; s++) {
      any = partOnce();
    }
  }

  private boolean partOnce() {
    NearPairs p = graph.pairs;
    double[] w = momenta.weight;
    boolean any = false;
    for (int c = 0; c < closeCount; c++) {
      int k = close[c];
      double need = target[c] - p.opening(u, k);
      if (impulse[c] > 0 || need > 0) {
        any = true;
        double mass = 1 / (w[p.owner[k]] + w[p.other[k]]);
        double next = Math.max(0, impulse[c] + need * mass);
        push(k, (next - impulse[c]) / mass);
        impulse[c] = next;
      }
    }
    return any;
  }

  /**
   * In turn, each takes the flight nearest to its own that obstacles and those before allow. By
   * powers of two of the mass the heavy ones come first, so that no light one lifts them.
   */
  void pass(double h, double slow) {
    sortByMass();
    sharePairs();
    for (int k = 0; k < graph.awake; k++) {
      int i = graph.order[(int) turns[k]];
      int a = 2 * i;
      double x = u[a];
      double y = u[a + 1];
      if (gather(i, h) && planes.nearest(x, y)) {
        double dx = planes.x - x;
        double dy = planes.y - y;
        double most = slow + (ContactLaw.NEWCOMER - 1) * Math.sqrt(x * x + y * y);
        if (dx * dx + dy * dy <= most * most) {
          u[a] = planes.x;
          u[a + 1] = planes.y;
          slowDown(a, momenta.v[a] + dx, momenta.v[a + 1] + dy);
        }
      }
    }
  }

  /** Whether a circle is heavier than another one, by powers of two; from inverse masses. */
  static boolean isHeavier(double weight, double other) {
    return Math.getExponent(weight) < Math.getExponent(other);
  }

  private void sortByMass() {
    for (int q = 0; q < graph.awake; q++) {
      long exponent = Math.getExponent(momenta.weight[graph.order[q]]);
      turns[q] = exponent << Integer.SIZE | q;
    }
    Arrays.sort(turns, 0, graph.awake);
  }

  /** Gives each pair to that one of its circles which has its turn later. */
  private void sharePairs() {
    NearPairs p = graph.pairs;
    if (next.length < p.size) {
      next = new int[p.owner.length];
    }
    for (int k = 0; k < graph.awake; k++) {
      first[graph.order[k]] = Index.NONE;
    }
    double[] w = momenta.weight;
    for (int k = p.size - 1; k >= 0; k--) {
      int i = isHeavier(w[p.owner[k]], w[p.other[k]]) ? p.other[k] : p.owner[k];
      next[k] = first[i];
      first[i] = k;
    }
  }

  /** Collects the bounds of a circle; false if its flight keeps them. */
  private boolean gather(int i, double h) {
    NearPairs p = graph.pairs;
    boolean bad = false;
    for (int k = first[i]; k >= 0 && !bad; k = next[k]) {
      bad = p.felt[k] && p.opening(u, k) < least(k, h);
    }
    planes.clear();
    for (int k = first[i]; k >= 0 && bad; k = next[k]) {
      if (p.felt[k]) {
        boolean owns = p.owner[k] == i;
        int b = 2 * (owns ? p.other[k] : p.owner[k]);
        double nx = owns ? p.nx[k] : -p.nx[k];
        double ny = owns ? p.ny[k] : -p.ny[k];
        double other = u[b] * nx + u[b + 1] * ny + p.drift[k];
        planes.add(nx, ny, other + least(k, h));
      }
    }
    return bad;
  }

  /** The opening speed that leaves a quarter of the standoff, or a little more than there is. */
  private double least(int k, double h) {
    double keep = graph.pairs.standoff[k] / 4;
    double gap = graph.pairs.gap[k];
    if (graph.pairs.isDeep(k)) {
      return 0;
    }
    return -(gap - Math.min(keep, gap + keep / 2)) / h;
  }

  /**
   * Takes the part along gravity of a momentum if that is smaller. Across it the momentum stays: a
   * flight that is not flown gains nothing there.
   */
  private void slowDown(int a, double x, double y) {
    double[] v = momenta.v;
    double speed = (v[a] * gx + v[a + 1] * gy) / square;
    double slower = (x * gx + y * gy) / square;
    if (Math.abs(slower) < Math.abs(speed)) {
      v[a] += (slower - speed) * gx;
      v[a + 1] += (slower - speed) * gy;
    }
  }

  /**
   * Makes all near pairs safe: by some rounds of pushes, then without the flights that meet. Each
   * round after the pushes stops a flight at least.
   *
   * @return false if that does not end, as where something moves
   */
  boolean secure(double h, int pushes) {
    int most = pushes + graph.awake;
    for (int round = 0; round <= most; round++) {
      if (!secureOnce(h, round < pushes)) {
        return true;
      }
    }
    return false;
  }

  private boolean secureOnce(double h, boolean pushes) {
    NearPairs p = graph.pairs;
    boolean any = false;
    for (int k = 0; k < p.size; k++) {
      if (p.part[k] >= 0) {
        graph.feel(k, u, h);
      }
      if (p.meets(u, k, h, members.radius[p.owner[k]])) {
        any = true;
        double opening = p.opening(u, k);
        double gap = Math.max(0, p.gap[k]);
        if (pushes) {
          push(k, -(gap - Math.min(gap, p.standoff[k]) / 2) / h - opening);
        } else {
          stop(p.owner[k]);
          stop(p.other[k]);
        }
      }
    }
    return any;
  }

  /** A flight that is given up goes along with what drives it, and takes the momentum along. */
  private void stop(int i) {
    if (momenta.weight[i] > 0) {
      u[2 * i] = drive[2 * i];
      u[2 * i + 1] = drive[2 * i + 1];
      slowDown(2 * i, u[2 * i], u[2 * i + 1]);
    }
  }
}
