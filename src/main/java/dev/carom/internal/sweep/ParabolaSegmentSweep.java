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
 * <p>{@link DirectHit} answers nearly all questions. The others are answered so:
 *
 * <ol>
 *   <li>A disk that starts outside the strip of width 2 r along the infinite line can touch nothing
 *       before it enters that. If it then is between the ends, it hits the side.
 *   <li>If it is beyond an end, or starts in the strip beyond an end, and its height is monotone
 *       until it hits that end, or for ever, that end is the answer.
 *   <li>If the height turns before, the other end counts, too. If it turns outside of the strip, so
 *       does the side, which the disk may hit when it enters the strip again.
 *   <li>All else, and all that doubles leave in doubt, goes to {@link StripContact}, and what that
 *       leaves in doubt to exact numbers.
 * </ol>
 */
public final class ParabolaSegmentSweep {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** In units of sizes: far more than the rounding of a place or a speed. */
  private static final double FAR = 0x1p-20;

  /**
   * A gap that rounding leaves in doubt is below 2^-47 of the size squared, and changes at first by
   * more than {@link #FAR} times size and speed. As long as the height does not turn, it keeps half
   * of its speed for half of the time, so the gap is gone after a time t of 2^-27 sizes over the
   * speed. Gravity g takes the disk no further than {@link #FAR} in it, {@code g t^2 / 2}, if the
   * speed squared is above this part of g times the size.
   */
  private static final double LEAST_STEADY = 0x1p-32;

  /** Above this, no product of a size and a speed underflows to less than rounding. */
  private static final double LEAST_SAFE = 0x1p-300;

  /** Below this, underflow alone may hide whether a disk is in the strip, however far it is. */
  private static final double LEAST_SQUARE = 0x1p-380;

