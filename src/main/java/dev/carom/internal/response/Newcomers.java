// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.util.IntList;

/**
 * The first flight of a circle that joins in mid-tick. It is the one nearest to its momentum that
 * the flights around it allow; else that of a neighbour, or none, if all others allow it. Else the
 * circle stops, and so does, by and by, each that would run into one that stands.
 */
final class Newcomers {

  private final Members members;
  private final Parts parts;
  private final ContactHost host;
  private final double gx;
  private final double gy;
  private final HalfPlanes planes = new HalfPlanes();
  private final Approach approach = new Approach();
  private final Arc arc = new Arc();

  /** What is around a newcomer: members, then parts. */
  private final IntList near = new IntList();

  private int nearMembers;
  private final IntList stopped = new IntList();

  /** The time to which all momenta belong. */
  double momentTime;

  /** No member flies faster. */
  double longest;

  // The present question: the time that is left in the tick, and a slow approach.
  private double now;
  private double time;
  private double slow;

  Newcomers(Members members, Parts parts, ContactHost host, double gx, double gy) {
    this.members = members;
    this.parts = parts;
    this.host = host;
    this.gx = gx;
    this.gy = gy;
  }

  /**
   * Gives a newcomer a flight: not much faster than its own, but what moves may push it.
   *
   * @param px,py the one that it would have
   * @return false if the tick has to end now
   */
  boolean fly(int i, double px, double py, double now, ContactClock clock) {
    this.now = now;
    time = clock.end - now;
    slow = clock.slow();
    members.fly(i, 0, 0);
    if (!(time > 0)) {
      return false;
    }
    longest = Math.max(longest, parts.fastest());
    double pushed = parts.areMoving() ? longest : 0;
    double most = ContactLaw.NEWCOMER * Math.sqrt(px * px + py * py) + slow + pushed;
    lookAround(i, (most + longest) * time + ContactLaw.STANDOFF * members.radius[i]);
    if (meetsLighter(i, px, py)) {
      return false;
    }
    if (takesNearest(i, px, py, most) || takesOther(i, px, py, most)) {
      longest = Math.max(longest, members.speed(i));
      turn(i, px, py);
      return true;
    }
    return halt(i, px, py);
  }

  /** Whether a flight meets a lighter member: in a tick of both, that one gives way. */
  private boolean meetsLighter(int i, double px, double py) {
    boolean does = false;
    for (int c = 0; c < nearMembers && !does; c++) {
      int j = near.get(c);
      boolean isHeavier = Flights.isHeavier(members.inverseMass[i], members.inverseMass[j]);
      does = isHeavier && members.isAwake(j) && meets(j, i, px, py);
    }
    return does;
  }

  private boolean takesNearest(int i, double px, double py, double most) {
    addPlanes(i, px, py);
    if (!planes.nearest(px, py)) {
      return false;
    }
    double x = planes.x;
    double y = planes.y;
    return x * x + y * y <= most * most && takes(i, x, y);
  }

  /** Takes the flight of a neighbour, or none, whichever all others allow and is nearest. */
  private boolean takesOther(int i, double px, double py, double most) {
    double best = Double.POSITIVE_INFINITY;
    for (int c = -1; c < nearMembers; c++) {
      double x = c < 0 ? 0 : members.ux[near.get(c)];
      double y = c < 0 ? 0 : members.uy[near.get(c)];
      double d = (x - px) * (x - px) + (y - py) * (y - py);
      if (d < best && x * x + y * y <= most * most && takes(i, x, y)) {
        best = d;
      }
    }
    return best < Double.POSITIVE_INFINITY;
  }

  /** Takes a flight if all that is around allows it. */
  private boolean takes(int i, double x, double y) {
    addPlanes(i, x, y);
    boolean holds = planes.holds(x, y, ContactLaw.SLACK / 2 * members.radius[i] / time);
    if (holds) {
      members.fly(i, x, y);
    }
    return holds;
  }

  /** Collects what is around a circle. */
  private void lookAround(int i, double reach) {
    near.clear();
    host.membersNear(i, members.x[i], members.y[i], reach, near);
    near.sort(0);
    nearMembers = 0;
    for (int c = 0; c < near.size(); c++) {
      double gap = members.gap(i, near.get(c), now);
      if (gap <= reach && gap > -members.radius[i] - members.radius[near.get(c)]) {
        near.set(nearMembers++, near.get(c));
      }
    }
    near.cut(nearMembers);
    parts.near(members, i, host, reach, now, near);
  }

  /** Adds what members and parts around ask of a flight that would be (ux, uy). */
  private void addPlanes(int i, double ux, double uy) {
    planes.clear();
    for (int c = 0; c < nearMembers; c++) {
      int j = near.get(c);
      double dx = members.x[i] - members.xAt(j, now);
      double dy = members.y[i] - members.yAt(j, now);
      double d = Math.sqrt(dx * dx + dy * dy);
      double rho = members.radius[i] + members.radius[j];
      approach.set(dx / d, dy / d, Math.max(0, d - rho));
      addPlane(rho, ux, uy, members.ux[j], members.uy[j]);
    }
    double r = members.radius[i];
    for (int c = nearMembers; c < near.size(); c++) {
      int p = near.get(c);
      if (parts.turns(p)) {
        addTurn(i, p, ux, uy);
        continue;
      }
      double mx = parts.wayX(p, ux, time);
      double my = parts.wayY(p, uy, time);
      if (parts.touches(p, r, members.filter[i], members.x[i], members.y[i], mx, my)
          && isSolid(p, i)) {
        approach.set(parts.normalX, parts.normalY, Math.max(0, parts.distance - r));
        double vx = parts.velocityX(p, members.y[i]);
        double vy = parts.velocityY(p, members.x[i]);
        addPlane(parts.isFlat(p) ? 0 : r + parts.radius[p], ux, uy, vx, vy);
      }
    }
  }

