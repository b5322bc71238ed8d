// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Gaps;
import dev.carom.internal.exact.Numbers;
import dev.carom.internal.exact.Ring;
import dev.carom.internal.exact.TurningGaps;

/**
 * A question to the detector: a disk with a constant acceleration, which may be 0, and an obstacle.
 * The obstacle is a line from a to b, or a disk around a = b. It moves with the velocity u.
 *
 * <p>The numbers are set for each question, by the methods below only, so that many are asked
 * without allocation. All is seen from the obstacle: {@code d = p - a} is the offset, {@code s = v
 * - u} the velocity, {@code w = b - a} the line, each rounded once.
 *
 * <p>Not safe for use by several threads.
 */
public final class Fall {

  /**
   * Factors by which a time or a distance becomes certainly less, or more, however it is rounded.
   */
  public static final double LESS = 1 - GapRoot.MARGIN;

  public static final double MORE = 1 + GapRoot.MARGIN;

  /**
   * A projection on the line, or a height, at a rounded time: differences 2, products 3, sums 3, of
   * the terms; half an ulp of time moves it by 1 of twice the terms: 10 u, and the terms are
   * computed.
   */
  private static final double PLACE_BOUND = 16 * 0x1p-53;

  /**
   * The same seen from an obstacle that turns. Times |c|^2 it is a polynomial of degree 4, so half
   * an ulp of time moves it by 4 u of the terms. The line times c^2 has 7 u, an offset 5 u, and a
   * sum of three products 4 u: 20 u, and the terms are computed.
   */
  private static final double TURNED_BOUND = 32 * 0x1p-53;

  private static final double TINY = 0x1p-600;

  private static final double MOST = 0x1p150;

  private static final ThreadLocal<Fall> OF_THREAD = ThreadLocal.withInitial(Fall::new);

  // The disk and its flight.
  public double px;
  public double py;
  public double r;
  public double vx;
  public double vy;
  public double gx;
  public double gy;

  // The obstacle. A line has the radius 0; one of no length is a disk.
  public double ax;
  public double ay;
  public double bx;
  public double by;
  public double radius;
  public double ux;
  public double uy;
  boolean isLine;

  /** Whether it is a line, if perhaps of no length. */
  boolean isSegment;

  // As seen from the obstacle.
  public double dx;
  public double dy;
  public double sx;
  public double sy;
  public double wx;
  public double wy;

  /** Whether the obstacle turns; then its velocity is 0. */
  private boolean turns;

  final Turn turn = new Turn();

  /** The first rung. */
  final DirectHit filter = new DirectHit(this);

  /** Its numbers are used again and again; null before the first question that comes to it. */
  private GapSearch search;

  /** Those for what turns; null before the first question about it. */
  private TurnWindow turnWindow;

  private TurningRoot turningRoot;

  /** The question about an end; null before the first one. */
  private Fall end;

  /** One for questions that are asked now and then; the next one of this thread sets it anew. */
  public static Fall ofThread() {
    return OF_THREAD.get();
  }

  /** Sets the disk and its flight, before the obstacle. */
  public Fall flight(
      double x,
      double y,
      double itsRadius,
      double itsVx,
      double itsVy,
      double itsGx,
      double itsGy) {
    px = x;
    py = y;
    r = itsRadius;
    vx = itsVx;
    vy = itsVy;
    gx = itsGx;
    gy = itsGy;
    return this;
  }

  /** Sets a line that moves with the velocity u. */
  public Fall line(
      double startX, double startY, double endX, double endY, double itsUx, double itsUy) {
    return obstacle(true, startX, startY, endX, endY, 0, itsUx, itsUy);
  }

  /** Sets a disk that moves with the velocity u. */
  public Fall disk(double x, double y, double itsRadius, double itsUx, double itsUy) {
    return obstacle(false, x, y, x, y, itsRadius, itsUx, itsUy);
  }

  /** Sets an obstacle from its row. */
  public Fall obstacle(ObstacleShape shape, double[] rows, int k, double itsUx, double itsUy) {
    double startX = rows[k + ObstacleShape.X];
    double startY = rows[k + ObstacleShape.Y];
    int end = k + shape.toEnd;
    double endX = rows[end + ObstacleShape.X];
    double endY = rows[end + ObstacleShape.Y];
    double itsRadius = shape.radius(rows, k);
    return obstacle(shape.toEnd > 0, startX, startY, endX, endY, itsRadius, itsUx, itsUy);
  }

