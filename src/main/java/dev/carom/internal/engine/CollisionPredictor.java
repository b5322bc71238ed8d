// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.response.PairResponse;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.TimeOfImpact;
import dev.carom.internal.util.Index;

/**
 * Predicts the next collision of each circle: its time, its partner, and the partner's change count
 * at the prediction.
 *
 * <p>The time at which two circles collide depends on their two flights alone. It is the detector's
 * answer, counted from the start of the later flight, from the position of the other circle at that
 * time. So neither the cells through which they found each other nor the steps of the caller change
 * a bit of it.
 *
 * <p>Most circles that are near do not collide, and of those that do only the first matters. Plain
 * doubles exclude the others wherever bounds of their errors allow it. The detector decides the
 * remaining cases. It computes the time of the first collision only when that is needed.
 */
final class CollisionPredictor {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** The time of a collision that is known by bounds only. */
  private static final double OPEN = Double.NaN;

  // Bounds of b and discriminant, the same as in DiskSweep with more to spare.
  private static final double DOT_BOUND = 8 * 0x1p-53;
  private static final double DISCRIMINANT_BOUND = 16 * 0x1p-53;

  /**
   * The bound of b where it is computed by an fma: then it errs by 3 u of itself and 5 u of {@code
   * uy dy}, since {@code |ux dx|} is no more than the sum of both. It is above 0 if it exceeds so
   * much of {@code |uy dy|}.
   */
  private static final double APART_BOUND = 16 * 0x1p-53;

  /** Added to u.u and r^2: more than underflow can take from one of them, times the other. */
  private static final double SMALL = 0x1p-990;

  /**
   * The least part of its terms that g or discriminant must be for {@link #TIME_BOUND}. b^2 =
   * discriminant + a g is then as large a part of a d.d, so b, which errs by 5 u of at most sqrt(a
   * d.d), errs by 5 u 2^10 of itself; g by 6 u 2^20, discriminant by 12 u 2^20, its root by half of
   * that.
   */
  private static final double WELL_CONDITIONED = 0x1p-20;

  /** t = g / (sqrt(discriminant) - b) errs by less than 2^4 u 2^20 = 2^-29 of itself. */
  private static final double TIME_BOUND = 0x1p-28;

  /** The error bound of the sum of a time and t, far more than its rounding and its tail. */
  private static final double SUM_BOUND = 0x1p-50;

  /** Half of the number that, added to the bits of -infinity, gives 0. */
  private static final long HALF_OF_REST = 1L << 51;

  private final CircleTable circles;
  private final PairResponse pairs;
  private final Contacts contacts;

  /** Whether circles may have accelerations. */
  private final boolean falls;

  private final FallingPair pair;

  // The first collision found so far: its partner, and the latest time at which it may come. The
  // rest is in the circle's row.
  private int partner;
  private double high;

  /** The time of the candidate, and of the first collision so far. */
  private final MeetingTime candidate = new MeetingTime();

  private final MeetingTime first = new MeetingTime();

  CollisionPredictor(CircleTable circles, PairResponse pairs, Contacts contacts) {
    this.contacts = contacts;
    this.circles = circles;
    this.pairs = pairs;
    falls = circles.allowsGravity();
    pair = new FallingPair(circles);
  }

  /** The earliest time at which circle i may collide; the exact time once it is refined. */
  static double time(double[] s, int i) {
    return s[CircleTable.collidingAt(i) + CircleTable.MEETING];
  }

  static double tail(double[] s, int i) {
    return s[CircleTable.collidingAt(i) + CircleTable.MEETING_TAIL];
  }

  /** Whether the time of circle i's predicted collision is known by bounds only. */
  static boolean isOpen(double[] s, int i) {
    return Double.isNaN(tau(s, i));
  }

  /** The duration from the start of the later flight to the collision. */
  static double tau(double[] s, int i) {
    return s[CircleTable.collidingAt(i) + CircleTable.TAU];
  }

  static int partner(int[] codes, int i) {
    return codes[CircleTable.collidingCodesAt(i) + CircleTable.PARTNER];
  }

