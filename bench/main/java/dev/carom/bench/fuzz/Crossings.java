// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.ObstacleKind;
import dev.carom.Response;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;

/**
 * Whether flights respect what is in their way, decided exactly and without the library's detector.
 * The distance from a convex thing is convex along a flight, and approaching at contact is an
 * impact; so no flight comes nearer than the radius, or than it was at its start if that was less.
 * For a moving obstacle, the flight is taken relative to it.
 */
final class Crossings {

  private final World world;
  private final Rounding rounding;
  private final MassCheck masses;
  private final PassedOver passed;

  Crossings(World world, Rounding rounding, MassCheck masses, PassedOver passed) {
    this.world = world;
    this.rounding = rounding;
    this.masses = masses;
    this.passed = passed;
  }

  void check(List<List<Flight>> flights) throws FindingException {
    for (int i = 0; i < flights.size(); i++) {
      for (Flight f : flights.get(i)) {
        checkLines(f);
        checkPegs(f);
        checkWalls(f);
      }
      for (int j = 0; world.scene().collide() && j < i; j++) {
        if (isSolid(i, j)) {
          checkPair(flights.get(i), flights.get(j));
        }
      }
    }
  }

  private boolean isSolid(int i, int j) {
    return world.contains(ObstacleKind.CIRCLE, i)
        && world.contains(ObstacleKind.CIRCLE, j)
        && !isSensor(ObstacleKind.CIRCLE, i)
        && !isSensor(ObstacleKind.CIRCLE, j)
        && Filters.meet(world, i, ObstacleKind.CIRCLE, j)
        && Math.min(world.mass(i), world.mass(j)) < Double.POSITIVE_INFINITY;
  }

  /** Whether an obstacle is there for the circle of a flight, and no sensor. */
  private boolean isSolid(Flight f, ObstacleKind kind, int id) {
    return !isSensor(kind, id) && Filters.meet(world, f.circle(), kind, id);
  }

  private boolean isSensor(ObstacleKind kind, int id) {
    return world.response(kind, id) == Response.SENSOR;
  }

  private void checkLines(Flight f) throws FindingException {
    for (int id : world.ids(ObstacleKind.LINE)) {
      Vec2 u = world.velocity(ObstacleKind.LINE, id);
      if (isSolid(f, ObstacleKind.LINE, id) && !passesOver(u, f)) {
        Line line = atStart(world.line(id), u, f);
        Flight seen = f.seenFrom(u);
        if (!world.oneWay(id) || isFromTheLeft(seen, line)) {
          check(seen, line, f.radius(), "line " + id);
        }
      }
    }
  }

  private void checkPegs(Flight f) throws FindingException {
    for (int id : world.ids(ObstacleKind.PEG)) {
      Vec2 u = world.velocity(ObstacleKind.PEG, id);
      if (isSolid(f, ObstacleKind.PEG, id) && !passesOver(u, f)) {
        Circle peg = world.peg(id);
        Line centre = atStart(new Line(peg.x(), peg.y(), peg.x(), peg.y()), u, f);
        check(f.seenFrom(u), centre, f.radius() + peg.radius(), "peg " + id);
      }
    }
  }

  private boolean passesOver(Vec2 u, Flight f) {
    return !u.equals(Vec2.ZERO) && passed.mayPass(f);
  }

  /** Where something was at the start of a flight that now is at a place. */
  private Line atStart(Line now, Vec2 u, Flight f) {
    double x = u.x() * (world.now() - f.from());
    double y = u.y() * (world.now() - f.from());
    return u.equals(Vec2.ZERO)
        ? now
        : new Line(now.ax() - x, now.ay() - y, now.bx() - x, now.by() - y);
  }

  /** Clearly so; where rounding could decide it, nothing is demanded. */
  private boolean isFromTheLeft(Flight f, Line line) {
    double wx = line.bx() - line.ax();
    double wy = line.by() - line.ay();
    double length = Math.hypot(wx, wy);
    double height = wx / length * (f.py() - line.ay()) - wy / length * (f.px() - line.ax());
    double climb = wx / length * f.vy() - wy / length * f.vx();
    return height > 4 * rounding.of(f) && climb < -0x1p-40 * rounding.fastest();
  }

