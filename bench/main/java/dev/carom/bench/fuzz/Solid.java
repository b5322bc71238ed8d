// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Response;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.ArrayList;
import java.util.List;

/**
 * A line or a peg that a circle can meet and that is no sensor.
 *
 * @param axis the line, or the peg's centre, at the start of a flight
 * @param radius of the peg, 0 of a line
 */
record Solid(String name, Line axis, double radius, Vec2 velocity, boolean oneWay) {

  /** All that a flight may meet. */
  static List<Solid> of(World world, Flight f) {
    List<Solid> solids = new ArrayList<>();
    double ago = world.now() - f.from();
    for (int id : world.ids(Kind.LINE)) {
      if (isSolid(world, f, Kind.LINE, id)) {
        Vec2 u = world.velocity(Kind.LINE, id);
        Line axis = before(world.line(id), u, ago);
        solids.add(new Solid("line " + id, axis, 0, u, world.traits(Kind.LINE, id).oneWay()));
      }
    }
    for (int id : world.ids(Kind.PEG)) {
      if (isSolid(world, f, Kind.PEG, id)) {
        Vec2 u = world.velocity(Kind.PEG, id);
        Circle peg = world.peg(id);
        Line axis = before(new Line(peg.x(), peg.y(), peg.x(), peg.y()), u, ago);
        solids.add(new Solid("peg " + id, axis, peg.radius(), u, false));
      }
    }
    return solids;
  }

  private static boolean isSolid(World world, Flight f, Kind kind, int id) {
    return world.traits(kind, id).response() != Response.SENSOR
        && Filters.meet(world, f.circle(), kind, id);
  }

  private static Line before(Line now, Vec2 u, double ago) {
    double x = u.x() * ago;
    double y = u.y() * ago;
    return u.equals(Vec2.ZERO)
        ? now
        : new Line(now.ax() - x, now.ay() - y, now.bx() - x, now.by() - y);
  }

  boolean moves() {
    return !velocity.equals(Vec2.ZERO);
  }

  /** How far a place is from the axis at the start of the flight. */
  double distance(double x, double y) {
    Vec2 offset = offset(x, y);
    return Math.hypot(offset.x(), offset.y());
  }

  /** From the nearest point of the axis to a place, at the start of the flight. */
  Vec2 offset(double x, double y) {
    double wx = axis.bx() - axis.ax();
    double wy = axis.by() - axis.ay();
    double dx = x - axis.ax();
    double dy = y - axis.ay();
    double length = Math.hypot(wx, wy);
    double along = length == 0 ? 0 : wx / length * dx + wy / length * dy;
    double t = Math.max(0, Math.min(length, along));
    return length == 0 ? new Vec2(dx, dy) : new Vec2(dx - wx / length * t, dy - wy / length * t);
  }

  /** How far a place is left of a line, at the start of the flight; less than 0 right of it. */
  double height(double x, double y) {
    return climb(x - axis.ax(), y - axis.ay());
  }

  /** The part of a vector across a line, to its left. */
  double climb(double x, double y) {
    double wx = axis.bx() - axis.ax();
    double wy = axis.by() - axis.ay();
    double length = Math.hypot(wx, wy);
    return wx / length * y - wy / length * x;
  }
}