  /** Whether the prediction is not stale: the partner is still on the same flight. */
  static boolean isValid(int[] codes, int i) {
    int c = CircleTable.collidingCodesAt(i);
    int j = codes[c + CircleTable.PARTNER];
    return codes[c + CircleTable.PARTNER_COUNT]
        == codes[CircleTable.collidingCodesAt(j) + CircleTable.COUNT];
  }

  /**
   * Whether the prediction must be refined, as its bounds do not decide if it comes before a time.
   */
  static boolean isInDoubt(double[] s, int[] codes, int i, double time) {
    int a = CircleTable.collidingAt(i);
    double low = s[a + CircleTable.MEETING];
    return Math.abs(time - low) < 2 * doubt(low, s[a + FlightRow.T])
        && isOpen(s, i)
        && isValid(codes, i);
  }

  /**
   * The width of the bounds of an unrefined collision, from its earliest time and the start of the
   * flight.
   */
  private static double doubt(double low, double start) {
    // low is the time less its error, and t at most the time since the flight's start.
    return (low - start) * (4 * TIME_BOUND) + low * (4 * SUM_BOUND);
  }

  /**
   * Computes the time of circle i's predicted collision, which is known by bounds only and not
   * stale.
   */
  void refine(double[] s, int[] codes, int i) {
    int a = CircleTable.collidingAt(i);
    find(first, s, i, partner(codes, i), true);
    s[a + CircleTable.MEETING] = first.head;
    s[a + CircleTable.MEETING_TAIL] = first.tail;
    s[a + CircleTable.TAU] = first.tau;
  }

  /**
   * Tests whether circle i collides with one of some others before its predicted collision.
   *
   * @param found the others, as {@link NeighborGrid} finds them; those that it cannot hit are
   *     removed
   * @return false if the prediction is stale and the answer depends on it: then all neighbours are
   *     to be tested {@linkplain #predictAmong anew}
   */
  boolean predictEarlier(double[] s, int[] codes, int i, int[] found, int size) {
    int left =
        size == 0
            ? 0
            : falls
                ? filterFalling(s, codes, i, found, size)
                : filterPairs(s, codes, i, found, size);
    if (left == 0) {
      return true;
    }
    start(s, codes, i);
    int before = partner;
    for (int k = 0; k < left; k++) {
      if (!consider(s, codes, i, found[k], before)) {
        return false;
      }
    }
    if (partner != before) {
      storePartner(codes, i);
    }
    return true;
  }

  /**
   * Discards the prediction of circle i, and predicts its collision among those that {@link
   * #filterPairs} left.
   */
  void predictAmong(double[] s, int[] codes, int i, int[] found, int left) {
    setFirst(s, i, Index.NONE, NEVER, NEVER, 0, 0);
    if (falls) {
      considerAlikeFirst(s, codes, i, found, left);
    } else {
      for (int k = 0; k < left; k++) {
        consider(s, codes, i, found[k], Index.NONE);
      }
    }
    storePartner(codes, i);
  }

  /**
   * Circles with the same acceleration are considered first: their collisions are found faster, and
   * leave less time to search for others.
   */
  private void considerAlikeFirst(double[] s, int[] codes, int i, int[] found, int left) {
    int others = 0;
    for (int k = 0; k < left; k++) {
      int j = found[k];
      if (pair.fallAlike(i, j)) {
        consider(s, codes, i, j, Index.NONE);
      } else {
        found[others++] = j;
      }
    }
    for (int k = 0; k < others; k++) {
      consider(s, codes, i, found[k], Index.NONE);
    }
  }

