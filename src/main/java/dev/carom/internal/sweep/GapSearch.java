// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.GapPolynomial.UNKNOWN;

import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Gaps;
import dev.carom.internal.exact.TurningGaps;
import java.util.Arrays;

/**
 * The certified search for the time at which a disk comes into contact with an obstacle. A contact
 * is the first time from which on the gap falls and is not above 0, in the region of {@link Gaps}
 * in which the centre is.
 *
 * <p>The search looks at one interval of time after the other. In an interval it finds the regions
 * in which the centre may be. A region is <i>open</i> if its gap may be 0 or less there, and may
 * fall.
 *
 * <ul>
 *   <li>No region is open: there is no contact. The next interval is twice as long.
 *   <li>The centre passes to another region: the interval is cut there.
 *   <li>The gap of the open region has one root, at which it falls: that is the contact.
 *   <li>The gap falls throughout: its signs at both ends of the interval tell.
 *   <li>The rate of the gap has one root: the sign of the gap at this turn tells.
 *   <li>Otherwise the interval is halved.
 * </ul>
 *
 * <p>The first search of a question has rounded coefficients, and answers most. A second one has
 * coefficients without rounding, and decides ties.
 */
final class GapSearch {

  static final double NEVER = Double.POSITIVE_INFINITY;

  /** The search leaves the answer open. */
  static final double DOUBT = Double.NaN;

  /** The interval must be halved. */
  private static final double HALVE = -1;

  /** Intervals looked at before the search gives up. */
  private static final int INTERVALS = 256;

  /** The least interval, of its end. Further halving costs time, and hardly tells more. */
  private static final double LEAST_WIDTH = 0x1p-44;

  /** The cost of the polynomials, for the budget: measured, 2 to 4 us. */
  private static final int BITS_PER_SEARCH = 24_576;

  /**
   * That of an interval without rounding, or of the gap of a straight flight and its root:
   * measured, 0.8 to 1.3 us.
   */
  static final int BITS_PER_INTERVAL = 6144;

  /**
   * The first interval of a return, in units of {@link #levelTime}. A disk that was dropped
   * straight onto an end returns just then, so the interval is a little longer.
   */
  private static final double FIRST_PART = 1.0625;

  /** Of half an ulp, to find whether a contact is before a border. More cost time only. */
  private static final int HALVINGS = 64;

  private static final int REGIONS = 3;

  /** Which question: the first contact of all, or after a time of none; an entry; a return. */
  static final int FIRST = 0;

  static final int FIRST_AFTER = 1;
  static final int ENTRY = 2;
  static final int RETURN = 3;

  /** When the height above a side is again that at the start, whatever the region. */
  static final int RISE = 4;

  /** Whose contact is asked for; null for that of a single gap. */
  private final Fall fall;

  /** The polynomials with rounded coefficients are used again by the next question. */
  private final GapPolynomial.Pool pool = new GapPolynomial.Pool();

  private final Gaps<GapPolynomial> rounded = new Gaps<>();

  private final TurningGaps<GapPolynomial> roundedTurning = new TurningGaps<>();

  private Gaps<GapPolynomial> gaps;

  /** Whether the obstacle turns. */
  private boolean turns;

  private Gaps<GapPolynomial> exactGaps;

  /** The gaps of the regions on this rung, and without rounding; each is made when needed. */
  private final GapPolynomial[] made = new GapPolynomial[REGIONS];

  private final GapPolynomial[] madeExact = new GapPolynomial[REGIONS];

  /** Their rates, of an obstacle that turns. */
  private final GapPolynomial[] rates = new GapPolynomial[REGIONS];

  /** The projections on the line from its start and from its end; null of a disk. */
  private GapPolynomial fromStart;

  private GapPolynomial fromEnd;

  /** The region whose gap counts from the start; -1 for none. */
  private int counted = -1;

  /** The side of the line above which the height counts as the gap of all regions; else 0. */
  private int rise;

  /** Whether contacts count only if the disk comes from outside, and later than a time. */
  private boolean isEntry;

  private double after = -1;

  // The interval, and the regions in it, as bits: where the centre may be, where the gap may come
  // to 0 from above, and where it certainly falls.
  private double low;
  private double high;
  private int possible;
  private int open;
  private int falling;

  /** The regions whose gap has one root in the interval, and falls there. */
  private int once;

  /** The regions whose gap is known never to fall below 0. */
  private int passed;

  /** Whether halving would tell nothing. */
  private boolean isLost;

