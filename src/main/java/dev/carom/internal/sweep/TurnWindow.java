// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.Gaps;

/**
 * The quick filter for an obstacle that turns, in plain doubles: it narrows the window in which a
 * contact may be, from both sides, or finds that there is none.
 *
 * <p>Seen from the obstacle, it rests, and the centre y of the disk moves on a curve. The distance
 * D of y from a convex set is convex in y, with the unit normal n as its gradient. So in time
 * {@code D'' >= n.y''}, and after a time h
 *
 * <pre>
 * D >= D(0) + a h - A h^2 / 2    a = n.y'    A = most of |y''|
 * </pre>
 *
 * <p>Up to the second root of this less the radius there is no contact: either the disk is clear of
 * the obstacle, or, as long as {@code a > A h}, it moves away. The same holds for a window that
 * ends clear, backwards. With the angular velocity w, the place p from the pivot and the velocity
 * v, {@code |y''| <= |g| + (|w'| + w^2) |p| + 2 |w| |v|}. The first set is the disk about the pivot
 * in which the obstacle stays; there y'' is g.
 */
final class TurnWindow {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** In units of the terms of a distance or a speed: far more than their rounding. */
  private static final double ROUNDING = 0x1p-40;

  /** More than what underflows: a square root of that. */
  private static final double TINY = 0x1p-500;

  /** Newton steps to a contact, until it is near enough to be corrected. They cost time only. */
  private static final int CORRECTIONS = 5;

  private static final double NEAR = 0x1p-24;

  /** Steps from one side. More would narrow the window further, and cost more. */
  private static final int STEPS = 3;

  /** The search ends when a step is a lesser part of what is left. */
  private static final double LEAST_STEP = 0x1p-6;

  /** The least |c|^2, of 1 at the start, with which rates are bounded. A turn has 0.85 at least. */
  private static final double LEAST_SQUARE = 0x1p-4;

  private final Fall f;

  /** No contact begins before this time, or after that one. */
  double from;

  double to;

  private double speed;
  private double pull;
  private double margin;
  private double reach;

  /** The bound A, and that of the speed |y'|. */
  private double bend;

  private double fastest;

  // The offset from what is seen at a time, and its product with the velocity; the rate.
  private double x;
  private double y;
  private double rise;
  private double rate;

  // The distance less the reach, how fast it grows, and the error of that.
  private double gap;
  private double growth;
  private double error;

  TurnWindow(Fall f) {
    this.f = f;
  }

  /**
   * Narrows a window, and returns whether there is certainly no contact in it.
   *
   * @param end if it is infinite, the window stays as it is
   * @param isReturn whether the obstacle is touched at the start by definition
   */
  boolean isClear(double start, double end, boolean isReturn) {
    from = start;
    to = end;
    bend = NEVER;
    double startX = f.ax - f.turn.pivotX;
    double startY = f.ay - f.turn.pivotY;
    double endX = f.bx - f.turn.pivotX;
    double endY = f.by - f.turn.pivotY;
    double square = Math.max(startX * startX + startY * startY, endX * endX + endY * endY);
    double far = Math.sqrt(square);
    double place = Math.abs(f.px - f.turn.pivotX) + Math.abs(f.py - f.turn.pivotY);
    pull = Math.sqrt(f.gx * f.gx + f.gy * f.gy) + TINY;
    speed = Math.sqrt(f.vx * f.vx + f.vy * f.vy) + pull * to + TINY;
    double r = f.r + f.radius;
    margin = fma(ROUNDING, place + speed * to + far + r, TINY);
    if (!(margin < NEVER)) {
      return false;
    }
    if (isReturn) {
      reach = 0;
      look(true, from);
      if (growth < -error) {
        return false; // that counts as none, so the distance does not tell
      }
      r = Math.max(r, gap + margin); // the distance at the start
    }
    reach = far + r;
    if (narrows(false, pull)) {
      return true;
    }
    reach = r;
    double least = f.turn.least(from, to);
    if (!(least > LEAST_SQUARE)) {
      return false;
    }
    findBounds(least);
    return narrows(true, bend);
  }

  /**
   * The correctly rounded time of the contact in the window, which {@link #isClear} left open;
   * {@code +infinity} if it is above T, NaN where this does not tell.
   *
   * <p>A distance D of half of the reach R or more has {@code D'' <= A + 2 |y'|^2 / R}. If by that
   * it falls from the start of the window on until it seems to be R, it is so once: below R / 2 the
   * disk would not come back in time.
   */
  double hit(double T) {
    double t = from;
    look(true, t);
    double least = gap > 0 ? growth + error : NEVER;
    for (int i = 0; i < CORRECTIONS && Math.abs(gap + margin) > NEAR * reach; i++) {
      t -= (gap + margin) / growth;
      if (!(t >= from && t <= to)) {
        return GapRoot.DOUBT;
      }
      look(true, t);
    }
    double wait = t * (1 + GapRoot.MARGIN) - from;
    int region = f.isLine ? f.region(t) : Gaps.BEFORE;
    if (!(least + wait * (bend + 2 * fastest * fastest / reach) < 0) || region == Gaps.UNKNOWN) {
      return GapRoot.DOUBT;
    }
    double time = GapRoot.beside(t, f.turningRoot().nearest(region, t));
    boolean isThere = !f.isLine || f.region(time) == region;
    return isThere ? GapRoot.upTo(T, time) : GapRoot.DOUBT;
  }