  /**
   * Appends the circles that follow in the lists, and removes those that circle i certainly does
   * not hit: they do not approach, or they pass. Branch-free, as the answers are unpredictable and
   * each has the latency of a chain of operations.
   *
   * @return the number of circles left
   */
  static int filterPairs(double[] s, int[] codes, int i, int[] found, int size) {
    int a = CircleTable.collidingAt(i);
    double xi = s[a + FlightRow.X];
    double yi = s[a + FlightRow.Y];
    double vxi = s[a + FlightRow.VX];
    double vyi = s[a + FlightRow.VY];
    double ti = s[a + FlightRow.T];
    double tli = s[a + FlightRow.TL];
    double ri = s[a + FlightRow.RADIUS];
    int left = 0;
    int end = size;
    for (int k = 0; k < end; k++) {
      int j = found[k];
      int follower = codes[CircleTable.collidingCodesAt(j) + CircleTable.FOLLOWER];
      found[end] = follower;
      end += 1 + (follower >> 31);
      int c = CircleTable.collidingAt(j);
      double xj = s[c + FlightRow.X];
      double r = ri + s[c + FlightRow.RADIUS];
      double vxj = s[c + FlightRow.VX];
      double vyj = s[c + FlightRow.VY];
      // The delay of j's start against i's, and of i's against j's; 0 for the one that is not
      // later.
      double later = (s[c + FlightRow.T] - ti) + (s[c + FlightRow.TL] - tli);
      double ofI = positive(later);
      double ofJ = ofI - later;
      double dx = fma(vxi, ofI, xi) - fma(vxj, ofJ, xj);
      double dy = fma(vyi, ofI, yi) - fma(vyj, ofJ, s[c + FlightRow.Y]);
      double ux = vxi - vxj;
      double uy = vyi - vyj;
      found[left] = j;
      int other = j ^ i;
      left += (mayMeet(dx, dy, ux, uy, r) & (other | -other)) >>> 31;
    }
    return left;
  }

  /**
   * The same for circles that may have accelerations. Two with the same one move straight relative
   * to each other, from the places and velocities that {@link FallingPair} takes; others stay. No
   * member of those in contact meets an awake one.
   */
  int filterFalling(double[] s, int[] codes, int i, int[] found, int size) {
    int a = CircleTable.collidingAt(i);
    double xi = s[a + FlightRow.X];
    double yi = s[a + FlightRow.Y];
    double vxi = s[a + FlightRow.VX];
    double vyi = s[a + FlightRow.VY];
    double ti = s[a + FlightRow.T];
    double tli = s[a + FlightRow.TL];
    double ri = s[a + FlightRow.RADIUS];
    double gx = circles.gx(i);
    double gy = circles.gy(i);
    boolean awake = contacts.isAwake(i) && !pairs.haveSilent();
    int left = 0;
    int end = size;
    for (int k = 0; k < end; k++) {
      int j = found[k];
      int follower = codes[CircleTable.collidingCodesAt(j) + CircleTable.FOLLOWER];
      found[end] = follower;
      end += 1 + (follower >> 31);
      if (awake && contacts.isMember(j)) {
        continue;
      }
      found[left] = j;
      if (circles.gx(j) != gx || circles.gy(j) != gy) {
        left++;
        continue;
      }
      int c = CircleTable.collidingAt(j);
      double r = ri + s[c + FlightRow.RADIUS];
      double later = (s[c + FlightRow.T] - ti) + (s[c + FlightRow.TL] - tli);
      double ofI = positive(later);
      double ofJ = ofI - later;
      double vxj = s[c + FlightRow.VX];
      double vyj = s[c + FlightRow.VY];
      double dx =
          MovingCircle.place(xi, vxi, gx, ofI)
              - MovingCircle.place(s[c + FlightRow.X], vxj, gx, ofJ);
      double dy =
          MovingCircle.place(yi, vyi, gy, ofI)
              - MovingCircle.place(s[c + FlightRow.Y], vyj, gy, ofJ);
      double ux = fma(gx, ofI, vxi) - fma(gx, ofJ, vxj);
      double uy = fma(gy, ofI, vyi) - fma(gy, ofJ, vyj);
      int other = j ^ i;
      left += (mayMeet(dx, dy, ux, uy, r) & (other | -other)) >>> 31;
    }
    return left;
  }

