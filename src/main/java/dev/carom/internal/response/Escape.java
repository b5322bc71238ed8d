// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * Lets a circle that falls, and is stuck between things of which one moves, leave all of them: each
 * by the least speed at which it leaves what is round. If there is no such velocity, they squeeze
 * it.
 */
final class Escape {

  /** How far from a circle things may be to count, in radii; the places of its impacts are less. */
  private static final double REACH = 2 * StuckRule.FALLING_PLACE;

  private final ObstacleTable obstacles;
  private final Gravity gravity;
  private final Settling settling;

  /** Tells whether another circle touches one; null as long as no circles meet. */
  private ContactCluster circles;

  /** The codes of obstacles that a circle may touch, ascending. */
  private final Function<MovingCircle, int[]> near;

  Escape(
      ObstacleTable obstacles,
      Gravity gravity,
      Settling settling,
      Function<MovingCircle, int[]> near) {
    this.obstacles = obstacles;
    this.gravity = gravity;
    this.settling = settling;
    this.near = near;
  }

  /** Lets a cluster tell of circles that touch. */
  void ask(ContactCluster cluster) {
    circles = cluster;
  }

  /**
   * Gives a circle the velocity nearest to its own with which it leaves all that it touches.
   *
   * @return false if there is none, if nothing of that moves, or if other circles touch it, too;
   *     then nothing has changed
   */
  boolean escapes(MovingCircle m) {
    List<Touch> touches = touches(m);
    boolean isAlone = circles == null || !circles.touchesCircle(m, REACH * m.radius);
    if (!isAlone || touches.stream().allMatch(touch -> obstacles.isAtRest(touch.code()))) {
      return false;
    }
    InelasticShock shock = new InelasticShock(1 + touches.size(), touches.size());
    shock.setCircle(0, m.vx, m.vy, 1);
    for (int k = 0; k < touches.size(); k++) {
      Touch touch = touches.get(k);
      double least = leastSpeed(m, touch.code());
      double ux = obstacles.ux(touch.code()) + least * touch.nx();
      double uy = obstacles.uy(touch.code()) + least * touch.ny();
      shock.setCircle(k + 1, ux, uy, Double.POSITIVE_INFINITY);
      shock.addContact(0, k + 1, touch.nx(), touch.ny());
    }
    if (!shock.resolve()) {
      return false;
    }
    m.vx = shock.vx(0);
    m.vy = shock.vy(0);
    m.leavePlace();
    settling.fall(m);
    return true;
  }

  private List<Touch> touches(MovingCircle m) {
    List<Touch> touches = new ArrayList<>();
    for (int code : near.apply(m)) {
      Touch touch =
          settling.isSolid(m, code) ? Touch.of(m, obstacles, code, REACH * m.radius) : null;
      if (touch != null) {
        touches.add(touch);
      }
    }
    return touches;
  }

  private double leastSpeed(MovingCircle m, int code) {
    double radius = Codes.isWall(code) ? 0 : obstacles.radius(code);
    return Math.sqrt(2 * gravity.size() * Settling.LEAST_HOP * (m.radius + radius));
  }
}
