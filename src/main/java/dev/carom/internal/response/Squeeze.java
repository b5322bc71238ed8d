// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.util.Index;

/**
 * Flights where something moves: to stand still is not safe there. So the flights of all circles
 * that touch each other are solved together, by {@link Sweeps}, until no pair can meet.
 *
 * <p>A row that lies exactly straight has no way out of first order. So groups between something
 * that moves and what that approaches get a wide standoff, which differs from pair to pair.
 */
final class Squeeze {

  /** Its multiples spread evenly: the golden ratio. */
  private static final double SPREAD = 0.618033988749895;

  private final Links links;
  private final double gx;
  private final double gy;
  private final Members members;
  private final ContactGraph graph;
  private final Momenta momenta;
  private final Parts parts;
  private final int n;
  private final Sweeps sweeps = new Sweeps();
  private final Groups groups;

  // Of each group: whether it is squeezed; whether something drives it, and which part.
  private final boolean[] inside;
  private final boolean[] driven;
  private final int[] driver;

  /** Whether any standoff is wide. */
  private boolean isWide;

  /** The pairs of the problem. */
  private int[] pair = new int[0];

  Squeeze(Members members, ContactGraph graph, Momenta momenta, Parts parts, double gx, double gy) {
    this.gx = gx;
    this.gy = gy;
    links = new Links(members.count);
    this.members = members;
    this.graph = graph;
    this.momenta = momenta;
    this.parts = parts;
    n = members.count;
    groups = new Groups(n);
    inside = new boolean[n];
    driven = new boolean[n];
    driver = new int[n];
  }

  /** Forgets the last solution, before flights are sought. */
  void begin() {
    sweeps.clear(0);
  }

  private boolean isAwake(int j) {
    return j < n && momenta.weight[j] > 0;
  }

  /** Joins circles that are near each other. */
  private void join(double reach) {
    groups.clear(n);
    for (int k = 0; k < graph.awake; k++) {
      inside[graph.order[k]] = false;
      driven[graph.order[k]] = false;
    }
    NearPairs p = graph.pairs;
    for (int k = 0; k < p.size; k++) {
      if (isAwake(p.other[k]) && p.gap[k] < reach * p.round[k]) {
        groups.join(p.other[k], p.owner[k]);
      }
    }
  }

  /** Gives a wide standoff to groups between something that moves and what it approaches. */
  void widen(double[] drive) {
    double reach = ContactLaw.HOLD * ContactLaw.WIDE / 2;
    join(reach);
    NearPairs p = graph.pairs;
    for (int k = 0; k < p.size; k++) {
      if (isAtPart(k, reach) && parts.moves(p.part[k])) {
        int q = groups.of(p.owner[k]);
        driven[q] = true;
        driver[q] = p.part[k];
      }
    }
    for (int k = 0; k < p.size; k++) {
      int q = groups.of(p.owner[k]);
      if (isAtPart(k, reach) && driven[q]) {
        double x = members.x[p.owner[k]];
        double y = members.y[p.owner[k]];
        double dx = parts.velocityX(p.part[k], y) - parts.velocityX(driver[q], y);
        double dy = parts.velocityY(p.part[k], x) - parts.velocityY(driver[q], x);
        inside[q] |= dx * p.nx[k] + dy * p.ny[k] > ContactLaw.FLAT * parts.fastest();
      }
    }
    for (int k = 0; k < p.size; k++) {
      if (inside[groups.of(p.owner[k])]) {
        widen(k);
      }
    }
    for (int k = 0; k < graph.awake; k++) {
      int i = graph.order[k];
      int q = groups.of(i);
      boolean isCarried = driven[q] && !inside[q];
      drive[2 * i] = isCarried ? parts.velocityX(driver[q], members.y[i]) : 0;
      drive[2 * i + 1] = isCarried ? parts.velocityY(driver[q], members.x[i]) : 0;
    }
  }

  private boolean isAtPart(int k, double reach) {
    NearPairs p = graph.pairs;
    return p.part[k] >= 0 && p.felt[k] && p.gap[k] <= reach * members.radius[p.owner[k]];
  }

  private void widen(int k) {
    NearPairs p = graph.pairs;
    int i = p.owner[k];
    int j = p.other[k];
    double spread = SPREAD * (parts.id(i) + (j < n ? parts.id(j) : 0)); // slots change by a save
    p.standoff[k] = ContactLaw.WIDE * graph.radius(k) * (0.5 + spread - Math.floor(spread));
    isWide = true;
  }

  /** Ends a tick: no standoff stays wide, since a world that is restored knows of none. */
  void end() {
    for (int k = 0; isWide && k < graph.pairs.size; k++) {
      graph.pairs.standoff[k] = ContactLaw.STANDOFF * graph.radius(k);
    }
    isWide = false;
  }

  /**
   * Lets circles between two opposite contacts of a squeezed group fly aside: to where they already
   * bulge, else against gravity. So a row buckles while there is room between its circles.
   */
  void bulge(double[] u, double h) {
    NearPairs p = graph.pairs;
    links.chain(p, graph.awake, graph.order);
    for (int q = 0; q < graph.awake; q++) {
      int i = graph.order[q];
      if (inside[groups.of(i)]) {
        bulge(u, h, i);
      }
    }
  }

