// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.exact.Gaps;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.FallReturn;
import dev.carom.internal.sweep.FallSweep;
import dev.carom.internal.sweep.ParabolaWallSweep;

/**
 * When a circle with a constant acceleration next hits an obstacle, or any circle one that turns:
 * asks the detector, by the kind of obstacle: the one just hit, a sensor, a one-way line, the line
 * on which it slides, or any other.
 *
 * <p>Every question is asked for the whole flight up to the end of a window. So the answer does not
 * depend on how the search cuts the path.
 */
abstract class FallTimes extends FirstImpact {

  /** In units of the terms of a place: far more than its rounding. */
  private static final double ROUNDING = 0x1p-40;

  FallTimes(ObstacleTable obstacles) {
    super(obstacles);
  }

  /** Whether the obstacle was removed: a list may still name it. */
  final boolean isGone() {
    return Double.isNaN(fall.ax);
  }

  // Times.

  /** The time of the next impact with a wall up to the end of a window. */
  final double wallTime(int code, double to) {
    boolean isVertical = Codes.isVertical(code);
    double v = isVertical ? vx : vy;
    double g = isVertical ? fall.gx : fall.gy;
    int inward = Codes.inwards(code);
    return code == body.last
        ? FallReturn.toWall(v, g, inward, to)
        : ParabolaWallSweep.time(isVertical ? px : py, r, v, g, obstacles.walls[code], inward, to);
  }

  @Override
  RealRoot exactTime(int code, int contact, double t) {
    if (!Codes.isWall(code)) {
      chooseAny(code);
      return FallSweep.exact(fall).at(t);
    }
    boolean isVertical = Codes.isVertical(code);
    double v = isVertical ? vx : vy;
    double g = isVertical ? fall.gx : fall.gy;
    double wall = obstacles.walls[code];
    return ParabolaWallSweep.exact(isVertical ? px : py, r, v, g, wall, Codes.inwards(code)).at(t);
  }

  /**
   * The time of the next contact that counts with the obstacle chosen, up to the end of a window.
   *
   * @param about the time near which it is expected; infinite or NaN for none
   */
  final double time(int code, double about, double to) {
    if (special && obstacles.isSensor(code)) {
      return timeOfSensor(code, to);
    }
    if (special && obstacles.isOneWay(code)) {
      return timeOfOneWay(code, about, to);
    }
    double t = code == body.last ? timeOfReturn(code, to) : FallSweep.time(fall, about, to);
    return special && obstacles.outside(code) != 0 ? timeThatCounts(code, t, to) : t;
  }

  /**
   * A bit beyond: what is exactly later than a time, but rounds to it, ties with the best one. So
   * far beyond that such a tie is no matter of rounding at the end of the window.
   */
  static double asked(double to) {
    return to * Fall.MORE + Double.MIN_VALUE;
  }

  /** The time of a contact, or of the first one after it that counts. */
  private double timeThatCounts(int code, double first, double to) {
    double t = first;
    while (t <= to && t < NEVER && !counts(code, contactAt(code, t), t)) {
      t = FallSweep.timeAfter(fall, t, to);
    }
    return t;
  }

  private double timeOfReturn(int code, double to) {
    return code == body.landing ? timeAtEnds(to) : FallReturn.time(fall, to);
  }

  /** The next time at which a sensor that was not reported yet is entered. */
  private double timeOfSensor(int code, double to) {
    double after = code > sensedCode && sensed > 0 ? Math.nextDown(sensed) : sensed;
    double t = FallSweep.timeAfter(fall, Math.max(after, 0), to);
    return obstacles.isOutline(code) ? timeThatCounts(code, t, to) : t;
  }

  /** The time at which a circle that flew off an end of a line hits that or the other end. */
  private double timeAtEnds(double to) {
    boolean isAtStart = isNearerToStart();
    double back = FallReturn.time(fall.end(isAtStart ? Gaps.BEFORE : Gaps.BEYOND), to);
    double other = FallSweep.time(fall.end(isAtStart ? Gaps.BEYOND : Gaps.BEFORE), to);
    return Math.min(back, other);
  }

  private boolean isNearerToStart() {
    double toEndX = px - fall.bx;
    double toEndY = py - fall.by;
    return fall.dx * fall.dx + fall.dy * fall.dy < toEndX * toEndX + toEndY * toEndY;
  }

  /** The next time at which a one-way line is hit, see {@link OneWay}. */
  private double timeOfOneWay(int code, double about, double to) {
    if (code == body.last) {
      double t = timeOfReturn(code, to);
      if (t > to || t == NEVER || OneWay.isLeft(fall, t)) {
        return t;
      }
    } else if (OneWay.standsOn(fall) && FallSweep.time(fall, about, to) == 0) {
      return 0;
    }
    double t = FallSweep.timeAfter(fall, -1, to);
    while (t <= to && t < NEVER && !OneWay.isLeft(fall, t)) {
      t = FallSweep.timeAfter(fall, t, to);
    }
    return t;
  }