  GapSearch(Fall fall) {
    this.fall = fall;
  }

  /** The search for when a gap without rounding falls, whatever the region. */
  GapSearch(GapPolynomial gap) {
    fall = null;
    made[Gaps.BEFORE] = gap;
  }

  /** Takes the gaps with rounded coefficients. */
  GapSearch roughly() {
    pool.reset(fall.turns());
    return of(fall.turns() ? fall.turningGaps(pool, roundedTurning) : fall.gaps(pool, rounded));
  }

  /** Takes the gaps with coefficients without rounding. */
  GapSearch exactly() {
    return of(fall.gaps(GapPolynomial.EXACT));
  }

  private GapSearch of(Gaps<GapPolynomial> newGaps) {
    boolean isLine = fall.isLine;
    gaps = newGaps;
    turns = newGaps.turns();
    exactGaps = null;
    fromStart = isLine ? gaps.fromStart() : null;
    fromEnd = isLine ? gaps.fromEnd() : null;
    Arrays.fill(made, null);
    Arrays.fill(madeExact, null);
    Arrays.fill(rates, null);
    counted = -1;
    rise = 0;
    isEntry = false;
    after = -1;
    passed = 0;
    return this;
  }

  /**
   * The correctly rounded time of a contact, {@code +infinity} for none up to the window's end T;
   * NaN if the search leaves it open. The first contact is from when on the gap falls and is not
   * above 0. At an entry it falls from above 0 to below. In a return the gap of the region that is
   * touched counts from the start: if it falls at once, the answer is 0.
   *
   * @param of the time after which the contact counts, or the region that is touched, or the side
   * @param from a time before which there is no contact
   * @param reach a time after which there is no contact
   */
  double time(int question, double of, double from, double reach, double T) {
    return switch (question) {
      case FIRST -> search(from, NEVER, reach, T);
      case FIRST_AFTER -> gap(Gaps.BEFORE).signAt(of, 0) == 1 ? search(of, NEVER, reach, T) : DOUBT;
      case ENTRY -> entry(of, from, reach, T);
      case RETURN -> returnTo((int) of, from, reach, T);
      default -> above((int) of).returnTo(Gaps.BEFORE, from, reach, T);
    };
  }

  private double entry(double s, double from, double reach, double T) {
    isEntry = true;
    after = s;
    return search(Math.max(from, s * Fall.LESS), NEVER, reach, T);
  }

  private double returnTo(int region, double from, double reach, double T) {
    from(region);
    int way = from > 0 ? 1 : gap(region).signAfterStart();
    return way == -1
        ? 0
        : way == UNKNOWN ? DOUBT : search(from, FIRST_PART * levelTime(region), reach, T);
  }

  private GapSearch above(int side) {
    rise = side;
    fromStart = null;
    fromEnd = null;
    return this;
  }

  /**
   * About when the disk is again as high above the tangent of its contact with an end as at the
   * start. It does not return to the end before.
   */
  private double levelTime(int region) {
    double dx = region == Gaps.BEYOND ? fall.px - fall.bx : fall.dx;
    double dy = region == Gaps.BEYOND ? fall.py - fall.by : fall.dy;
    double time = -2 * (dx * fall.sx + dy * fall.sy) / (dx * fall.gx + dy * fall.gy);
    return time > 0 ? time : NEVER;
  }

  /** Has the gap of a region count from the start. */
  GapSearch from(int region) {
    counted = region;
    return this;
  }

  /** The region at a contact that is rounded to t, or {@link Gaps#UNKNOWN}. */
  int regionAt(double t) {
    return t == 0 ? regionAtStart() : regionNear(t);
  }

  private int regionAtStart() {
    return isNow() ? region(fromStart.signAtStart(), fromEnd.signAtStart()) : Gaps.UNKNOWN;
  }

  /** The side of a line that is hit at time 0, by the height just before; 0 if not known. */
  int sideAtStart() {
    return isNow() ? gaps.height().signBeforeStart() : 0;
  }

  /** Whether the contact is at time 0 itself: the gap is not above 0 there, and falls. */
  private boolean isNow() {
    int after = region(fromStart.signAfterStart(), fromEnd.signAfterStart());
    return after != Gaps.UNKNOWN
        && gap(after).signAtStart() <= 0
        && rate(after).signAfterStart() == -1;
  }

