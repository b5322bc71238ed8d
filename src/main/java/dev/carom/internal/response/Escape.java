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
 * Lets a circle that falls, and is stuck between things of which one moves, leave all of them:
 * those that carry it by the least speed at which it leaves what is round. If there is no such
 * velocity, they squeeze it.
 */
final class Escape {

  /** How far from a circle things may be to count, in radii; the places of its impacts are less. */
  private static final double REACH = 2 * StuckRule.FALLING_PLACE;

  private final ObstacleTable obstacles;
  private final Gravity gravity;
  private final Settling settling;

  /** Tells which circles touch one; null as long as no circles meet. */
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
   * @return false if there is none, or none that differs from others by more than rounding; if
   *     nothing of that moves; or if a circle of finite mass touches it, too. Then nothing has
   *     changed.
   */
  boolean escapes(MovingCircle m) {
    List<Touch> touches = touches(m);
    List<MovingCircle> partners =
        circles == null ? List.of() : circles.touching(m, REACH * m.radius);
    if (!partners.stream().allMatch(other -> circles.isInfinite(other))
        || !isAnyMoving(touches, partners)) {
      return false;
    }
    int most = touches.size() + partners.size();
    InelasticShock shock = new InelasticShock(1 + most, most);
    shock.setCircle(0, m.vx, m.vy, 1);
    boolean leaves = true;
    int k = 1;
    for (Touch touch : touches) {
      int code = touch.code();
      double radius = Codes.isWall(code) ? 0 : obstacles.radius(code);
      leaves &= leave(shock, k++, m, touch, obstacles.ux(code), obstacles.uy(code), radius);
    }
    for (MovingCircle other : partners) {
      Touch touch = Touch.of(m, other, REACH * m.radius);
      leaves &= leave(shock, k++, m, touch, other.vx, other.vy, other.radius);
    }
    if (!leaves || !shock.resolve()) {
      return false;
    }
    m.vx = shock.vx(0);
    m.vy = shock.vy(0);
    m.leavePlace();
    settling.fall(m);
    return true;
  }

  private boolean isAnyMoving(List<Touch> touches, List<MovingCircle> partners) {
    return touches.stream().anyMatch(touch -> !obstacles.isAtRest(touch.code()))
        || partners.stream().anyMatch(other -> other.vx != 0 || other.vy != 0);
  }

  /**
   * Adds a contact k with what has a velocity u, and which the circle leaves by the least speed.
   *
   * @return whether that is more than rounding of the velocities
   */
  private boolean leave(
      InelasticShock shock,
      int k,
      MovingCircle m,
      Touch touch,
      double ux,
      double uy,
      double radius) {
    double least = Math.sqrt(2 * gravity.size() * Settling.LEAST_HOP * (m.radius + radius));
    double vx = ux + least * touch.nx();
    double vy = uy + least * touch.ny();
    shock.setCircle(k, vx, vy, Double.POSITIVE_INFINITY);
    shock.addContact(0, k, touch.nx(), touch.ny());
    double speeds = Math.abs(m.vx) + Math.abs(m.vy) + Math.abs(ux) + Math.abs(uy);
    return least > Settling.ROUNDING * speeds;
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
}
