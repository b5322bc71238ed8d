// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.Random;
import java.util.function.Supplier;
import java.util.function.ToIntFunction;
import org.junit.jupiter.api.Test;

/**
 * Near ties, put to the predicates themselves: one number is chosen, as the difference or the sum
 * of two doubles, such that what is left of the polynomial is some 2^-107 of its terms.
 * Double-double numbers err by more than that, so a sign that they tell although their bound does
 * not allow it is wrong as often as not. Exact numbers are the truth.
 */
class PredicatesTest {
  private static final int QUESTIONS = 2_000;
  private static final MathContext DIGITS = new MathContext(60);

  private final Random random = new Random(11);

  /** A number near 1, or smaller by some powers of two; often one of few bits. */
  private double number() {
    double size = random.nextInt(3) == 0 ? 1 + random.nextInt(8) / 8.0 : 1 + random.nextDouble();
    return Math.scalb(random.nextBoolean() ? size : -size, -random.nextInt(4));
  }

  /** Nearly the same, by some powers of two. */
  private double slightlyOff(double x) {
    return x * (1 + Math.scalb(random.nextDouble() - 0.5, -random.nextInt(45)));
  }

  private static BigDecimal big(double x) {
    return new BigDecimal(x);
  }

  private static BigDecimal times(BigDecimal a, BigDecimal b) {
    return a.multiply(b);
  }

  private static BigDecimal over(BigDecimal a, BigDecimal b) {
    return a.divide(b, DIGITS);
  }

  /** The difference of two numbers of a question. */
  private static BigDecimal difference(double[] n, int i, int j) {
    return big(n[i]).subtract(big(n[j]));
  }

  /** Makes a difference such that it is a value, as nearly as two doubles can. */
  private static void set(double[] n, int i, int j, BigDecimal value) {
    n[i] = value.doubleValue();
    n[j] = big(n[i]).subtract(value).doubleValue();
  }

  /** Makes a sum such that it is a value. */
  private static void setSum(double[] n, int i, int j, BigDecimal value) {
    set(n, i, j, value);
    n[j] = -n[j];
  }

  /** A difference of 106 bits or less. */
  private void draw(double[] n, int i, int j) {
    n[i] = number();
    n[j] = random.nextInt(4) == 0 ? 0 : Math.ulp(n[i]) * (random.nextDouble() - 0.5);
  }

  /** In other units, of some of the numbers. */
  private void scale(double[] n, int most, int... places) {
    multiply(n, random.nextInt(3) == 0 ? random.nextInt(2 * most) - most : 0, places);
  }

  private static void multiply(double[] n, int exponent, int... places) {
    for (int i : places) {
      n[i] = Math.scalb(n[i], exponent);
    }
  }

  private static void assertTold(
      Supplier<double[]> question, ToIntFunction<double[]> told, ToIntFunction<double[]> truth) {
    int certain = 0;
    for (int i = 0; i < QUESTIONS; i++) {
      double[] n = question.get();
      int sign = truth.applyAsInt(n);
      assertThat(told.applyAsInt(n)).as(() -> Arrays.toString(n)).isEqualTo(sign);
      certain += sign * sign;
    }
    assertThat(certain).as("no ties").isGreaterThan(QUESTIONS / 2);
  }

  // In the plane.

  /** Vectors p = (0 - 2, 1 - 3) and q = (4 - 6, 5 - 7). */
  private static BigDecimal cross(double[] n) {
    return times(difference(n, 0, 2), difference(n, 5, 7))
        .subtract(times(difference(n, 1, 3), difference(n, 4, 6)));
  }

  private static BigDecimal square(double[] n, int... at) {
    BigDecimal sum = BigDecimal.ZERO;
    for (int i = 0; i < at.length; i += 2) {
      sum = sum.add(difference(n, at[i], at[i + 1]).pow(2));
    }
    return sum;
  }

  private double[] twoVectors(int more) {
    double[] n = new double[8 + more];
    draw(n, 0, 2);
    draw(n, 1, 3);
    draw(n, 4, 6);
    draw(n, 5, 7);
    return n;
  }

