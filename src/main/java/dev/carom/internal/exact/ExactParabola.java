// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
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
  private static final RealRoot START = RealRoot.at(Dyadic.ZERO);

  /** The offset from the other disk, or from the line's start. */
  private final Polynomial x;

  private final Polynomial y;

  /** The vector of the line, as constants. */
  private final Polynomial lengthX;

  private final Polynomial lengthY;

  /** The projection on the line beyond its start and beyond its end; 0 if there is no line. */
  private final Polynomial alongStart;

  private final Polynomial alongEnd;

  /** The distance from the line times its length; 0 if there is no line. */
  private final Polynomial height;

  /** The gaps before the start, beside the line and beyond the end; one gap if there is no line. */
  private final Polynomial[] gaps;

  private final boolean isPoint;

  private ExactParabola(Polynomial x, Polynomial y, Dyadic r) {
    this.x = x;
    this.y = y;
    lengthX = NONE;
    lengthY = NONE;
    alongStart = NONE;
    alongEnd = NONE;
    height = NONE;
    gaps = new Polynomial[] {x.times(x).plus(y.times(y)).minus(constant(r.square()))};
    isPoint = r.sign() == 0;
  }

  private ExactParabola(Polynomial x, Polynomial y, Dyadic r, Dyadic wx, Dyadic wy) {
    this.x = x;
    this.y = y;
    Polynomial px = constant(wx);
    Polynomial py = constant(wy);
    lengthX = px;
    lengthY = py;
    Polynomial ww = constant(wx.square().plus(wy.square()));
    Polynomial rr = constant(r.square());
    alongStart = px.times(x).plus(py.times(y));
    alongEnd = alongStart.minus(ww);
    height = px.times(y).minus(py.times(x));
    Polynomial endX = x.minus(px);
    Polynomial endY = y.minus(py);
    gaps =
        new Polynomial[] {
          x.times(x).plus(y.times(y)).minus(rr),
          height.times(height).minus(rr.times(ww)),
          endX.times(endX).plus(endY.times(endY)).minus(rr)
        };
    isPoint = r.sign() == 0;
  }

  /** A wall has a gap that is linear in the place. */
  private ExactParabola(Polynomial gap) {
    x = NONE;
    y = NONE;
    lengthX = NONE;
    lengthY = NONE;
    alongStart = NONE;
    alongEnd = NONE;
    height = NONE;
    gaps = new Polynomial[] {gap};
    isPoint = false;
  }

  /** Against a disk that moves straight on. */
  public static ExactParabola disk(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2) {
    return new ExactParabola(
        motion(x1, x2, vx1, vx2, gx),
        motion(y1, y2, vy1, vy2, gy),
        Dyadic.of(r1).plus(Dyadic.of(r2)));
  }

  /**
   * Against a line that is from a to b at the start and moves with the velocity u; one of no length
   * is a disk of radius 0.
   */
  public static ExactParabola line(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy) {
    if (ax == bx && ay == by) {
      return disk(px, py, r, vx, vy, gx, gy, ax, ay, 0, ux, uy);
    }
    return new ExactParabola(
        motion(px, ax, vx, ux, gx),
        motion(py, ay, vy, uy, gy),
        Dyadic.of(r),
        Dyadic.difference(bx, ax),
        Dyadic.difference(by, ay));
  }

  /**
   * Against a wall, on one axis.
   *
   * @param inward +1 if the disk is to stay above the wall, -1 if below
   */
  public static ExactParabola wall(
      double p, double r, double v, double g, double wall, int inward) {
    Polynomial place = motion(p, wall, v, 0, g);
    Polynomial distance = inward > 0 ? place : NONE.minus(place);
    return new ExactParabola(distance.minus(constant(Dyadic.of(r))));
  }

  /** Back to a wall: the gap {@code v t + g t^2 / 2}, a negative v counting as 0. */
  public static ExactParabola returnToWall(double v, double g, int inward) {
    Dyadic away = Dyadic.of(inward * v);
    return returning(away, Dyadic.of(inward * g).half(), Dyadic.ZERO, Dyadic.ZERO);
  }

  /** Back to the height above a line at the start. */
  public static ExactParabola returnToSide(
      int side, double vx, double vy, double gx, double gy, double ax, double ay, double bx,
      double by) {
    Dyadic away = Exact.cross(bx, by, ax, ay, side * vx, side * vy, 0, 0);
    Dyadic lift = Exact.cross(bx, by, ax, ay, side * gx, side * gy, 0, 0);
    return returning(away, lift.half(), Dyadic.ZERO, Dyadic.ZERO);
  }

  /** Back to the distance from a disk at the start. */
  public static ExactParabola returnToDisk(
      double x1, double y1, double vx1, double vy1, double gx, double gy, double x2, double y2,
      double vx2, double vy2) {
    Dyadic[] d = {Dyadic.difference(x1, x2), Dyadic.difference(y1, y2)};
    Dyadic[] u = {Dyadic.difference(vx1, vx2), Dyadic.difference(vy1, vy2)};
    Dyadic[] g = {Dyadic.of(gx), Dyadic.of(gy)};
    return returning(
        dot(d, u).times(Dyadic.of(2)),
        dot(u, u).plus(dot(d, g)),
        dot(u, g),
        dot(g, g).half().half());
  }

  private static Dyadic dot(Dyadic[] a, Dyadic[] b) {
    return a[0].times(b[0]).plus(a[1].times(b[1]));
  }

  /** The gap from its coefficients after the constant one, which is 0. */
  private static ExactParabola returning(Dyadic away, Dyadic c2, Dyadic c3, Dyadic c4) {
    Dyadic c1 = away.sign() > 0 ? away : Dyadic.ZERO;
    return new ExactParabola(Polynomial.of(Dyadic.ZERO, c1, c2, c3, c4));
  }

  /** The time of impact; null for none up to the window's end T. */
  public RealRoot first(double T) {
    PrecisionCounters.exactParabola();
    RealRoot first =
        !isPoint
            ? firstFall(T == Double.POSITIVE_INFINITY ? null : RealRoot.after(T))
            : height.isZero() && !alongStart.isZero() ? firstEnd() : firstOfPoint();
    boolean isLate =
        first != null && T < Double.POSITIVE_INFINITY && first.compare(Dyadic.of(T)) > 0;
    return isLate ? null : first;
  }

  /** 0, or the first border up to a limit, after which the gap falls; null for none. */
  private RealRoot firstFall(RealRoot limit) {
    RealRoot root = START;
    for (RealRoot next : borders(limit)) {
      if (root.compare(next) != 0 && falls(root.between(next))) {
        return root;
      }
      root = next;
    }
    return falls(limit == null ? root.after() : root.between(limit)) ? root : null;
  }

  /** The correctly rounded time of impact, {@code +infinity} for none up to the window's end T. */
  public double time(double T) {
    RealRoot root = first(T);
    return root == null ? Double.POSITIVE_INFINITY : root.nearest();
  }

  /** The region at a time: -1 before the start, 0 beside the line, 1 beyond its end. */
  public int region(RealRoot t) {
    return t.sign(alongStart) <= 0 ? -1 : t.sign(alongEnd) >= 0 ? 1 : 0;
  }

  /** The side of the line just before an impact: +1 left, -1 right. */
  public int side(RealRoot t) {
    int sign = t.sign(height);
    return sign != 0 ? sign : -t.sign(height.derivative());
  }

  /**
   * The unit vector from the other disk, or the end of the line, to this one at an impact. Where
   * their offset vanishes, it is the limit from before: against the velocity.
   */
  public UnitVector normal(RealRoot t) {
    if (isPoint) {
      return t.unit(NONE.minus(x.derivative()), NONE.minus(y.derivative()));
    }
    boolean end = !alongStart.isZero() && region(t) > 0;
    return end ? t.unit(x.minus(lengthX), y.minus(lengthY)) : t.unit(x, y);
  }

  /** Whether a point that hits an end of a line was beside the line just before. */
  public boolean comesFromSide(RealRoot t) {
    return isBefore(alongStart, t, 1) && isBefore(alongEnd, t, -1);
  }

  /** Whether a quadratic polynomial has a sign just before a time. */
  private static boolean isBefore(Polynomial along, RealRoot t, int sign) {
    int at = t.sign(along);
    int slope = -t.sign(along.derivative());
    int bend = t.sign(along.derivative().derivative());
    return (at != 0 ? at : slope != 0 ? slope : bend) == sign;
  }

  /** The times before a limit, null for none, at which the gap may begin to fall, in order. */
  private List<RealRoot> borders(RealRoot limit) {
    List<RealRoot> borders = new ArrayList<>();
    Stream.concat(
            Stream.of(gaps).flatMap(gap -> Stream.of(gap, gap.derivative())),
            Stream.of(alongStart, alongEnd))
        .forEach(f -> borders.addAll(f.positiveRoots(limit)));
    Collections.sort(borders, RealRoot::compare);
    return borders;
  }

  /** Whether the gap at a time is not above 0 and falls. */
  private boolean falls(Dyadic t) {
    Polynomial gap = gaps[gaps.length == 1 ? 0 : 1 + region(RealRoot.at(t))];
    return gap.sign(t) <= 0 && gap.derivative().sign(t) < 0;
  }

  /** A point that comes to a point, or to a line and not along it. */
  private RealRoot firstOfPoint() {
    Polynomial distance = alongStart.isZero() ? x.gcd(y) : height;
    for (RealRoot root : distance.positiveRoots(null)) {
      if (alongStart.isZero() ? isMoving(root) : isMet(root)) {
        return root;
      }
    }
    return null;
  }

  private boolean isMoving(RealRoot t) {
    return t.sign(x.derivative()) != 0 || t.sign(y.derivative()) != 0;
  }

  /** Whether a point that is in line with the line at a time hits it: from a side, or an end. */
  private boolean isMet(RealRoot t) {
    int start = t.sign(alongStart);
    int end = t.sign(alongEnd);
    if (start < 0 || end > 0) {
      return false;
    }
    return t.sign(height.derivative()) != 0
        || (start == 0 && t.sign(alongStart.derivative()) > 0)
        || (end == 0 && t.sign(alongEnd.derivative()) < 0);
  }

  /** A point that moves along the line's direction, in line with it. */
  private RealRoot firstEnd() {
    RealRoot start = firstPassage(alongStart, 1);
    RealRoot end = firstPassage(alongEnd, -1);
    return start == null || (end != null && end.compare(start) < 0) ? end : start;
  }

  private static RealRoot firstPassage(Polynomial along, int direction) {
    for (RealRoot root : along.positiveRoots(null)) {
      if (root.sign(along.derivative()) == direction) {
        return root;
      }
    }
    return null;
  }

  /** (p - q) + (v - u) t + g / 2 t^2. */
  private static Polynomial motion(double p, double q, double v, double u, double g) {
    return Polynomial.of(Dyadic.difference(p, q), Dyadic.difference(v, u), Dyadic.of(g).half());
  }

  private static Polynomial constant(Dyadic value) {
    return Polynomial.of(value);
  }
}