  private Fall obstacle(
      boolean hasEnds,
      double startX,
      double startY,
      double endX,
      double endY,
      double itsRadius,
      double itsUx,
      double itsUy) {
    isSegment = hasEnds;
    ax = startX;
    ay = startY;
    bx = endX;
    by = endY;
    radius = itsRadius;
    ux = itsUx;
    uy = itsUy;
    dx = px - ax;
    dy = py - ay;
    sx = vx - ux;
    sy = vy - uy;
    wx = bx - ax;
    wy = by - ay;
    isLine = ax != bx || ay != by;
    turns = false;
    return this;
  }

  /**
   * Lets the obstacle, which was set with the velocity 0, turn about a pivot, see {@link Turn}.
   *
   * @param q1 the real part of q; it does not turn if both are 0
   */
  public Fall turn(double pivotX, double pivotY, double q1, double q2) {
    turn.set(pivotX, pivotY, q1, q2);
    turns = q2 != 0; // c stays real without it
    return this;
  }

  public boolean turns() {
    return turns;
  }

  /** Whether the end of the obstacle in a region of {@link Gaps} does not turn: at the pivot. */
  boolean rests(int region) {
    boolean isEnd = region == Gaps.BEYOND;
    return !turns || ((isEnd ? bx : ax) == turn.pivotX && (isEnd ? by : ay) == turn.pivotY);
  }

  /** The velocity at a time of the point of the obstacle that is at (x, y) then. */
  double velocityX(double y, double t) {
    return turns ? -turn.rate(t) * (y - turn.pivotY) : ux;
  }

  double velocityY(double x, double t) {
    return turns ? turn.rate(t) * (x - turn.pivotX) : uy;
  }

  /** The place at a time of the point of the obstacle that starts at (x, y). */
  double placeX(double x, double y, double t) {
    return turns ? turn.at(t).placeX(x, y) : fma(ux, t, x);
  }

  double placeY(double x, double y, double t) {
    return turns ? turn.at(t).placeY(x, y) : fma(uy, t, y);
  }

  /** The same question about one end of the line alone: that in a region of {@link Gaps}. */
  public Fall end(int region) {
    if (end == null) {
      end = new Fall();
    }
    boolean isEnd = region == Gaps.BEYOND;
    end.flight(px, py, r, vx, vy, gx, gy).disk(isEnd ? bx : ax, isEnd ? by : ay, 0, ux, uy);
    return turns ? end.turn(turn.pivotX, turn.pivotY, turn.q1, turn.q2) : end;
  }

  /** The second rung. */
  GapSearch search() {
    if (search == null) {
      search = new GapSearch(this);
    }
    return search;
  }

  /** The first rung of what turns. */
  TurnWindow turnWindow() {
    if (turnWindow == null) {
      turnWindow = new TurnWindow(this);
    }
    return turnWindow;
  }

  TurningRoot turningRoot() {
    if (turningRoot == null) {
      turningRoot = new TurningRoot(this);
    }
    return turningRoot;
  }

  /** The gaps on one rung of precision. */
  <P extends Ring<P>> Gaps<P> gaps(Numbers<P> of) {
    return turns ? turningGaps(of, new TurningGaps<>()) : gaps(of, new Gaps<>());
  }

  /** The same, put into given ones. */
  <P extends Ring<P>> Gaps<P> gaps(Numbers<P> of, Gaps<P> out) {
    P x = of.motion(px, ax, vx, ux, gx);
    P y = of.motion(py, ay, vy, uy, gy);
    P endX = isLine ? of.motion(px, bx, vx, ux, gx) : x;
    P endY = isLine ? of.motion(py, by, vy, uy, gy) : y;
    P line = of.difference(bx, ax);
    return out.set(x, y, endX, endY, line, of.difference(by, ay), of.difference(r, -radius));
  }

  /** The gaps of an obstacle that turns, put into given ones. */
  <P extends Ring<P>> TurningGaps<P> turningGaps(Numbers<P> of, TurningGaps<P> out) {
    double pivotX = turn.pivotX;
    double pivotY = turn.pivotY;
    P startX = of.difference(ax, pivotX);
    P startY = of.difference(ay, pivotY);
    return out.turn(of.line(1, 0, turn.q1), of.line(0, 0, turn.q2))
        .set(
            gx == 0 ? of.line(px, pivotX, vx) : of.motion(px, pivotX, vx, 0, gx),
            gy == 0 ? of.line(py, pivotY, vy) : of.motion(py, pivotY, vy, 0, gy),
            startX,
            startY,
            isLine ? of.difference(bx, pivotX) : startX,
            isLine ? of.difference(by, pivotY) : startY,
            of.difference(bx, ax),
            of.difference(by, ay),
            of.difference(r, -radius));
  }

  /** Whether the disk moves straight on, as seen from the obstacle. */
  public boolean isStraight() {
    return gx == 0 && gy == 0 && !turns;
  }

