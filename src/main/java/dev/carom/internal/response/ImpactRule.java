// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;

/**
 * When a circle has made so many impacts at one place that it is stuck; and what follows an impact
 * under gravity, of approach u along the unit normal n, restitution e, and the relative
 * acceleration a along n. An approach is slow below {@code s = 4 g tau}.
 *
 * <ul>
 *   <li>What comes fast takes its impulse at once.
 *   <li>On one flat side the bounces follow each other down to a hop of {@code (e u)^2 / (2 |a|) =
 *       2^-40 R}. Then the circle <b>slides</b>. A sliding circle that meets another side changes
 *       to that if it leaves its own.
 *   <li>What gravity does not press together, beyond the rounding of n, <b>bounces</b>. So does
 *       what comes fast, and what makes such a hop for e from 1 on.
 *   <li>Else the circles <b>join</b> those in contact, see {@link ContactCore}. So does one that
 *       made 24 impacts at one place, 1,536 for e from 1 on.
 * </ul>
 */
final class ImpactRule {

  static final int BOUNCE = 0;
  static final int SLIDE = 1;
  static final int JOIN = 2;

  private final Gravity gravity;

  /** The last radius and size of gravity, and a slow approach for them. */
  private double radius;

  private double size;
  private double slow;

  ImpactRule(Gravity gravity) {
    this.gravity = gravity;
  }

  /** The least approach of a circle that is not slow. */
  double slow(double itsRadius) {
    return slow(itsRadius, gravity.size());
  }

  /** The same for a pull that may be more than gravity, see {@link ContactClock}. */
  double slow(double itsRadius, double pull) {
    if (itsRadius != radius || pull != size) {
      radius = itsRadius;
      size = pull;
      slow = ContactClock.slowOf(radius, size);
    }
    return slow;
  }

  /** The pull on a circle at something that turns, or gravity if that is more. */
  double pull(double bend) {
    return Math.max(gravity.size(), bend);
  }

  /** The same with places of the least width. */
  static void count(MovingCircle m, double way, boolean again, boolean pushes) {
    count(m, way, ContactLaw.FLAT * size(m), again, pushes);
  }

  /** The width of a place without gravity: wider where an impact takes or adds motion. */
  static double place(MovingCircle m, double e) {
    double least = ContactLaw.FLAT * size(m);
    return e == 1 ? least : Math.max(least, ContactLaw.PLACE * m.radius);
  }

  /**
   * Counts impacts of a circle at one place. Bounces on one thing do not count.
   *
   * @param way how far it moved since the last one, relative to what it hits
   * @param place the width of a place
   * @param again whether it hits the same thing again
   * @param pushes whether that moves towards it, and does not give way
   */
  static void count(MovingCircle m, double way, double place, boolean again, boolean pushes) {
    if (m.isCrushed()) {
      return;
    }
    m.pushed |= pushes;
    if (way > (m.pushed ? ContactLaw.PUSHED * m.radius : place)) {
      m.leavePlace();
      m.pushed = pushes;
    } else if (!again) {
      m.stuck = Math.min(m.stuck + 1, MovingCircle.STUCK_LIMIT);
    }
  }

  static double size(MovingCircle m) {
    return Math.max(Math.abs(m.x) + Math.abs(m.y), m.radius);
  }

  private static boolean isMany(MovingCircle m, double e) {
    return m.stuck > ContactLaw.IMPACTS
        && (e < 1 || m.stuck > ContactLaw.IMPACTS * ContactLaw.ELASTIC);
  }

  /** Whether a circle is stuck without gravity; without bounce the second impact does. */
  static boolean isStuck(MovingCircle m, double e) {
    return e == 0 ? m.stuck > 0 : isMany(m, e == 1 ? 1 : 0);
  }

  /** Whether a stuck circle stays so, whatever new velocities it gets. */
  static boolean isHopeless(MovingCircle m) {
    return m.stuck > ContactLaw.IMPACTS * (ContactLaw.ELASTIC + 1);
  }

  /** Whether an approach is no more than rounding of a speed. */
  static boolean isFaint(double approach, double speed) {
    return Math.abs(approach) <= ContactLaw.ROUNDED * speed;
  }

  /** Stops a circle whose velocity an impact made infinite or NaN; returns whether it did. */
  static boolean stopsBeyondRange(MovingCircle m) {
    boolean stops = !(Math.abs(m.vx) <= Double.MAX_VALUE && Math.abs(m.vy) <= Double.MAX_VALUE);
    if (stops) {
      m.vx = 0;
      m.vy = 0;
    }
    return stops;
  }

  /** Whether a pull of some size presses a circle onto a thing, by more than n is rounded. */
  private static boolean isPressed(MovingCircle m, double pull, double size) {
    double part = pull / size;
    return pull < 0 && part * part > turn(m);
  }

  /**
   * The square of the sine by which a step of height d, which is rounding, turns a normal: {@code 2
   * d / r}.
   */
  static double turn(MovingCircle m) {
    return 2 * ContactLaw.ULPS * Math.ulp(size(m)) / m.radius;
  }

  /**
   * The rule for a circle that meets an obstacle; flat: a side, on no other one.
   *
   * @param size the size of what the pull is a part of
   */
  int of(MovingCircle m, boolean flat, double e, double approach, double pull, double size) {
    boolean pressed = isPressed(m, pull, size);
    double up = e * approach;
    if (isMany(m, e)) {
      return JOIN;
    }
    if (pressed && up * up < -2 * pull * ContactLaw.FLAT * m.radius) {
      return flat ? SLIDE : JOIN;
    }
    return flat || e >= 1 || !pressed || approach >= slow(m.radius, size) ? BOUNCE : JOIN;
  }

  /** The rule for two circles. */
  int of(MovingCircle a, MovingCircle b, double e, double approach, double pull) {
    double g = gravity.size();
    boolean pressed = isPressed(a, pull, g) && isPressed(b, pull, g);
    double smaller = Math.min(a.radius, b.radius);
    double up = e * approach;
    boolean hops = !pressed || up * up >= -2 * pull * ContactLaw.FLAT * smaller;
    if (isMany(a, e) || isMany(b, e) || !hops) {
      return JOIN;
    }
    return e >= 1 || !pressed || approach >= slow(smaller) ? BOUNCE : JOIN;
  }

  /**
   * Marks the row of an impact, and whether the circle settled: by the first slow one after a fast
   * one. Later ones have no row.
   */
  static void mark(MovingCircle m, boolean settles, ImpactRows log) {
    if (settles && m.settled) {
      log.removeLast();
    } else if (settles) {
      log.setOutcome(ImpactRows.SETTLED);
    }
    m.settled = settles;
  }
}
