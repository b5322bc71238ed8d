// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.SplittableRandom;

/** Random numbers of the kinds that break detectors, from one seed. */
public final class Draw {
  private final SplittableRandom random;

  public Draw(long seed) {
    this.random = new SplittableRandom(seed);
  }

  /** Those of a seed for a family. */
  public static Draw of(long seed, String family) {
    return new Draw(seed * 0x9E3779B97F4A7C15L ^ family.hashCode());
  }

  /** A plain vector of doubles, to build queries with. */
  record Point(double x, double y) {
    Point plus(Point other) {
      return new Point(x + other.x, y + other.y);
    }

    Point minus(Point other) {
      return new Point(x - other.x, y - other.y);
    }

    Point times(double factor) {
      return new Point(x * factor, y * factor);
    }

    Point turned() {
      return new Point(-y, x);
    }

    /** This vector turned left by an angle. */
    Point turned(double angle) {
      return times(StrictMath.cos(angle)).plus(turned().times(StrictMath.sin(angle)));
    }
  }

  /** An exact Pythagorean triple: x^2 + y^2 = z^2, z > 0, any quadrant. */
  record Triple(double x, double y, double z) {
    Point direction() {
      return new Point(x, y);
    }
  }

  boolean chance(double probability) {
    return random.nextDouble() < probability;
  }

  /** A whole number in low..high, both included. */
  public int whole(int low, int high) {
    return random.nextInt(low, high + 1);
  }

  double in(double low, double high) {
    return low + (high - low) * random.nextDouble();
  }

  /** Log-uniform: every power of ten in low..high as likely as any other. */
  double log(double low, double high) {
    return StrictMath.exp(in(StrictMath.log(low), StrictMath.log(high)));
  }

  double sign() {
    return random.nextBoolean() ? 1 : -1;
  }

  double pick(double... values) {
    return values[random.nextInt(values.length)];
  }

  /** A point of the usual box, +-100. */
  Point place() {
    return new Point(in(-100, 100), in(-100, 100));
  }

  /** A point of a small integer lattice. */
  Point node(int range) {
    return new Point(whole(-range, range), whole(-range, range));
  }

  /** A unit vector in any direction, rounded. */
  Point direction() {
    return new Point(1, 0).turned(in(-Math.PI, Math.PI));
  }

  /** A value moved by a given number of ulps. */
  static double ulps(double value, int count) {
    double moved = value;
    for (int i = 0; i < Math.abs(count); i++) {
      moved = count > 0 ? Math.nextUp(moved) : Math.nextDown(moved);
    }
    return moved;
  }

  /** A value moved by -3..3 ulps, seldom up to a thousand, not at all in a third of the cases. */
  double nudge(double value) {
    int count = chance(0.35) ? 0 : chance(0.8) ? whole(-3, 3) : whole(-1000, 1000);
    return ulps(value, count);
  }

  /** One of the numbers but the last, which is the end of the window, moved by a few ulps. */
  void nudgeOne(double[] numbers, double probability) {
    if (chance(probability)) {
      int i = whole(0, numbers.length - 2);
      numbers[i] = nudge(numbers[i]);
    }
  }

  /**
   * Moves some of the given numbers: those that are 0 by small multiples of one unit of
   * 1e-16..1e-323, so that two such moves can cancel; others by an ulp.
   */
  void tiny(double[] numbers, int... candidates) {
    double unit = Math.max(Double.MIN_VALUE, StrictMath.pow(10, in(-323.3, -16)));
    for (int moves = chance(0.7) ? 1 : whole(2, 3); moves > 0; moves--) {
      int i = candidates[whole(0, candidates.length - 1)];
      numbers[i] = numbers[i] == 0 ? whole(-2, 2) * unit : ulps(numbers[i], whole(-1, 1));
    }
  }

  /** A small Pythagorean triple, also the flat ones (1, 0, 1). */
  Triple triple() {
    int m = whole(1, 12);
    int n = whole(0, m);
    double odd = m * m - n * n;
    double even = 2 * m * n;
    double z = m * m + n * n;
    Triple t = new Triple(sign() * odd, sign() * even, z);
    return random.nextBoolean() ? t : new Triple(t.y(), t.x(), z);
  }

  /** A whole number of any size up to 2^40, as a rule a small one. */
  double multiple() {
    return chance(0.7) ? whole(1, 30) : Math.rint(log(1, 0x1p40));
  }

  /** A power of two that keeps small integers exact: often 1. */
  double binaryScale() {
    return chance(0.4) ? 1 : Math.scalb(1.0, whole(-12, 12));
  }
}
