// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.Expansion;
import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Gaps;

/**
 * A disk with a constant acceleration g, and an obstacle: a line from a to b, or a disk around a =
 * b. The obstacle moves with the velocity u.
 *
 * <p>This is the second rung: a question that the filter leaves open goes to a {@link GapSearch}
 * with rounded coefficients, and then to one with coefficients without rounding.
 *
 * <p>Each thread has one, whose numbers are set for each question.
 */
final class Fall {

  private static final double NEVER = GapSearch.NEVER;

  /** Below this, underflow may have taken a part. */
  private static final double LEAST_SAFE = 0x1p-1000;

  private static final Expansion HALF = Expansion.sum(0.5, 0);

  private static final ThreadLocal<Fall> OF_THREAD = ThreadLocal.withInitial(Fall::new);

  // The disk and its flight.
  private double px;
  private double py;
  private double r;
  private double vx;
  private double vy;
  private double gx;
  private double gy;

  // The obstacle.
  private double ax;
  private double ay;
  private double bx;
  private double by;
  private double radius;
  private double ux;
  private double uy;

  private final GapPolynomial.Pool pool = new GapPolynomial.Pool();
  private final Gaps<GapPolynomial> roundedGaps = new Gaps<>();
  private final GapSearch search = new GapSearch(this);

  private Fall() {}

  /** A disk and a line that moves with the velocity u. */
  static Fall of(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double gx,
      double gy,
      double ax,
      double ay,
      double bx,
      double by,
      double ux,
      double uy) {
    Fall fall = OF_THREAD.get();
    fall.px = px;
    fall.py = py;
    fall.r = r;
    fall.vx = vx;
    fall.vy = vy;
    fall.gx = gx;
    fall.gy = gy;
    fall.ax = ax;
    fall.ay = ay;
    fall.bx = bx;
    fall.by = by;
    fall.radius = 0;
    fall.ux = ux;
    fall.uy = uy;
    return fall;
  }

  /** A disk and another one that moves straight on. */
  static Fall ofDisks(
      double x1,
      double y1,
      double r1,
      double vx1,
      double vy1,
      double gx,
      double gy,
      double x2,
      double y2,
      double r2,
      double vx2,
      double vy2) {
    Fall fall = of(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, x2, y2, vx2, vy2);
    fall.radius = r2;
    return fall;
  }

  private boolean isLine() {
    return ax != bx || ay != by;
  }

  /** The time of the first contact up to T; NaN if a search leaves it open. */
  double first(double T) {
    return time(GapSearch.FIRST, 0, r + radius == 0, T);
  }

  /** The time of the first contact with a disk after a time of none. */
  double firstAfter(double start, double T) {
    return time(GapSearch.FIRST_AFTER, start, r + radius == 0, T);
  }

  /** The time of the first entry after s. */
  double entryAfter(double s, double T) {
    return time(GapSearch.ENTRY, s, r + radius == 0, T);
  }

  /**
   * The time of the next contact with a line or a disk that is touched in a region at the start.
   */
  double next(int region, double T) {
    return time(GapSearch.RETURN, region, isLine() && r == 0, T);
  }

  /**
   * The answer of the rounded search, or of that without rounding. The gap of a point does not fall
   * below 0 where it hits a line or another point: there the second one would see a graze.
   */
  private double time(int question, double of, boolean isPoint, double T) {
    double reach = reach();
    double time = rounded().time(question, of, reach, T);
    boolean isOpen = Double.isNaN(time) && !isPoint;
    return isOpen ? exact().time(question, of, reach, T) : time;
  }

  private GapSearch rounded() {
    pool.reset();
    roundedGaps.set(
        pool.rounded(px - ax, vx - ux, half(gx)),
        pool.rounded(py - ay, vy - uy, half(gy)),
        pool.rounded(bx - ax),
        pool.rounded(by - ay),
        pool.rounded(r + radius));
    return search.of(roundedGaps, isLine());
  }

  private GapSearch exact() {
    return search.of(exactGaps(), isLine());
  }

  /** Half of an acceleration; not 0 if that underflows. */
  private static double half(double g) {
    return g != 0 && 0.5 * g == 0 ? g : 0.5 * g;
  }

  /** The gaps with coefficients without rounding. */
  Gaps<GapPolynomial> exactGaps() {
    return new Gaps<GapPolynomial>()
        .set(
            motion(px, ax, vx, ux, gx),
            motion(py, ay, vy, uy, gy),
            GapPolynomial.exact(Expansion.difference(bx, ax)),
            GapPolynomial.exact(Expansion.difference(by, ay)),
            GapPolynomial.exact(Expansion.sum(r, radius)));
  }

