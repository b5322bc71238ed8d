// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.Gaps;

/**
 * The quick filter for a disk with a constant acceleration: the first hit on a line or a disk, in
 * plain doubles. It finds a hit, and proves by the normal there that none comes before. Nearly all
 * questions of a search are answered here; the others are left open.
 *
 * <p>A line is convex, so it lies behind the tangent at a contact, which is perpendicular to the
 * normal n. At a time s before the time t of the contact, the disk was in front of the tangent if
 * {@code n.(p(s) - p(t))} is above 0. With the velocity v at the start, seen from the line, this is
 * {@code (s - t) n.(v + g (s + t) / 2)}, and the last factor is linear in s. So it suffices that
 * this factor is below 0 at {@code s = t}, where it is the speed of approach, and at {@code s = 0}.
 *
 * <p>The time of the contact is first found in plain doubles. The signs are shown to hold at all
 * times within {@link GapRoot#MARGIN} of that, so they hold at the true time. Then the time is
 * corrected in double-double. A disk that seems to touch nothing in time is shown to stay in front
 * of a tangent.
 *
 * <p>A disk that touches the obstacle at the start, within rounding, and leaves it comes into no
 * contact for a while: {@link #leaves}. The question is asked from then on. If it comes on, its gap
 * alone decides: {@link #regionOfStart}.
 */
final class DirectHit {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private static final double DOUBT = GapRoot.DOUBT;

  /**
   * The error of a product of a place and a speed, in units of its terms, if the time errs by
   * {@link GapRoot#MARGIN} of itself. In units of the margin, a place errs by twice its terms and a
   * speed by its terms. Rounding is far less.
   */
  private static final double ROUGH_BOUND = 4 * GapRoot.MARGIN;

  /** In units of the terms of a distance from a tangent: far more than its rounding. */
  private static final double ROUNDING = 0x1p-40;

  /** Underflow of fewer than 64 operations, times two factors of at most {@link #MOST}. */
  private static final double TINY = 0x1p-600;

  private static final double MOST = 0x1p150;

  /** Above this, the square of a normal has lost nothing to underflow. */
  private static final double LEAST_SQUARE = 0x1p-300;

  /** Steps towards a contact, while they are longer, in proportion, than the next number. */
  private static final int STEPS = 6;

  private static final double NEAR = 0x1p-10;

  /** How often a part of a way is halved. More would answer more questions, and cost more. */
  private static final int HALVINGS = 2;

  /** The first part of a flight from what is touched, of the way to the height of the start. */
  private static final double FIRST_PART = 0x1p-5;

  /** A speed along the normal is above this part of its terms, or its rounding may count. */
  private static final double LEAST_SPEED = 0x1p-24;

  private final Fall f;

  /** No contact begins before this time. */
  private double since;

  /** The end of the window. */
  private double windowEnd;

  /** The distance of a contact: the sum of the radii, or in a return that at the start. */
  private double reach;

  private boolean isReturn;

  // The normal at the start, the speed along it, 0 in doubt, up to when its sign lasts for certain,
  // and when the disk is again as high above the tangent as at the start.
  private double nx;
  private double ny;
  private double away;
  private double steady;
  private double level;

  // A point q of the obstacle: an end of the line, or the centre of the disk. The offset d from it
  // at the start, and the way e from it to the other end of the line; 0 of a disk.
  private double qx;
  private double qy;
  private double dx;
  private double dy;
  private double ex;
  private double ey;

  DirectHit(Fall f) {
    this.f = f;
  }

  /**
   * The correctly rounded time, {@code +infinity} if it is above T; NaN where this does not tell.
   *
   * @param about a time near which the hit is expected; infinite or NaN for none
   */
  double time(double about, double end) {
    windowEnd = end;
    reach = f.r + f.radius;
    isReturn = false;
    since = 0;
    double time = first(about);
    if (!Double.isNaN(time)) {
      return time;
    }
    findStart();
    return !leaves() ? DOUBT : since < windowEnd ? first(level) : NEVER;
  }

