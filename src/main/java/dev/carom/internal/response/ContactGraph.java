// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;
import java.util.Arrays;

/**
 * The awake members in order, and the list of their near pairs. A pair belongs to an awake circle,
 * its owner. The other one is an awake circle before it in the order, a frozen circle, or a part of
 * an obstacle. The order is height against gravity, for places and numbers alone break mirror
 * images.
 *
 * <p>The list has a margin for each circle, within which it may move. Only who left it, or is new,
 * is listed anew. Pairs keep their impulses then.
 */
final class ContactGraph {

  private final Members members;
  private final Parts parts;
  private final ContactSurroundings host;
  private final Approach approach = new Approach();
  private final Arc arc = new Arc();

  /** Whether pairs are measured for flights, which have to be safe, and not for momenta. */
  private boolean forFlights;

  private final double gx;
  private final double gy;

  /** The awake circles in order, how many they are, and the place of each in the order. */
  final int[] order;

  int awake;
  final int[] rank;
  private final double[] height;

  // Where and when each circle was listed, and how far it may be from there; 0 if it is not.
  final double[] listX;
  final double[] listY;
  final double[] margin;
  final double[] listTime;

  /** The awake circles that are listed anew. */
  private final boolean[] isNew;

  /** What is fixed is no faster than this. */
  double fastest;

  boolean isValid;

  /** All margins are so much wider. */
  double slack;

  NearPairs pairs;
  private NearPairs old;

  /** Frozen circles that lost a neighbour. */
  final IntList lost = new IntList();

  private boolean[] found = new boolean[16];
  private final int[] oldRank;
  private final int[] fill;
  private final IntList near = new IntList();

  /** The pairs as they were found: the owner, then the other one, or the complement of a part. */
  private final IntList raw = new IntList();

  private long[] place = new long[16];

  ContactGraph(Members members, Parts parts, ContactSurroundings host, double gx, double gy) {
    this.members = members;
    this.parts = parts;
    this.host = host;
    this.gx = gx;
    this.gy = gy;
    int n = members.count;
    order = new int[n];
    rank = new int[n];
    height = new double[n];
    listX = new double[n];
    listY = new double[n];
    margin = new double[n];
    listTime = new double[n];
    isNew = new boolean[n];
    oldRank = new int[n];
    fill = new int[n + 1];
    pairs = new NearPairs(n);
    old = new NearPairs(n);
    Arrays.fill(rank, Index.NONE);
  }

  /** Lets all circles be listed anew. */
  void forget() {
    isValid = false;
    for (int k = 0; k < awake; k++) {
      margin[order[k]] = 0;
    }
  }

  /** Forgets all circles and pairs. */
  void clear() {
    awake = 0;
    pairs.size = 0;
    Arrays.fill(rank, Index.NONE);
  }

  /** Appends a circle that joined or woke; the next listing puts it in its place. */
  void enter(int i) {
    rank[i] = awake;
    margin[i] = 0;
    listX[i] = 0;
    listY[i] = 0;
    order[awake++] = i;
    pairs.start[awake] = pairs.start[awake - 1];
    isValid = false;
  }

  /** Drops a circle, with its pairs, from the order and the list. */
  void remove(int i) {
    isValid = false;
    int left = 0;
    int size = 0;
    for (int k = 0; k < awake; k++) {
      int from = pairs.start[k];
      int to = pairs.start[k + 1];
      pairs.start[left] = size;
      for (int pair = from; order[k] != i && pair < to; pair++) {
        if (pairs.other[pair] != i) {
          pairs.copy(size++, pair);
        }
      }
      if (order[k] != i) {
        rank[order[k]] = left;
        order[left++] = order[k];
      }
    }
    rank[i] = Index.NONE;
    awake = left;
    pairs.size = size;
    pairs.start[left] = size;
  }

  /** Appends a saved circle, with so many pairs that are filled in next. */
  int restore(int i, int size) {
    int from = pairs.size;
    pairs.makeRoom(from + size);
    pairs.size += size;
    rank[i] = awake;
    order[awake++] = i;
    pairs.start[awake] = pairs.size;
    return from;
  }

  /** Finds the parts of saved pairs by their keys. */
  void findParts(double now) {
    for (int g = 0; g < awake; g++) {
      int i = order[g];
      near.clear();
      // What was listed within a margin is within three: a circle and a part went one each at most.
      parts.near(members, i, host, 3 * margin[i], now, near); // this makes the vertices
      for (int k = pairs.start[g]; k < pairs.start[g + 1]; k++) {
        boolean isPart = pairs.other[k] == members.count;
        int part = isPart ? parts.ofKey(pairs.key[k], now) : Index.NONE;
        if (isPart && part < 0) {
          margin[i] = 0;
          isValid = false;
        } else {
          describe(k, i, isPart ? ~part : pairs.other[k]);
        }
      }
    }
  }

