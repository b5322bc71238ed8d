// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import java.util.Random;

/**
 * Numbers for worlds in a box of 100 x 80 units, of one kind for a session: any, whole ones on a
 * lattice (ties, joints, corridors of just one diameter), or neighbours of those by some ulps. The
 * units of length and of speed may be any powers of two.
 */
final class Numbers {

  static final double WIDTH = 100;
  static final double HEIGHT = 80;

  private static final int PITCH = 5;
  private static final int LARGEST_EXPONENT = 150;

  private final Random random;
  private final boolean small;
  private final boolean lattice;
  private final boolean neighbours;
  private final double length;
  private final double speed;

  /**
   * Draws the kind of a session.
   *
   * @param small whether all numbers are small and whole, or halves, in a box of 20 x 16
   */
  Numbers(Random random, boolean small) {
    this.random = random;
    this.small = small;
    lattice = random.nextInt(3) > 0;
    neighbours = random.nextBoolean() && !small;
    boolean extreme = random.nextInt(4) == 0 && !small;
    length = extreme ? power() : 1;
    speed = extreme ? power() : 1;
  }

  private double power() {
    return Math.scalb(1.0, random.nextInt(2 * LARGEST_EXPONENT + 1) - LARGEST_EXPONENT);
  }

  /** The unit of length. */
  double length() {
    return length;
  }

  /** The unit of speed. */
  double speedUnit() {
    return speed;
  }

  /** The pitch of the lattice, in units. */
  private double pitch() {
    return small ? 1 : PITCH;
  }

  /** The width of the box. */
  double width() {
    return WIDTH / PITCH * pitch() * length;
  }

  /** The height of the box. */
  double height() {
    return HEIGHT / PITCH * pitch() * length;
  }

  double x() {
    return place((int) WIDTH);
  }

  double y() {
    return place((int) HEIGHT);
  }

  private double place(int most) {
    return length * (isWhole() ? near(pitch() * random.nextInt(most / PITCH + 1)) : most * part());
  }

  /** One step along an axis, of about the lattice's pitch, or none. */
  double step() {
    return length * pitch() * (isWhole() ? near(random.nextInt(3) - 1.0) : random.nextGaussian());
  }

  /** Often a half or a whole of the lattice's pitch. */
  double radius() {
    return length * (isWhole() ? near((1 + random.nextInt(4)) * pitch() / 2) : 0.1 + 8 * part());
  }

  /** Of a peg: 0 too. */
  double pegRadius() {
    return random.nextInt(4) == 0 ? 0 : radius();
  }

  /** Along the axes and the diagonals as a rule; sometimes very slow or very fast. */
  double speed() {
    double v = isWhole() ? near(random.nextInt(7) - 3.0) : 3 * random.nextGaussian();
    int rare = small ? 2 : random.nextInt(20);
    return speed * v * (rare == 0 ? 1e-9 : rare == 1 ? 1e3 : 1);
  }

  /** Of a step: often 0, as a rule some frames. */
  double duration() {
    double unit = length / speed;
    return switch (random.nextInt(8)) {
      case 0 -> 0;
      case 1 -> unit * 60 * part();
      case 2 -> unit * (1 + random.nextInt(3));
      default -> unit * 4 * part();
    };
  }

  double mass() {
    return switch (random.nextInt(12)) {
      case 0 -> Double.POSITIVE_INFINITY;
      case 1 -> 0x1p-500;
      case 2 -> 0x1p500;
      case 3, 4 -> 1 + part();
      default -> 1 + random.nextInt(3);
    };
  }

  private boolean isWhole() {
    return small || (lattice && random.nextInt(4) > 0);
  }

  private double part() {
    return random.nextDouble();
  }

  private double near(double value) {
    double moved = value;
    int ulps = neighbours ? random.nextInt(7) - 3 : 0;
    for (int i = 0; i < Math.abs(ulps); i++) {
      moved = ulps > 0 ? Math.nextUp(moved) : Math.nextDown(moved);
    }
    // Not next to 0: such numbers lose their places when they are scaled.
    return value == 0 ? 0 : moved;
  }
}