  /** The time of the first contact after {@link #since}. */
  private double first(double about) {
    from(false);
    if (!f.isLine) {
      double height = entry(-f.gy, f.gx); // that of the disk is the first to be reached
      return atPoint(since > 0 ? about : height > 0 ? height : 0);
    }
    double t = about < NEVER ? about : entry(ex, ey);
    // Straight on with the place and the velocity of that time, would the disk touch the start of
    // the line, its end, or the side between them? Products x |x| are squares that keep the sign.
    double x = x(t);
    double y = y(t);
    double speedX = f.sx + f.gx * t;
    double speedY = f.sy + f.gy * t;
    double start = x * speedY - y * speedX;
    double beyond = (x - ex) * speedY - (y - ey) * speedX;
    double along = f.r * (ex * speedX + ey * speedY);
    double scale = Math.copySign(ex * ex + ey * ey, ey * speedX - ex * speedY);
    double square = along * Math.abs(along);
    if (scale * (start * Math.abs(start)) + square > 0) {
      return atPoint(t);
    }
    return scale * (beyond * Math.abs(beyond)) + square < 0 ? from(true).atPoint(t) : atSide();
  }

  // A disk that touches the obstacle at the start, within rounding.

  /**
   * Finds the normal at the start, and for how long the disk certainly keeps moving along it, or
   * against it.
   *
   * <p>The speed along the normal to the nearest point is {@code n.v}. The normal turns no faster
   * than the disk moves. So in a time h the speed changes by {@code h |n.g| + h |v| |v|} at most,
   * with the greatest |v| until then.
   */
  private void findStart() {
    from(false);
    double part = nearestPart(dx, dy);
    nx = dx - part * ex;
    ny = dy - part * ey;
    double speed = nx * f.sx + ny * f.sy;
    double pull = -(nx * f.gx + ny * f.gy);
    double most = Math.abs(f.sx) + Math.abs(f.sy);
    level = pull * speed > 0 ? 2 * speed / pull : NEVER;
    steady = FIRST_PART * Math.min(Math.min(level, windowEnd), Math.abs(speed) / (most * most));
    double fastest = most + (Math.abs(f.gx) + Math.abs(f.gy)) * steady;
    double terms = Math.abs(dx) + Math.abs(dy) + part * (Math.abs(ex) + Math.abs(ey));
    double change = steady * (Math.abs(pull) + fastest * fastest);
    double least = 2 * (change + fma(ROUNDING, terms * fastest, TINY));
    away = Math.abs(speed) > least && Math.max(steady, fastest) < MOST ? speed : 0;
  }

  /**
   * Whether a disk is certain to leave the obstacle. Then no contact begins up to {@link #since}: at
   * first the disk moves away, and then it is in front of the tangent at the start, until it is
   * nearly as high above that as at the start.
   */
  private boolean leaves() {
    since = Math.min(level - steady, windowEnd);
    return away > 0 && isClear(nx, ny, steady, since);
  }

  /**
   * The region of {@link Gaps} in which a disk comes into contact up to the time {@link #steady},
   * all the time nearer; UNKNOWN if that is not certain. To be asked after {@link #time}.
   */
  int regionOfStart() {
    double distance = Math.sqrt(nx * nx + ny * ny);
    if (!(away < 0 && (distance - reach) * distance < -0.5 * away * steady)) {
      return Gaps.UNKNOWN;
    }
    if (!f.isLine || staysBeside(false, steady)) {
      return Gaps.BEFORE;
    }
    if (staysBeside(true, steady)) {
      return Gaps.BEYOND;
    }
    boolean isBeside =
        isBeyond(ex, ey, 0, 0, steady) && from(false).isBeyond(ex, ey, 0, 0, steady);
    return isBeside ? Gaps.BESIDE : Gaps.UNKNOWN;
  }

  /** Up to when a disk keeps coming nearer, or going away. */
  double steady() {
    return steady;
  }