  /**
   * A time before which the circle cannot return to what it has just hit. That is convex, so it
   * lies behind the tangent at the contact, to which the circle does not return before {@code 2 v.n
   * / -g.n}. That holds unless it overlaps a line deeply, in which it may turn round. From an end
   * that it overlaps by d, it may return to the side earlier, by {@code d / v.n}.
   */
  final double earliestReturn() {
    if (!isLastFixed()) {
      return 0;
    }
    choose(body.last);
    double part = nearestPart();
    double nx = px - (fall.ax + part * (fall.bx - fall.ax));
    double ny = py - (fall.ay + part * (fall.by - fall.ay));
    double nn = nx * nx + ny * ny;
    double sum = r + fall.radius;
    double reach = Fall.LESS * sum;
    if (!(nn > reach * reach)) {
      return 0; // it overlaps that, and may come deeper; or n is NaN
    }
    // The normal errs by this, so speeds along it by that times theirs.
    double places = Math.abs(px) + Math.abs(py) + Math.abs(fall.ax) + Math.abs(fall.ay);
    double error = 0x1p-50 * (places + Math.abs(fall.bx) + Math.abs(fall.by));
    double away = vx * nx + vy * ny;
    double terms = Math.abs(vx * nx) + Math.abs(vy * ny);
    double termsOfError = error * (Math.abs(vx) + Math.abs(vy));
    if (!(away > 0x1p-24 * terms + 0x1p24 * termsOfError)) {
      return 0; // the relative error of that may exceed the margin
    }
    double pull =
        ROUNDING * (Math.abs(fall.gx * nx) + Math.abs(fall.gy * ny))
            + error * (Math.abs(fall.gx) + Math.abs(fall.gy))
            - (fall.gx * nx + fall.gy * ny);
    // At least 2 (sum - |n|) |n|. The return to the side beside an end is earlier by a quarter of
    // overlap pull / away^2, in proportion: far less than the margin.
    double overlap = Math.max(0, sum * sum - nn) + 4 * error * sum;
    boolean isAtEnd = part == 0 || part == 1;
    if (isAtEnd && !(overlap * pull <= 0x1p-22 * (away * away))) {
      return 0;
    }
    return pull > 0 ? Fall.LESS * (2 * away / pull) : NEVER;
  }

  /** Whether a line or a peg at rest was hit last. The return to a wall is computed as fast. */
  private boolean isLastFixed() {
    int code = body.last;
    return code >= 0
        && !Codes.isCircle(code)
        && !Codes.isWall(code)
        && !obstacles.moves(code)
        && !obstacles.isGone(code);
  }

  /** The part of the way along the spine to its point nearest to the centre; NaN if too long. */
  private double nearestPart() {
    double square = fall.wx * fall.wx + fall.wy * fall.wy;
    if (square == 0) {
      return 0;
    }
    double part = (fall.dx * fall.wx + fall.dy * fall.wy) / square;
    return square < NEVER ? Math.max(0, Math.min(1, part)) : Double.NaN;
  }

  // Slides.

  /** The time at which a circle that slides along a line comes to one of its ends. */
  final double endOfSlide() {
    int code = body.support;
    if (code == MovingCircle.NOTHING || Codes.isWall(code) || !Codes.isLine(code)) {
      return NEVER;
    }
    chooseAny(code);
    double speed = fall.wx * fall.sx + fall.wy * fall.sy;
    double pull = fall.wx * fall.gx + fall.wy * fall.gy;
    double beyond = fall.wx * (px - fall.bx) + fall.wy * (py - fall.by);
    double toEnd = reaches(beyond, speed, pull);
    double toStart = reaches(-(fall.wx * fall.dx + fall.wy * fall.dy), -speed, -pull);
    return Math.min(toEnd, toStart);
  }

  /** The first time at which c + v t + g t^2 / 2 becomes positive. */
  static double reaches(double c, double v, double g) {
    if (c >= 0) {
      return v > 0 || (v == 0 && g > 0) ? 0 : g > 0 ? -2 * v / g : NEVER;
    }
    double root = Math.sqrt(v * v - 2 * g * c);
    if (v < 0) { // v + root would cancel
      return g > 0 ? (root - v) / g : NEVER;
    }
    return v + root > 0 ? -2 * c / (v + root) : NEVER; // never also for NaN
  }

  // The contact.

  /** The {@link Contact} at the time of an impact. */
  final int contact(int code, double t) {
    if (Codes.isWall(code) || code == body.support) {
      return 0;
    }
    if (!Codes.isLine(code)) {
      return t == 0 ? Contact.NOW : Contact.LATER;
    }
    chooseAny(code);
    return contactAt(code, t);
  }

  /** The contact with the line chosen. */
  private int contactAt(int code, double t) {
    return isReturn(code, t) ? FallReturn.contact(fall, t) : FallSweep.contact(fall, t);
  }

  private boolean mayLetPass(int code) {
    return obstacles.isOneWay(code) || obstacles.outside(code) != 0;
  }

  /**
   * Whether an impact with the obstacle just hit is the return to it; a one-way line, or a side of
   * a solid polygon, may let pass.
   */
  private boolean isReturn(int code, double t) {
    return code == body.last
        && !obstacles.isSensor(code)
        && (!mayLetPass(code) || timeOfReturn(code, t) == t);
  }
}