  private int regionNear(double t) {
    int near = region(fromStart.signNear(t), fromEnd.signNear(t));
    if (near != Gaps.UNKNOWN) {
      return near;
    }
    int exact = region(fromStart.signAt(t, 0), fromEnd.signAt(t, 0));
    if (exact != Gaps.UNKNOWN && gap(exact).fallsAt(t)) {
      return exact;
    }
    int start = signAtContact(fromStart, Gaps.BEFORE, t);
    return region(start, start == 1 ? signAtContact(fromEnd, Gaps.BEYOND, t) : UNKNOWN);
  }

  /**
   * The sign of a projection at a contact that is rounded to t. Where it changes its sign, the gaps
   * of both regions are equal, and both fall. So the contact comes after that if they are above 0
   * there, and before if they are below.
   */
  private int signAtContact(GapPolynomial projection, int region, double t) {
    int near = projection.signNear(t);
    if (near != UNKNOWN || projection.derivative().signNear(t) == UNKNOWN) {
      return near;
    }
    double width = 0.5 * Math.ulp(t);
    int before = projection.signAt(t, -width);
    int after = projection.signAt(t, width);
    if (before * after == -1 && isTouchedAlways(region)) {
      return growth(projection).signNear(t) == UNKNOWN ? UNKNOWN : 0;
    }
    if (before == after || !fallsNear(Gaps.BESIDE, t) || !fallsNear(region, t)) {
      return before == after ? before : UNKNOWN;
    }
    return switch (signAtBorder(gap(region), projection, before, t, width)) {
      case 1 -> after;
      case -1 -> before;
      default -> UNKNOWN;
    };
  }

  /** Whether a gap that counts as it is falls at all times that are rounded to t. */
  private boolean fallsNear(int region, double t) {
    return region != counted && gap(region).derivative().signNear(t) == -1;
  }

  /** The sign of a gap where a projection changes its sign; UNKNOWN if halvings do not tell. */
  private static int signAtBorder(
      GapPolynomial gap, GapPolynomial projection, int before, double t, double width) {
    double first = -width;
    double last = width;
    for (int i = 0; i < HALVINGS; i++) {
      int sign = gap.signAt(t, first);
      if (sign != 0 && sign == gap.signAt(t, last)) {
        return sign;
      }
      double middle = 0.5 * (first + last);
      if (projection.signAt(t, middle) == before) {
        first = middle;
      } else {
        last = middle;
      }
    }
    return UNKNOWN;
  }

  /** The same for the return to a side, from the height above that at the start. */
  int regionAt(double t, GapPolynomial rise) {
    Arrays.fill(made, rise);
    return regionNear(t);
  }

  /** The region, by the signs of the projections from the start and from the end of a line. */
  static int region(int start, int end) {
    boolean isKnown = start <= 0 || (start == 1 && end != UNKNOWN);
    int region = start <= 0 ? Gaps.BEFORE : end >= 0 ? Gaps.BEYOND : Gaps.BESIDE;
    return isKnown ? region : Gaps.UNKNOWN;
  }

  /** Searches from a time on, at first an interval of a given width or less. */
  private double search(double start, double first, double reach, double T) {
    double end = T > GapRoot.EARLIEST ? Math.min(T, reach) : reach;
    if (!(end < NEVER)) {
      return DOUBT;
    }
    ExactBudget.add(BITS_PER_SEARCH);
    low = start;
    double width = Math.min(end - start, first);
    boolean isCut = false;
    for (int i = 0; i < INTERVALS && low < end; i++) {
      high = Math.min(low + width, end);
      possible = regions();
      double cut = isOne(possible) ? high : beside(border());
      if (cut < high) {
        width = cut - low;
        isCut = true;
        continue;
      }
      look();
      if (gap(Integer.numberOfTrailingZeros(possible)).isExact()) {
        ExactBudget.add(BITS_PER_INTERVAL);
      }
      double time = open == 0 ? NEVER : contact();
      if (time == HALVE) {
        width = 0.5 * (high - low);
        if (isLost || width < LEAST_WIDTH * high) {
          return DOUBT;
        }
        width = low == 0 ? Math.min(width, scale()) : width;
        isCut = false;
      } else if (time == NEVER || time <= after) {
        width = isCut ? end - high : 2 * (high - low);
        low = high;
      } else {
        return time > T ? NEVER : time;
      }
    }
    return low < end ? DOUBT : NEVER;
  }

  /** The scale of the shortest motion in an open region. */
  private double scale() {
    double scale = NEVER;
    for (int region = 0; region < REGIONS; region++) {
      scale = isIn(open, region) ? Math.min(scale, rate(region).scale()) : scale;
    }
    return scale;
  }

