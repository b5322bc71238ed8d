// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.SceneBuilder;
import dev.carom.World;

/** A line that turns about its start, up while it is held, and else down. */
final class Flipper {

  private static final double DOWN = Math.toRadians(-25);
  private static final double UP = Math.toRadians(30);
  private static final double RATE = 0.2; // in radians a frame

  private final World world;
  private final int id;
  private final int side;
  private boolean held;

  /**
   * Steers a line of a world, which is down.
   *
   * @param side 1 if it points to the right, -1 to the left
   */
  Flipper(World world, int id, int side) {
    this.world = world;
    this.id = id;
    this.side = side;
  }

  /** Adds a flipper that is down to a scene, as its next line. */
  static void add(SceneBuilder scene, double x, double y, double length, int side) {
    scene.line(x, y, x + side * length * Math.cos(DOWN), y + length * Math.sin(DOWN));
  }

  /** Sends it up or down from where it is: it arrives at a time of its own, within a frame. */
  void hold(boolean isHeld) {
    if (isHeld != held) {
      held = isHeld;
      Line now = world.line(id);
      double from = Math.atan2(now.by() - now.ay(), side * (now.bx() - now.ax()));
      double angle = (held ? UP : DOWN) - from;
      double arrival = world.now() + Math.abs(angle) / RATE;
      world.turn(Kind.LINE, id, now.ax(), now.ay(), side * angle, arrival);
    }
  }

  /** Whether a ball is where a stroke would hit it. */
  boolean isNear(int ball) {
    Line now = world.line(id);
    double along = side * (world.x(ball) - now.ax());
    double above = world.y(ball) - now.ay();
    return along > 5 && along < 25 && Math.abs(above) < 12;
  }
}
