// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.oracle.PairQuery;
import dev.carom.oracle.SegmentQuery;
import dev.carom.oracle.SphereQuery;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.Random;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Whether an impact comes before the end of the window, where that end is nearly the time of
 * impact, in any units of length and of time.
 */
class WindowEndTest {
  private static final int HITS = 2_000;
  private static final MathContext DIGITS = new MathContext(60);
  private static final double FOREVER = Double.POSITIVE_INFINITY;

  private final Random random = new Random(3);

  private double number(double size) {
    double x = random.nextInt(3) == 0 ? random.nextInt(9) / 8.0 : random.nextDouble();
    return random.nextBoolean() ? x * size : -x * size;
  }

  private double radius() {
    return Math.scalb(1 + random.nextDouble(), -random.nextInt(random.nextInt(12) + 1));
  }

  private static void multiply(double[] n, int exponent, int... places) {
    for (int i : places) {
      n[i] = Math.scalb(n[i], exponent);
    }
  }

  /**
   * Ends the window near the time of impact, or makes that nearly 1; then changes the units.
   *
   * @param lengths where the lengths stand, the others are velocities, the last one the window's
   *     end
   */
  private void end(double[] n, ToDoubleFunction<double[]> time, int[] lengths, int[] speeds) {
    int end = n.length - 1;
    n[end] = FOREVER;
    double t = time.applyAsDouble(n);
    double off = random.nextInt(4) == 0 ? 0 : Math.scalb(number(1), -random.nextInt(53));
    if (!(t > 1e-9 && t < 1e9)) {
      t = 1;
    }
    int length = random.nextInt(3) == 0 ? 0 : -470 - random.nextInt(90);
    int speed = length;
    if (random.nextInt(3) == 0) {
      for (int i : speeds) {
        n[i] *= t * (1 + off);
      }
      n[end] = 1;
    } else {
      n[end] = t * (1 + off);
      int ticks = random.nextInt(3) == 0 ? 0 : random.nextInt(1_000) - 500;
      speed = Math.max(length - ticks, -1_000);
      n[end] = Math.scalb(n[end], length - speed);
    }
    multiply(n, length, lengths);
    multiply(n, speed, speeds);
  }

  private static double[] parse(ArgumentsAccessor numbers, int count) {
    return IntStream.range(0, count)
        .mapToDouble(i -> Double.parseDouble(numbers.getString(i)))
        .toArray();
  }

  // Two disks: x1 y1 r1 vx1 vy1 x2 y2 r2 vx2 vy2 T.

  private double[] disks() {
    double[] n = new double[11];
    int small = random.nextInt(2) * -random.nextInt(50);
    for (int i : new int[] {0, 1, 5, 6}) {
      n[i] = number(4);
    }
    for (int i : new int[] {3, 4, 8, 9}) {
      n[i] = number(1);
    }
    if (random.nextInt(3) == 0) {
      n[5] = -n[0];
      n[6] = -n[1];
    }
    multiply(n, small, 0, 5);
    multiply(n, random.nextInt(2) * -random.nextInt(50), 3, 8);
    n[2] = radius();
    n[7] = random.nextBoolean() ? 0 : radius();
    if (random.nextBoolean()) {
      n = new double[] {n[1], n[0], n[2], n[4], n[3], n[6], n[5], n[7], n[9], n[8], 0};
    }
    end(n, WindowEndTest::pair, new int[] {0, 1, 2, 5, 6, 7}, new int[] {3, 4, 8, 9});
    return n;
  }

  private static double pair(double[] n) {
    return new SweptCircle(n[0], n[1], n[2], n[3], n[4])
        .timeToCircle(new SweptCircle(n[5], n[6], n[7], n[8], n[9]), n[10]);
  }

  @Test
  void ofDisks() {
    assertTimes(this::disks, WindowEndTest::pair, n -> PairQuery.of(n).truth().time());
  }

  // Two spheres: x1 y1 z1 r1 vx1 vy1 vz1 x2 y2 z2 r2 vx2 vy2 vz2 T.