  private void bulge(double[] u, double h, int i) {
    for (int a = links.first(i); a >= 0; a = links.next(i, a)) {
      for (int b = links.next(i, a); b >= 0; b = links.next(i, b)) {
        double sa = links.sign(i, a);
        double sb = links.sign(i, b);
        NearPairs p = graph.pairs;
        double cosine = sa * sb * (p.nx[a] * p.nx[b] + p.ny[a] * p.ny[b]);
        if (presses(a) && presses(b) && cosine < ContactLaw.OPPOSITE) {
          double most = 2 * members.radius[i] / h; // out of the way
          double speed = Math.min(most, ContactLaw.ASIDE * parts.fastest());
          fly(u, i, speed, sa * p.nx[a], sa * p.ny[a], sb * p.nx[b], sb * p.ny[b]);
          return;
        }
      }
    }
  }

  private boolean presses(int k) {
    NearPairs p = graph.pairs;
    return p.felt[k] && p.gap[k] <= p.standoff[k];
  }

  /** Flies aside, between two contacts with the unit normals a and b. */
  private void fly(double[] u, int i, double speed, double ax, double ay, double bx, double by) {
    double tx = -(ay - by);
    double ty = ax - bx;
    double bulge = (ax + bx) * tx + (ay + by) * ty;
    double g = Math.sqrt(gx * gx + gy * gy);
    double up = g == 0 ? 0 : -(gx * tx + gy * ty) / g;
    double way = Math.abs(bulge) > ContactLaw.FLAT ? bulge : up;
    if (Math.abs(way) <= ContactLaw.FLAT) {
      return; // either side is as good
    }
    double length = Math.copySign(Math.sqrt(tx * tx + ty * ty), way);
    tx /= length;
    ty /= length;
    double more = speed - u[2 * i] * tx - u[2 * i + 1] * ty;
    if (more > 0) {
      u[2 * i] += more * tx;
      u[2 * i + 1] += more * ty;
    }
  }

  private boolean meets(double[] u, int k, double h) {
    NearPairs p = graph.pairs;
    return p.meets(u, k, h, members.radius[p.owner[k]]);
  }

  boolean anyMeets(double[] u, double h) {
    boolean any = false;
    for (int k = 0; k < graph.pairs.size && !any; k++) {
      any = meets(u, k, h);
    }
    return any;
  }

  /** A frozen circle that a flight runs into, or NONE. */
  int blocked(double[] u, double h) {
    NearPairs p = graph.pairs;
    for (int k = 0; k < p.size; k++) {
      int j = p.other[k];
      if (j < n && members.canWake(j) && meets(u, k, h)) {
        return j;
      }
    }
    return Index.NONE;
  }

  /**
   * Solves for the flights of groups in which a pair meets; false if that did not come out. A row
   * of many circles that has to buckle takes thousands of sweeps: where fewer do not do the tick is
   * cut, and each cut allows four times as many.
   */
  boolean solve(double[] u, double h, double kick, int cuts) {
    NearPairs p = graph.pairs;
    join(ContactLaw.STANDOFF * ContactLaw.HOLD);
    for (int k = 0; k < p.size; k++) {
      if (meets(u, k, h)) {
        if (isAwake(p.other[k])) {
          groups.join(p.other[k], p.owner[k]);
        }
        inside[groups.of(p.owner[k])] = true;
      }
    }
    fill(h);
    sweeps.load(graph.order, graph.awake, u);
    sweeps.solve(ContactLaw.RESIDUAL * kick, ContactLaw.SWEEPS << (2 * cuts));
    sweeps.store(graph.order, u);
    return isSafe(h);
  }

  private void fill(double h) {
    NearPairs p = graph.pairs;
    sweeps.clear(p.size);
    if (pair.length < p.size) {
      pair = new int[p.owner.length];
    }
    for (int k = 0; k < p.size; k++) {
      int i = p.owner[k];
      int j = p.other[k];
      if (p.felt[k] && (inside[groups.of(i)] || (isAwake(j) && inside[groups.of(j)]))) {
        int second = isAwake(j) ? graph.rank[j] : graph.awake;
        pair[sweeps.size()] = k;
        double[] w = momenta.weight;
        double goal = p.leaving(p.standoff[k] / 4, k, h) + p.drift[k];
        sweeps.add(graph.rank[i], second, p.nx[k], p.ny[k], goal, w[i], w[j], 0);
      }
    }
  }

  private boolean isSafe(double h) {
    NearPairs p = graph.pairs;
    boolean safe = true;
    for (int c = 0; c < sweeps.size() && safe; c++) {
      int k = pair[c];
      double slack = ContactLaw.SLACK * members.radius[p.owner[k]];
      safe = (sweeps.opening(c) - p.drift[k]) * h >= Math.min(0, -p.gap[k] - slack);
    }
    return safe;
  }

  /** The pair of something that moves which presses most in the last solve, else one that meets. */
  int pressed(double[] u, double h) {
    NearPairs p = graph.pairs;
    int best = Index.NONE;
    double most = 0;
    for (int c = 0; c < sweeps.size(); c++) {
      if (movesInto(pair[c]) && sweeps.impulse(c) > most) {
        most = sweeps.impulse(c);
        best = pair[c];
      }
    }
    for (int k = 0; k < p.size && best < 0; k++) {
      best = movesInto(k) && meets(u, k, h) ? k : best;
    }
    for (int k = 0; k < p.size && best < 0; k++) {
      best = meets(u, k, h) ? k : best;
    }
    return best;
  }

  private boolean movesInto(int k) {
    int part = graph.pairs.part[k];
    return part >= 0 && parts.moves(part);
  }
}