  /**
   * Negative if two circles may meet; at least 0 only if they certainly do not approach, or pass.
   *
   * @param dx,dy the offset of one from the other
   * @param ux,uy its relative velocity
   * @param r the sum of the radii
   */
  private static int mayMeet(double dx, double dy, double ux, double uy, double r) {
    double by = uy * dy;
    double b = fma(ux, dx, by);
    double toward = fma(APART_BOUND, Math.abs(by), TimeOfImpact.TINY) - b;
    double arr = fma(ux, ux, fma(uy, uy, SMALL)) * fma(r, r, SMALL);
    double ky = uy * dx;
    double cross = fma(ux, dy, -ky);
    // No less than |ux dy| + |uy dx|. The loss by underflow times m is below TINY + its bound.
    double m = fma(2, Math.abs(ky), Math.abs(cross));
    double near =
        fma(-cross, cross, arr) + (DISCRIMINANT_BOUND * fma(m, m, arr) + TimeOfImpact.TINY);
    return ~(int) ((below(toward) | below(near)) >> 32);
  }

  /** x, or 0 if x is negative; branch-free. */
  static double positive(double x) {
    long bits = Double.doubleToRawLongBits(x);
    return Double.longBitsToDouble(bits & ~(bits >> 63));
  }

  /** Negative if x is negative and finite; else at least 0. */
  private static long below(double x) {
    // As integers, -infinity and negative NaNs are from -2^52 on.
    return (Double.doubleToRawLongBits(x) >> 1) + HALF_OF_REST;
  }

  /**
   * Makes j the partner of circle i if it collides with it first; false as in {@link
   * #predictEarlier}. As one method it is too large to be inlined at each of its calls: measured, a
   * gas is 3 % faster than with such copies.
   */
  private boolean consider(double[] s, int[] codes, int i, int j, int before) {
    if (!pairs.meet(i, j)) {
      return true;
    }
    boolean alike = !falls || pair.fallAlike(i, j);
    boolean silent = pairs.haveSilent() && pairs.isSilent(i, j);
    if (falls && !silent && isKeptApart(s, i, j)) {
      return true;
    }
    int a = CircleTable.collidingAt(i);
    int c = CircleTable.collidingAt(j);
    double t = Double.NaN;
    if (falls) {
      t = !silent && alike && pair.start(s, i, j) ? pair.roughTime() : t;
    } else if (!silent) {
      // The first and the last column first: then compilers need not check the range of the rest.
      double xi = s[a + FlightRow.X];
      double xj = s[c + FlightRow.X];
      double r = s[a + FlightRow.RADIUS] + s[c + FlightRow.RADIUS];
      double later =
          (s[c + FlightRow.T] - s[a + FlightRow.T]) + (s[c + FlightRow.TL] - s[a + FlightRow.TL]);
      double ofI = positive(later);
      double ofJ = ofI - later;
      double vxi = s[a + FlightRow.VX];
      double vyi = s[a + FlightRow.VY];
      double vxj = s[c + FlightRow.VX];
      double vyj = s[c + FlightRow.VY];
      double dx = fma(vxi, ofI, xi) - fma(vxj, ofJ, xj);
      double dy = fma(vyi, ofI, s[a + FlightRow.Y]) - fma(vyj, ofJ, s[c + FlightRow.Y]);
      t = roughTime(dx, dy, vxi - vxj, vyi - vyj, r);
    }
    double time = Math.max(s[a + FlightRow.T], s[c + FlightRow.T]) + t;
    double error = fma(t, TIME_BOUND, time * SUM_BOUND);
    if (time - error > high) {
      return true;
    }
    if (alike ? pairs.skips(circles, i, j) : pairs.areInert(circles, i, j)) {
      return true;
    }
    if (time + error < s[a + CircleTable.MEETING]) {
      setFirst(s, i, j, time - error, time + error, OPEN, Double.NEGATIVE_INFINITY);
      return true;
    }
    return compareExactly(s, codes, i, j, before, silent);
  }

  /** Whether contact keeps two falling circles apart, at least until its next tick. */
  private boolean isKeptApart(double[] s, int i, int j) {
    if (contacts.keepsApart(i, j)) {
      return true;
    }
    if (!contacts.isAwake(i) && !contacts.isAwake(j)) {
      return false;
    }
    pair.start(s, i, j);
    return pair.isFar(contacts.nextTick() - laterStart(s));
  }

