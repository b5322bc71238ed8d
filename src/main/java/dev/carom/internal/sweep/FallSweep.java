// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Gaps;
import dev.carom.internal.exact.Polynomial;
import dev.carom.internal.exact.PrecisionCounter;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.exact.UnitVector;

/**
 * When a disk with a constant acceleration hits a line or a disk.
 *
 * <p>The disk touches a line when its centre enters the capsule of radius r around it: a disk
 * around each end, and the strip between them. {@link Gaps} states the equations of their gaps.
 *
 * <p>Three rungs answer. {@link DirectHit} is a quick filter in doubles. The certified {@link
 * GapSearch} follows, with rounded coefficients and then with those without rounding. What it
 * leaves open goes to algebraic numbers, {@link ExactParabola}.
 */
public final class FallSweep {

  private static final double NEVER = GapSearch.NEVER;

  /** Below this, underflow may have taken a part. */
  private static final double LEAST_SAFE = 0x1p-1000;

  private FallSweep() {}

  // Questions. A time is correctly rounded, +infinity for none up to the window's end T.

  /** The time of impact. */
  public static double time(Fall f, double T) {
    return time(f, NEVER, T);
  }

  /**
   * The same, found sooner if it is near an expected time.
   *
   * @param about the expected time; infinite or NaN for none
   */
  public static double time(Fall f, double about, double T) {
    if (f.turns()) {
      return TurningSweep.time(f, T);
    }
    if (f.isStraight()) {
      return straightTime(f, straightContact(f), T);
    }
    PrecisionCounter.PARABOLAS.add();
    double time = f.filter.time(about, windowEnd(f, T));
    time = Double.isNaN(time) ? atStart(f, T) : time;
    time = Double.isNaN(time) ? searched(f, GapSearch.FIRST, 0, T) : time;
    return Double.isNaN(time) ? exact(f).time(T) : time;
  }

  /**
   * The time of the first entry that is above s: the distance comes from above the radius and falls
   * below it. Contact at the start is no entry.
   *
   * @param s a time from 0 on, or -1 for the first entry of all
   */
  public static double timeAfter(Fall f, double s, double T) {
    if (!(s < T)) {
      return NEVER;
    }
    if (f.turns()) {
      return TurningSweep.timeAfter(f, s, T);
    }
    if (f.isStraight()) {
      int contact = straightContact(f);
      double t = (contact & Contact.NOW) != 0 ? NEVER : straightTime(f, contact, T);
      return t > s ? t : NEVER;
    }
    PrecisionCounter.PARABOLAS.add();
    double time = f.filter.time(NEVER, T);
    if (time > s) {
      return time; // the first contact of all, from outside
    }
    time = searched(f, GapSearch.ENTRY, s, T);
    return Double.isNaN(time) ? exact(f).timeAfter(s, T) : time;
  }

  /** The {@link Contact} of a disk that flies straight on, followed for ever. */
  public static int straightContact(Fall f) {
    return f.isSegment
        ? SegmentSweep.contact(f.px, f.py, f.r, f.vx, f.vy, f.ax, f.ay, f.bx, f.by, f.ux, f.uy)
        : DiskSweep.contact(f.px, f.py, f.r, f.vx, f.vy, f.ax, f.ay, f.radius, f.ux, f.uy);
  }

  /** The time of such a contact. */
  public static double straightTime(Fall f, int contact, double T) {
    return f.isSegment
        ? SegmentSweep.time(
            contact, f.px, f.py, f.r, f.vx, f.vy, f.ax, f.ay, f.bx, f.by, f.ux, f.uy, T)
        : DiskSweep.time(contact, f.px, f.py, f.r, f.vx, f.vy, f.ax, f.ay, f.radius, f.ux, f.uy, T);
  }

  /** The exact time of such a contact that is no MISS. */
  public static RealRoot exactTime(Fall f, int contact) {
    return RealRoot.ofStraight(f.gaps(Polynomial.EXACT).gap(Contact.region(contact)));
  }

  /** The same, correctly rounded: the second and the third rung of straight flights. */
  static double settled(Fall f, int contact, double T) {
    int region = Contact.region(contact);
    double time = settled(f.gaps(GapPolynomial.EXACT).gap(region), T);
    return Double.isNaN(time) ? settled(exactTime(f, contact), T) : time;
  }

  /** The time at which the gap of a straight flight falls to 0; NaN in doubt. */
  static double settled(GapPolynomial gap, double T) {
    PrecisionCounter.DOUBTFUL_TIMES.add();
    ExactBudget.add(GapSearch.BITS_PER_INTERVAL);
    return gap.fallOfConvex(T);
  }

  static double settled(RealRoot time, double T) {
    PrecisionCounter.EXACT_TIMES.add();
    return time.upTo(T);
  }

  /**
   * The {@link Contact} of an impact on a line.
   *
   * @param t its time, from {@link #time} or {@link #timeAfter}
   */
  public static int contact(Fall f, double t) {
    int now = t == 0 ? Contact.NOW : 0;
    if (!f.isLine) {
      return (f.isSegment ? Contact.START : Contact.LATER) | now;
    }
    int region = f.region(t);
    if (region == Gaps.UNKNOWN) {
      region = f.search().exactly().regionAt(t);
    }
    int contact = contact(region, f.side(t));
    if (contact == Contact.DOUBT && region == Gaps.BESIDE && t == 0) {
      contact = contact(region, f.search().exactly().sideAtStart());
    }
    if (contact == Contact.DOUBT) {
      ExactParabola exact = exact(f);
      RealRoot root = exact.at(t);
      contact = contact(exact.region(root), exact.side(root));
    }
    return contact | now;
  }