  /**
   * The offset from the start of the obstacle at a time, with the rounding of plain doubles; as
   * seen from an obstacle that turns, which stays where it starts.
   */
  public double roughX(double t) {
    return turns ? turnedBackX(t) : dx + (sx + 0.5 * gx * t) * t;
  }

  public double roughY(double t) {
    return turns ? turnedBackY(t) : dy + (sy + 0.5 * gy * t) * t;
  }

  private double turnedBackX(double t) {
    return turn.at(t).backX(fromPivotX(t), fromPivotY(t)) - (ax - turn.pivotX);
  }

  private double turnedBackY(double t) {
    return turn.at(t).backY(fromPivotX(t), fromPivotY(t)) - (ay - turn.pivotY);
  }

  /** The place of the centre, seen from the pivot. */
  double fromPivotX(double t) {
    return (px - turn.pivotX) + (vx + 0.5 * gx * t) * t;
  }

  double fromPivotY(double t) {
    return (py - turn.pivotY) + (vy + 0.5 * gy * t) * t;
  }

  /** The offset from a point q of the obstacle at a time, without its rounding error. */
  double x(double qx, double t) {
    return Offset.head(px, qx, vx, ux, gx, t);
  }

  double y(double qy, double t) {
    return Offset.head(py, qy, vy, uy, gy, t);
  }

  /** The rounding error of that offset. */
  double xTail(double qx, double t) {
    return Offset.tail(px, qx, vx, ux, gx, t);
  }

  double yTail(double qy, double t) {
    return Offset.tail(py, qy, vy, uy, gy, t);
  }

  /** The sum of the absolute values of the terms of that offset. */
  double sizeX(double qx, double t) {
    return Offset.size(px - qx, sx, gx, t);
  }

  double sizeY(double qy, double t) {
    return Offset.size(py - qy, sy, gy, t);
  }

  double speedX(double t) {
    return Offset.speed(vx, ux, gx, t);
  }

  double speedY(double t) {
    return Offset.speed(vy, uy, gy, t);
  }

  // Where the centre is, seen from the line, at the time that t is the rounding of.

  /** The region: before the start of the line, beside it, or beyond its end. */
  int region(double t) {
    return GapSearch.region(along(ax, ay, wx, wy, t), along(bx, by, wx, wy, t));
  }

  /** The side of the line, +1 left or -1 right; 0 in doubt. */
  int side(double t) {
    int side = along(ax, ay, -wy, wx, t);
    return side == GapPolynomial.UNKNOWN ? 0 : side;
  }

  /** The sign of e.(p(t) - q), which is 0 if it is so all the time. */
  private int along(double qx, double qy, double ex, double ey, double t) {
    if (turns) {
      return turnedAlong(qx - turn.pivotX, qy - turn.pivotY, ex, ey, t);
    }
    boolean isZeroX = ex == 0 || (px == qx && sx == 0 && gx == 0);
    if (isZeroX && (ey == 0 || (py == qy && sy == 0 && gy == 0))) {
      return 0;
    }
    double late = t + GapRoot.EARLIEST; // covers half an ulp of a subnormal time
    double value = ex * x(qx, t) + ey * y(qy, t);
    double terms = Math.abs(ex) * sizeX(qx, late) + Math.abs(ey) * sizeY(qy, late);
    double bound = fma(PLACE_BOUND, terms, TINY);
    boolean isCertain = Math.abs(value) > bound && t < MOST && Math.abs(ex) + Math.abs(ey) < MOST;
    return isCertain ? UnitVectors.sign(value) : GapPolynomial.UNKNOWN;
  }

  /** The same of a vector that turns, and an end q of the line, seen from the pivot. */
  private int turnedAlong(double qx, double qy, double ex, double ey, double t) {
    turn.at(t);
    double lineX = ex * turn.re - ey * turn.im;
    double lineY = ex * turn.im + ey * turn.re;
    double value = lineX * fromPivotX(t) + lineY * fromPivotY(t) - (ex * qx + ey * qy) * turn.n;
    double late = t + GapRoot.EARLIEST;
    double growth = 1 + (Math.abs(turn.q1) + Math.abs(turn.q2)) * late; // at least |c|
    double sizes =
        Math.abs(qx)
            + Math.abs(qy)
            + Offset.size(px - turn.pivotX, vx, gx, late)
            + Offset.size(py - turn.pivotY, vy, gy, late);
    double terms = (Math.abs(ex) + Math.abs(ey)) * sizes * growth * growth;
    double bound = fma(TURNED_BOUND, terms, TINY);
    boolean isCertain = Math.abs(value) > bound && t < MOST && terms < MOST;
    return isCertain ? UnitVectors.sign(value) : GapPolynomial.UNKNOWN;
  }
}
