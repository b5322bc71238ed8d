// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Bounds;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Response;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;
import java.util.Set;

/**
 * Whether flights respect what is in their way, decided without the library's detector. Approaching
 * at contact is an impact, and so is approaching more deeply inside; so no flight, straight or a
 * parabola, comes nearer than the radius, or than it was at its start if that was less. For a
 * moving obstacle, the flight is taken relative to it.
 */
final class Crossings {

  /** Of a parabola, so many parts are looked at for whether they come to a one-way line. */
  private static final int PARTS = 8;

  private static final Line CENTRE = new Line(0, 0, 0, 0);

  private final World world;
  private final Rounding rounding;
  private final MassCheck masses;
  private final PassedOver passed;
  private final Set<String> turning;

  /** Whether there is gravity. */
  private final boolean falls;

  /**
   * A check.
   *
   * @param turning the names of the obstacles that turn; {@link TurnCheck} looks at these
   */
  Crossings(
      World world, Rounding rounding, MassCheck masses, PassedOver passed, Set<String> turning) {
    this.world = world;
    this.turning = turning;
    this.rounding = rounding;
    this.masses = masses;
    this.passed = passed;
    falls = !world.gravity().equals(Vec2.ZERO);
  }

  void check(List<List<Flight>> flights) throws FindingException {
    for (int i = 0; i < flights.size(); i++) {
      for (Flight f : flights.get(i)) {
        checkObstacles(f);
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
    return world.contains(Kind.CIRCLE, i)
        && world.contains(Kind.CIRCLE, j)
        && !isSensor(i)
        && !isSensor(j)
        && Filters.meet(world, i, Kind.CIRCLE, j)
        && Math.min(world.traits(Kind.CIRCLE, i).mass(), world.traits(Kind.CIRCLE, j).mass())
            < Double.POSITIVE_INFINITY;
  }

  /** Whether a circle moves like an obstacle: nothing stops it. */
  private boolean isMassive(Flight f) {
    return world.traits(Kind.CIRCLE, f.circle()).mass() == Double.POSITIVE_INFINITY;
  }

  private boolean isSensor(int circle) {
    return world.traits(Kind.CIRCLE, circle).response() == Response.SENSOR;
  }

  private void checkObstacles(Flight f) throws FindingException {
    for (Solid solid : Solid.of(world, f, turning)) {
      if (!solid.moves() || !passed.mayPass(f)) {
        Flight seen = f.seenFrom(solid.velocity());
        if (solid.oneWay()) {
          checkOneWay(seen, solid);
        } else {
          check(seen, solid);
        }
      }
    }
  }

  /** Only where it is clear that the flight comes from the left; else nothing is demanded. */
  private void checkOneWay(Flight f, Solid line) throws FindingException {
    if (!falls || world.traits(Kind.CIRCLE, f.circle()).mass() == Double.POSITIVE_INFINITY) {
      if (isLeft(f, line) && line.climb(f.vx(), f.vy()) < -0x1p-40 * rounding.fastest()) {
        check(f, line);
      }
      return;
    }
    double limit = limit(f, line);
    for (int k = 0; k < PARTS; k++) {
      Flight rest = f.within(f.from() + k * ((f.to() - f.from()) / PARTS), f.to());
      if (isLeft(rest, line) && line.distance(rest.px(), rest.py()) > f.radius() + rounding.of(f)) {
        check(whileLeft(rest, line), line, limit);
      }
    }
  }

  private boolean isLeft(Flight f, Solid line) {
    return line.height(f.px(), f.py()) > 4 * rounding.of(f);
  }

  /** The part of a flight that starts left of a line until it first crosses that, or its end. */
  private static Flight whileLeft(Flight f, Solid line) {
    double h = line.height(f.px(), f.py());
    double v = line.climb(f.vx(), f.vy());
    double root = Math.sqrt(v * v - 2 * line.climb(f.ax(), f.ay()) * h);
    double until = v < root ? 2 * h / (root - v) : Double.POSITIVE_INFINITY;
    double end = f.from() + 0.999 * until;
    return end < f.to() ? f.within(f.from(), end) : f;
  }

  private void check(Flight f, Solid solid) throws FindingException {
    check(f, solid, limit(f, solid));
  }

  private double limit(Flight f, Solid solid) {
    double start = solid.distance(f.px(), f.py());
    return limit(f, f.radius() + solid.radius(), start, rounding.of(f));
  }

  private void check(Flight f, Solid solid, double limit) throws FindingException {
    Line axis = solid.axis();
    if (limit > 0 && new Nearness(axis, limit, rounding.of(f)).isReachedBy(f)) {
      boolean through = f.passage().crosses(axis.ax(), axis.ay(), axis.bx(), axis.by());
      throw new FindingException(
          "%s comes nearer to %s than %s%s"
              .formatted(f, solid.name(), limit, through ? ", THROUGH" : ""));
    }
  }

  /**
   * How near a flight may come; 0 where nothing is demanded. With gravity, what was hit last is hit
   * again where the flight comes as near to it as at its start, which may be before this piece.
   */
  static double limit(Flight f, double reach, double start, double slack) {
    return f.begins() ? Math.min(reach, start) * (1 - 0x1p-50) - slack : 0;
  }

  private void checkWalls(Flight f) throws FindingException {
    if (!Filters.areBound(world, f.circle())) {
      return;
    }
    Bounds b = world.scene().bounds().get();
    double r = f.radius();
    double turnX = turn(f, f.vx(), f.ax());
    double turnY = turn(f, f.vy(), f.ay());
    double lowX = Math.min(f.qx(), f.x(turnX));
    double lowY = Math.min(f.qy(), f.y(turnY));
    double highX = Math.max(f.qx(), f.x(turnX));
    double highY = Math.max(f.qy(), f.y(turnY));
    checkWall(f, f.px() - b.xmin() - r, lowX - b.xmin() - r, "left");
    checkWall(f, b.xmax() - f.px() - r, b.xmax() - highX - r, "right");
    checkWall(f, f.py() - b.ymin() - r, lowY - b.ymin() - r, "bottom");
    checkWall(f, b.ymax() - f.py() - r, b.ymax() - highY - r, "top");
  }

  /** When a coordinate turns back in a flight; its end if it does not. */
  private static double turn(Flight f, double v, double a) {
    double turn = f.from() - v / a;
    return turn > f.from() && turn < f.to() ? turn : f.to();
  }

  private void checkWall(Flight f, double before, double least, String wall)
      throws FindingException {
    double slack = rounding.of(f);
    if (f.begins() && least < Math.min(0, before) - slack) {
      throw new FindingException(
          "%s goes over the %s wall by %s; before: %s".formatted(f, wall, -least, -before));
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
    Flight seen = f.seenFrom(g);
    double slack = rounding.of(f) + rounding.of(g);
    double limit = limit(seen, seen.radius(), Math.hypot(seen.px(), seen.py()), slack);
    if (limit > 0
        && !masses.mayOverlap(f, g)
        && !(isMassive(g) && passed.mayPass(f))
        && !(isMassive(f) && passed.mayPass(g))
        && new Nearness(CENTRE, limit, slack).isReachedBy(seen)) {
      throw new FindingException("%s and %s come nearer than %s".formatted(f, g, limit));
    }
  }
}