  private double[] spheres() {
    double[] n = new double[15];
    for (int axis = 0; axis < 3; axis++) {
      n[axis] = number(4);
      n[7 + axis] = random.nextInt(3) == 0 ? -n[axis] : number(4);
      n[4 + axis] = number(1);
      n[11 + axis] = random.nextInt(3) == 0 ? n[4 + axis] : number(1);
      multiply(n, random.nextInt(2) * -random.nextInt(50), axis, 7 + axis);
      multiply(n, random.nextInt(2) * -random.nextInt(50), 4 + axis, 11 + axis);
    }
    n[3] = radius();
    n[10] = random.nextBoolean() ? 0 : radius();
    end(
        n,
        WindowEndTest::sphere,
        new int[] {0, 1, 2, 3, 7, 8, 9, 10},
        new int[] {4, 5, 6, 11, 12, 13});
    return n;
  }

  private static double sphere(double[] n) {
    return new SweptSphere(n[0], n[1], n[2], n[3], n[4], n[5], n[6])
        .timeToSphere(new SweptSphere(n[7], n[8], n[9], n[10], n[11], n[12], n[13]), n[14]);
  }

  @Test
  void ofSpheres() {
    assertTimes(this::spheres, WindowEndTest::sphere, n -> new SphereQuery(n).truth());
  }

  /**
   * Apart by next to nothing, and moving nearly along each other: they touch soon, and part again.
   * No digit of the plain time is right, so it may lie beyond the window's end.
   */
  private double[] touching() {
    double size = radius();
    double[] d = {number(size), number(size), number(size)};
    double[] u = {-d[1], d[0], random.nextInt(3) == 0 ? Math.scalb(number(1), -60) : 0};
    double least = Math.scalb(1 + random.nextDouble(), -random.nextInt(16) - 26);
    BigDecimal dd = BigDecimal.ZERO;
    BigDecimal b = BigDecimal.ZERO;
    BigDecimal a = BigDecimal.ZERO;
    for (int axis = 0; axis < 3; axis++) {
      u[axis] -= least * d[axis];
      dd = dd.add(new BigDecimal(d[axis]).pow(2));
      a = a.add(new BigDecimal(u[axis]).pow(2));
      b = b.add(new BigDecimal(u[axis]).multiply(new BigDecimal(d[axis])));
    }
    if (a.signum() == 0) {
      return touching();
    }
    BigDecimal gap = b.pow(2).divide(a, DIGITS).multiply(new BigDecimal(random.nextDouble()));
    BigDecimal r = dd.subtract(gap).sqrt(DIGITS);
    double r1 = Math.nextDown(r.doubleValue());
    double r2 = r.subtract(new BigDecimal(r1)).doubleValue();
    double end = Math.scalb(1.0, -random.nextInt(14) - 12);
    double[] n = new double[15];
    int turn = random.nextInt(3);
    double share = random.nextBoolean() ? 0.5 : 1;
    for (int axis = 0; axis < 3; axis++) {
      int to = (axis + turn) % 3;
      n[to] = share * d[axis];
      n[7 + to] = (share - 1) * d[axis];
      n[4 + to] = u[axis];
    }
    n[3] = r1;
    n[10] = r2;
    n[14] = end;
    int ticks = random.nextInt(2) * random.nextInt(60);
    multiply(n, -ticks, 4, 5, 6);
    multiply(n, ticks, 14);
    return n;
  }

  @Test
  void ofSpheresThatNearlyTouch() {
    assertTimes(this::touching, WindowEndTest::sphere, n -> new SphereQuery(n).truth());
  }

  /** Found by search: they touch at a time near the end, along an axis of which a term is left. */
  @ParameterizedTest
  @CsvSource({
    "0x1.6b9f37f52ff8ep-64, -0x1.bfc062d69c093p-64, -0x1.3a6fe688a2bb1p-64, 0x1.17cd3abc9b388p-65,"
        + " -0x1.47a803ecab2c2p-1, 0x1.39fbbf67e7249p-4, -0x1.3ffa2a1515e86p-3,"
        + " 0x1.547c9c62cd3a8p-64, -0x1.37dadd7713692p-64, -0x1.524b280cd9696p-64, 0, 0, 0, 0,"
        + " 0x1.c5e48da5b9acbp-116",
    "0x1.11639f78b6fbap351, -0x1.151cd0bcad9cfp351, -0x1.d5e41794c8c92p350, 0x1.27103e765f848p346,"
        + " 0x1.17dd069f50eb7p1, -0x1.d83d4d6ab2425p-1, -0x1.514d9f759a211p-2,"
        + " 0x1.1499625831db8p351, -0x1.15e806134aaf2p351, -0x1.01d8eb3219836p351,"
        + " 0x1.a0a844fc808eap346, 0, 0, 0, 0x1.55133bb14cae2p344"
  })
  void ofSpheresFoundBySearch(ArgumentsAccessor numbers) {
    double[] n = parse(numbers, 15);
    assertThat(sphere(n)).isEqualTo(new SphereQuery(n).truth());
  }

