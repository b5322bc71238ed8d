// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.SweptCircle;
import dev.carom.Trajectory;
import dev.carom.Vec2;
import dev.carom.World;

/**
 * Something that the mouse is about to add, from where it was pressed to where it is.
 *
 * @param tool which thing: not the hand
 * @param radius of a new circle
 */
record Draft(Tool tool, Vec2 from, Vec2 to, double radius) {

  /** Frames that a new circle takes for the way that was drawn. */
  private static final double FRAMES = 30;

  private static final double LONG = 400;
  private static final int IMPACTS = 7;

  Draft to(Vec2 there) {
    return new Draft(tool, from, there, radius);
  }

  double length() {
    return Math.hypot(to.x() - from.x(), to.y() - from.y());
  }

  Circle circle() {
    return new Circle(from.x(), from.y(), tool == Tool.PEG ? length() : radius);
  }

  Line line() {
    return new Line(from, to);
  }

  /** The velocity of a new circle: the further the mouse went, the faster. */
  Vec2 velocity(Player player) {
    double time = FRAMES * player.frame();
    return new Vec2((to.x() - from.x()) / time, (to.y() - from.y()) / time);
  }

  /** The way that a new circle would take among what stands still. */
  Trajectory way(Player player) {
    World world = player.look();
    Vec2 g = world.gravity();
    SweptCircle drawn = new SweptCircle(circle(), velocity(player)).withAcceleration(g.x(), g.y());
    return world.trace(drawn, 1, LONG * player.frame(), IMPACTS);
  }

  /** Adds it; a line or peg of no size is not meant. */
  void add(Player player) {
    if (tool == Tool.CIRCLE) {
      Vec2 v = velocity(player);
      player.addCircle(from.x(), from.y(), radius, v.x(), v.y());
    } else if (tool == Tool.LINE && length() > 0) {
      player.addLine(line());
    } else if (tool == Tool.PEG && length() > 0) {
      player.addPeg(from.x(), from.y(), length());
    }
  }
}
