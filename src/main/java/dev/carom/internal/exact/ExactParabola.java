// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * A disk with a constant acceleration against an obstacle, in exact numbers: which root of which
 * polynomial is the time of impact. Slow, some hundred microseconds, and always right.
 *
 * <p>The gap f, the square of the distance less that of the radius, is a polynomial in each Voronoi
 * region of a line: start, side and end. An impact is the first time after which f is not above 0
 * and falls. Between two neighbouring roots of all f, all f' and the borders of the regions nothing
 * changes, so one sample tells.
 *
 * <p>The gap of a point never is below 0. It falls to 0 where the offset vanishes and the velocity
 * does not.
 */
public final class ExactParabola {

  private static final Polynomial NONE = Polynomial.of();

  /** Time 0. */
  static final RealRoot START = RealRoot.at(Dyadic.ZERO);

  /** The equations; null of a single gap. */
  private final Gaps<Polynomial> gaps;

  /** The projection on the line from its start and from its end; 0 if there is no line. */
  private final Polynomial alongStart;

  private final Polynomial alongEnd;

  /** The distance from the line times its length; 0 if there is no line. */
  private final Polynomial height;

  /** The gaps by region; one gap if there is no line. */
  private final Polynomial[] gap;

  /** Their rates. */
  private final Polynomial[] rate;

  private ExactParabola(Gaps<Polynomial> gaps, Polynomial[] gap, Polynomial[] rate) {
    boolean isLine = gap.length > 1;
    this.gaps = gaps;
    this.gap = gap;
    this.rate = rate;
    alongStart = isLine ? gaps.fromStart() : NONE;
    alongEnd = isLine ? gaps.fromEnd() : NONE;
    height = isLine ? gaps.height() : NONE;
  }

  /** Against a line that has a length, or a disk. */
  public static ExactParabola of(Gaps<Polynomial> gaps, boolean isLine) {
    Polynomial[] gap = new Polynomial[isLine ? Gaps.BEYOND + 1 : 1];
    Polynomial[] rate = new Polynomial[gap.length];
    for (int region = 0; region < gap.length; region++) {
      gap[region] = gaps.gap(region);
      rate[region] = gaps.rate(gap[region], region, Polynomial::derivative);
    }
    return new ExactParabola(gaps, gap, rate);
  }

  /** Against what has one gap everywhere: a wall, or the thing just hit. */
  public static ExactParabola ofGap(Polynomial gap) {
    return ofGap(gap, gap.derivative());
  }

  /** The same, with a rate of its own. */
  static ExactParabola ofGap(Polynomial gap, Polynomial rate) {
    return new ExactParabola(null, new Polynomial[] {gap}, new Polynomial[] {rate});
  }

  /** The time of impact; null for none up to the window's end T. */
  public RealRoot first(double T) {
    PrecisionCounter.EXACT_PARABOLAS.add();
    return firstFrom(START, T);
  }

  /** The first time from a given one on that is one of impact; null for none up to T. */
  RealRoot firstFrom(RealRoot from, double T) {
    return isPoint() ? upTo(T, firstOfPoint(root -> root.compare(from) >= 0)) : firstFall(from, T);
  }

  /**
   * The correctly rounded time of the first entry that is above s: the gap comes from above 0 and
   * falls below 0. Contact at the start is no entry. It is {@code +infinity} for none up to T.
   */
  public double timeAfter(double s, double T) {
    PrecisionCounter.EXACT_PARABOLAS.add();
    RealRoot root = entryAfter(s, T);
    return root == null ? Double.POSITIVE_INFINITY : root.nearest();
  }

  private RealRoot entryAfter(double s, double T) {
    return isPoint()
        ? upTo(T, firstOfPoint(root -> root.isRoundedAbove(s)))
        : firstBorder(START, T, (before, root, after) ->
            before != null && sign(before) > 0 && sign(after) < 0 && root.isRoundedAbove(s));
  }

  /** The impact or the later entry whose rounded time is t; t itself if there is none. */
  public RealRoot at(double t) {
    double end = Math.nextUp(t); // what is later is not rounded to t
    RealRoot root = first(end);
    if (root == null || root.nearest() != t) {
      root = entryAfter(Math.nextDown(t), end);
    }
    return root == null || root.nearest() != t ? RealRoot.at(Dyadic.of(t)) : root;
  }

  /** A time, or the first border from it on up to T, after which the gap is not above 0 and falls. */
  RealRoot firstFall(RealRoot from, double T) {
    return firstBorder(from, T, (before, root, after) -> falls(after));
  }

  /** The first impact of a point up to T that is not in a given region. */
  RealRoot firstOfPoint(int region, double T) {
    return upTo(T, firstOfPoint(root -> region(root) != region));
  }

  /** Whether a border counts, given a number just before it, or null, and one just after it. */
  private interface Border {
    boolean counts(Dyadic before, RealRoot root, Dyadic after);
  }

  /** A time, or the first border from it on up to T, that counts; null for none. */
  private RealRoot firstBorder(RealRoot from, double T, Border border) {
    RealRoot limit = T == Double.POSITIVE_INFINITY ? null : RealRoot.after(T);
    List<RealRoot> borders = borders(limit);
    borders.add(limit);
    RealRoot root = from;
    Dyadic before = null;
    for (RealRoot next : borders) {
      if (next == null || root.compare(next) < 0) {
        Dyadic after = next == null ? root.after() : root.between(next);
        if (border.counts(before, root, after)) {
          return upTo(T, root);
        }
        before = after;
        root = next;
      }
    }
    return null;
  }

  /** A root, or null if it is later than T. */
  private static RealRoot upTo(double T, RealRoot root) {
    boolean isLate =
        root != null && T < Double.POSITIVE_INFINITY && root.compare(Dyadic.of(T)) > 0;
    return isLate ? null : root;
  }