  private static GapPolynomial motion(double p, double q, double v, double u, double g) {
    return GapPolynomial.exact(
        Expansion.difference(p, q), Expansion.difference(v, u), HALF.times(Expansion.sum(g, 0)));
  }

  /** The double nearest to a root of the gap in a region, from a time near it; NaN in doubt. */
  double nearest(int region, boolean isCounted, double start) {
    double qx = region == Gaps.BEYOND ? bx : ax;
    double qy = region == Gaps.BEYOND ? by : ay;
    if (isCounted) {
      return ParabolaReturn.nearest(px, py, vx, vy, gx, gy, qx, qy, ux, uy, start);
    }
    return region == Gaps.BESIDE
        ? ParabolaSegmentSweep.nearest(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, start)
        : ParabolaDiskSweep.nearest(px, py, r, vx, vy, gx, gy, qx, qy, radius, ux, uy, start);
  }

  /** The {@link LineRegion} at a contact that is rounded to t. */
  int regionAt(double t) {
    return exact().regionAt(t);
  }

  /** The same at the return from a region, -1 to 1, to the line that is touched there. */
  int regionAtReturn(int region, int side, double t) {
    return region == LineRegion.BESIDE
        ? exact().regionAt(t, rise(side))
        : exact().from(1 + region).regionAt(t);
  }

  /** Whether a disk that is back at its height above a side, at t, is exactly at an end of it. */
  boolean returnsAtEnd(int side, double t) {
    Gaps<GapPolynomial> gaps = exactGaps();
    boolean isAtEnd = gaps.fromStart().signAt(t, 0) == 0 || gaps.fromEnd().signAt(t, 0) == 0;
    return isAtEnd && rise(side).fallsAt(t);
  }

  /** The height above that at the start, times the length of the line. */
  private GapPolynomial rise(int side) {
    return exactGaps().height().signed(side).counted();
  }

  /** The time of the return to the height at the start. */
  double toSide(int side, double T) {
    return upTo(T, rise(side).overTime());
  }

  /** The time at which {@code inward (v + g t)} falls to 0. */
  static double linear(double v, double g, int inward, double T) {
    GapPolynomial speed = GapPolynomial.exact(Expansion.sum(v, 0), Expansion.sum(g, 0));
    return upTo(T, speed.signed(inward));
  }

  /** The root of a linear polynomial, half of its scale, up to T. */
  private static double upTo(double T, GapPolynomial linear) {
    double time = linear.nearestRoot(1, 0, linear.scale());
    return time < T || (time == T && linear.signAt(T, 0) <= 0) ? time : time >= T ? NEVER : time;
  }

  /** Of a wall on one axis: when does {@code s + v t + g t^2 / 2} with {@code s = h - r} fall? */
  static double toWall(double p, double r, double v, double g, double wall, int inward, double T) {
    GapPolynomial place = motion(p, wall, v, 0, g);
    GapPolynomial gap = place.signed(inward).minus(GapPolynomial.exact(Expansion.sum(r, 0)));
    double reach = ofDisks(p, 0, r, v, 0, g, 0, wall, 0, 0, 0, 0).reach();
    return new GapSearch(gap).time(GapSearch.FIRST, 0, reach, T);
  }

  /**
   * A time after which there is no contact: later {@code g t^2 / 2}, on the axis on which it is
   * greater, exceeds all other terms of a place.
   */
  private double reach() {
    double size =
        Math.abs(px - ax) + Math.abs(py - ay) + Math.abs(bx - ax) + Math.abs(by - ay) + r + radius;
    double speed = Math.abs(vx - ux) + Math.abs(vy - uy);
    double least = 0.5 * Math.max(Math.abs(gx), Math.abs(gy));
    double reach = 1.001 * ((speed + Math.sqrt(speed * speed + 4 * least * size)) / (2 * least));
    boolean isSafe = least > LEAST_SAFE && Math.max(speed * speed, least * size) > LEAST_SAFE;
    return isSafe ? reach : NEVER;
  }

  /** The last rung. */
  ExactParabola exactly() {
    return isLine()
        ? ExactParabola.line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy)
        : ExactParabola.disk(px, py, r, vx, vy, gx, gy, ax, ay, radius, ux, uy);
  }
}
