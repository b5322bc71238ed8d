// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Filter;
import dev.carom.Kind;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.Random;

/**
 * Draws the filters of a session, in one of three sessions, from a generator of its own. It also
 * says which things can meet.
 */
final class Filters {

  private final Random random;
  private final boolean used;

  Filters(long seed) {
    random = new Random(seed);
    used = random.nextInt(3) == 0;
  }

  /** Draws a filter for the thing added last, or leaves it the default. */
  void draw(SceneBuilder builder) {
    if (used && random.nextBoolean()) {
      builder.filter(new Filter(bits(), bits()));
    }
  }

  /** Each bit of three is set three times of four. */
  private int bits() {
    return random.ints(2, 0, 8).reduce(0, (a, b) -> a | b);
  }

  /** Now and then sets the filter of something. */
  void edit(World world) {
    Kind kind = Kind.values()[random.nextInt(4)];
    int[] ids = world.ids(kind);
    if (used && ids.length > 0 && random.nextInt(4) == 0) {
      int id = ids[random.nextInt(ids.length)];
      Filter filter = new Filter(bits(), bits());
      world.setTraits(kind, id, world.traits(kind, id).withFilter(filter));
    }
  }

  /** Whether a circle can meet something, which may be a circle. */
  static boolean meet(World world, int circle, Kind kind, int id) {
    return world.traits(Kind.CIRCLE, circle).filter().meets(world.traits(kind, id).filter());
  }

  /** Whether the scene has bounds that a circle can meet. */
  static boolean areBound(World world, int circle) {
    return world.scene().bounds().isPresent() && meet(world, circle, Kind.WALL, 0);
  }
}