  /** The correctly rounded time of impact, {@code +infinity} for none up to the window's end T. */
  public double time(double T) {
    RealRoot root = first(T);
    return root == null ? Double.POSITIVE_INFINITY : root.nearest();
  }

  /** The region of {@link Gaps} at a time. */
  public int region(RealRoot t) {
    return t.sign(alongStart) <= 0
        ? Gaps.BEFORE
        : t.sign(alongEnd) >= 0 ? Gaps.BEYOND : Gaps.BESIDE;
  }

  /** Whether the centre is between the ends of the line at a time, or exactly at one. */
  boolean isBeside(RealRoot t) {
    return t.sign(alongStart) >= 0 && t.sign(alongEnd) <= 0;
  }

  boolean turns() {
    return gaps.turns();
  }

  boolean isPoint() {
    return gaps != null && gaps.r().isZero();
  }

  /** The same line, but for the gap in a region. */
  ExactParabola withGap(int region, ExactParabola other) {
    Polynomial[] others = gap.clone();
    Polynomial[] rates = rate.clone();
    others[region] = other.gap[0];
    rates[region] = other.rate[0];
    return new ExactParabola(gaps, others, rates);
  }

  /** The end of the line in a region, as a disk. */
  ExactParabola part(int region) {
    Polynomial x = gaps.x(region);
    Polynomial y = gaps.y(region);
    return of(new Gaps<Polynomial>().set(x, y, x, y, NONE, NONE, gaps.r()), false);
  }

  /** The side of the line just before an impact: +1 left, -1 right. */
  public int side(RealRoot t) {
    return signBefore(height, t);
  }

  /**
   * The unit vector from the other disk, or the end of the line, to this one at an impact. Where
   * their offset vanishes, it is the limit from before: against the velocity.
   */
  public UnitVector normal(RealRoot t) {
    int region = alongStart.isZero() ? Gaps.BEFORE : region(t);
    if (isPoint()) {
      Polynomial speedX = gaps.x(region).derivative();
      return t.unit(NONE.minus(speedX), NONE.minus(gaps.y(region).derivative()));
    }
    return t.unit(gaps.x(region), gaps.y(region));
  }

  /** Whether a point that hits an end of a line was beside the line just before. */
  public boolean comesFromSide(RealRoot t) {
    return signBefore(alongStart, t) > 0 && signBefore(alongEnd, t) < 0;
  }

  /** The sign of a polynomial just before a time: of the first derivative that is not 0 then. */
  private static int signBefore(Polynomial f, RealRoot t) {
    int order = order(f, t);
    Polynomial derivative = f;
    for (int i = 0; i < order; i++) {
      derivative = derivative.derivative();
    }
    return t.sign(derivative) * (order % 2 == 0 ? 1 : -1);
  }

  /** Which derivative of a polynomial is the first one that is not 0 at a time. */
  private static int order(Polynomial f, RealRoot t) {
    int order = 0;
    for (Polynomial g = f; !g.isZero() && t.sign(g) == 0; g = g.derivative()) {
      order++;
    }
    return order;
  }

  /** The times before a limit, null for none, at which the gap may begin to fall, in order. */
  private List<RealRoot> borders(RealRoot limit) {
    List<RealRoot> borders = new ArrayList<>();
    Stream.concat(
            Stream.concat(Stream.of(gap), Stream.of(rate)), Stream.of(alongStart, alongEnd))
        .forEach(f -> borders.addAll(f.positiveRoots(limit)));
    Collections.sort(borders, RealRoot::compare);
    return borders;
  }

  /** The region in which the disk is at a time. */
  private int region(Dyadic t) {
    return gap.length == 1 ? 0 : region(RealRoot.at(t));
  }

  private int sign(Dyadic t) {
    return gap[region(t)].sign(t);
  }

  /** Whether the gap at a time is not above 0 and falls. */
  private boolean falls(Dyadic t) {
    int here = region(t);
    return gap[here].sign(t) <= 0 && rate[here].sign(t) < 0;
  }

  /** The first of the times that count at which a point comes to a point, or to a line. */
  private RealRoot firstOfPoint(Predicate<RealRoot> counts) {
    if (alongStart.isZero()) {
      return first(gaps.x(Gaps.BEFORE).gcd(gaps.y(Gaps.BEFORE)), counts.and(this::isMoving));
    }
    if (!height.isZero()) {
      return first(height, counts.and(this::isMet));
    }
    // It moves along the line's direction, in line with it.
    RealRoot start = first(alongStart, counts.and(t -> t.sign(alongStart.derivative()) > 0));
    RealRoot end = first(alongEnd, counts.and(t -> t.sign(alongEnd.derivative()) < 0));
    return start == null || (end != null && end.compare(start) < 0) ? end : start;
  }

  private static RealRoot first(Polynomial f, Predicate<RealRoot> counts) {
    return f.positiveRoots(null).stream().filter(counts).findFirst().orElse(null);
  }

  private boolean isMoving(RealRoot t) {
    return t.sign(gaps.x(Gaps.BEFORE).derivative()) != 0
        || t.sign(gaps.y(Gaps.BEFORE).derivative()) != 0;
  }

  /**
   * Whether a point that is in line with the line at a time hits it: from a side, to which it
   * passes to the other one, or an end.
   */
  private boolean isMet(RealRoot t) {
    int start = t.sign(alongStart);
    int end = t.sign(alongEnd);
    if (start < 0 || end > 0) {
      return false;
    }
    return order(height.derivative(), t) % 2 == 0
        || (start == 0 && t.sign(alongStart.derivative()) > 0)
        || (end == 0 && t.sign(alongEnd.derivative()) < 0);
  }
}
