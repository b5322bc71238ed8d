// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import java.util.Arrays;

/**
 * The momenta of a tick. Of all velocities that the contacts allow they are the nearest, in the
 * mass norm, to those of the last tick and the kick of gravity between. In a tick of length h, the
 * gap of a contact opens at no less than
 *
 * <ul>
 *   <li>0 on a flat side, or {@code -min((gap - standoff / 2) / h, vt^2 h / (2 rho))} on what is
 *       round, at the tangential speed vt: so circles follow it;
 *   <li>{@code -(gap - standoff) / h} if the gap is too wide to carry;
 *   <li>for a hit, an approach that is not slow: what restitution makes of it, see {@link #bounce}.
 * </ul>
 *
 * <p>Newton's restitution at several contacts can make energy. So the work of the impulses, {@code
 * sum l (q_before + q_after)}, is taken for each group of contacts that bear; where it is above 0
 * they are solved anew, without restitution. All others go on from where they are, so they are
 * asked again.
 */
final class Momenta {

  private final Members members;
  private final ContactGraph graph;
  private final Parts parts;
  private final int fixed;

  /** Velocities by circles; the last one is that of what does not take part. */
  final double[] v;

  /** Inverse masses; 0 but for awake circles. */
  final double[] weight;

  /** Whether contacts, but no hit, bore on a circle in the last solve. */
  final boolean[] bears;

  // Contacts: the pair, whether it is a hit, the gap after that, the opening speed before.
  int count;
  int[] pair = new int[0];
  boolean[] hit = new boolean[0];
  double[] endGap = new double[0];
  private double[] before = new double[0];

  /** The impulses of the last tick, by pairs. */
  private double[] warmStart = new double[0];

  /** The kick of this tick, the same for all awake circles. */
  private double kickX;

  private double kickY;

  private final Groups groups;
  private final double[] work;
  final Sweeps sweeps = new Sweeps();

  Momenta(Members members, ContactGraph graph, Parts parts) {
    this.members = members;
    this.graph = graph;
    this.parts = parts;
    fixed = members.count;
    v = new double[2 * fixed + 2];
    weight = new double[fixed + 1];
    bears = new boolean[fixed];
    groups = new Groups(fixed);
    work = new double[fixed];
  }

  /**
   * Chooses the contacts of a tick, and solves.
   *
   * @param h the length of the tick
   * @param clock it has the least approach that is a hit
   */
  void solve(double h, ContactClock clock, double gx, double gy) {
    kickX = gx * h;
    kickY = gy * h;
    choose(h, clock);
    solve(h, clock.pull * h);
  }

  private void choose(double h, ContactClock clock) {
    NearPairs p = graph.pairs;
    sweeps.clear(p.size);
    makeRoom(p);
    count = 0;
    for (int k = 0; k < p.size; k++) {
      double pull = members.pull(p, k);
      double reach = 2 * pull * h * h;
      warmStart[k] = 0;
      if (p.felt[k]) {
        double q = p.opening(v, k);
        double room = p.gap[k] - p.standoff[k];
        warmStart[k] = Math.min(p.impulse[k], mostAtStart(k, q, h) * lightWeight(k, pull * h));
        if (room + Math.min(q, 0) * h < reach || warmStart[k] > 0) {
          choose(k, q, room, h, clock.slow(pull));
        }
      }
    }
  }

  /**
   * The impulse at which a solve may start, in weights of the lighter circle. Where a contact opens
   * it has to go, and a sweep takes back about a weight: what is left would push heavy circles.
   */
  private double mostAtStart(int k, double q, double h) {
    double end = graph.pairs.gap[k] + Math.max(0, q) * h;
    return carries(k, end) ? ContactLaw.MASS_RATIO : ContactLaw.SWEEPS;
  }

  private void choose(int k, double q, double room, double h, double slow) {
    NearPairs p = graph.pairs;
    int c = count++;
    pair[c] = k;
    before[c] = q;
    hit[c] = q < -slow && room + q * h < 0;
    double target = hit[c] ? bounce(c, k, q, h) : bound(k, room, h);
    int i = p.owner[k];
    int j = p.other[k];
    int second = weight[j] > 0 ? graph.rank[j] : graph.awake;
    double goal = target + p.drift[k];
    sweeps.add(graph.rank[i], second, p.nx[k], p.ny[k], goal, weight[i], weight[j], warmStart[k]);
  }

  private void makeRoom(NearPairs p) {
    if (pair.length < p.size) {
      int room = p.owner.length;
      pair = new int[room];
      hit = new boolean[room];
      endGap = new double[room];
      before = new double[room];
      warmStart = new double[room];
    }
  }

  /** Whether a pair carries at a gap. */
  private boolean carries(int k, double gap) {
    return gap <= ContactLaw.HOLD * graph.pairs.standoff[k];
  }

  /** The least opening speed of a contact that is no hit. */
  private double bound(int k, double room, double h) {
    NearPairs p = graph.pairs;
    if (!carries(k, p.gap[k])) {
      return -room / h;
    }
    double ease = p.gap[k] - p.standoff[k] / 2;
    if (p.round[k] == 0 || ease <= 0) {
      return 0;
    }
    int i = 2 * p.owner[k];
    int j = 2 * p.other[k];
    int part = p.part[k];
    int a = p.owner[k];
    double ux = v[i] - v[j] - (part < 0 ? 0 : parts.velocityX(part, members.y[a]));
    double uy = v[i + 1] - v[j + 1] - (part < 0 ? 0 : parts.velocityY(part, members.x[a]));
    double across = uy * p.nx[k] - ux * p.ny[k];
    return -Math.min(ease / h, across * across * h / (2 * p.round[k]));
  }

