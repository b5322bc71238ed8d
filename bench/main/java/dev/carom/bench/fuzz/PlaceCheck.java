// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Bounds;
import dev.carom.Kind;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.BitSet;

/**
 * After any call, finished or not: no NaN, and nobody outside the bounds who was inside. A circle
 * that falls and was outside once may be so again: a wall that it hit out there throws it back at
 * the same place as often as it comes.
 */
final class PlaceCheck {

  /** So many ulps of its coordinates a circle inside the bounds may be over a wall. */
  /** In radii: circles in contact under gravity may overlap by so much. */
  private static final double IN_CONTACT = 1e-9;

  private static final double ULPS = 4;

  private World world;
  private final BitSet inside = new BitSet();

  /** Who was outside before a step since there is gravity. */
  private final BitSet outside = new BitSet();

  void enter(World entered) {
    world = entered;
  }

  /** Notes who is inside at the start of a step. */
  void begin() {
    inside.clear();
    if (world.gravity().equals(Vec2.ZERO)) {
      outside.clear();
    }
    for (int id : world.ids(Kind.CIRCLE)) {
      boolean isInside = isInside(id, false);
      outside.set(id, outside.get(id) || !isInside);
      inside.set(id, isInside && (!outside.get(id) || world.gravity().equals(Vec2.ZERO)));
    }
  }

  /**
   * Compares with the end of the step.
   *
   * @param turned whether circles may be in contact without gravity
   */
  void end(boolean turned) throws FindingException {
    for (int id : world.ids(Kind.CIRCLE)) {
      boolean numbers = !Double.isNaN(world.x(id)) && !Double.isNaN(world.y(id));
      if (!numbers || !Double.isFinite(world.vx(id)) || !Double.isFinite(world.vy(id))) {
        throw new FindingException("circle %d has a coordinate that is no number".formatted(id));
      }
      if (inside.get(id) && !isInside(id, turned)) {
        throw new FindingException(
            "circle %d left the bounds by %s at %s".formatted(id, beyond(world, id), world.now()));
      }
    }
  }

  private boolean isInside(int id, boolean turned) {
    double size =
        Math.max(world.radius(id), Math.max(Math.abs(world.x(id)), Math.abs(world.y(id))));
    for (Bounds b : world.scene().bounds().stream().toList()) {
      size = Math.max(size, Math.max(Math.abs(b.xmin()), Math.abs(b.xmax())));
      size = Math.max(size, Math.max(Math.abs(b.ymin()), Math.abs(b.ymax())));
    }
    double slack = size <= Double.MAX_VALUE ? ULPS * Math.ulp(size) : 0;
    boolean mayTouch = turned || !world.gravity().equals(Vec2.ZERO);
    return beyond(world, id) <= slack + (mayTouch ? IN_CONTACT * world.radius(id) : 0);
  }

  /** How far a circle is over a wall that it can meet; less than 0 inside, and without any. */
  static double beyond(World world, int id) {
    if (!Filters.areBound(world, id)) {
      return Double.NEGATIVE_INFINITY;
    }
    return world.radius(id) - room(world, world.x(id), world.y(id));
  }

  /** How far a place is from the nearest wall; less than 0 outside of the bounds. */
  static double room(World world, double x, double y) {
    Bounds b = world.scene().bounds().get();
    return Math.min(Math.min(x - b.xmin(), b.xmax() - x), Math.min(y - b.ymin(), b.ymax() - y));
  }
}
