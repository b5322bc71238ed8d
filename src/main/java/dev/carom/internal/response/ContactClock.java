// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

/**
 * The clock of contact: ticks at multiples of a power of two, tau, that the pull and the radius of
 * each awake circle decide. The pull is gravity, or what something that turns does if that is more.
 * Clocks are nested. A tick may be cut; the next one then ends where the cut one would have.
 */
final class ContactClock {

  /** The largest pull. */
  double pull;

  /** The length of a tick, and the end of the present one. */
  double tau;

  double end = Double.POSITIVE_INFINITY;

  /** The end of the present tick if it is not cut: circles leave then. */
  double due;

  ContactClock(double g) {
    pull = g;
  }

  /**
   * The power of two nearest to the time of a fall of {@link ContactLaw#FALL} radii; infinite
   * without a pull.
   */
  static double ownTick(double radius, double pull) {
    if (pull == 0) {
      return Double.POSITIVE_INFINITY;
    }
    double time = Math.sqrt(2 * ContactLaw.FALL * radius / pull);
    double power = Math.scalb(1.0, Math.getExponent(time));
    return time * time > 2 * power * power ? 2 * power : power;
  }

  /** What the largest pull adds to a speed in a tick. */
  double kick() {
    return pull * tau;
  }

  /** The least approach that is not slow. */
  double slow() {
    return slow(pull);
  }

  /** The same for a pair with its own pull. */
  double slow(double itsPull) {
    return ContactLaw.SLOW * itsPull * tau;
  }

  /** The same for a circle with its own clock. */
  static double slowOf(double radius, double pull) {
    return pull == 0 ? 0 : ContactLaw.SLOW * pull * ownTick(radius, pull);
  }

  /** The first multiple of a tick after a time; the next double, where ticks are shorter. */
  private static double after(double time, double tick) {
    return Math.max((Math.floor(time / tick) + 1) * tick, Math.nextUp(time));
  }

  /** Starts the clock. */
  void start(double tick, double now) {
    tau = tick;
    due = after(now, tau);
    end = due;
  }

  /** Makes ticks as short as a given one. */
  void refine(double tick, double now) {
    if (tick < tau) {
      tau = tick;
      due = Math.min(due, after(now, tick));
      end = Math.min(end, due);
    }
  }

  /** Ends the present tick now. */
  void cut(double now) {
    end = Math.min(end, now);
  }
}