  /**
   * A hit takes place at its own moment t = gap / approach. Until then, and after it, the relative
   * acceleration is the one of the last tick. So the bound is the mean opening speed after the hit,
   * and the flight ends at the gap that the bounce has at the end of the tick.
   */
  private double bounce(int c, int k, double q, double h) {
    NearPairs p = graph.pairs;
    double pull = -pull(p.owner[k], k) + pull(p.other[k], k);
    double approach = Math.max(0, -q + relativeKick(k) + pull * h);
    double moment = approach > 0 ? Math.min(h, Math.max(0, p.gap[k]) / approach) : h;
    double speed = Math.max(0, approach - pull * (h / 2 - moment));
    double rest = h - moment;
    double e = p.bounce[k];
    endGap[c] = Math.max(0, e * speed * rest - pull * rest * rest / 2);
    return Math.max(0, Math.min(e * speed - pull * (h / 2 - moment), -e * q));
  }

  private double pull(int i, int k) {
    NearPairs p = graph.pairs;
    return weight[i] > 0 ? members.ax[i] * p.nx[k] + members.ay[i] * p.ny[k] : 0;
  }

  /** The kick along the normal of a pair: alike for two awake circles. */
  private double relativeKick(int k) {
    NearPairs p = graph.pairs;
    return weight[p.other[k]] > 0 ? 0 : kickX * p.nx[k] + kickY * p.ny[k];
  }

  private void solve(double h, double kick) {
    double tolerance = ContactLaw.RESIDUAL * kick;
    int most = count == 0 ? 0 : Math.max(ContactLaw.SWEEPS, ContactLaw.WORK / count);
    sweeps.load(graph.order, graph.awake, v);
    sweeps.solve(tolerance, most);
    for (int s = 0; s < ContactLaw.TRIES && makesEnergy(); s++) {
      sweeps.load(graph.order, graph.awake, v);
      sweeps.solvePlainly(tolerance, most);
    }
    sweeps.store(graph.order, v);
    keep(h);
  }

  /**
   * Finds twice the work of the impulses on each group of contacts that bear: {@code sum l (q +
   * q_after)}.
   */
  private void findWork() {
    groups.clear(graph.awake);
    Arrays.fill(work, 0, graph.awake, 0);
    for (int c = 0; c < count; c++) {
      if (sweeps.impulse(c) > 0 && sweeps.second(c) < graph.awake) {
        groups.join(sweeps.second(c), sweeps.first(c));
      }
    }
    for (int c = 0; c < count; c++) {
      double l = sweeps.impulse(c);
      if (l > 0) {
        int k = pair[c];
        work[groups.of(sweeps.first(c))] +=
            l * (before[c] + sweeps.opening(c) - graph.pairs.drift[k]);
      }
    }
  }

  /** Finds groups whose impulses do work; they start anew, with impulses and targets of 0. */
  private boolean makesEnergy() {
    NearPairs p = graph.pairs;
    findWork();
    boolean any = false;
    for (int c = 0; c < count; c++) {
      if (work[groups.of(sweeps.first(c))] > 0) {
        sweeps.restart(c, hit[c] ? p.drift[pair[c]] : sweeps.target(c));
        hit[c] = false;
        any = true;
      }
    }
    return any;
  }

  /**
   * Keeps the impulses for the next tick, each at most twice that of its warm start and what the
   * heavier circle weighs: that of a hit is no load.
   */
  private void keep(double h) {
    NearPairs p = graph.pairs;
    Arrays.fill(p.impulse, 0, p.size, 0);
    for (int k = 0; k < graph.awake; k++) {
      bears[graph.order[k]] = false;
    }
    for (int c = 0; c < count; c++) {
      double l = sweeps.impulse(c);
      if (l > 0) {
        int k = pair[c];
        double kick = members.pull(p, k) * h;
        p.impulse[k] = Math.min(l, 2 * warmStart[k] + heavyWeight(k, kick));
        setBears(k, true);
      }
    }
    for (int c = 0; c < count; c++) {
      if (hit[c] && sweeps.impulse(c) > 0) {
        setBears(pair[c], false);
      }
    }
  }

  /** What the lighter one of a pair weighs in a tick. */
  private double lightWeight(int k, double kick) {
    return kick / Math.max(weight[graph.pairs.owner[k]], weight[graph.pairs.other[k]]);
  }

  /** What the heavier one of a pair, of those that are awake, weighs in a tick. */
  private double heavyWeight(int k, double kick) {
    double own = weight[graph.pairs.owner[k]];
    double other = weight[graph.pairs.other[k]];
    return kick / (other > 0 ? Math.min(own, other) : own);
  }

  private void setBears(int k, boolean does) {
    NearPairs p = graph.pairs;
    bears[p.owner[k]] = does;
    if (p.other[k] < fixed) {
      bears[p.other[k]] = does;
    }
  }
}