  private void check(Flight f, Line line, double reach, String thing) throws FindingException {
    double limit = Math.min(reach, distance(f.px(), f.py(), line)) * (1 - 0x1p-50) - rounding.of(f);
    if (limit > 0
        && !isApart(f, line, limit)
        && f.passage().comesNearer(line.ax(), line.ay(), line.bx(), line.by(), limit)) {
      boolean through = f.passage().crosses(line.ax(), line.ay(), line.bx(), line.by());
      throw new FindingException(
          "%s comes nearer to %s than %s%s".formatted(f, thing, limit, through ? ", THROUGH" : ""));
    }
  }

  private static double distance(double x, double y, Line line) {
    double wx = line.bx() - line.ax();
    double wy = line.by() - line.ay();
    double dx = x - line.ax();
    double dy = y - line.ay();
    double length = Math.hypot(wx, wy);
    double along = length == 0 ? 0 : wx / length * dx + wy / length * dy;
    double t = Math.max(0, Math.min(length, along));
    return length == 0
        ? Math.hypot(dx, dy)
        : Math.hypot(dx - wx / length * t, dy - wy / length * t);
  }

  /** Whether their boxes are so far from each other that no exact answer is needed. */
  private static boolean isApart(Flight f, Line line, double limit) {
    double room = 1.001 * limit;
    return Math.min(f.px(), f.qx()) - Math.max(line.ax(), line.bx()) > room
        || Math.min(line.ax(), line.bx()) - Math.max(f.px(), f.qx()) > room
        || Math.min(f.py(), f.qy()) - Math.max(line.ay(), line.by()) > room
        || Math.min(line.ay(), line.by()) - Math.max(f.py(), f.qy()) > room;
  }

  private void checkWalls(Flight f) throws FindingException {
    if (!Filters.areBound(world, f.circle())) {
      return;
    }
    Bounds b = world.scene().bounds().get();
    double r = f.radius();
    checkWall(f, f.px() - b.xmin() - r, f.qx() - b.xmin() - r, "left");
    checkWall(f, b.xmax() - f.px() - r, b.xmax() - f.qx() - r, "right");
    checkWall(f, f.py() - b.ymin() - r, f.qy() - b.ymin() - r, "bottom");
    checkWall(f, b.ymax() - f.py() - r, b.ymax() - f.qy() - r, "top");
  }

  private void checkWall(Flight f, double before, double after, String wall)
      throws FindingException {
    if (after < Math.min(0, before) - rounding.of(f)) {
      throw new FindingException(
          "%s goes over the %s wall by %s; before: %s".formatted(f, wall, -after, -before));
    }
  }

  private void checkPair(List<Flight> first, List<Flight> second) throws FindingException {
    int k = 0;
    for (Flight f : first) {
      while (k < second.size() && second.get(k).to() <= f.from()) {
        k++;
      }
      for (int n = k; n < second.size() && second.get(n).from() < f.to(); n++) {
        double begin = Math.max(f.from(), second.get(n).from());
        double end = Math.min(f.to(), second.get(n).to());
        checkPair(f.within(begin, end), second.get(n).within(begin, end));
      }
    }
  }

  private void checkPair(Flight f, Flight g) throws FindingException {
    double start = Math.hypot(f.px() - g.px(), f.py() - g.py());
    double slack = rounding.of(f) + rounding.of(g);
    double limit = Math.min(f.radius() + g.radius(), start) * (1 - 0x1p-50) - slack;
    if (limit > 0
        && !masses.mayOverlap(f, g)
        && f.passage().seenFrom(g.passage()).comesNearer(0, 0, 0, 0, limit)) {
      throw new FindingException("%s and %s come nearer than %s".formatted(f, g, limit));
    }
  }
}
