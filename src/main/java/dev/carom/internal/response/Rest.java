// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.util.IntList;

/**
 * Freezes and wakes members. A circle that stays in one place, or in one place of a moving frame,
 * for some of its ticks is <i>calm</i>. It freezes if what it bears on is calm, too. It wakes if it
 * <i>would move</i>: if the velocity nearest to its kick and the impulses on it, of those that
 * frozen neighbours and obstacles allow, is not next to 0. Comparing forces would wake full rows
 * for ever, where they are not unique.
 */
final class Rest {

  private final Members members;
  private final ContactGraph graph;
  private final Parts parts;
  private final ContactHost host;
  private final HalfPlanes planes = new HalfPlanes();
  private final IntList near = new IntList();

  /** Frozen circles to look at, and the impulses on each from awake ones. */
  private final IntList asked = new IntList();

  private final boolean[] isAsked;
  private final double[] pushX;
  private final double[] pushY;
  private final double[] push;
  private final boolean[] calm;

  Rest(Members members, ContactGraph graph, Parts parts, ContactHost host) {
    this.members = members;
    this.graph = graph;
    this.parts = parts;
    this.host = host;
    int n = members.count;
    isAsked = new boolean[n];
    pushX = new double[n];
    pushY = new double[n];
    push = new double[n];
    calm = new boolean[n];
  }

  /** Begins to watch a circle here and now, in the frame of what moves most like it. */
  void watch(int i, double now) {
    members.calmX[i] = members.x[i];
    members.calmY[i] = members.y[i];
    members.calmSince[i] = now;
    members.load[i] = 0;
    int frame = parts.nearestFrame(members.ux[i], members.uy[i]);
    members.frameX[i] = parts.frameX(frame);
    members.frameY[i] = parts.frameY(frame);
  }

  // Waking.

  void wake(int i, double now) {
    members.moveTo(i, now);
    members.mode[i] = Members.AWAKE;
    members.rest(i);
    watch(i, now);
    graph.enter(i);
  }

  /** Wakes a frozen circle and all frozen ones that it touches, directly or by others. */
  void wakeAll(int i, double now) {
    asked.clear();
    ask(i);
    for (int k = 0; k < asked.size(); k++) { // the list grows
      int j = asked.get(k);
      double reach = ContactLaw.HOLD * ContactLaw.WIDE / 2 * members.radius[j];
      near.clear();
      host.membersNear(j, members.xAt(j, now), members.yAt(j, now), reach, near);
      near.sort(0);
      for (int c = 0; c < near.size(); c++) {
        int o = near.get(c);
        if (members.canWake(o) && members.gap(o, j, now) <= reach) {
          ask(o);
        }
      }
    }
    for (int k = 0; k < asked.size(); k++) {
      isAsked[asked.get(k)] = false;
      wake(asked.get(k), now);
      host.flies(asked.get(k));
    }
    asked.clear();
  }

  private void ask(int j) {
    if (!isAsked[j]) {
      isAsked[j] = true;
      asked.add(j);
      pushX[j] = 0;
      pushY[j] = 0;
      push[j] = 0;
    }
  }

  /** Wakes frozen circles that would move under what awake ones do to them. */
  boolean wake(double now, double gx, double gy, double tick) {
    gatherPushes();
    boolean any = false;
    double kick = Math.sqrt(gx * gx + gy * gy) * tick;
    for (int k = 0; k < asked.size(); k++) {
      int j = asked.get(k);
      isAsked[j] = false;
      if (members.canWake(j)) {
        double w = members.inverseMass[j];
        double vx = gx * tick + pushX[j] * w;
        double vy = gy * tick + pushY[j] * w;
        boolean isPressed = push[j] * w > 2 * members.load[j] * w + kick;
        if (isPressed || moves(j, vx, vy, least(j) * kick, now)) {
          wake(j, now);
          host.flies(j);
          any = true;
        }
      }
    }
    asked.clear();
    return any;
  }

  /**
   * In kicks: the least speed that wakes. Where nothing pushes, no solve errs, and g alone decides.
   */
  private double least(int j) {
    return push[j] > 0 ? ContactLaw.WAKE : ContactLaw.FLAT;
  }

  private void gatherPushes() {
    NearPairs p = graph.pairs;
    for (int k = 0; k < graph.lost.size(); k++) {
      ask(graph.lost.get(k));
    }
    graph.lost.clear();
    for (int k = 0; k < p.size; k++) {
      int j = p.other[k];
      if (p.part[k] < 0 && members.isFrozen(j)) {
        double l = p.impulse[k];
        if (l > 0 || p.bore[k] || p.gap[k] < ContactLaw.HOLD * p.standoff[k]) {
          ask(j);
          p.bore[k] = l > 0;
          pushX[j] -= l * p.nx[k];
          pushY[j] -= l * p.ny[k];
          push[j] += l;
        }
      }
    }
  }

