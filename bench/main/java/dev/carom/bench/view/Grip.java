// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.ObstacleKind;
import dev.carom.Vec2;
import dev.carom.World;

/** What the mouse holds: a circle, a line as a whole, or one of its ends. */
final class Grip {

  private enum Part {
    CIRCLE,
    LINE,
    START,
    END
  }

  private final Player player;
  private final Part part;
  private final int id;
  private Vec2 last;

  private Grip(Player player, Part part, int id, Vec2 at) {
    this.player = player;
    this.part = part;
    this.id = id;
    last = at;
  }

  /**
   * Takes hold of what lies at a point: circles first.
   *
   * @param reach how far beside it the point may lie
   * @return null if nothing is there
   */
  static Grip at(Player player, Vec2 point, double reach) {
    World world = player.look();
    int[] circles = world.overlapping(ObstacleKind.CIRCLE, new Circle(point.x(), point.y(), reach));
    if (circles.length > 0) {
      return new Grip(player, Part.CIRCLE, circles[circles.length - 1], point);
    }
    int id = world.nearest(ObstacleKind.LINE, point.x(), point.y());
    if (id < 0 || distance(world.line(id).closestPoint(point), point) > reach) {
      return null;
    }
    Line line = world.line(id);
    Part part =
        distance(new Vec2(line.ax(), line.ay()), point) <= reach
            ? Part.START
            : distance(new Vec2(line.bx(), line.by()), point) <= reach ? Part.END : Part.LINE;
    return new Grip(player, part, id, point);
  }

  private static double distance(Vec2 a, Vec2 b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y());
  }

  /** Moves it along with the mouse. */
  void drag(Vec2 to) {
    World world = player.editable();
    double dx = to.x() - last.x();
    double dy = to.y() - last.y();
    last = to;
    if (part == Part.CIRCLE) {
      player.moveCircle(id, world.x(id) + dx, world.y(id) + dy);
      return;
    }
    Line l = world.line(id);
    double a = part == Part.END ? 0 : 1;
    double b = part == Part.START ? 0 : 1;
    player.moveLine(
        id, new Line(l.ax() + a * dx, l.ay() + a * dy, l.bx() + b * dx, l.by() + b * dy));
  }
}
