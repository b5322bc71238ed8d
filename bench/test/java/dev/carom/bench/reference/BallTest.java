// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import java.util.function.BinaryOperator;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;

class BallTest {

  private static final int BITS = 128;
  private static final int CASES = 5_000;

  private static Ball ball(double value) {
    return Ball.of(value, BITS);
  }

  /** A difference that is zero for real numbers is zero here, or within the errors carried. */
  private static void assertNotRefuted(Ball zero) {
    try {
      assertThat(zero.sign()).isZero();
    } catch (DoubtException e) {
      assertThat(zero.error()).isPositive().isLessThan(1e-20);
    }
  }

  @Test
  void identitiesAreNeverRefuted() {
    Random random = new Random(1);
    for (int i = 0; i < CASES; i++) {
      Ball a = ball(random.nextGaussian()).over(ball(3 + random.nextDouble()));
      Ball b = ball(random.nextGaussian() * 100).over(ball(-1 - random.nextDouble()));
      Ball c = ball(1 + random.nextDouble()).sqrt();
      assertNotRefuted(a.plus(b).times(c).minus(a.times(c)).minus(b.times(c)));
      assertNotRefuted(a.over(c).times(c).minus(a));
      assertNotRefuted(b.times(b).sqrt().minus(b.abs()));
      assertNotRefuted(a.plus(b).times(a.minus(b)).minus(a.times(a).minus(b.times(b))));
      assertNotRefuted(a.times(b).negate().plus(b.times(a)));
    }
  }

  /** A number with an error of 2^-38, far above the rounding of doubles: {@code x / 3 * 3}. */
  private static Ball wide(double x) {
    return Ball.of(x * 0x1p-40, 80).over(Ball.of(3, 80)).times(Ball.of(0x3p40, 80));
  }

  /** Numbers at the ends of two balls give one within the result, and it is no larger than that. */
  private static void assertErrorIsThatOf(BinaryOperator<Ball> f, DoubleBinaryOperator g) {
    Random random = new Random(4);
    for (int i = 0; i < 100; i++) {
      Ball a = wide(1 + random.nextDouble());
      Ball b = wide(random.nextBoolean() ? 3 + random.nextDouble() : -2 - random.nextDouble());
      double error = f.apply(a, b).error();
      double middle = g.applyAsDouble(a.head(), b.head());
      double most = 0;
      for (int ends = 0; ends < 4; ends++) {
        double x = a.head() + (ends % 2 == 0 ? -1 : 1) * a.error();
        double y = b.head() + (ends < 2 ? -1 : 1) * b.error();
        most = Math.max(most, Math.abs(g.applyAsDouble(x, y) - middle));
      }
      assertThat(error).isBetween(0.999 * most, 1.001 * most);
    }
  }

  @Test
  void errorsAreThoseOfTheEnds() {
    assertThat(wide(1).error()).isBetween(0x1p-40, 0x1p-37);
    assertErrorIsThatOf(Ball::plus, (x, y) -> x + y);
    assertErrorIsThatOf(Ball::minus, (x, y) -> x - y);
    assertErrorIsThatOf(Ball::times, (x, y) -> x * y);
    assertErrorIsThatOf(Ball::over, (x, y) -> x / y);
    assertErrorIsThatOf((a, b) -> a.sqrt(), (x, y) -> Math.sqrt(x));
    assertErrorIsThatOf((a, b) -> b.abs(), (x, y) -> Math.abs(y));
  }

  /** One unit in the 110th of 128 places is seen, so errors are not held far too large either. */
  @Test
  void smallDifferencesAreTold() {
    Random random = new Random(2);
    Ball little = ball(0x1p-110);
    for (int i = 0; i < CASES; i++) {
      Ball a = ball(1 + random.nextDouble()).over(ball(3));
      Ball c = ball(1 + random.nextDouble()).sqrt();
      assertThat(a.over(c).times(c).minus(a).plus(little).sign()).isEqualTo(1);
      assertThat(a.times(a).sqrt().compareTo(a.plus(little))).isEqualTo(-1);
    }
  }

  @Test
  void dyadicNumbersStayExact() {
    Ball zero = ball(0.1).times(ball(-0.3)).plus(ball(0.3).times(ball(0.1)));
    assertThat(zero.sign()).isZero();
    assertThat(ball(0.75).over(ball(1.5)).minus(ball(0.5)).sign()).isZero();
    assertThat(ball(2.25).sqrt().minus(ball(1.5)).error()).isZero();
    assertThat(ball(0x1p-200).error()).as("too small for the bits").isEqualTo(0x1p-128);
  }

  @Test
  void whatTheBitsDoNotDecideIsInDoubt() {
    Ball third = ball(1).over(ball(3));
    Ball difference = third.times(ball(3)).minus(ball(1));
    assertThatThrownBy(difference::sign).isInstanceOf(DoubtException.class);
    assertThatThrownBy(() -> third.over(difference)).isInstanceOf(DoubtException.class);
  }

  /** With so many bits that only a tie explains it. */
  @Test
  void tiesAreTakenAsTies() {
    Ball third = Ball.of(1, 1024).over(Ball.of(3, 1024));
    assertThat(third.times(Ball.of(3, 1024)).compareTo(Ball.of(1, 1024))).isZero();
  }

  /** {@code 1 + 2^-53} and {@code 1 + 3 x 2^-53}, with errors to either side. */
  @Test
  void halfwayBetweenTwoDoublesTheEvenOneIsTaken() {
    for (int k = 3; k < 200; k += 2) {
      Ball part = Ball.of(1, 1024).over(Ball.of(k, 1024));
      assertThat(Ball.of(k, 1024).plus(Ball.of(k * 0x1p-53, 1024)).times(part).rounded())
          .isEqualTo(1);
      assertThat(Ball.of(k, 1024).plus(Ball.of(k * 0x3p-53, 1024)).times(part).rounded())
          .isEqualTo(1 + 0x1p-51);
    }
  }

  @Test
  void doublesAreTheNearest() {
    Random random = new Random(3);
    for (int i = 0; i < CASES; i++) {
      double a = Math.scalb(random.nextDouble() - 0.5, random.nextInt(40) - 20);
      double b = 1 + random.nextDouble();
      BigDecimal quotient = new BigDecimal(a).divide(new BigDecimal(b), new MathContext(60));
      Ball ball = ball(a).over(ball(b));
      assertThat(ball.rounded()).isEqualTo(quotient.doubleValue());
      BigDecimal rest = quotient.subtract(new BigDecimal(ball.rounded()));
      assertThat(ball.tail())
          .isCloseTo(rest.doubleValue(), within(0x1p-127 + 2 * Math.ulp(ball.tail())));
    }
  }

  @Test
  void logarithmIsThatOfAnUpperBound() {
    assertThat(ball(1e-30).log10()).isBetween(-30.0, -30 + 1e-7);
    assertThat(ball(0).log10()).isEqualTo(Double.NEGATIVE_INFINITY);
  }
}
