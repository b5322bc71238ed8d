// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Bounds;
import dev.carom.Kind;
import dev.carom.Response;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * What keeps circles from falling. The acceleration in a flight is gravity, or the part of it along
 * some direction, or none. Where it is not gravity, the circle touches something that carries it,
 * was jammed, or has infinite mass. The normals of what a circle at rest touches hold gravity
 * between them; of circles only those count that stand still.
 */
final class SupportCheck {

  /** An obstacle that holds a circle at rest is no further from it, in its own radii. */
  private static final double HOLD = 0x1p-7;

  /** Nor is another circle, in the sum of the radii. */
  private static final double PAIR_HOLD = 0x1p-7;

  /** More than a tick of circles in contact: its square, in R / g. */
  private static final double TICK = 0x1p-3;

  /** Gravity is held if it is so near to the angle between two normals, in radians. */
  private static final double TILT = 0x1p-6;

  /** A normal is only known of a distance of so many roundings. */
  private static final double KNOWN = 0x1p10;

  /** Of an acceleration, in proportion to gravity. */
  private static final double ROUNDING = 0x1p-40;

  private final World world;
  private final Rounding rounding;
  private final PassedOver passed;
  private final Vec2 gravity;

  /** The directions of the normals at which a circle touches things, from upwards. */
  private final List<Double> tilts = new ArrayList<>();

  SupportCheck(World world, Rounding rounding, PassedOver passed) {
    this.world = world;
    this.rounding = rounding;
    this.passed = passed;
    gravity = world.gravity();
  }

  void check(List<List<Flight>> flights) throws FindingException {
    for (List<Flight> of : flights) {
      for (Flight f : of) {
        check(f, flights);
      }
    }
  }

  private void check(Flight f, List<List<Flight>> all) throws FindingException {
    if (f.to() - f.from() < Math.sqrt(TICK * f.radius() / gravity.length())) {
      return; // it may be in contact, where its velocity is its momentum
    }
    double lackX = gravity.x() - f.ax();
    double lackY = gravity.y() - f.ay();
    double lack = Math.hypot(lackX, lackY);
    double slack = slack(f);
    double share = f.ax() * lackX + f.ay() * lackY;
    if (Math.abs(share) > slack * (lack + Math.hypot(f.ax(), f.ay()))) {
      throw new FindingException("%s does not fall by a part of %s".formatted(f, gravity));
    }
    if (lack > slack
        && world.traits(Kind.CIRCLE, f.circle()).mass() < Double.POSITIVE_INFINITY
        && !isCarried(f, all)) {
      throw new FindingException("nothing carries %s".formatted(f));
    }
  }

  private boolean isCarried(Flight f, List<List<Flight>> all) {
    double near = f.radius() * (1 + HOLD) + rounding.of(f);
    if (passed.wasJammed(f.circle()) || f.radius() < KNOWN * rounding.of(f)) {
      return true;
    }
    tilts.clear();
    addWalls(f, near);
    for (Solid solid : Solid.of(world, f, Set.of())) {
      Vec2 offset = solid.offset(f.px(), f.py());
      addTouch(offset.x(), offset.y(), near + solid.radius());
    }
    if (!stands(f)) {
      return !tilts.isEmpty();
    }
    if (world.scene().collide() && !isSensor(f.circle())) {
      addCircles(f, all);
    }
    return tilts.stream().anyMatch(a -> tilts.stream().anyMatch(b -> holdBetween(a, b)));
  }

  private static boolean holdBetween(double left, double right) {
    return left >= -TILT && right <= TILT && left - right <= Math.PI + TILT;
  }

  private void addWalls(Flight f, double near) {
    if (Filters.areBound(world, f.circle())) {
      Bounds b = world.scene().bounds().get();
      addWall(f.px() - b.xmin(), 1, 0, near);
      addWall(b.xmax() - f.px(), -1, 0, near);
      addWall(f.py() - b.ymin(), 0, 1, near);
      addWall(b.ymax() - f.py(), 0, -1, near);
    }
  }

  private void addWall(double distance, double nx, double ny, double near) {
    if (distance <= near) {
      addNormal(nx, ny);
    }
  }

  private void addCircles(Flight f, List<List<Flight>> all) {
    double middle = f.from() + (f.to() - f.from()) / 2;
    for (int id : world.ids(Kind.CIRCLE)) {
      if (id != f.circle() && !isSensor(id) && Filters.meet(world, f.circle(), Kind.CIRCLE, id)) {
        List<Flight> flights = all.get(id).stream().filter(o -> isAt(o, middle)).toList();
        if (flights.isEmpty() && isNear(id, f)) {
          tilts.add(0.0); // its way is not known: it may carry the circle
        }
        for (Flight other : flights) {
          if (stands(other)) {
            double reach = f.radius() + other.radius();
            double x = f.px() - other.px();
            double y = f.py() - other.py();
            addTouch(x, y, reach * (1 + PAIR_HOLD) + rounding.of(f));
          }
        }
      }
    }
  }

  /** Whether a circle, when the step is over, is near where another one rests. */
  private boolean isNear(int id, Flight f) {
    double distance = Math.hypot(world.x(id) - f.px(), world.y(id) - f.py());
    return distance <= 2 * (f.radius() + world.radius(id));
  }

  /** Whether a circle rests, but for a fall at the end that is too short to be told from it. */
  private boolean stands(Flight f) {
    double way = Math.hypot(f.vx(), f.vy()) * (f.to() - f.from());
    return way <= rounding.of(f) && Math.hypot(f.ax(), f.ay()) <= slack(f);
  }

  /** How far rounding may carry the acceleration of a flight. */
  private double slack(Flight f) {
    double g = gravity.length();
    return ROUNDING * g + 2 * rounding.ofVelocity(f, g) / (f.to() - f.from());
  }

  private static boolean isAt(Flight f, double moment) {
    return f.from() <= moment && moment <= f.to();
  }

  private boolean isSensor(int circle) {
    return world.traits(Kind.CIRCLE, circle).response() == Response.SENSOR;
  }

  /** Notes the normal of something at a given offset, if that is near. */
  private void addTouch(double nx, double ny, double near) {
    if (nx == 0 && ny == 0) {
      tilts.add(0.0); // its centre is in a point, which has no normal
    } else if (Math.hypot(nx, ny) <= near) {
      addNormal(nx, ny);
    }
  }

  private void addNormal(double nx, double ny) {
    double up = -(nx * gravity.x() + ny * gravity.y());
    double across = nx * gravity.y() - ny * gravity.x();
    tilts.add(Math.atan2(across, up));
  }
}
