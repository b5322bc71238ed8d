// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Random;

/**
 * Random numbers of an {@link EditSession}: places in a box of 100 x 80, often whole ones, so that
 * there are ties.
 */
class SessionNumbers {

  static final int WIDTH = 100;
  static final int HEIGHT = 80;

  /** Spacing of a lattice of places. */
  static final int PITCH = 5;

  final Random random;

  SessionNumbers(Random random) {
    this.random = random;
  }

  /** The unit of length; a power of two. */
  double length() {
    return 1;
  }

  /** Where the box begins, on both axes. */
  double origin() {
    return 0;
  }

  /** When circles begin to move. */
  double begin() {
    return 0;
  }

  /** How many circles a scene has. */
  int circles() {
    return 2 + random.nextInt(6);
  }

  double x() {
    return place(WIDTH);
  }

  double y() {
    return place(HEIGHT);
  }

  double place(int most) {
    return random.nextBoolean()
        ? PITCH * random.nextInt(most / PITCH + 1)
        : most * random.nextDouble();
  }

  double radius() {
    return random.nextBoolean() ? 1 + random.nextInt(4) : 0.5 + 4 * random.nextDouble();
  }

  /** The radius of a peg: 0 too. */
  double pegRadius() {
    return random.nextInt(6);
  }

  double speed() {
    return random.nextBoolean() ? random.nextInt(11) - 5 : 3 * random.nextGaussian();
  }

  /** An acceleration, often a whole one. */
  double gravity(Random random) {
    return random.nextBoolean() ? random.nextInt(5) - 2 : 2 * random.nextGaussian();
  }

  double mass() {
    return 1 + random.nextInt(3);
  }

  double restitution() {
    return random.nextInt(4) == 0 ? 0.9 : 1;
  }

  /** Duration of a step: about that many units of time, or, if whole, 0, 1 or 2. */
  double duration(double units, boolean whole) {
    return whole ? random.nextInt(3) : units * random.nextDouble();
  }

  /**
   * Numbers in which methods fail: on a lattice that is that of the radii too (joints, corridors of
   * one diameter), or some ulps off; in units of any power of two; far from the origin; masses
   * without bound and without end; walls that add to a speed; and so late that a circle crosses
   * cells within an ulp of time.
   */
  static final class Hard extends SessionNumbers {

    private static final int LARGEST_EXPONENT = 480;

    /** With gravity, whose terms are of the second degree in time. */
    private static final int LARGEST_FALLING_EXPONENT = 120;

    private static final int FARTHEST_EXPONENT = 36;

    private final boolean lattice;
    private final boolean neighbours;
    private final boolean elastic;
    private final boolean late;

    /** Many circles, of sizes that share no cells. */
    private final boolean crowded;

    private final double length;
    private final double origin;
    private final double speed;
    private final double begin;

    Hard(Random random, boolean falls) {
      super(random);
      int largest = falls ? LARGEST_FALLING_EXPONENT : LARGEST_EXPONENT;
      lattice = random.nextInt(3) > 0;
      neighbours = random.nextBoolean();
      elastic = random.nextBoolean();
      late = random.nextInt(3) == 0;
      boolean extreme = !late && random.nextInt(3) == 0;
      length = extreme ? power(largest) : 1;
      origin = random.nextInt(4) > 0 ? 0 : length * farAway();
      crowded = origin == 0 && random.nextInt(6) == 0;
      // Within the last place of the time a circle moves by 2^-4 to 2^8 units.
      begin = late ? Math.scalb(1.0, 30 + random.nextInt(20)) : 0;
      speed =
          late
              ? Math.scalb(1 / Math.ulp(begin), random.nextInt(13) - 4)
              : (extreme ? power(largest) : 1);
    }

    /** Up to where a double tells a thousandth of the smallest radius, or nearly so. */
    private double farAway() {
      return Math.copySign(power(FARTHEST_EXPONENT), random.nextGaussian());
    }

    private double power(int most) {
      return Math.scalb(1.0, random.nextInt(2 * most + 1) - most);
    }

    @Override
    double length() {
      return length;
    }

    @Override
    double origin() {
      return origin;
    }

    @Override
    double begin() {
      return begin;
    }

    @Override
    double place(int most) {
      double place =
          isWhole() ? PITCH * random.nextInt(most / PITCH + 1) : most * random.nextDouble();
      return near(origin + length * place);
    }

    @Override
    int circles() {
      return crowded ? 20 + random.nextInt(20) : super.circles();
    }

    @Override
    double radius() {
      double smaller = crowded ? Math.scalb(1.0, -random.nextInt(8)) : 1;
      return length
          * smaller
          * (isWhole()
              ? near((1 + random.nextInt(4)) * PITCH / 2.0)
              : 0.1 + 8 * random.nextDouble());
    }

    @Override
    double pegRadius() {
      return random.nextInt(4) == 0 ? 0 : radius();
    }

    /** Along the axes and the diagonals as a rule; sometimes very slow or very fast. */
    @Override
    double speed() {
      double v = isWhole() ? near(random.nextInt(7) - 3.0) : 3 * random.nextGaussian();
      return speed
          * v
          * switch (random.nextInt(20)) {
            case 0 -> 1e-9;
            case 1 -> 0x1p-20;
            case 2 -> late ? 1 : 1e3;
            default -> 1;
          };
    }

    @Override
    double gravity(Random random) {
      return super.gravity(random) * (speed * speed / length);
    }

    @Override
    double mass() {
      return switch (random.nextInt(12)) {
        case 0 -> Double.POSITIVE_INFINITY;
        case 1 -> 0x1p-500;
        case 2 -> 0x1p500;
        case 3, 4 -> 1 + random.nextDouble();
        default -> 1 + random.nextInt(3);
      };
    }

    @Override
    double restitution() {
      double[] some = {0, 0.5, 0.9, 1, 1, 1, 1, 1.1};
      return elastic ? 1 : some[random.nextInt(some.length)];
    }

    /** Late in time as long as an ulp of it. */
    @Override
    double duration(double units, boolean whole) {
      double drawn = super.duration(2 * units, whole) * (length / speed);
      return late && whole ? Math.ulp(begin) : drawn;
    }

    private boolean isWhole() {
      return lattice && random.nextInt(4) > 0;
    }

    /** The same or up to three ulps off; 0 itself, for its neighbours lose places when scaled. */
    private double near(double value) {
      double near = value;
      int ulps = neighbours ? random.nextInt(7) - 3 : 0;
      for (int i = 0; i < Math.abs(ulps) && value != 0; i++) {
        near = ulps > 0 ? Math.nextUp(near) : Math.nextDown(near);
      }
      return near;
    }
  }
}