  /**
   * The correctly rounded time at which a disk is again as near to the other disk as at the start,
   * {@code +infinity} if it is above T; NaN where this does not tell. It is not so near before it is
   * again as high above the tangent as at the start.
   */
  double timeOfReturn(double end) {
    windowEnd = end;
    from(false);
    reach = Math.sqrt(dx * dx + dy * dy);
    isReturn = true;
    double speed = dx * f.sx + dy * f.sy;
    double pull = -(dx * f.gx + dy * f.gy);
    double sizeX = Math.abs(dx);
    double sizeY = Math.abs(dy);
    double speeds = sizeX * Math.abs(f.sx) + sizeY * Math.abs(f.sy);
    double pulls = sizeX * Math.abs(f.gx) + sizeY * Math.abs(f.gy);
    if (!(speed > fma(LEAST_SPEED, speeds, TINY)
        && Math.abs(pull) > fma(LEAST_SPEED, pulls, TINY)
        && speeds + pulls < MOST)) {
      return DOUBT;
    }
    level = pull > 0 ? 2 * speed / pull : NEVER;
    since = Fall.LESS * level;
    return since < windowEnd ? atPoint(level) : NEVER;
  }

  /**
   * Whether the centre of a disk is certain to be before the start of a line, or beyond its end, up
   * to a time; exactly at a right angle to the line above that end counts, too.
   */
  boolean staysBeside(boolean isEnd, double end) {
    return from(isEnd).staysAtEnd() || isBeyond(-ex, -ey, 0, 0, end);
  }

  /** Whether the projection of the centre on the line is q all the time, which belongs to the end. */
  private boolean staysAtEnd() {
    boolean isZeroX = ex == 0 || (dx == 0 && f.sx == 0 && f.gx == 0);
    return isZeroX && (ey == 0 || (dy == 0 && f.sy == 0 && f.gy == 0));
  }

  /** Looks from the start of the line, or from its end. */
  private DirectHit from(boolean isEnd) {
    qx = isEnd ? f.bx : f.ax;
    qy = isEnd ? f.by : f.ay;
    dx = f.px - qx;
    dy = f.py - qy;
    ex = isEnd ? -f.wx : f.wx;
    ey = isEnd ? -f.wy : f.wy;
    return this;
  }

  /** The time of a hit on the side. */
  private double atSide() {
    double t = entry(ex, ey);
    if (!(t < Fall.MORE * windowEnd)) {
      return unlessMissed(windowEnd);
    }
    double side = Math.copySign(1, ex * dy - ey * dx);
    double nx = -side * ey;
    double ny = side * ex;
    if (!(f.r < MOST)
        || !isInFront(nx, ny, t)
        || !isApproach(nx, ny, Math.abs(nx), Math.abs(ny), since, t)) {
      return DOUBT;
    }
    double time = GapRoot.beside(t, GapRoot.nearestSide(f, t));
    return switch (f.region(time)) {
      case Gaps.BESIDE -> GapRoot.upTo(windowEnd, time);
      case Gaps.BEFORE -> atPoint(t);
      case Gaps.BEYOND -> from(true).atPoint(t);
      default -> DOUBT;
    };
  }

  /**
   * About when the centre enters the strip along a line with the vector w through the obstacle; 0
   * if it starts there and may stay, NaN if it seems not to enter it.
   */
  private double entry(double wx, double wy) {
    double h0 = wx * dy - wy * dx;
    double side = Math.copySign(1, h0);
    double gap = Math.abs(h0) - (f.r + f.radius) * Math.sqrt(wx * wx + wy * wy);
    if (gap <= 0 && since == 0) {
      return 0;
    }
    double fall = side * (wx * f.sy - wy * f.sx);
    double bend = 0.5 * side * (wx * f.gy - wy * f.gx);
    double root = Math.sqrt(fall * fall - 4 * gap * bend);
    if (fall < 0) {
      return 2 * gap / (root - fall);
    }
    return bend < 0 ? (fall + root) / (-2 * bend) : Double.NaN;
  }

