// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;

/**
 * What keeps circles from falling. The acceleration in a flight is gravity, or the part of it along
 * some direction, or none. Where it is not gravity, the circle touches something that carries it,
 * was jammed, or has infinite mass.
 */
final class SupportCheck {

  /** What holds a circle at rest is no further from it, in its own radii. */
  private static final double HOLD = 0x1p-8;

  /** Of an acceleration, in proportion to gravity. */
  private static final double ROUNDING = 0x1p-40;

  private final World world;
  private final Rounding rounding;
  private final PassedOver passed;
  private final Vec2 gravity;

  SupportCheck(World world, Rounding rounding, PassedOver passed) {
    this.world = world;
    this.rounding = rounding;
    this.passed = passed;
    gravity = world.gravity();
  }

  void check(List<List<Flight>> flights) throws FindingException {
    for (List<Flight> of : flights) {
      for (Flight f : of) {
        check(f);
      }
    }
  }

  private void check(Flight f) throws FindingException {
    double lackX = gravity.x() - f.ax();
    double lackY = gravity.y() - f.ay();
    double lack = Math.hypot(lackX, lackY);
    double g = gravity.length();
    double slack = ROUNDING * g + 2 * rounding.ofVelocity(f, g) / (f.to() - f.from());
    double share = f.ax() * lackX + f.ay() * lackY;
    if (Math.abs(share) > slack * (lack + Math.hypot(f.ax(), f.ay()))) {
      throw new FindingException("%s does not fall by a part of %s".formatted(f, gravity));
    }
    if (lack > slack && world.mass(f.circle()) < Double.POSITIVE_INFINITY && !isCarried(f)) {
      throw new FindingException("nothing carries %s".formatted(f));
    }
  }

  private boolean isCarried(Flight f) {
    double near = f.radius() * (1 + HOLD) + rounding.of(f);
    return passed.wasJammed(f.circle())
        || (Filters.areBound(world, f.circle()) && PlaceCheck.room(world, f.px(), f.py()) <= near)
        || Solid.of(world, f).stream()
            .anyMatch(solid -> solid.distance(f.px(), f.py()) <= near + solid.radius());
  }
}
