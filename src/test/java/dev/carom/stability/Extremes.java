// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Draws doubles from all over their range, its ends, and what was drawn before. */
final class Extremes {

  private static final double[] POOL = {
    0,
    Double.MIN_VALUE,
    3 * Double.MIN_VALUE,
    Double.MIN_NORMAL,
    1e-310,
    1e-300,
    1e-200,
    1e-162,
    1e-100,
    1e-16,
    0.1,
    0.5,
    1,
    2,
    3,
    10,
    1e9,
    0x1p53,
    1e30,
    1e100,
    1e150,
    1e154,
    1e200,
    1e300,
    0x1p1023,
    Double.MAX_VALUE / 4,
    Double.MAX_VALUE
  };

  final Random random;
  private final List<Double> drawn = new ArrayList<>();

  Extremes(long seed) {
    random = new Random(seed);
  }

  /** Any finite double: -0, denormals, the largest, and neighbours of each other. */
  double any() {
    double v = random.nextInt(3) == 0 ? -size() : size();
    for (int i = random.nextInt(5); i > 2; i--) {
      v = random.nextBoolean() ? Math.nextUp(v) : Math.nextDown(v);
    }
    v = Math.max(-Double.MAX_VALUE, Math.min(v, Double.MAX_VALUE));
    drawn.add(v);
    return v;
  }

  /** A number of any size, at least 0. */
  double size() {
    return switch (random.nextInt(8)) {
      case 0, 1 -> drawn.isEmpty() ? 1 : Math.abs(drawn.get(random.nextInt(drawn.size())));
      case 2 -> random.nextInt(5);
      case 3 -> Math.scalb(random.nextDouble(), random.nextInt(2098) - 1074);
      case 4 -> random.nextDouble();
      default -> POOL[random.nextInt(POOL.length)];
    };
  }

  /** The end of a window. */
  double window() {
    return random.nextInt(3) == 0 ? Double.POSITIVE_INFINITY : size();
  }

  /** A mass: 2^-500 to 2^500, or infinite. */
  double mass() {
    return random.nextInt(3) == 0
        ? Double.POSITIVE_INFINITY
        : Math.scalb(1.0, random.nextInt(1001) - 500);
  }
}
