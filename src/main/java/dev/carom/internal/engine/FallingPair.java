// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.FallReturn;
import dev.carom.internal.sweep.FallSweep;

/**
 * Two circles of which each may have an acceleration, at the start of the later of their flights.
 * Relative to each other, circles with the same acceleration move straight on.
 */
final class FallingPair {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Far more than the rounding of places and times, in proportion. */
  private static final double ROUNDING = 0x1p-20;

  private final CircleTable circles;

  /** The questions to the detector. */
  private final Fall fall = new Fall();

  private double x1;
  private double y1;
  private double vx1;
  private double vy1;
  private double r1;
  private double x2;
  private double y2;
  private double vx2;
  private double vy2;
  private double r2;

  /** The acceleration of the first less that of the second, each component rounded. */
  private double gx;

  private double gy;

  /** The one whose flight began later. */
  private int later;

  /** Whether both flights began at the same time. */
  private boolean together;

  FallingPair(CircleTable circles) {
    this.circles = circles;
  }

  /** Whether two circles have the same acceleration. */
  boolean fallAlike(int i, int j) {
    return circles.gx(i) == circles.gx(j) && circles.gy(i) == circles.gy(j);
  }

  /** The circle whose flight began later. */
  int later() {
    return later;
  }

  /** Takes two circles; false if they can never meet: both are points, or out of range. */
  boolean start(double[] s, int first, int second) {
    int a = CircleTable.collidingAt(first);
    int b = CircleTable.collidingAt(second);
    double delay =
        (s[b + FlightRow.T] - s[a + FlightRow.T]) + (s[b + FlightRow.TL] - s[a + FlightRow.TL]);
    double of1 = Math.max(0, delay);
    double of2 = Math.max(0, -delay);
    later = delay > 0 ? second : first;
    together = delay == 0;
    double gx1 = circles.gx(first);
    double gy1 = circles.gy(first);
    double gx2 = circles.gx(second);
    double gy2 = circles.gy(second);
    x1 = MovingCircle.place(s[a + FlightRow.X], s[a + FlightRow.VX], gx1, of1);
    y1 = MovingCircle.place(s[a + FlightRow.Y], s[a + FlightRow.VY], gy1, of1);
    vx1 = MovingCircle.velocity(s[a + FlightRow.VX], gx1, of1);
    vy1 = MovingCircle.velocity(s[a + FlightRow.VY], gy1, of1);
    r1 = s[a + FlightRow.RADIUS];
    x2 = MovingCircle.place(s[b + FlightRow.X], s[b + FlightRow.VX], gx2, of2);
    y2 = MovingCircle.place(s[b + FlightRow.Y], s[b + FlightRow.VY], gy2, of2);
    vx2 = MovingCircle.velocity(s[b + FlightRow.VX], gx2, of2);
    vy2 = MovingCircle.velocity(s[b + FlightRow.VY], gy2, of2);
    r2 = s[b + FlightRow.RADIUS];
    gx = gx1 - gx2;
    gy = gy1 - gy2;
    return Math.abs(x1 - x2) + Math.abs(y1 - y2) < NEVER && r1 + r2 > 0;
  }

  /** Whether two circles certainly do not meet within a time after the later start. */
  boolean isFar(double time) {
    double spare = (1 + ROUNDING) * time;
    double speeds = Math.abs(vx1 - vx2) + Math.abs(vy1 - vy2);
    double pulls = Math.abs(gx) + Math.abs(gy);
    double places = Math.abs(x1) + Math.abs(y1) + Math.abs(x2) + Math.abs(y2) + r1 + r2;
    double reach = r1 + r2 + spare * (speeds + spare * pulls) + ROUNDING * places;
    double dx = x1 - x2;
    double dy = y1 - y2;
    return dx * dx + dy * dy > reach * reach;
  }

  /** See {@link CollisionPredictor#roughTime}. */
  double roughTime() {
    return CollisionPredictor.roughTime(x1 - x2, y1 - y2, vx1 - vx2, vy1 - vy2, r1 + r2);
  }

  /**
   * The duration from the later start to the collision.
   *
   * @param known whether {@link #roughTime} told it
   * @param justMet whether they hit each other last: if both flights began there, it is the
   *     duration to their return
   * @param until later collisions of circles with different accelerations may be left out
   */
  double time(boolean known, boolean justMet, double until) {
    if (gx == 0 && gy == 0) {
      int contact =
          known ? Contact.LATER : DiskSweep.contact(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2);
      return DiskSweep.time(contact, x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, NEVER);
    }
    return justMet && together ? FallReturn.time(fall(), until) : FallSweep.time(fall(), until);
  }

  /** The duration to the first contact from outside that comes after a given one. */
  double timeAfter(double after) {
    if (gx == 0 && gy == 0) {
      double t = time(false, false, NEVER);
      return t > after ? t : NEVER;
    }
    return FallSweep.timeAfter(fall(), after, NEVER);
  }

  private Fall fall() {
    return fall.flight(x1, y1, r1, vx1, vy1, gx, gy).disk(x2, y2, r2, vx2, vy2);
  }
}
