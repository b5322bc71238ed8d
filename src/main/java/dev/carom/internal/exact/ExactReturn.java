// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * When a disk with a constant acceleration comes back to the thing that it has just hit, in exact
 * numbers.
 *
 * <p>The gap of that thing counts from the start: it is 0 there, whatever the rounded place says.
 * Its slope there counts as 0 if it is negative. The other parts of a line have the gaps that the
 * rounded place gives them.
 */
public final class ExactReturn {

  /** Against the part that was hit alone. */
  private final ExactParabola own;

  /** Against the whole line; null if the thing is no line. */
  private final ExactParabola line;

  /** The region of the line that was hit. */
  private final int part;

  /** The side of the line: +1 left, -1 right. */
  private final int side;

  private ExactReturn(Polynomial gap) {
    this(gap, null, Gaps.BEFORE, 0);
  }

  private ExactReturn(Polynomial gap, ExactParabola line, int part, int side) {
    own = ExactParabola.ofGap(gap.fromStart());
    this.line = line;
    this.part = part;
    this.side = side;
  }

  /**
   * To a wall, on one axis.
   *
   * @param inward +1 if the disk is above the wall, -1 if below
   */
  public static ExactReturn toWall(double v, double g, int inward) {
    return new ExactReturn(signed(inward, ExactParabola.motion(0, 0, v, 0, g)));
  }

  /**
   * To the height above the infinite line at the start.
   *
   * @param side +1 if the disk is left of the line, -1 if right
   */
  public static ExactReturn toSide(
      int side, double vx, double vy, double gx, double gy, double ax, double ay, double bx,
      double by, double ux, double uy) {
    return new ExactReturn(rise(side, vx, vy, gx, gy, ax, ay, bx, by, ux, uy));
  }

  /** The height of the centre above that at the start, times the length of the line. */
  private static Polynomial rise(
      int side, double vx, double vy, double gx, double gy, double ax, double ay, double bx,
      double by, double ux, double uy) {
    Polynomial x = ExactParabola.motion(0, 0, vx, ux, gx);
    Polynomial y = ExactParabola.motion(0, 0, vy, uy, gy);
    Polynomial wx = Polynomial.of(Dyadic.difference(bx, ax));
    Polynomial wy = Polynomial.of(Dyadic.difference(by, ay));
    return signed(side, wx.times(y).minus(wy.times(x)));
  }

  /** To the distance from a disk at the start. */
  public static ExactReturn toDisk(
      double x1, double y1, double vx1, double vy1, double gx, double gy, double x2, double y2,
      double vx2, double vy2) {
    Polynomial x = ExactParabola.motion(x1, x2, vx1, vx2, gx);
    Polynomial y = ExactParabola.motion(y1, y2, vy1, vy2, gy);
    return new ExactReturn(x.times(x).plus(y.times(y)));
  }

  /**
   * To a line that is from a to b at the start and moves with the velocity u. The disk touches the
   * part in whose region its centre is then.
   */
  public static ExactReturn toLine(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy) {
    if (ax == bx && ay == by) {
      return toDisk(px, py, vx, vy, gx, gy, ax, ay, ux, uy);
    }
    ExactParabola line = ExactParabola.line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy);
    int part = line.region(ExactParabola.START);
    if (part != Gaps.BESIDE) {
      return new ExactReturn(line.gap(part), line, part, 0);
    }
    int side = line.sideAtStart();
    Polynomial rise = rise(side, vx, vy, gx, gy, ax, ay, bx, by, ux, uy);
    return new ExactReturn(rise, line, part, side);
  }

  private static Polynomial signed(int sign, Polynomial f) {
    return sign > 0 ? f : Polynomial.of().minus(f);
  }

  /** The correctly rounded time of the return, {@code +infinity} for none up to T. */
  public double time(double T) {
    RealRoot root = first(T);
    return root == null ? Double.POSITIVE_INFINITY : root.nearest();
  }

  /** The time of the return; null for none up to the window's end T. */
  public RealRoot first(double T) {
    PrecisionCounters.exactParabola();
    RealRoot back = own.firstFrom(ExactParabola.START, T);
    if (line == null) {
      return back;
    }
    return part == Gaps.BESIDE ? fromSide(back, T) : fromEnd(back, T);
  }

  /** A return to the side beyond an end of the line is none: that end can be hit from then on. */
  private RealRoot fromSide(RealRoot back, double T) {
    if (back == null || line.isBeside(back)) {
      return back;
    }
    return line.part(line.region(back)).firstFrom(back, T);
  }

  private RealRoot fromEnd(RealRoot back, double T) {
    if (back != null && back.compare(Dyadic.ZERO) == 0) {
      return back;
    }
    RealRoot next = line.withGap(part, own).firstFall(T);
    if (!line.isPoint()) {
      return next;
    }
    RealRoot other = line.firstOfPoint(part, T);
    return next == null || (other != null && other.compare(next) < 0) ? other : next;
  }

  /** The region of the line at a time. */
  public int region(RealRoot t) {
    return line.region(t);
  }

  /** The side of the line that is hit at a time: +1 left, -1 right. */
  public int side(RealRoot t) {
    return part == Gaps.BESIDE ? side : line.side(t);
  }
}