  /** Whether the list has all that the awake circles can meet in a time at velocities q. */
  boolean covers(double[] q, double now, double time) {
    boolean covers = isValid;
    for (int k = 0; k < awake && covers; k++) {
      covers = covers(order[k], q, now, time);
    }
    return covers;
  }

  private boolean covers(int i, double[] q, double now, double time) {
    double dx = members.x[i] - listX[i];
    double dy = members.y[i] - listY[i];
    double room = margin[i] - path(q, i, time) - fastest * (now - listTime[i] + time);
    return room >= 0 && dx * dx + dy * dy <= room * room;
  }

  private static double path(double[] q, int i, double time) {
    return Math.sqrt(q[2 * i] * q[2 * i] + q[2 * i + 1] * q[2 * i + 1]) * time;
  }

  /** Makes the list complete, for flights of about the velocities q in a time. */
  void list(double[] q, double now, double time) {
    fastest = parts.fastest();
    keepOld();
    dropOthers();
    sort();
    double widest = 0;
    for (int k = 0; k < awake; k++) {
      int i = order[k];
      isNew[i] = margin[i] == 0 || !covers(i, q, now, time);
      if (isNew[i]) {
        double way = path(q, i, time) + fastest * time;
        margin[i] = ContactLaw.MARGIN * members.radius[i] + 2 * way + slack;
        listX[i] = members.x[i];
        listY[i] = members.y[i];
        listTime[i] = now;
      }
      widest = Math.max(widest, margin[i]);
    }
    collect(now, widest);
    arrange();
    for (int k = 0; k < old.size; k++) {
      boolean bore = old.bore[k] || old.impulse[k] > 0;
      if (!found[k] && bore && old.part[k] < 0 && members.isFrozen(old.other[k])) {
        lost.add(old.other[k]);
      }
    }
    isValid = true;
  }

  private void keepOld() {
    NearPairs p = old;
    old = pairs;
    pairs = p;
    if (found.length < old.size) {
      found = new boolean[old.owner.length];
    }
    Arrays.fill(found, 0, old.size, false);
    System.arraycopy(rank, 0, oldRank, 0, members.count);
  }

  /** Drops all that are not awake from the order. */
  private void dropOthers() {
    int left = 0;
    for (int k = 0; k < awake; k++) {
      int i = order[k];
      if (members.isAwake(i)) {
        order[left++] = i;
      } else {
        rank[i] = Index.NONE;
      }
    }
    awake = left;
  }

  /** Sorts by height, from the last order, which is nearly sorted; ties by slots. */
  private void sort() {
    for (int k = 0; k < awake; k++) {
      int i = order[k];
      height[i] = members.x[i] * gx + members.y[i] * gy;
    }
    for (int a = 1; a < awake; a++) {
      int i = order[a];
      int b = a - 1;
      while (b >= 0 && isBefore(i, order[b])) {
        order[b + 1] = order[b];
        b--;
      }
      order[b + 1] = i;
    }
    for (int k = 0; k < awake; k++) {
      rank[order[k]] = k;
    }
  }

  private boolean isBefore(int i, int j) {
    return height[i] > height[j] || (height[i] == height[j] && i < j);
  }

  /**
   * Takes over the pairs of who stays listed, and finds those of who is new.
   *
   * @param widest the widest margin
   */
  private void collect(double now, double widest) {
    raw.clear();
    for (int k = 0; k < old.size; k++) {
      keep(old.owner[k], old.part[k] < 0 ? old.other[k] : ~old.part[k]);
    }
    for (int k = 0; k < awake; k++) {
      int i = order[k];
      if (isNew[i]) {
        near.clear();
        // The other one may be a margin from where it was listed.
        host.membersNear(i, members.x[i], members.y[i], margin[i] + 2 * widest, near);
        for (int c = 0; c < near.size(); c++) {
          collect(i, near.get(c), now);
        }
        near.clear();
        parts.near(members, i, host, margin[i], now, near);
        for (int c = 0; c < near.size(); c++) {
          raw.add(i);
          raw.add(~near.get(c));
        }
      }
    }
  }

  /** Takes over a pair of a circle and another one, or the complement of a part. */
  private void keep(int i, int o) {
    boolean isFirst = isListed(i);
    boolean isSecond = o >= 0 && isListed(o);
    boolean isOther = isSecond || o < 0 || members.isFrozen(o);
    if (isFirst && isOther) {
      add(i, o);
    } else if (isSecond && members.isFrozen(i)) {
      add(o, i);
    }
  }

  private boolean isListed(int i) {
    return members.isAwake(i) && !isNew[i];
  }

