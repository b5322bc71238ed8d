// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Obstacle;
import dev.carom.Outline;
import dev.carom.Response;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.Sides;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * A line or a peg that a circle can meet and that is no sensor.
 *
 * @param axis the line, or the peg's centre, at the start of a flight
 * @param whole all that is solid with it: the sides of a polygon, else the axis alone
 * @param radius of the peg, 0 of a line
 */
record Solid(
    String name, Line axis, List<Line> whole, double radius, Vec2 velocity, boolean oneWay) {

  /** All that a flight may meet, apart from things of given names. */
  static List<Solid> of(World world, Flight f, Set<String> apart) {
    List<Solid> solids = new ArrayList<>();
    double ago = world.now() - f.from();
    for (int id : world.ids(Kind.LINE)) {
      if (isSolid(world, f, Kind.LINE, id) && !apart.contains(name(Kind.LINE, id))) {
        Vec2 u = world.velocity(Kind.LINE, id);
        boolean oneWay = world.traits(Kind.LINE, id).oneWay();
        List<Line> sides = sides(world.shape(Kind.LINE, id), f, u, ago);
        boolean isWhole = isPolygon(world.shape(Kind.LINE, id));
        for (Line side : sides) {
          List<Line> whole = isWhole ? sides : List.of(side);
          solids.add(new Solid(name(Kind.LINE, id), side, whole, 0, u, oneWay));
        }
      }
    }
    for (int id : world.ids(Kind.PEG)) {
      if (isSolid(world, f, Kind.PEG, id) && !apart.contains(name(Kind.PEG, id))) {
        Vec2 u = world.velocity(Kind.PEG, id);
        Circle peg = world.peg(id);
        Line axis = before(new Line(peg.x(), peg.y(), peg.x(), peg.y()), u, ago);
        solids.add(new Solid(name(Kind.PEG, id), axis, List.of(axis), peg.radius(), u, false));
      }
    }
    return solids;
  }

  /** The sides at the start of a flight; none of a polygon in which that starts. */
  private static List<Line> sides(Obstacle shape, Flight f, Vec2 u, double ago) {
    List<Line> sides = Sides.of(shape).stream().map(side -> before(side, u, ago)).toList();
    if (isPolygon(shape)) {
      Path2D polygon = new Path2D.Double();
      sides.forEach(s -> polygon.append(new Line2D.Double(s.ax(), s.ay(), s.bx(), s.by()), true));
      return polygon.contains(f.px(), f.py()) ? List.of() : sides;
    }
    return sides;
  }

  static boolean isPolygon(Obstacle shape) {
    return shape instanceof Outline outline && outline.solid();
  }

  static String name(Kind kind, int id) {
    return (kind == Kind.LINE ? "line " : "peg ") + id;
  }

  static boolean isSolid(World world, Flight f, Kind kind, int id) {
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

  /** How far a place is from the whole at the start of the flight. */
  double distance(double x, double y) {
    return whole.stream()
        .map(line -> offset(line, x, y))
        .mapToDouble(offset -> Math.hypot(offset.x(), offset.y()))
        .min()
        .orElseThrow();
  }

  /** From the nearest point of the axis to a place, at the start of the flight. */
  Vec2 offset(double x, double y) {
    return offset(axis, x, y);
  }

  static Vec2 offset(Line axis, double x, double y) {
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