  /** The contact in a region, on a side; {@link Contact#DOUBT} if that is not known. */
  static int contact(int region, int side) {
    return switch (region) {
      case Gaps.BEFORE -> Contact.START;
      case Gaps.BEYOND -> Contact.END;
      case Gaps.BESIDE -> side > 0 ? Contact.LEFT : side < 0 ? Contact.RIGHT : Contact.DOUBT;
      default -> Contact.DOUBT;
    };
  }

  /**
   * The unit normal at an impact on a disk at a time t, see {@link #normal(Fall, double, double,
   * double)}.
   */
  public static UnitVector normal(Fall f, double t) {
    return normal(f, f.ax, f.ay, t);
  }

  /**
   * The unit normal at an impact on an end q of a line, or on a disk there, to the falling disk,
   * each component within 1e-15; null if doubles and double-double do not tell.
   *
   * @param t the time of impact
   */
  static UnitVector normal(Fall f, double qx, double qy, double t) {
    if (f.turns()) {
      boolean isEnd = f.isLine && qx == f.bx && qy == f.by;
      return f.turningRoot().ofEnd(isEnd ? Gaps.BEYOND : Gaps.BEFORE, t);
    }
    if (t == 0) {
      boolean haveOneCentre = f.px == qx && f.py == qy; // the normal is where they come from
      boolean isNow = DiskSweep.isNow(f.px, f.py, f.r, f.vx, f.vy, qx, qy, f.radius, f.ux, f.uy);
      return haveOneCentre || !isNow ? null : UnitVectors.unit(f.px, f.py, qx, qy);
    }
    double slope = GapRoot.slopeOfEnd(f, qx, qy, t);
    double c = -GapRoot.residueOfEnd(f, qx, qy, t) / slope;
    double sizes = f.sizeX(qx, t) + f.sizeY(qy, t);
    double r = f.r + f.radius;
    // t is within an ulp of the impact: so is the place, but for this much and the bend's u^2.
    double error = GapRoot.stepError(t, c, slope, r + sizes);
    if (!(error * 2 * sizes < 0x1p-55 * r * t)) {
      return null;
    }
    double x = f.x(qx, t) + (f.xTail(qx, t) + f.speedX(t) * c);
    double y = f.y(qy, t) + (f.yTail(qy, t) + f.speedY(t) * c);
    return UnitVectors.unit(x, y, 0, 0);
  }

  /** The end of a window, if need be that of all contacts. */
  static double windowEnd(Fall f, double T) {
    return T < NEVER ? T : reach(f);
  }

  // The second rung.

  /** The time of contact of a disk that comes on from within rounding of that; NaN in doubt. */
  private static double atStart(Fall f, double T) {
    int region = f.filter.regionOfStart();
    if (region == Gaps.UNKNOWN) {
      return GapSearch.DOUBT;
    }
    ExactBudget.add(GapSearch.BITS_PER_INTERVAL);
    return f.gaps(GapPolynomial.EXACT).gap(region).fallWithin(f.filter.steady(), T);
  }

  /**
   * The answer of the search with rounded coefficients, or of that without rounding; NaN if both
   * leave it open. The gap of a point does not fall below 0 where it hits a line or another point:
   * there the second search would see a graze.
   */
  static double searched(Fall f, int question, double of, double T) {
    return searched(f, question, of, 0, reach(f), T);
  }

  /** The same where there is no contact but from one time on up to another one. */
  static double searched(Fall f, int question, double of, double from, double reach, double T) {
    PrecisionCounter.SEARCHED_PARABOLAS.add();
    double time = f.search().roughly().time(question, of, from, reach, T);
    boolean isTie = question == GapSearch.RISE || (question == GapSearch.RETURN && !f.isLine);
    boolean isOpen = Double.isNaN(time) && (isTie || f.r + f.radius > 0);
    return isOpen ? f.search().exactly().time(question, of, from, reach, T) : time;
  }

  /**
   * A time after which there is no contact: later {@code g t^2 / 2}, on the axis on which it is
   * greater, exceeds all other terms of a place.
   */
  static double reach(Fall f) {
    double size =
        Math.abs(f.dx) + Math.abs(f.dy) + Math.abs(f.wx) + Math.abs(f.wy) + f.r + f.radius;
    double speed = Math.abs(f.sx) + Math.abs(f.sy);
    double least = 0.5 * Math.max(Math.abs(f.gx), Math.abs(f.gy));
    double reach = 1.001 * ((speed + Math.sqrt(speed * speed + 4 * least * size)) / (2 * least));
    boolean isSafe = least > LEAST_SAFE && Math.max(speed * speed, least * size) > LEAST_SAFE;
    return isSafe ? reach : NEVER;
  }

  // The third rung.

  /** The question in algebraic numbers. */
  public static ExactParabola exact(Fall f) {
    return ExactParabola.of(f.gaps(Polynomial.EXACT), f.isLine);
  }
}