  /**
   * Whether a centre is certain to be further along the normal n than the point q, at about the
   * time t.
   */
  private boolean isInFront(double nx, double ny, double t) {
    double height = nx * x(t) + ny * y(t);
    double sizeX = Math.abs(nx);
    double sizeY = Math.abs(ny);
    double bound = fma(ROUGH_BOUND, sizeX * sizeX(t) + sizeY * sizeY(t), TINY);
    return height > bound && t < MOST && sizeX + sizeY < MOST;
  }

  /**
   * Whether a centre is certain to move against a normal n, both at about the time t and in the
   * mean since an earlier time. Then it was in front of the tangent all the time between.
   *
   * @param sizeX the terms of nx
   */
  private boolean isApproach(
      double nx, double ny, double sizeX, double sizeY, double from, double t) {
    double middle = 0.5 * (from + t);
    double mean = nx * (f.sx + f.gx * middle) + ny * (f.sy + f.gy * middle);
    double last = nx * (f.sx + f.gx * t) + ny * (f.sy + f.gy * t);
    double speedX = Math.abs(f.sx) + Math.abs(f.gx) * t;
    double speedY = Math.abs(f.sy) + Math.abs(f.gy) * t;
    double bound = fma(ROUGH_BOUND, sizeX * speedX + sizeY * speedY, TINY);
    return mean < -bound && last < -bound && t > 0 && t < MOST && speedX + speedY < MOST;
  }

  /**
   * The time of a hit on an end q of a line, or on a disk there. Each step goes to the first root of
   * the quadratic part of the gap, or to its least value if there is none.
   *
   * @param about a time near which it is expected
   */
  private double atPoint(double about) {
    double t = about;
    boolean touches = true;
    boolean isNear = false;
    for (int i = 0; i < STEPS && !isNear; i++) {
      double x = x(t);
      double y = y(t);
      double vx = f.sx + f.gx * t;
      double vy = f.sy + f.gy * t;
      double gap = (x * x + y * y) - reach * reach;
      double slope = x * vx + y * vy; // half the rate of the gap
      double bend = (vx * vx + vy * vy) + (x * f.gx + y * f.gy);
      double root = Math.sqrt(slope * slope - gap * bend);
      touches = root >= 0;
      double step = touches ? gap / (root - slope) : -slope / bend;
      t += step;
      isNear = Math.abs(step) <= NEAR * t;
    }
    if (!touches || !(t > 0 && t < Fall.MORE * windowEnd)) {
      return unlessMissed(Math.min(Math.max(t, since), windowEnd));
    }
    boolean isAtEnd = !f.isLine || staysAtEnd() || isInFront(-ex, -ey, t);
    if (!isAtEnd || !isFirst(t)) {
      return DOUBT;
    }
    double nearest =
        isReturn ? GapRoot.nearestReturn(f, qx, qy, t) : GapRoot.nearestEnd(f, qx, qy, t);
    return GapRoot.upTo(windowEnd, GapRoot.beside(t, nearest));
  }

  // The way from the point q to the disk: its place at t, and the terms of that.

  private double x(double t) {
    return dx + (f.sx + 0.5 * f.gx * t) * t;
  }

  private double y(double t) {
    return dy + (f.sy + 0.5 * f.gy * t) * t;
  }

  private double sizeX(double t) {
    return Offset.size(dx, f.sx, f.gx, t);
  }

  private double sizeY(double t) {
    return Offset.size(dy, f.sy, f.gy, t);
  }

  /**
   * Whether a disk is certain not to touch the line before t. It is if it moves against the normal
   * at t all the time since then. If it comes from behind the tangent, it has to move so in the last
   * part of the way only; in the first part its chord has to be clear of the line.
   */
  private boolean isFirst(double t) {
    double nx = x(t);
    double ny = y(t);
    double sizeX = sizeX(t);
    double sizeY = sizeY(t);
    if (isApproach(nx, ny, sizeX, sizeY, since, t)) {
      return true;
    }
    double from = crest(nx, ny);
    boolean isLater = from > since && from < t && isApproach(nx, ny, sizeX, sizeY, from, t);
    return isLater && isChordClear(since, from);
  }