  /** Bounds the speed and the acceleration in the window, as seen from the obstacle. */
  private void findBounds(double least) {
    double q1 = Math.abs(f.turn.q1);
    double q2 = Math.abs(f.turn.q2);
    double rate = 2 * q2 / least;
    double change = 2 * rate / least * (q1 + (q1 * q1 + q2 * q2) * to);
    double width = to - from;
    double place = Math.max(place(from), place(to)) + 0.125 * pull * width * width;
    bend = 1.001 * (pull + (change + rate * rate) * place + 2 * rate * speed);
    fastest = 1.001 * (speed + rate * place);
  }

  private double place(double t) {
    double x = f.fromPivotX(t);
    double y = f.fromPivotY(t);
    return Math.sqrt(x * x + y * y);
  }

  /** Narrows the window, and returns whether nothing is left. */
  private boolean narrows(boolean isObstacle, double acceleration) {
    boolean isNarrowed = true;
    for (int i = 0; i < STEPS && isNarrowed; i++) {
      double width = to - from;
      look(isObstacle, from);
      double step = isObstacle || gap > 0 ? step(growth, acceleration) : 0;
      from += step;
      if (step > 0 && from >= to) {
        return true;
      }
      look(isObstacle, to);
      step = gap > 0 ? step(-growth, acceleration) : 0;
      to -= step;
      if (step > 0 && from >= to) {
        return true;
      }
      isNarrowed = to - from < (1 - LEAST_STEP) * width;
    }
    return false;
  }

  /** For how long there is no contact; 0 if that is not known. */
  private double step(double rate, double acceleration) {
    double a = rate - error;
    double square = a * a + 2 * acceleration * gap;
    if (!(square >= 0 && (a > 0 || gap > 0))) {
      return 0;
    }
    double root = Math.sqrt(square);
    return a > 0 ? (a + root) / acceleration : 2 * gap / (root - a);
  }

  /** Sees the disk about the pivot, or the obstacle. */
  private void look(boolean isObstacle, double t) {
    if (isObstacle) {
      see(Gaps.UNKNOWN, t);
    } else {
      x = f.fromPivotX(t);
      y = f.fromPivotY(t);
      rise = x * (f.vx + f.gx * t) + y * (f.vy + f.gy * t);
      rate = 0;
    }
    double distance = Math.sqrt(x * x + y * y);
    growth = rise / distance;
    gap = distance - reach - margin;
    // The normal errs by the margin over the distance.
    error = fma(speed + Math.abs(rate) * place(t), ROUNDING + margin / distance, TINY);
  }

  /**
   * Sees the offset of the centre from the part of the obstacle in a region, or if that is UNKNOWN,
   * from the nearest one.
   */
  private void see(int region, double t) {
    Turn c = f.turn.at(t);
    rate = 2 * c.q2 / c.n;
    double px = f.fromPivotX(t);
    double py = f.fromPivotY(t);
    double vx = f.vx + f.gx * t + rate * py;
    double vy = f.vy + f.gy * t - rate * px;
    x = c.backX(px, py) - (f.ax - c.pivotX);
    y = c.backY(px, py) - (f.ay - c.pivotY);
    double along = x * f.wx + y * f.wy;
    double part = along / (f.wx * f.wx + f.wy * f.wy);
    if (region != Gaps.BESIDE) {
      boolean isEnd = region == Gaps.UNKNOWN ? part >= 1 : region == Gaps.BEYOND;
      boolean isStart = region == Gaps.UNKNOWN ? !(part > 0) : region == Gaps.BEFORE;
      part = isEnd ? 1 : isStart ? 0 : part;
    }
    x -= part * f.wx;
    y -= part * f.wy;
    rise = x * c.backX(vx, vy) + y * c.backY(vx, vy);
  }

  /**
   * The derivative of a gap of {@link dev.carom.internal.exact.TurningGaps} near a root, where that
   * of its factor does not count.
   */
  double slope(int region, double t) {
    see(region, t);
    double n = f.turn.n;
    return 2 * rise * (region == Gaps.BESIDE ? n * n * (f.wx * f.wx + f.wy * f.wy) : n);
  }
}