  // One interval.

  /** Finds out what the gaps do where the centre may be. */
  private void look() {
    open = 0;
    falling = 0;
    once = 0;
    isLost = false;
    for (int region = 0; region < REGIONS; region++) {
      if (isIn(possible, region)) {
        look(region);
      }
    }
  }

  private void look(int region) {
    GapPolynomial gap = gap(region);
    int sign = gap.sign(low, high);
    if (sign > 0 || (isEntry && sign < 0) || isIn(passed, region)) {
      return;
    }
    if (gap.fallsOnce()) {
      open |= 1 << region;
      once |= 1 << region;
      return;
    }
    GapPolynomial rate = rate(region);
    int way = rate.sign(low, high);
    if (way < 0 || (way == 0 && !rate.isZero() && !leaves(region))) {
      open |= 1 << region;
      falling |= way < 0 ? 1 << region : 0;
      boolean isDoubtful = !gap.isExact() && gap.isLost() && rate.isLost();
      isLost |= way == 0 && (isDoubtful || (low == 0 && isOpenAtStart(gap, rate)));
    }
  }

  /** Whether it is in doubt, in each interval from the start on, if there is contact there. */
  private static boolean isOpenAtStart(GapPolynomial gap, GapPolynomial rate) {
    return rate.signAfterStart() == UNKNOWN && gap.signAfterStart() != 1;
  }

  /**
   * Whether a centre beyond an end certainly comes no nearer to that. In units of w.w its gap has
   * the rate {@code 2 (h h' + s s')}, with the height h and the projection s from that end: neither
   * part falls if the gap of the side does not, and the projection goes away from the line.
   */
  private boolean leaves(int region) {
    if (fromStart == null || region == Gaps.BESIDE || region == counted || turns) {
      return false;
    }
    int away = region - Gaps.BESIDE;
    GapPolynomial speed = (away < 0 ? fromStart : fromEnd).derivative();
    return isNever(-away, speed) && isNever(-1, gap(Gaps.BESIDE).derivative());
  }

  /** Whether a polynomial certainly has no time with a sign in the interval. */
  private boolean isNever(int sign, GapPolynomial polynomial) {
    return polynomial.isZero() || polynomial.sign(low, high) == -sign;
  }

  /** A time in the interval at which the centre comes to another region; NaN if none is sure. */
  private double border() {
    double fromStartOn = border(fromStart);
    return Double.isNaN(fromStartOn) ? border(fromEnd) : fromStartOn;
  }

  private double border(GapPolynomial projection) {
    int first = low == 0 ? projection.signAtStart() : projection.signAt(low, 0);
    boolean isCrossed = first * projection.signAt(high, 0) == -1;
    return isCrossed ? projection.root(first, low, high) : Double.NaN;
  }

  /** The end of an interval just before a time, or, from just before it, just after it. */
  private double beside(double border) {
    double before = Fall.LESS * border;
    return before > low ? before : Fall.MORE * border;
  }

  private static boolean isOne(int regions) {
    return (regions & (regions - 1)) == 0;
  }

  /** Where the centre may be. A projection of exactly 0 is that of an end. */
  private int regions() {
    if (fromStart == null || fromStart.isZero()) {
      return 1 << Gaps.BEFORE;
    }
    int start = fromStart.sign(low, high);
    int end = fromEnd.sign(low, high);
    if (start < 0) {
      return 1 << Gaps.BEFORE;
    }
    if (end > 0 || fromEnd.isZero()) {
      return 1 << Gaps.BEYOND;
    }
    return (1 << Gaps.BESIDE)
        | (start > 0 ? 0 : 1 << Gaps.BEFORE)
        | (end < 0 ? 0 : 1 << Gaps.BEYOND);
  }

  /** The time of contact in the interval; NEVER for none, {@link #HALVE} or NaN if it is open. */
  private double contact() {
    if (open == 1 << Gaps.BESIDE && !isOne(possible)) {
      int end = Integer.numberOfTrailingZeros(possible & ~open);
      if (isOne(possible & ~open) && isTouchedAlways(end)) {
        return fromEndOn(end);
      }
    }
    double time = DOUBT;
    for (int region = 0; region < REGIONS; region++) {
      if (isIn(open, region)) {
        double here = contact(region);
        boolean isOne = Double.isNaN(time) || here == time;
        if (!isOne || here == HALVE || Double.isNaN(here)) {
          return Double.isNaN(here) ? here : HALVE;
        }
        time = here;
      }
    }
    return time == NEVER || open == possible ? time : HALVE;
  }