  // A disk and the side of a line: ax ay bx by px py r vx vy T.

  private double[] side() {
    double[] n = new double[10];
    n[0] = number(4);
    n[1] = number(4);
    n[2] = n[0] + Math.scalb(number(4), random.nextInt(2) * -random.nextInt(40));
    n[3] = n[1] + Math.scalb(number(4), random.nextInt(2) * -random.nextInt(40));
    n[4] = (n[0] + n[2]) / 2;
    n[5] = (n[1] + n[3]) / 2 + 6 + number(1);
    n[6] = radius();
    n[7] = number(1) / 8;
    n[8] = -radius();
    return n;
  }

  private static double line(double[] n) {
    return new SweptCircle(n[4], n[5], n[6], n[7], n[8]).timeToLine(n[0], n[1], n[2], n[3], n[9]);
  }

  @Test
  void ofSides() {
    assertSides(
        n -> {
          end(n, WindowEndTest::line, new int[] {0, 1, 2, 3, 4, 5, 6}, new int[] {7, 8});
          return n;
        });
  }

  /** A line that is as good as a point, beside the radius. */
  @Test
  void ofSidesOfAnyLength() {
    assertSides(
        n -> {
          int unit = random.nextInt(300);
          double half = Math.scalb(1 + random.nextDouble(), -400 - random.nextInt(140));
          double[] m = {-half, 0, half, 0, 0, 3 + random.nextDouble(), 1, 0, -1, FOREVER};
          m[9] = line(m) * (1 + Math.scalb(number(1), -random.nextInt(53)));
          multiply(m, unit, 5, 6, 8);
          return m;
        });
  }

  private void assertSides(UnaryOperator<double[]> change) {
    assertTimes(
        () -> change.apply(side()), WindowEndTest::line, n -> SegmentQuery.of(n).truth().time());
  }

  /** The answers are those of the oracle, to questions of which so many end in an impact. */
  private static void assertTimes(
      Supplier<double[]> questions,
      ToDoubleFunction<double[]> time,
      ToDoubleFunction<double[]> truth) {
    int hits = 0;
    while (hits < HITS) {
      double[] n = questions.get();
      double expected = truth.applyAsDouble(n);
      assertThat(time.applyAsDouble(n)).as(() -> Arrays.toString(n)).isEqualTo(expected);
      hits += expected < FOREVER ? 1 : 0;
    }
  }

  /**
   * Found by search: lines and pegs in units in which a term of the bound that is for what
   * underflows is all there is of it, or in which the polynomial overflows.
   */
  @ParameterizedTest
  @CsvSource({
    "0x1.2p4, 0x1.ep3, 0, 0, -0x1.b80ab2c4a1p41, 0x1.520ca9dd8bp41, 0x1.b80ab2bec5p41, 0x1p-771,"
        + " 0, 0x1.fffffffffffffp1023",
    "0x1.c90157e3274b2p-531, -0x1.48p10, -0x1.c90157e3274b2p-530, 0, 0, -0x1.0ep11, 0, 0,"
        + " 0x1.a8p10, 1",
    "-0x1.7cafa36134e8fp353, -0x1.3cb9487d37ee6p355, -0x1.7f415e36520e4p353,"
        + " -0x1.3c082bb7a9696p355, -0x1.cc96fcf919206p353, -0x1.1647e20deb775p355, 0,"
        + " 0x1.f300eb82009a8p148, -0x1.e72e640f3334ap149, 0x1.3d64f961a790bp202"
  })
  void ofSidesInExtremeUnits(ArgumentsAccessor numbers) {
    double[] n = parse(numbers, 10);
    assertThat(line(n)).isEqualTo(SegmentQuery.of(n).truth().time());
  }
}
