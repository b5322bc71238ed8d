// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.Random;

/**
 * Gravity in one of three sessions, at its start and set between its steps. It is drawn from a
 * generator of its own, so that all else of the session is as it is without.
 */
final class Falls {

  /** Between one of so many actions gravity is set. */
  private static final int EDITS = 12;

  private static final long SALT = 0x67726176697479L;

  private final Random random;
  private final boolean used;
  private final double unit;

  Falls(long seed, Numbers numbers) {
    random = new Random(seed ^ SALT);
    used = random.nextInt(3) == 0;
    unit = numbers.speedUnit() / numbers.length() * numbers.speedUnit();
  }

  /** Gives a scene gravity, or not; some begin without, and get it later. */
  void begin(SceneBuilder builder) {
    if (used && random.nextInt(5) > 0) {
      builder.gravity(across(), down());
    }
  }

  /** Sets gravity, or not; returns whether it did. */
  boolean edit(World world) {
    if (!used || random.nextInt(EDITS) > 0) {
      return false;
    }
    if (random.nextInt(4) == 0) {
      world.setGravity(0, 0);
    } else {
      world.setGravity(across(), down());
    }
    return true;
  }

  /** As a rule none. */
  private double across() {
    return random.nextInt(4) == 0 ? unit * random.nextGaussian() / 4 : 0;
  }

  /** As a rule downwards, such that a fall through the box takes some steps; also very weak. */
  private double down() {
    double[] some = {-0.125, -0.25, -1, -0.3 * random.nextDouble(), random.nextGaussian(), -1e-9};
    return unit * some[random.nextInt(some.length)];
  }
}
