// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Vec2;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;

/**
 * Where the things of a session are put, and how often it is edited: in half of all sessions as
 * drawn, in each of the others in one special way. It draws from a generator of its own, so that
 * all else of the session is as it is without.
 */
final class Variation {

  /** A special way. */
  enum Kind {
    NONE,
    /** Some circles start far outside of the box, or are put there. */
    FAR,
    /** Many start, or are put, on the centre of a circle or a peg, or on an end of a line. */
    CONCENTRIC,
    /** All places, radii and speeds are small whole numbers, or halves of them. */
    SMALL,
    /** Something is edited before each step. */
    EDITED;

    /** The kind of the session of a seed. */
    static Kind of(long seed) {
      SplittableRandom random = new SplittableRandom(seed ^ SALT); // its first bits are random, too
      return random.nextBoolean() ? NONE : values()[1 + random.nextInt(values().length - 1)];
    }
  }

  private static final long SALT = 0x706C6163000AC3L;

  /** The least and the most powers of two of box widths to a circle far outside. */
  private static final int NEAREST = 2;

  private static final int FARTHEST = 28;

  private final Kind kind;
  private final Random random;
  private final double length;
  private final List<Vec2> centres = new ArrayList<>();

  Variation(Kind kind, long seed, double length) {
    this.kind = kind;
    this.length = length;
    random = new Random(~(seed ^ SALT));
  }

  /** Whether something is edited before each step. */
  boolean editsEachStep() {
    return kind == Kind.EDITED;
  }

  /** Notes a place as that of a centre. */
  void centre(double x, double y) {
    centres.add(new Vec2(x, y));
  }

  /** Where a circle is put for which a place was drawn. */
  Vec2 place(double x, double y) {
    Vec2 drawn = new Vec2(x, y);
    centres.add(drawn);
    return switch (kind) {
      case FAR -> random.nextInt(3) > 0 ? drawn : far(x, y);
      case CONCENTRIC -> centres.get(random.nextInt(centres.size()));
      default -> drawn;
    };
  }

  /** On an axis, on a diagonal or anywhere. */
  private Vec2 far(double x, double y) {
    int power = NEAREST + random.nextInt(FARTHEST - NEAREST + 1);
    double distance = Math.scalb(Numbers.WIDTH * length, power);
    double across = (random.nextInt(3) - 1) * distance;
    double up =
        (random.nextInt(3) - 1) * distance * (random.nextBoolean() ? 1 : random.nextDouble());
    return new Vec2(x + across, y + up);
  }
}