  /** Adds what a part that turns asks of a flight u: of each control point, see {@link Arc}. */
  private void addTurn(int i, int p, double ux, double uy) {
    double r = members.radius[i];
    arc.set(parts, p, members.x[i], members.y[i], time);
    if (!parts.touches(p, r, members.filter[i], members.x[i], members.y[i], arc, ux, uy)
        || !isSolid(p, i)) {
      return;
    }
    approach.set(parts.normalX, parts.normalY, Math.max(0, parts.distance - r));
    if (!parts.isFlat(p)) {
      int end = Arc.POINTS - 1;
      approach.turn(r + parts.radius[p], arc.wayX(end, ux, uy), arc.wayY(end, ux, uy));
    }
    for (int k = 0; k < Arc.POINTS; k++) {
      arc.bound(k, approach.nx, approach.ny, approach.gap);
      planes.add(arc.nx, arc.ny, arc.drift - approach.gap / time);
    }
  }

  /** Adds what something of velocity v asks of a flight u, for the approach of now. */
  private void addPlane(double rho, double ux, double uy, double vx, double vy) {
    if (rho > 0) {
      approach.turn(rho, (ux - vx) * time, (uy - vy) * time);
    }
    double other = vx * approach.nx + vy * approach.ny;
    planes.add(approach.nx, approach.ny, other - approach.gap / time);
  }

  /**
   * Whether a part is there for a newcomer: under gravity it passes through one-way lines that it
   * overlaps.
   */
  private boolean isSolid(int p, int i) {
    boolean mayPass = parts.isOneWay(p) && (gx != 0 || gy != 0);
    return parts.isSolidFrom(p, members.x[i], members.y[i])
        && (!mayPass || parts.distance >= members.radius[i] * (1 - ContactLaw.STANDOFF));
  }

  /**
   * Stops a newcomer for the rest of the tick, and each whose flight runs into one that stands;
   * false, and nothing is done, if something that moves runs into one of these.
   */
  private boolean halt(int i, double px, double py) {
    stopped.clear();
    stopped.add(i);
    for (int c = 0; c < stopped.size(); c++) { // the list grows
      if (!addWhoMeets(stopped.get(c))) {
        return false;
      }
    }
    turn(i, px, py);
    for (int c = 1; c < stopped.size(); c++) {
      stop(stopped.get(c));
    }
    return true;
  }

  /** Adds who would meet a circle that stands to those that stop; false if one cannot stop. */
  private boolean addWhoMeets(int s) {
    double x = members.xAt(s, now);
    double y = members.yAt(s, now);
    near.clear();
    host.membersNear(s, x, y, longest * time, near);
    near.sort(0);
    for (int c = 0; c < near.size(); c++) {
      int j = near.get(c);
      if (!stopped.contains(j) && meets(j, s, 0, 0)) {
        stopped.add(j);
        if (!members.isAwake(j)) {
          return false; // it is carried
        }
      }
    }
    return !isMetByMover(s, x, y);
  }

  /** Whether member j meets circle s in the time that is left, where s flies at (ux, uy). */
  private boolean meets(int j, int s, double ux, double uy) {
    double x = members.xAt(s, now);
    double y = members.yAt(s, now);
    double dx = x - members.xAt(j, now);
    double dy = y - members.yAt(j, now);
    double d = Math.sqrt(dx * dx + dy * dy);
    double gap = Math.max(0, d - members.radius[j] - members.radius[s]);
    return gap * d < ((members.ux[j] - ux) * dx + (members.uy[j] - uy) * dy) * time;
  }

  /** Whether an obstacle that moves would meet a circle that stands. */
  private boolean isMetByMover(int s, double x, double y) {
    boolean is = false;
    if (parts.areMoving()) {
      near.clear();
      parts.near(members, s, host, parts.fastest() * time, now, near);
      double r = members.radius[s];
      for (int c = 0; c < near.size(); c++) {
        is |= isMetBy(near.get(c), r, members.filter[s], x, y);
      }
    }
    return is;
  }

  private boolean isMetBy(int p, double r, long filter, double x, double y) {
    if (!parts.turns(p)) {
      double mx = parts.wayX(p, 0, time);
      double my = parts.wayY(p, 0, time);
      return parts.touches(p, r, filter, x, y, mx, my)
          && mx * parts.normalX + my * parts.normalY < Math.min(0, r - parts.distance);
    }
    arc.set(parts, p, x, y, time);
    if (!parts.touches(p, r, filter, x, y, arc, 0, 0)) {
      return false;
    }
    arc.boundStrictly(parts.normalX, parts.normalY, parts.distance - r, 0, 0);
    return -arc.drift * time < Math.min(0, r - parts.distance);
  }

  private void stop(int j) {
    double px = members.ux[j];
    double py = members.uy[j];
    members.moveTo(j, now);
    members.fly(j, 0, 0);
    turn(j, px, py);
    host.flies(j);
  }

  /**
   * Lets the momentum of a member follow its flight until the tick, if that is far from the flight
   * (px, py) which the momentum asks for, and falls less.
   */
  private void turn(int i, double px, double py) {
    double dx = px - members.ux[i];
    double dy = py - members.uy[i];
    if (dx * gx + dy * gy <= 0 || dx * dx + dy * dy <= slow * slow / 16) {
      return;
    }
    double passed = now - momentTime;
    double before = members.rise[i];
    members.follow(i, gx, gy, slow / ContactLaw.SLOW);
    double less = (before - members.rise[i]) * passed;
    members.vx[i] += less * gx;
    members.vy[i] += less * gy;
    members.turned[i] = Members.TRULY;
  }
}
