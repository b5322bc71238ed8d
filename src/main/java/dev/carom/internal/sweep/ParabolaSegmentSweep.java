// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.crossTail;
import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.PrecisionCounters;
import dev.carom.internal.exact.RealRoot;

/**
 * A disk with a constant acceleration g against a line that moves with the velocity u, or rests.
 *
 * <p>All is seen from the line: with {@code w = b - a}, {@code d = p - a} and the relative velocity
 * {@code s = v - u}, the centre's height is {@code h(t) = cross(w, d + s t + g t^2 / 2)}. The gap
 * beside the line, times w.w, is {@code h^2 - r^2 w.w}. Double-double takes s with its tail, and
 * exact numbers take it exactly. The disk touches the line when its centre
 * enters the capsule of radius r around it: a disk around each end, and the strip between them.
 *
 * <p>{@link DirectHit} answers nearly all questions, {@link GapSearch} nearly all others, and exact
 * numbers answer the rest.
 */
public final class ParabolaSegmentSweep {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Below this, no product of a size and a speed overflows. */
  private static final double MOST = 0x1p150;

  private ParabolaSegmentSweep() {}

  /** The correctly rounded time of impact, {@code +infinity} for none up to the window's end T. */
  public static double time(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double T) {
    return time(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, NEVER, T);
  }

  /**
   * The same, found sooner if it is near an expected time.
   *
   * @param about the expected time; infinite or NaN for none
   */
  public static double time(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double about, double T) {
    if (gx == 0 && gy == 0) {
      int contact = SegmentSweep.contact(px, py, r, vx, vy, ax, ay, bx, by, ux, uy);
      return SegmentSweep.time(contact, px, py, r, vx, vy, ax, ay, bx, by, ux, uy, T);
    }
    if (ax == bx && ay == by) {
      return ParabolaDiskSweep.time(px, py, r, vx, vy, gx, gy, ax, ay, 0, ux, uy, T);
    }
    PrecisionCounters.parabola();
    double time = DirectHit.time(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, about, T);
    if (!Double.isNaN(time)) {
      return time;
    }
    Fall fall = Fall.of(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy);
    time = fall.first(T);
    return Double.isNaN(time) ? fall.exactly().time(T) : time;
  }

  /**
   * The correctly rounded time of the first entry that is above s: the distance from the line comes
   * from above the radius and falls below it. Contact at the start is no entry. It is {@code
   * +infinity} for none up to the window's end T.
   *
   * @param s a time from 0 on, or -1 for the first entry of all
   */
  public static double timeAfter(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double s, double T) {
    if (!(s < T)) {
      return NEVER;
    }
    if (gx == 0 && gy == 0) {
      int contact = SegmentSweep.contact(px, py, r, vx, vy, ax, ay, bx, by, ux, uy);
      double t =
          (contact & Contact.NOW) != 0
              ? NEVER
              : SegmentSweep.time(contact, px, py, r, vx, vy, ax, ay, bx, by, ux, uy, T);
      return t > s ? t : NEVER;
    }
    if (ax == bx && ay == by) {
      return ParabolaDiskSweep.timeAfter(px, py, r, vx, vy, gx, gy, ax, ay, 0, ux, uy, s, T);
    }
    PrecisionCounters.parabola();
    double time = DirectHit.time(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, NEVER, T);
    if (time > s) {
      return time; // the first contact of all, from outside
    }
    Fall fall = Fall.of(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy);
    time = fall.entryAfter(s, T);
    return Double.isNaN(time) ? fall.exactly().timeAfter(s, T) : time;
  }

  /**
   * The {@link Contact} of an impact.
   *
   * @param t its time, from {@link #time} or {@link #timeAfter}
   */
  public static int contact(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double t) {
    int now = t == 0 ? Contact.NOW : 0;
    if (ax == bx && ay == by) {
      return Contact.START | now;
    }
    int region = LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
    if (region == LineRegion.UNKNOWN) {
      region = Fall.of(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy).regionAt(t);
    }
    int side = LineRegion.side(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
    int contact = LineRegion.contact(region, side);
    return contact == Contact.DOUBT
        ? exactContact(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t) | now
        : contact | now;
  }

  private static int exactContact(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double t) {
    ExactParabola exact = ExactParabola.line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy);
    RealRoot root = exact.at(t);
    return LineRegion.contact(exact.region(root), exact.side(root));
  }

  /** Whether a vector is along the line by its zeros: both terms of cross(w, v) are 0. */
  static boolean isAlong(double wx, double wy, double vx, double vy) {
    return (wx == 0 || vy == 0) && (wy == 0 || vx == 0);
  }

  /**
   * Whether a radius and a line are so small that underflow, multiplied by the squares of both,
   * stays below the bounds.
   */
  static boolean isInRange(double r, double wx, double wy) {
    return r < MOST && Math.abs(wx) + Math.abs(wy) < MOST;
  }

  /** The double nearest to the root of the gap beside the line. */
  static double nearest(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double start) {
    double t = start;
    double nearest = GapRoot.DOUBT;
    for (int i = 0; i < GapRoot.CORRECTIONS && Double.isNaN(nearest); i++) {
      double f = residue(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
      double slope = slope(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
      double size = size(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
      nearest = GapRoot.nearest(t, f, slope, size);
      t -= f / slope;
    }
    return nearest;
  }

  /** The slope of the gap beside the line at t. */
  private static double slope(
      double px, double py, double vx, double vy, double gx, double gy, double ax, double ay,
      double bx, double by, double ux, double uy, double t) {
    double wx = bx - ax;
    double wy = by - ay;
    double x = Offset.head(px, ax, vx, ux, gx, t);
    double y = Offset.head(py, ay, vy, uy, gy, t);
    double speedX = Offset.speed(vx, ux, gx, t);
    double speedY = Offset.speed(vy, uy, gy, t);
    return 2 * (wx * y - wy * x) * (wx * speedY - wy * speedX);
  }

  /** The root of the sum of the absolute values of its terms at t. */
  private static double size(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double t) {
    return Math.abs(bx - ax) * (r + Offset.size(py - ay, vy - uy, gy, t))
        + Math.abs(by - ay) * (r + Offset.size(px - ax, vx - ux, gx, t));
  }

  /** {@code h^2 - r^2 w.w} at t. What cancels is kept as head and tail. */
  private static double residue(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double t) {
    double wx = bx - ax;
    double wy = by - ay;
    double wxl = differenceTail(bx, ax, wx);
    double wyl = differenceTail(by, ay, wy);
    double x = Offset.head(px, ax, vx, ux, gx, t);
    double y = Offset.head(py, ay, vy, uy, gy, t);
    double xl = Offset.tail(px, ax, vx, ux, gx, t);
    double yl = Offset.tail(py, ay, vy, uy, gy, t);
    double h0 = wx * y - wy * x;
    double h1 = crossTail(wx, wxl, wy, wyl, x, xl, y, yl, h0);
    double h = h0 + h1;
    return SideSweep.gap(h, sumTail(h0, h1, h), wx, wxl, wy, wyl, r);
  }
}