  /** Of two circles that are listed anew the one with the smaller slot finds the pair. */
  private void collect(int i, int j, double now) {
    if (members.isFrozen(j)) {
      double x = members.xAt(j, now);
      if (isCloser(i, x, members.yAt(j, now), members.radius[j] + margin[i])) {
        add(i, j);
      }
    } else if (!(isNew[j] && j < i)
        && isCloser(i, listX[j], listY[j], members.radius[j] + margin[i] + margin[j])) {
      add(i, j);
    }
  }

  /** Adds a pair; of two awake circles it belongs to the later one. */
  private void add(int i, int o) {
    boolean turns = o >= 0 && members.isAwake(o) && rank[o] > rank[i];
    raw.add(turns ? o : i);
    raw.add(turns ? i : o);
  }

  private boolean isCloser(int i, double x, double y, double reach) {
    double d = members.radius[i] + reach;
    double dx = members.x[i] - x;
    double dy = members.y[i] - y;
    return dx * dx + dy * dy <= d * d;
  }

  /** Puts the pairs in order: by the owner, then awake ones, frozen ones, parts. */
  private void arrange() {
    NearPairs p = pairs;
    p.size = raw.size() / 2;
    p.makeRoom(p.size);
    if (place.length < p.size) {
      place = new long[p.owner.length];
    }
    Arrays.fill(p.start, 0, awake + 1, 0);
    for (int k = 0; k < p.size; k++) {
      p.start[rank[raw.get(2 * k)] + 1]++;
    }
    for (int k = 0; k < awake; k++) {
      p.start[k + 1] += p.start[k];
    }
    System.arraycopy(p.start, 0, fill, 0, awake);
    for (int k = 0; k < p.size; k++) {
      insert(rank[raw.get(2 * k)], raw.get(2 * k + 1));
    }
    for (int g = 0; g < awake; g++) {
      for (int k = p.start[g]; k < p.start[g + 1]; k++) {
        describe(k, order[g], p.other[k]);
        inherit(k);
      }
    }
  }

  private void insert(int g, int o) {
    long its = o < 0 ? 1L << 62 | parts.key(~o) : members.isAwake(o) ? rank[o] : 1L << 32 | o;
    int at = fill[g]++;
    while (at > pairs.start[g] && place[at - 1] > its) {
      place[at] = place[at - 1];
      pairs.other[at] = pairs.other[at - 1];
      at--;
    }
    place[at] = its;
    pairs.other[at] = o;
  }

  /** Fills in what does not change of a pair of circle i with o, a circle or ~part. */
  void describe(int k, int i, int o) {
    NearPairs p = pairs;
    boolean isPart = o < 0;
    double r = members.radius[i];
    p.owner[k] = i;
    p.other[k] = isPart ? members.count : o;
    p.part[k] = isPart ? ~o : Index.NONE;
    p.key[k] = isPart ? parts.key(~o) : Index.NONE;
    p.standoff[k] = ContactLaw.STANDOFF * radius(k);
    double e = isPart ? parts.restitution[~o] : members.restitution[o];
    p.bounce[k] = members.restitution[i] * e;
    boolean isFlat = isPart && parts.isFlat(~o);
    p.round[k] = isFlat ? 0 : r + (isPart ? parts.radius[~o] : members.radius[o]);
  }

  /** The radius of pair k, of two circles the smaller one. */
  double radius(int k) {
    double r = members.radius[pairs.owner[k]];
    int j = pairs.other[k];
    return j < members.count ? Math.min(r, members.radius[j]) : r;
  }

  /** Takes over what the last list knew of pair k. */
  private void inherit(int k) {
    NearPairs p = pairs;
    int last = findOld(p.owner[k], p.other[k], p.key[k]);
    if (last < 0 && p.part[k] < 0) {
      last = findOld(p.other[k], p.owner[k], Index.NONE);
    }
    boolean isOld = last >= 0;
    p.impulse[k] = isOld ? old.impulse[last] : 0;
    p.bore[k] = isOld && old.bore[last];
    p.through[k] = isOld ? old.through[last] : p.part[k] >= 0 && parts.isOneWay(p.part[k]);
    if (isOld) {
      found[last] = true;
    }
  }

  private int findOld(int i, int o, long key) {
    int g = i == members.count ? Index.NONE : oldRank[i];
    for (int k = g < 0 ? 0 : old.start[g]; g >= 0 && k < old.start[g + 1]; k++) {
      if (old.other[k] == o && old.key[k] == key) {
        return k;
      }
    }
    return Index.NONE;
  }

  /**
   * Finds normals, gaps and spans of now, for momenta of velocities q in a time. Of what turns they
   * are those of the middle of that.
   */
  void measure(double[] q, double time) {
    forFlights = false;
    measureAll(q, time);
  }