  /** Below this, no such product overflows. */
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
    if (Double.isNaN(time)) {
      time = certain(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, T);
    }
    if (Double.isNaN(time)) {
      time = StripContact.time(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, T);
    }
    return !Double.isNaN(time)
        ? time
        : ExactParabola.line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy).time(T);
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
    double time = LaterEntry.certain(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, s, T);
    return !Double.isNaN(time)
        ? time
        : ExactParabola.line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy).timeAfter(s, T);
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
    int contact =
        LineRegion.contact(
            LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t),
            LineRegion.side(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t));
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

  /** The time, if doubles and double-double tell. */
  private static double certain(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double T) {
    double wx = bx - ax;
    double wy = by - ay;
    if (!isInRange(r, wx, wy)) {
      return GapRoot.DOUBT;
    }
    double dx = px - ax;
    double dy = py - ay;
    double sx = vx - ux;
    double sy = vy - uy;
    double h0 = wx * dy - wy * dx;
    double h1 = wx * sy - wy * sx;
    double h2 = 0.5 * (wx * gy - wy * gx);
    double rr = r * r;
    double c0 = h0 * h0 - rr * (wx * wx + wy * wy);
    double width = Math.abs(wx) + Math.abs(wy);
    double m0 = Math.abs(wx * dy) + Math.abs(wy * dx) + r * width;
    double m1 = Math.abs(wx * sy) + Math.abs(wy * sx);
    double m2 = 0.5 * (Math.abs(wx * gy) + Math.abs(wy * gx));
    int strip = GapRoot.sign(c0, m0 * m0);
    int beside = strip == 0 ? whereItTouches(dx, dy, sx, sy, gx, gy, wx, wy, r) : 0;
    if (strip == 0 && beside == 0) {
      return GapRoot.DOUBT;
    }
    if (strip < 0 || beside < 0) {
      return fromStrip(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, T);
    }
    double c1 = 2 * h0 * h1;
    double c2 = h1 * h1 + 2 * h0 * h2;
    if (beside > 0 && h0 * h1 < 0) {
      if (Predicates.discriminant(bx, by, ax, ay, px, py, ax, ay, r, 0) >= 0) {
        return 0;
      }
      return GapRoot.DOUBT;
    }
    double c3 = 2 * h1 * h2;
    double c4 = h2 * h2;
    double end = reach(wx, wy, gx, gy, h1, h2, m0, m1, m2, T);
    double out = beside > 0 ? GapRoot.leaves(c0, c1, c2, c3, c4, m0, m1, m2, end) : 0;
    if (Double.isNaN(out)) {
      double t = GapRoot.rise(c1, c2, c3, c4, m0, m1, m2, end);
      double f = residue(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
      out = GapRoot.isAbove(t, f, m0 + (m1 + m2 * t) * t) ? t : GapRoot.DOUBT;
    }
    if (!(out < NEVER)) {
      return out;
    }
    double in = GapRoot.first(c0, c1, c2, c3, c4, m0, m1, m2, out, end);
    return in < NEVER
        ? atStrip(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, in, T)
        : in;
  }

  /** The time of impact of a disk that starts in the strip. */
  private static double fromStrip(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double T) {
    int region = LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, 0);
    if (region != LineRegion.BESIDE) {
      return region == LineRegion.UNKNOWN
          ? GapRoot.DOUBT
          : beyondAnEnd(region, px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, 0, T);
    }
    double wx = bx - ax;
    double wy = by - ay;
    double dx = px - ax;
    double dy = py - ay;
    double sx = vx - ux;
    double sy = vy - uy;
    double height = wx * dy - wy * dx;
    double speed = wx * sy - wy * sx;
    int side = GapRoot.sign(height, Math.abs(wx * dy) + Math.abs(wy * dx));
    int way = GapRoot.sign(speed, Math.abs(wx * sy) + Math.abs(wy * sx));
    return side * way < 0 ? 0 : GapRoot.DOUBT;
  }

  /** The time of impact of a disk that enters the strip at about the time in. */
  private static double atStrip(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double in, double T) {
    double time =
        GapRoot.beside(in, nearest(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, in));
    int region = LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, time);
    if (region == LineRegion.BESIDE || region == LineRegion.UNKNOWN) {
      return region == LineRegion.BESIDE ? time : GapRoot.DOUBT;
    }
    double before = GapRoot.before(time);
    return beyondAnEnd(region, px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, before, T);
  }

  /**
   * Where a disk that touches the strip is: 1 beside the line, -1 beyond an end. It is 0 near an
   * end, for a disk that moves nearly along the line, and where gravity is strong. So a disk that
   * is in the strip or out of it by no more than rounding has left or entered it before it comes to
   * an end.
   */
  private static int whereItTouches(
      double dx, double dy, double sx, double sy, double gx, double gy, double wx, double wy,
      double r) {
    double width = Math.abs(wx) + Math.abs(wy);
    double size = width * (Math.abs(dx) + Math.abs(dy) + r);
    double speed = width * (Math.abs(sx) + Math.abs(sy));
    double start = wx * dx + wy * dy;
    double toEnd = wx * (wx - dx) + wy * (wy - dy);
    double h0 = wx * dy - wy * dx;
    double h1 = wx * sy - wy * sx;
    double least = FAR * size;
    double pull = width * (Math.abs(gx) + Math.abs(gy));
    boolean isFast =
        size * size > LEAST_SQUARE
            && Math.abs(h0 * h1) > FAR * (size * speed)
            && speed * speed > LEAST_STEADY * (pull * size)
            && size * speed < MOST
            && size * speed > LEAST_SAFE;
    if (!isFast) {
      return 0;
    }
    return start > least && toEnd > least ? 1 : start < -least || toEnd < -least ? -1 : 0;
  }

  /**
   * The time of impact of a disk that is in the strip, beyond an end of the line. If its height is
   * monotone until it hits this end, or for ever, it cannot come to the other end: it would have to
   * pass this one in the strip. Otherwise it must be outside of this end at the start: one that
   * overlaps it, and leaves, does not hit the other one by coming nearer to that.
   *
   * @param region which end
   * @param from a time at which it is there, or just before it enters the strip there
   */
  static double beyondAnEnd(
      int region, double px, double py, double r, double vx, double vy, double gx, double gy,
      double ax, double ay, double bx, double by, double ux, double uy, double from, double T) {
    boolean isStart = region == LineRegion.BEFORE;
    double near = endTime(isStart, px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, from, T);
    if (near == 0 || Double.isNaN(near)) {
      return near;
    }
    double wx = bx - ax;
    double wy = by - ay;
    double sx = vx - ux;
    double sy = vy - uy;
    int turn = turn(sx, sy, gx, gy, wx, wy, from, Math.min(near, T));
    if (turn <= 0 || (from == 0 && !isOutside(isStart, px, py, r, ax, ay, bx, by))) {
      return turn < 0 ? near : GapRoot.DOUBT;
    }
    double far = endTime(!isStart, px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, 0, T);
    double first = Math.min(near, far);
    if (first == 0 || Double.isNaN(first)) {
      return first;
    }
    double dx = px - ax;
    double dy = py - ay;
    double h1 = wx * sy - wy * sx;
    double h2 = 0.5 * (wx * gy - wy * gx);
    double vertex = -0.5 * h1 / h2;
    double height = (wx * dy - wy * dx) + 0.5 * h1 * vertex;
    double width = Math.abs(wx) + Math.abs(wy);
    double sizeX = Offset.size(dx, sx, gx, vertex);
    double sizeY = Offset.size(dy, sy, gy, vertex);
    double m = r * width + Math.abs(wx) * sizeY + Math.abs(wy) * sizeX;
    double ww = wx * wx + wy * wy;
    int outside = GapRoot.sign(height * height - r * r * ww, m * m);
    if (outside <= 0 || !(vertex < GapRoot.LATEST)) {
      return outside < 0 && vertex < GapRoot.LATEST ? first : GapRoot.DOUBT;
    }
    double again = vertex + Math.sqrt((Math.abs(height) - r * Math.sqrt(ww)) / Math.abs(h2));
    return Math.min(
        first, again(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, vertex, again, first, T));
  }

  /** Whether a disk is certain not to overlap an end at the start. */
  private static boolean isOutside(
      boolean isStart, double px, double py, double r, double ax, double ay, double bx, double by) {
    double dx = px - (isStart ? ax : bx);
    double dy = py - (isStart ? ay : by);
    double size = Math.abs(dx) + Math.abs(dy) + r;
    return GapRoot.sign((dx * dx + dy * dy) - r * r, size * size) > 0;
  }

  /** The time of the first contact with an end, from a time on before which there is none. */
  private static double endTime(
      boolean isStart, double px, double py, double r, double vx, double vy, double gx, double gy,
      double ax, double ay, double bx, double by, double ux, double uy, double from, double T) {
    double qx = isStart ? ax : bx;
    double qy = isStart ? ay : by;
    return ParabolaDiskSweep.certain(px, py, r, vx, vy, gx, gy, qx, qy, 0, ux, uy, from, T);
  }

  /**
   * Whether the height turns between two times: 1 if it does, -1 if it is monotone, 0 in doubt. It
   * does not turn if its slope has the same sign at both, or nothing but the velocity, or nothing
   * but the acceleration, changes it.
   *
   * @param sx the velocity of the disk less that of the line
   */
  static int turn(
      double sx, double sy, double gx, double gy, double wx, double wy, double from, double to) {
    double h1 = wx * sy - wy * sx;
    double h2 = 0.5 * (wx * gy - wy * gx);
    double m1 = Math.abs(wx * sy) + Math.abs(wy * sx);
    double m2 = 0.5 * (Math.abs(wx * gy) + Math.abs(wy * gx));
    if (isAlong(wx, wy, gx, gy) || (isAlong(wx, wy, sx, sy) && from == 0)) {
      return -1;
    }
    int first = GapRoot.sign(h1 + 2 * h2 * from, m1 + 2 * m2 * from);
    int last =
        to < GapRoot.LATEST
            ? GapRoot.sign(h1 + 2 * h2 * to, m1 + 2 * m2 * to)
            : GapRoot.sign(h2, m2);
    return -first * last;
  }

  /**
   * The time of a hit on the side by a disk that has left the strip, turned and comes again; NEVER
   * if it then is beyond an end, or later than the first hit of one or the window.
   */
  private static double again(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double vertex, double start,
      double first, double T) {
    double t = nearest(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, start);
    if (!(t > vertex)) {
      return GapRoot.DOUBT;
    }
    if (t > first || t > T) {
      return NEVER;
    }
    return switch (LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t)) {
      case LineRegion.BEFORE, LineRegion.BEYOND -> NEVER;
      case LineRegion.BESIDE -> t < T ? t : GapRoot.DOUBT;
      default -> GapRoot.DOUBT;
    };
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

  /**
   * The end of the window in which the disk can enter the strip.
   *
   * <p>It may be too early where h2 is all rounding error, below 2^-41 of its terms m2. Then the
   * gap at this end is so small a part of its terms that its sign is in doubt. It is certain only
   * later, if the height grows with h2. From then on the disk does not enter the strip.
   */
  static double reach(
      double wx, double wy, double gx, double gy, double h1, double h2, double m0, double m1,
      double m2, double T) {
    if (!isAlong(wx, wy, gx, gy)) {
      return GapRoot.reach(m0, m1, Math.abs(h2), T);
    }
    double speed = Math.abs(h1); // without cancellation: the line is along an axis
    double reach = 1.001 * (m0 / speed);
    return speed > 0x1p-600 && reach < T ? reach : T;
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

  /** The sign of the gap beside the line half an ulp after t, by double-double; 0 in doubt. */
  static int signAfter(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double t) {
    return GapRoot.signAfter(
        t,
        residue(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t),
        slope(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t),
        size(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t));
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
