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
 * Lets a circle that falls, and is stuck between things of which one moves, leave each of them by
 * the {@linkplain Settling#LEAST_HOP least speed}. If no velocity does that, they squeeze it.
 */
final class Escape {

  /** How far from a circle things may be to count, in radii; the places of its impacts are less. */
  private static final double REACH = 2 * StuckRule.FALLING_PLACE;

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  /**
   * What a circle touches.
   *
   * @param ux,uy its velocity
   * @param least the least speed at which the circle leaves it
   * @param isInfinite whether it keeps its velocity
   */
  private record Contact(Touch touch, double ux, double uy, double least, boolean isInfinite) {

    boolean isAtRest() {
      return ux == 0 && uy == 0;
    }
  }

  private final ObstacleTable obstacles;
  private final Gravity gravity;
  private final Settling settling;

  /** Knows the circles near one; null as long as no circles meet. */
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

  /** Takes the cluster that knows the circles near one. */
  void ask(ContactCluster cluster) {
    circles = cluster;
  }

  /**
   * Gives a circle the velocity nearest to its own with which it leaves all that it touches.
   *
   * @return false, and then nothing has changed, if there is no such velocity; if a least speed is
   *     mere rounding; if nothing that it touches moves; or if it touches a circle of finite mass
   */
  boolean escapes(MovingCircle m) {
    List<Contact> contacts = new ArrayList<>();
    addObstacles(m, contacts);
    addCircles(m, contacts);
    if (contacts.stream().allMatch(Contact::isAtRest)
        || !contacts.stream().allMatch(c -> c.isInfinite && c.least > rounding(m, c))) {
      return false;
    }
    InelasticShock shock = new InelasticShock(1 + contacts.size(), contacts.size());
    shock.setCircle(0, m.vx, m.vy, 1);
    for (int k = 0; k < contacts.size(); k++) {
      Contact c = contacts.get(k);
      double nx = c.touch.nx();
      double ny = c.touch.ny();
      shock.setCircle(k + 1, c.ux + c.least * nx, c.uy + c.least * ny, INFINITE);
      shock.addContact(0, k + 1, nx, ny);
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

  /** The rounding of the velocities of a circle and of what it touches. */
  private static double rounding(MovingCircle m, Contact c) {
    double speeds = Math.abs(m.vx) + Math.abs(m.vy) + Math.abs(c.ux) + Math.abs(c.uy);
    return Settling.ROUNDING * speeds;
  }

  private void addObstacles(MovingCircle m, List<Contact> contacts) {
    for (int code : near.apply(m)) {
      if (settling.isSolid(m, code)) {
        double radius = Codes.isWall(code) ? 0 : obstacles.radius(code);
        Touch touch = Touch.of(m, obstacles, code, REACH * m.radius);
        add(contacts, touch, obstacles.ux(code), obstacles.uy(code), m.radius + radius, true);
      }
    }
  }

  private void addCircles(MovingCircle m, List<Contact> contacts) {
    if (circles != null) {
      for (MovingCircle other : circles.circlesNear(m)) {
        Touch touch = Touch.of(m, other, REACH * m.radius);
        double reach = m.radius + other.radius;
        add(contacts, touch, other.vx, other.vy, reach, circles.isInfinite(other));
      }
    }
  }

  private void add(
      List<Contact> contacts, Touch touch, double ux, double uy, double reach, boolean isInfinite) {
    if (touch != null) {
      double least = Math.sqrt(2 * gravity.size() * Settling.LEAST_HOP * reach);
      contacts.add(new Contact(touch, ux, uy, least, isInfinite));
    }
  }
}