  /**
   * The duration to the collision of two circles with the same acceleration; NaN in doubt.
   *
   * @param dx,dy the offset of the first one from the second, at the later start
   * @param ux,uy its relative velocity
   * @param r the sum of the radii
   */
  static double roughTime(double dx, double dy, double ux, double uy, double r) {
    double bx = ux * dx;
    double by = uy * dy;
    double b = bx + by;
    double rr = r * r;
    double u2 = ux * ux + uy * uy;
    double kx = ux * dy;
    double ky = uy * dx;
    double cross = kx - ky;
    double m = Math.abs(kx) + Math.abs(ky);
    double arr = u2 * rr;
    double discriminant = arr - cross * cross;
    double dd = dx * dx + dy * dy;
    double g = dd - rr;
    boolean isCertain =
        b < -fma(DOT_BOUND, Math.abs(bx) + Math.abs(by), TimeOfImpact.TINY)
            && discriminant
                > fma(WELL_CONDITIONED, arr + m * m, TimeOfImpact.TINY * (u2 + rr + m + 1))
            && g > fma(WELL_CONDITIONED, dd + rr, TimeOfImpact.TINY);
    return isCertain ? g / (Math.sqrt(discriminant) - b) : Double.NaN;
  }

  private void start(double[] s, int[] codes, int i) {
    int a = CircleTable.collidingAt(i);
    double low = s[a + CircleTable.MEETING];
    partner = partner(codes, i);
    high = isOpen(s, i) ? low + doubt(low, s[a + FlightRow.T]) : low;
  }

  /**
   * Stores the first collision of circle i so far: its partner and the bounds of its time. If tau
   * is not OPEN, also the duration from the later start, and the tail of the time.
   */
  private void setFirst(
      double[] s, int i, int j, double low, double high, double tau, double tail) {
    int a = CircleTable.collidingAt(i);
    partner = j;
    this.high = high;
    s[a + CircleTable.MEETING] = low;
    s[a + CircleTable.TAU] = tau;
    s[a + CircleTable.MEETING_TAIL] = tail;
  }

  private void storePartner(int[] codes, int i) {
    int c = CircleTable.collidingCodesAt(i);
    codes[c + CircleTable.PARTNER] = partner;
    if (partner != Index.NONE) {
      codes[c + CircleTable.PARTNER_COUNT] =
          codes[CircleTable.collidingCodesAt(partner) + CircleTable.COUNT];
    }
  }

  /**
   * Compares the exact time of the collision of i and j with the first one so far; false as in
   * {@link #predictEarlier}.
   */
  private boolean compareExactly(
      double[] s, int[] codes, int i, int j, int before, boolean silent) {
    MeetingTime time = candidate;
    find(time, s, i, j, false);
    if (time.tau == NEVER || time.head > high || (silent && !isEntered(time, i, j))) {
      return true;
    }
    if (time.head >= time(s, i) && isOpen(s, i)) {
      if (partner == before && !isValid(codes, i)) {
        return false;
      }
      find(first, s, i, partner, true);
      setFirst(s, i, partner, first.head, first.head, first.tau, first.tail);
    }
    double low = time(s, i);
    double tail = tail(s, i);
    if (time.head != low
        ? time.head < low
        : time.tail != tail ? time.tail < tail : comesFirst(i, j, partner)) {
      setFirst(s, i, j, time.head, time.head, time.tau, time.tail);
    }
    return true;
  }

  /** Whether, at equal times, the collision of i with j comes before that with k. */
  private boolean comesFirst(int i, int j, int k) {
    return k == Index.NONE
        || pairs.rank(Math.min(i, j), Math.max(i, j)) < pairs.rank(Math.min(i, k), Math.max(i, k));
  }

  /**
   * Whether a contact without a response has yet to be reported. It was reported before if both
   * circles are still on the same flights. A sensor does not report what it touches at the start of
   * a flight.
   */
  private boolean isEntered(MeetingTime time, int i, int j) {
    return (time.tau > 0 || !pairs.isSensor(i, j))
        && !(circles.isSensed(i, time.head, time.tail, j)
            && circles.isSensed(j, time.head, time.tail, i));
  }