  /** Whether the gap of an end is 0 all the time, as of a disk at rest that touches the pivot. */
  private boolean isTouchedAlways(int end) {
    return end != counted && gap(end).isExact() && gap(end).isZero();
  }

  /**
   * The contact with a line, an end of which is touched all the time. By Pythagoras the gap of the
   * side is less than that of the end by the square of the projection: it falls from when on the
   * centre comes beside the line.
   */
  private double fromEndOn(int end) {
    GapPolynomial projection = end == Gaps.BEFORE ? fromStart : fromEnd;
    int first = low == 0 ? projection.signAtStart() : projection.signAt(low, 0);
    int way = growth(projection).sign(low, high);
    if (first * projection.signAt(high, 0) != -1 || way == 0) {
      return HALVE;
    }
    boolean isLeaving = first == (end == Gaps.BEFORE ? 1 : -1);
    return isLeaving || isEntry ? NEVER : projection.nearestRoot(first, low, high);
  }

  /** A polynomial with the sign of the rate of a projection. */
  private GapPolynomial growth(GapPolynomial projection) {
    return gaps.rate(projection, Gaps.BEFORE, GapPolynomial::derivative);
  }

  private double contact(int region) {
    if (isIn(once, region)) {
      return root(region, low, high);
    }
    return isIn(falling, region) ? fall(region) : turn(region);
  }

  /** The gap falls throughout. */
  private double fall(int region) {
    int before = signAt(region, low);
    int last = signAt(region, high);
    if (before == UNKNOWN || last == UNKNOWN) {
      return HALVE;
    }
    return before == 1 && last == 1
        ? NEVER
        : before == 1 ? root(region, low, high) : within(before);
  }

  /** The sign of a gap at an end of the interval. */
  private int signAt(int region, double t) {
    int sign = t == 0 ? gap(region).signAtStart() : gap(region).signAt(t, 0);
    if (sign == UNKNOWN && turns && region != counted) {
      sign = fall.turningRoot().sign(region, t);
    }
    return sign != UNKNOWN ? sign : exactGap(region).signAt(t, 0);
  }

  /** The double nearest to the only root in an interval: by its residue, or without rounding. */
  private double root(int region, double from, double to) {
    double t = DOUBT;
    boolean hasSpeed = region != counted || (!turns && gap(region).derivative().signAtStart() == 1);
    if (!gap(region).isExact() && hasSpeed) {
      t = rounded(region, gap(region).root(1, from, to));
    }
    boolean isInside = from < Math.nextDown(t) && Math.nextUp(t) < to;
    return isInside ? t : exactGap(region).nearestRoot(1, from, to);
  }

  /** A root, rounded by its residue. */
  private double rounded(int region, double root) {
    double qx = region == Gaps.BEYOND ? fall.bx : fall.ax;
    double qy = region == Gaps.BEYOND ? fall.by : fall.ay;
    if (region == counted) {
      return GapRoot.nearestReturn(fall, qx, qy, root);
    }
    if (turns) {
      return fall.turningRoot().nearest(region, root);
    }
    return region == Gaps.BESIDE
        ? GapRoot.nearestSide(fall, root)
        : GapRoot.nearestEnd(fall, qx, qy, root);
  }

  /** The gap has this sign, 0 or -1, where the interval begins, and falls from there on. */
  private double within(int sign) {
    if (isEntry) {
      return sign == 0 && low > 0 ? DOUBT : NEVER; // as in hill
    }
    return low == 0 ? 0 : HALVE;
  }

  /** The rate changes its sign at most once, if it changes monotonically. */
  private double turn(int region) {
    GapPolynomial gap = gap(region);
    GapPolynomial rate = rate(region);
    if (rate.derivative().sign(low, high) == 0) {
      return HALVE;
    }
    int first = low == 0 ? rate.signAtStart() : rate.signAt(low, 0);
    int last = rate.signAt(high, 0);
    if (first == last) {
      return first == -1 ? fall(region) : first == 1 ? NEVER : HALVE;
    }
    if (first * last != -1) {
      return HALVE;
    }
    double t = rate.root(first, low, high);
    double width = gap.isExact() ? Math.ulp(t) : high - low;
    boolean isNear =
        !gap.isExact() || (rate.signAt(t, -width) == first && rate.signAt(t, width) == last);
    int sign = isNear ? signAtTurn(region, t, width) : UNKNOWN;
    if (sign == UNKNOWN) {
      passed |= gap.isExact() && isPassed(region) ? 1 << region : 0;
      return HALVE;
    }
    return first == -1 ? valley(region, sign, t) : hill(region, sign, t);
  }

