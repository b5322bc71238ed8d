// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.MovingCircle;

/**
 * Decides when an impact stops a circle.
 *
 * <p>Two impacts of restitution 0 at the same place that turn the velocity in opposite directions
 * stop the circle. Else they would turn it to and fro for ever, by less each time. (The velocity
 * lies in the cone of directions that the two normals forbid. Among the velocities that lead into
 * neither obstacle, 0 is the nearest.)
 *
 * <p>A {@linkplain StuckRule stuck} circle stops when no more than rounding is left of its
 * velocity.
 */
public final class StopRule {

  private StopRule() {}

  /**
   * Whether an impact without bounce turns the velocity one way after another one at the same place
   * turned it the other way. Remembers the way for the next impact.
   */
  static boolean turnsBack(MovingCircle m, double nx, double ny, double way, double approach) {
    if (StuckRule.isFaint(m, approach)) {
      return false;
    }
    int turn = m.vx * ny > m.vy * nx ? 1 : -1;
    boolean back = m.turn == -turn && way <= StuckRule.widthOfPlace(m);
    m.turn = turn;
    return back;
  }

  /** Whether no more than rounding is left of a stuck circle's velocity. */
  static boolean isSpent(MovingCircle m) {
    return StuckRule.isFaint(m, Math.abs(m.vx) + Math.abs(m.vy));
  }

  static void stop(MovingCircle m) {
    m.vx = 0;
    m.vy = 0;
  }

  /** Stops a circle whose velocity an impact made infinite or NaN; returns whether it did. */
  public static boolean stopsBeyondRange(MovingCircle m) {
    if (Math.abs(m.vx) <= Double.MAX_VALUE && Math.abs(m.vy) <= Double.MAX_VALUE) {
      return false;
    }
    stop(m);
    return true;
  }
}