  /**
   * Computes the time at which two circles collide.
   *
   * @param known whether they are known to collide, but not at once
   */
  private void find(MeetingTime found, double[] s, int i, int j, boolean known) {
    if (falls) {
      findFalling(found, s, i, j, known);
      return;
    }
    int a = CircleTable.collidingAt(Math.min(i, j));
    int b = CircleTable.collidingAt(Math.max(i, j));
    // The first and the last column first, as in consider.
    double x1 = s[a + FlightRow.X];
    double r1 = s[a + FlightRow.RADIUS];
    double x2 = s[b + FlightRow.X];
    double r2 = s[b + FlightRow.RADIUS];
    double vx1 = s[a + FlightRow.VX];
    double vy1 = s[a + FlightRow.VY];
    double vx2 = s[b + FlightRow.VX];
    double vy2 = s[b + FlightRow.VY];
    // The delay of the second start against the first, and of the first against the second.
    double later =
        (s[b + FlightRow.T] - s[a + FlightRow.T]) + (s[b + FlightRow.TL] - s[a + FlightRow.TL]);
    double earlier = 0 - later;
    double of1 = positive(later);
    double of2 = positive(earlier);
    int late = a + ((b - a) & (int) (Double.doubleToRawLongBits(earlier) >> 63));
    x1 = fma(vx1, of1, x1);
    double y1 = fma(vy1, of1, s[a + FlightRow.Y]);
    x2 = fma(vx2, of2, x2);
    double y2 = fma(vy2, of2, s[b + FlightRow.Y]);
    if (!(Math.abs(x1 - x2) + Math.abs(y1 - y2) < NEVER) || r1 + r2 == 0) {
      found.tau = NEVER; // a position is beyond the range of doubles, or both are points
      return;
    }
    int contact =
        known ? Contact.LATER : DiskSweep.contact(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2);
    double tau = DiskSweep.time(contact, x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, NEVER);
    found.set(s, late, tau);
  }

  /** The same for circles that may have accelerations. */
  private void findFalling(MeetingTime found, double[] s, int i, int j, boolean known) {
    int low = Math.min(i, j);
    int high = Math.max(i, j);
    found.tau = NEVER;
    if (pair.start(s, low, high)) {
      int late = CircleTable.collidingAt(pair.later());
      boolean silent = pairs.haveSilent() && pairs.isSilent(low, high);
      boolean justMet = pairs.skips(circles, low, high);
      double tau = silent ? pair.timeAfter(-1) : pair.time(known, justMet, until(s, low, high));
      found.set(s, late, tau);
      while (silent && found.tau < NEVER && !isEntered(found, i, j)) {
        found.set(s, late, pair.timeAfter(found.tau));
      }
    }
  }

  /**
   * How long a collision of two circles is of interest, from the later start: until the first one
   * so far, or the end of one of their flights.
   */
  private double until(double[] s, int i, int j) {
    double end = Math.min(high, Math.min(circles.endOfFlight(i), circles.endOfFlight(j)));
    if (contacts.isAwake(i) || contacts.isAwake(j)) {
      end = Math.min(end, contacts.nextTick());
    }
    double start = laterStart(s);
    return end < NEVER ? Math.max(0, end - start + 4 * Math.ulp(end)) : NEVER;
  }

  private double laterStart(double[] s) {
    return s[CircleTable.collidingAt(pair.later()) + FlightRow.T];
  }

  /**
   * The time of a collision: the duration from the start of the later flight, and the time as head
   * and tail.
   */
  private static final class MeetingTime {
    double tau;
    double head;
    double tail;

    /** Sets it to tau after the start of the flight in the row at {@code late}. */
    void set(double[] s, int late, double duration) {
      double t = s[late + FlightRow.T];
      double sum = t + duration;
      double l = sumTail(t, duration, sum) + s[late + FlightRow.TL];
      tau = duration;
      head = sum + l;
      tail = sumTail(sum, l, head);
    }
  }
}