  private int signAtTurn(int region, double t, double width) {
    GapPolynomial gap = gap(region);
    return turns
        ? gap.signAtTurn(
            t, width, rate(region), fall.turn.change(low, high, region == Gaps.BESIDE ? 2 : 1))
        : gap.signAtTurn(t, width);
  }

  /** The gap falls to its least value at about t, which has a sign. */
  private double valley(int region, int sign, double t) {
    if (sign >= 0) {
      return NEVER;
    }
    int before = signAt(region, low);
    return before == UNKNOWN ? HALVE : before == 1 ? root(region, low, t) : within(before);
  }

  /** The gap rises to its greatest value at about t, which has a sign, and falls then. */
  private double hill(int region, int sign, double t) {
    if (sign > 0) {
      int last = signAt(region, high);
      return last == UNKNOWN ? HALVE : last == 1 ? NEVER : root(region, t, high);
    }
    if (isEntry) {
      // At 0 where the centre passes to this region: the gap of the other one may come from above.
      return sign == 0 && !isOne(possible) ? DOUBT : NEVER;
    }
    return sign == 0 ? t : exactRate(region).nearestRoot(1, low, high);
  }

  private GapPolynomial gap(int region) {
    if (made[region] == null) {
      made[region] = of(gaps, region);
    }
    return made[region];
  }

  private GapPolynomial rate(int region) {
    if (gaps == null) {
      return gap(region).derivative();
    }
    if (rates[region] == null) {
      rates[region] = gaps.rate(gap(region), region, GapPolynomial::derivative);
    }
    return rates[region];
  }

  private GapPolynomial exactGap(int region) {
    if (gap(region).isExact()) {
      return gap(region);
    }
    if (madeExact[region] == null) {
      madeExact[region] = of(exactGaps(), region);
    }
    return madeExact[region];
  }

  private GapPolynomial exactRate(int region) {
    return gap(region).isExact()
        ? rate(region)
        : exactGaps().rate(exactGap(region), region, GapPolynomial::derivative);
  }

  private Gaps<GapPolynomial> exactGaps() {
    if (exactGaps == null) {
      exactGaps = fall.gaps(GapPolynomial.EXACT);
    }
    return exactGaps;
  }

  private GapPolynomial of(Gaps<GapPolynomial> source, int region) {
    if (rise != 0) {
      return counted(source, source.height().signed(rise));
    }
    GapPolynomial gap = source.gap(region);
    return region == counted ? counted(source, gap) : gap;
  }

  private static GapPolynomial counted(Gaps<GapPolynomial> source, GapPolynomial gap) {
    return source.aboveStart(gap, GapPolynomial::constant).counted();
  }

  /**
   * Whether the centre moves on one straight line, and that passes an end of the line, or a disk,
   * at a distance of the radius or more: {@code s x g = 0} and {@code (d x g)^2 >= r^2 g.g}. It
   * grazes that at most. Of what turns only an end at the pivot, which rests, is known to be passed
   * so; straight on, s takes the place of g.
   */
  private boolean isPassed(int region) {
    if (gaps == null || region == Gaps.BESIDE || region == counted || !fall.rests(region)) {
      return false;
    }
    Gaps<GapPolynomial> still = fall.gaps(GapPolynomial.EXACT, new Gaps<>());
    GapPolynomial x = still.x(region);
    GapPolynomial y = still.y(region);
    GapPolynomial speedX = x.derivative();
    GapPolynomial speedY = y.derivative();
    boolean isStraight = fall.gx == 0 && fall.gy == 0;
    GapPolynomial gx = isStraight ? speedX : speedX.derivative();
    GapPolynomial gy = isStraight ? speedY : speedY.derivative();
    GapPolynomial aside = x.times(gy).minus(y.times(gx));
    GapPolynomial reach = still.r().times(still.r()).times(gx.times(gx).plus(gy.times(gy)));
    int clearance = aside.times(aside).minus(reach).signAtStart();
    return speedX.times(gy).minus(speedY.times(gx)).isZero() && (clearance == 0 || clearance == 1);
  }

  private static boolean isIn(int regions, int region) {
    return (regions & (1 << region)) != 0;
  }
}