  /** Whether the allowed velocity nearest to (vx, vy) is above the least that counts. */
  private boolean moves(int j, double vx, double vy, double least, double now) {
    if (vx * vx + vy * vy <= least * least) {
      return false;
    }
    double x = members.xAt(j, now);
    double y = members.yAt(j, now);
    double r = members.radius[j];
    double hold = ContactLaw.HOLD * ContactLaw.STANDOFF;
    planes.clear();
    near.clear();
    host.membersNear(j, x, y, hold * r, near);
    near.sort(0);
    for (int c = 0; c < near.size(); c++) {
      int i = near.get(c);
      double gap = members.gap(i, j, now);
      if (members.isFrozen(i) && gap < hold * Math.min(r, members.radius[i])) {
        double dx = x - members.xAt(i, now);
        double dy = y - members.yAt(i, now);
        double d = Math.sqrt(dx * dx + dy * dy);
        planes.add(dx / d, dy / d, 0);
      }
    }
    near.clear();
    parts.near(members, j, host, hold * r, now, near);
    for (int c = 0; c < near.size(); c++) {
      int part = near.get(c);
      if (parts.touches(part, r, members.filter[j], x, y, 0, 0)
          && parts.isSolidFrom(part, x, y)
          && parts.distance - r < hold * r) {
        planes.add(parts.normalX, parts.normalY, 0);
      }
    }
    return planes.nearest(vx, vy) && planes.x * planes.x + planes.y * planes.y > least * least;
  }

  // Freezing.

  /** Freezes calm circles that bear on calm ones. */
  boolean freeze(double now, ContactClock clock) {
    if (!findCalm(now)) {
      return false;
    }
    NearPairs p = graph.pairs;
    for (int k = 0; k < p.size; k++) {
      if (p.felt[k] && p.impulse[k] > 0) {
        disturb(k, now, clock);
      }
    }
    boolean any = false;
    for (int k = 0; k < graph.awake; k++) {
      int i = graph.order[k];
      if (calm[i]) {
        any = true;
        members.mode[i] = Members.FROZEN;
        members.fly(i, members.frameX[i], members.frameY[i]);
        members.rest(i);
        members.load[i] = 0;
      }
    }
    if (any) {
      takeLoads();
    }
    return any;
  }

  /** Finds the awake circles that are calm; whether there is any. */
  private boolean findCalm(double now) {
    boolean any = false;
    for (int k = 0; k < graph.awake; k++) {
      int i = graph.order[k];
      double t = now - members.calmSince[i];
      double dx = members.x[i] - members.calmX[i] - members.frameX[i] * t;
      double dy = members.y[i] - members.calmY[i] - members.frameY[i] * t;
      double most = ContactLaw.CALM_DISTANCE * members.radius[i];
      if (dx * dx + dy * dy > most * most) {
        watch(i, now);
      }
      calm[i] = members.isAwake(i) && isCalm(i, ContactLaw.CALM_TICKS, now);
      any |= calm[i];
    }
    return any;
  }

  private boolean isCalm(int i, int ticks, double now) {
    double tick = ContactClock.ownTick(members.radius[i], members.pull[i]);
    return now - members.calmSince[i] >= ticks * tick;
  }

  /** Keeps circles awake that bear on one that is not calm, or whose frames come or go. */
  private void disturb(int k, double now, ContactClock clock) {
    NearPairs p = graph.pairs;
    int i = p.owner[k];
    int j = p.other[k];
    int part = p.part[k];
    double ux = part >= 0 ? parts.velocityX(part, members.y[i]) : members.frameX[j];
    double uy = part >= 0 ? parts.velocityY(part, members.x[i]) : members.frameY[j];
    double opening = (members.frameX[i] - ux) * p.nx[k] + (members.frameY[i] - uy) * p.ny[k];
    boolean turns = part >= 0 && parts.turns(part);
    boolean parted = turns || Math.abs(opening) > ContactLaw.FLAT * clock.slow();
    boolean isFixed = part >= 0 || members.isFrozen(j);
    int half = ContactLaw.CALM_TICKS / 2;
    boolean disturbsJ = !isFixed && (parted || !isCalm(i, half, now));
    if (parted || (!isFixed && !isCalm(j, half, now))) {
      calm[i] = false;
    }
    if (disturbsJ) {
      calm[j] = false;
    }
  }

  private void takeLoads() {
    NearPairs p = graph.pairs;
    for (int k = 0; k < p.size; k++) {
      int i = p.owner[k];
      int j = p.other[k];
      if (calm[i]) {
        members.load[i] += p.impulse[k];
      }
      if (p.part[k] < 0 && members.isFrozen(j) && calm[j]) {
        members.load[j] += p.impulse[k];
      }
    }
    for (int k = 0; k < graph.awake; k++) {
      int i = graph.order[k];
      if (calm[i]) {
        calm[i] = false;
        host.flies(i);
      }
    }
  }
}