  /** The time at which the speed along a normal, {@code n.(s + g t)}, turns. */
  private double crest(double nx, double ny) {
    return -(nx * f.sx + ny * f.sy) / (nx * f.gx + ny * f.gy);
  }

  /**
   * NEVER if a disk is certain not to touch a line up to T, else NaN. It does not if it stays in
   * front of a tangent, or of another one in each part of the way. The parts end where the speed
   * along the first tangent's normal turns, and where the disk is closest; then they are halved.
   *
   * @param closest about when the disk is closest to the line
   */
  private double unlessMissed(double closest) {
    double x = x(closest);
    double y = y(closest);
    double part = nearestPart(x, y);
    double nx = x - part * ex;
    double ny = y - part * ey;
    double turn = crest(nx, ny);
    double from = turn > since && turn < closest ? turn : since;
    boolean isMissed =
        isClear(nx, ny, since, windowEnd)
            || ((from == since || isPartClear(nx, ny, since, from, HALVINGS))
                && isPartClear(nx, ny, from, closest, HALVINGS)
                && (closest == windowEnd || isPartClear(nx, ny, closest, windowEnd, HALVINGS)));
    return isMissed ? NEVER : DOUBT;
  }

  /** The part of the way from q to the other end at which the line is nearest to a place. */
  private double nearestPart(double x, double y) {
    double along = x * ex + y * ey;
    return along > 0 ? Math.min(1, along / (ex * ex + ey * ey)) : 0;
  }

  private boolean isPartClear(double nx, double ny, double from, double to, int halvings) {
    if (isClear(nx, ny, from, to) || isChordClear(from, to)) {
      return true;
    }
    double middle = 0.5 * (from + to);
    return halvings > 0
        && isPartClear(nx, ny, from, middle, halvings - 1)
        && isPartClear(nx, ny, middle, to, halvings - 1);
  }

  /** Whether a disk stays in front of a tangent along the chord of a part of its way. */
  private boolean isChordClear(double from, double to) {
    double x = x(from);
    double y = y(from);
    double nx = y - y(to);
    double ny = x(to) - x;
    double side = Math.copySign(1, nx * (x - 0.5 * ex) + ny * (y - 0.5 * ey));
    return isClear(side * nx, side * ny, from, to);
  }

  /**
   * Whether a disk is certain to stay in front of a tangent with the normal n: the Bernstein
   * coefficients of its distance from that, which is quadratic, are all above 0. Any normal will
   * do, for the tangent is moved to where the line is behind it.
   */
  private boolean isClear(double nx, double ny, double from, double to) {
    double distance = reach * Math.sqrt(nx * nx + ny * ny) + Math.max(0, nx * ex + ny * ey);
    return isBeyond(nx, ny, distance, from, to);
  }

  /** Whether the projection of a centre on n, seen from q, is certain to stay above a distance. */
  private boolean isBeyond(double nx, double ny, double distance, double from, double to) {
    double square = nx * nx + ny * ny;
    double r = f.r + f.radius;
    double first = nx * x(from) + ny * y(from);
    double speed = nx * (f.sx + f.gx * from) + ny * (f.sy + f.gy * from);
    double middle = first + speed * (0.5 * (to - from));
    double last = nx * x(to) + ny * y(to);
    double termsX = Math.abs(nx) * (r + Math.abs(ex) + sizeX(to));
    double terms = termsX + Math.abs(ny) * (r + Math.abs(ey) + sizeY(to));
    double least = distance + fma(ROUNDING, terms, TINY);
    return Math.min(first, Math.min(middle, last)) > least
        && square > LEAST_SQUARE
        && square < MOST
        && to < MOST;
  }
}