  @Test
  void cross() {
    assertTold(
        () -> {
          double[] n = twoVectors(0);
          BigDecimal qy = times(difference(n, 1, 3), difference(n, 4, 6));
          set(n, 5, 7, over(qy, difference(n, 0, 2)));
          scale(n, 300, 0, 1, 2, 3);
          scale(n, 300, 4, 5, 6, 7);
          return n;
        },
        n -> Predicates.cross(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]),
        n -> ExactSigns.NUMBERS.cross(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]));
  }

  @Test
  void gap() {
    assertTold(
        () -> {
          double[] n = new double[6];
          draw(n, 0, 2);
          draw(n, 1, 3);
          setSum(n, 4, 5, square(n, 0, 2, 1, 3).sqrt(DIGITS));
          scale(n, 400, 0, 1, 2, 3, 4, 5);
          return n;
        },
        n -> Predicates.gap(n[0], n[1], n[2], n[3], n[4], n[5]),
        n -> ExactSigns.NUMBERS.gap(n[0], n[1], n[2], n[3], n[4], n[5]));
  }

  @Test
  void reach() {
    assertTold(
        () -> {
          double[] n = twoVectors(2);
          if (random.nextBoolean()) {
            // Nearly parallel: the cross product cancels.
            n[4] = slightlyOff(n[0]);
            n[5] = slightlyOff(n[1]);
          }
          setSum(n, 8, 9, over(cross(n).abs(), square(n, 0, 2, 1, 3).sqrt(DIGITS)));
          scale(n, 500, 0, 1, 2, 3);
          scale(n, 500, 4, 5, 6, 7, 8, 9);
          return n;
        },
        n -> Predicates.discriminant(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9]),
        n ->
            ExactSigns.NUMBERS.discriminant(
                n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9]));
  }

  /** p, a, v, b, c, r: {@code (p - a) x v |w| = -side r (v.w)}, {@code w = b - c}. */
  private double[] corner(int side) {
    double[] n = new double[11];
    draw(n, 1, 3);
    draw(n, 6, 8);
    draw(n, 7, 9);
    if (random.nextBoolean()) {
      multiply(n, -random.nextInt(60), 1, 3);
    }
    n[4] = number();
    // Often nearly across the line: v.w cancels.
    n[5] = random.nextBoolean() ? number() : slightlyOff(-n[4] * n[6] / n[7]);
    n[10] = Math.scalb(Math.abs(number()), -random.nextInt(30));
    BigDecimal along =
        times(big(n[4]), difference(n, 6, 8)).add(times(big(n[5]), difference(n, 7, 9)));
    BigDecimal x = over(times(big(n[10]), along), square(n, 6, 8, 7, 9).sqrt(DIGITS));
    BigDecimal dx = times(difference(n, 1, 3), big(n[4])).add(side > 0 ? x.negate() : x);
    set(n, 0, 2, over(dx, big(n[5])));
    if (random.nextInt(4) == 0) {
      // A circle so small that the tail of its square underflows, but fast along a long line.
      int small = 470 + random.nextInt(40);
      multiply(n, -small, 0, 1, 2, 3, 10);
      multiply(n, small - random.nextInt(300), 4, 5);
      return n;
    }
    if (random.nextInt(4) == 0) {
      // A line so short that the tail of its squared length does, and a large and fast circle.
      int large = 120 + random.nextInt(20);
      multiply(n, large, 0, 1, 2, 3, 10);
      multiply(n, 230 - large + random.nextInt(20), 4, 5);
      multiply(n, -490 - random.nextInt(40), 6, 7, 8, 9);
      return n;
    }
    scale(n, 500, 0, 1, 2, 3, 10);
    scale(n, 500, 4, 5);
    scale(n, 500, 6, 7, 8, 9);
    return n;
  }

  @Test
  void corner() {
    for (int side = -1; side <= 1; side += 2) {
      int s = side;
      assertTold(
          () -> corner(s),
          n ->
              Predicates.corner(
                  s, n[0], n[1], n[2], n[3], n[4], n[5], 0, 0, n[6], n[7], n[8], n[9], n[10]),
          n ->
              ExactSigns.NUMBERS.corner(
                  s, n[0], n[1], n[2], n[3], n[4], n[5], 0, 0, n[6], n[7], n[8], n[9], n[10]));
    }
  }
}