  /** The same for flights: of what turns they are those of the strictest bound, see {@link Arc}. */
  void measureFlights(double[] q, double time) {
    forFlights = true;
    measureAll(q, time);
  }

  private void measureAll(double[] q, double time) {
    NearPairs p = pairs;
    for (int k = 0; k < p.size; k++) {
      if (p.part[k] >= 0) {
        feel(k, q, time);
      } else {
        measureCircles(k, q, time);
      }
    }
  }

  private void measureCircles(int k, double[] q, double time) {
    NearPairs p = pairs;
    int a = p.owner[k];
    int b = p.other[k];
    double now = members.since[a];
    double dx = members.x[a] - members.xAt(b, now);
    double dy = members.y[a] - members.yAt(b, now);
    double d = Parts.length(dx, dy);
    double inverse = d > 0 ? 1 / d : 0;
    p.nx[k] = dx * inverse;
    p.ny[k] = dy * inverse;
    p.gap[k] = d - p.round[k];
    p.felt[k] = true;
    boolean still = members.isAwake(b);
    double fx = still ? 0 : members.frameX[b];
    double fy = still ? 0 : members.frameY[b];
    turn(k, (q[2 * a] - q[2 * b] - fx) * time, (q[2 * a + 1] - q[2 * b + 1] - fy) * time);
    p.drift[k] = fx * p.nx[k] + fy * p.ny[k];
  }

  /** Takes the normal of a pair that does not carry from where a flight is nearest. */
  private void turn(int k, double mx, double my) {
    NearPairs p = pairs;
    if (p.round[k] > 0 && p.gap[k] > ContactLaw.HOLD * p.standoff[k]) {
      approach.set(p.nx[k], p.ny[k], p.gap[k]);
      approach.turn(p.round[k], mx, my);
      p.nx[k] = approach.nx;
      p.ny[k] = approach.ny;
      p.gap[k] = approach.gap;
    }
  }

  /** Measures the part of pair k, if its owner is in the span, or gets there by its flight. */
  void feel(int k, double[] q, double time) {
    NearPairs p = pairs;
    int a = p.owner[k];
    int part = p.part[k];
    boolean turns = parts.turns(part);
    p.felt[k] = turns ? feelTurn(k, q, time) : feelStraight(k, q, time);
    if (p.felt[k] && parts.isOneSided(part)) {
      boolean isSolid = parts.isSolidFrom(part, members.x[a], members.y[a]);
      // Without gravity a one-way line stops a circle that overlaps it, too.
      boolean lasts = gx != 0 || gy != 0 || !parts.isOneWay(part);
      p.through[k] = !isSolid || (lasts && p.through[k] && p.gap[k] < -p.standoff[k]);
    } else if (p.felt[k] && p.gap[k] >= 0) {
      p.through[k] = false;
    }
    p.felt[k] &= !p.through[k];
  }

  private boolean feelStraight(int k, double[] q, double time) {
    NearPairs p = pairs;
    int a = p.owner[k];
    int part = p.part[k];
    double mx = parts.wayX(part, q[2 * a], time);
    double my = parts.wayY(part, q[2 * a + 1], time);
    double r = members.radius[a];
    if (!parts.touches(part, r, members.filter[a], members.x[a], members.y[a], mx, my)) {
      return false;
    }
    take(k, r, mx, my);
    p.drift[k] = parts.driftAlong(part, p.nx[k], p.ny[k]);
    return true;
  }

  private void take(int k, double r, double mx, double my) {
    pairs.nx[k] = parts.normalX;
    pairs.ny[k] = parts.normalY;
    pairs.gap[k] = parts.distance - r;
    turn(k, mx, my);
  }

  /** The same for a part that turns: the path has three control points. */
  private boolean feelTurn(int k, double[] q, double time) {
    NearPairs p = pairs;
    int a = p.owner[k];
    double ux = q[2 * a];
    double uy = q[2 * a + 1];
    double r = members.radius[a];
    arc.set(parts, p.part[k], members.x[a], members.y[a], time);
    if (!parts.touches(p.part[k], r, members.filter[a], members.x[a], members.y[a], arc, ux, uy)) {
      return false;
    }
    take(k, r, arc.wayX(Arc.POINTS - 1, ux, uy), arc.wayY(Arc.POINTS - 1, ux, uy));
    if (forFlights) {
      arc.boundStrictly(p.nx[k], p.ny[k], p.gap[k], ux, uy);
    } else {
      arc.middle(p.nx[k], p.ny[k], ux, uy);
    }
    p.nx[k] = arc.nx;
    p.ny[k] = arc.ny;
    p.drift[k] = arc.drift;
    return true;
  }
}
