// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.oracle.Draw;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.Query;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The detector's answers for a circle with a constant acceleration: the contract by examples. */
class SweptCircleParabolaTest {
  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** From (0, 0) to (10, 0). */
  private static final Line FLOOR = new Line(0, 0, 10, 0);

  private static final Vec2 G = new Vec2(0, -2);

  private static Optional<Impact> cast(Circle circle, Vec2 v, Obstacle obstacle, double T) {
    return new SweptCircle(circle, v).withAcceleration(G.x(), G.y()).cast(obstacle, T);
  }

  @Test
  void aBallFallsOnTheFloor() {
    Impact impact = cast(new Circle(5, 5, 1), new Vec2(1, 0), FLOOR, NEVER).orElseThrow();
    assertThat(impact.time()).isEqualTo(2);
    assertThat(impact.feature()).isEqualTo(Feature.SIDE);
    assertThat(impact.normal()).isEqualTo(new Vec2(0, 1));
    assertThat(impact.point()).isEqualTo(new Vec2(7, 0));
    assertThat(impact.approachSpeed()).isEqualTo(4);
    assertThat(impact.kind()).isEqualTo(Kind.LINE);
    assertThat(impact.kind()).isEqualTo(Kind.LINE);
    assertThat(impact.id()).isEqualTo(-1);
  }

  @Test
  void aBallFallsOnAnEnd() {
    // Height 0.8 and 0.6 beside the end after 2.
    Impact impact = cast(new Circle(-0.6, 4.8, 1), new Vec2(0, 0), FLOOR, 9).orElseThrow();
    assertThat(impact.time()).isCloseTo(2, within(1e-15));
    assertThat(impact.feature()).isEqualTo(Feature.START);
    assertThat(impact.normal().x()).isCloseTo(-0.6, within(1e-15));
    assertThat(impact.normal().y()).isCloseTo(0.8, within(1e-15));
    assertThat(impact.point()).isEqualTo(new Vec2(0, 0));
    assertThat(impact.approachSpeed()).isCloseTo(3.2, within(1e-14));
  }

  @Test
  void aBallFallsOnAPegAndOnACircleThatRises() {
    Circle peg = new Circle(5, -1, 1);
    Impact impact = cast(new Circle(5, 5, 1), Vec2.ZERO, peg, NEVER).orElseThrow();
    assertThat(impact.time()).isEqualTo(2);
    assertThat(impact.feature()).isEqualTo(Feature.CIRCLE);
    assertThat(impact.kind()).isEqualTo(Kind.PEG);
    assertThat(impact.point()).isEqualTo(new Vec2(5, 0));
    Impact rising =
        new SweptCircle(5, 5, 1, 0, 0)
            .withAcceleration(G.x(), G.y())
            .cast(new SweptCircle(peg, new Vec2(0, 3)), NEVER)
            .orElseThrow();
    assertThat(rising.time()).isEqualTo(1);
    assertThat(rising.approachSpeed()).isEqualTo(5);
    assertThat(rising.point()).isEqualTo(new Vec2(5, 3));
    assertThat(rising.kind()).isEqualTo(Kind.CIRCLE);
  }

  @Test
  void circlesWithOneCentreThatFallTogetherAtOnceHaveANormal() {
    Impact impact =
        new SweptCircle(3, 4, 1, 0, 0)
            .withAcceleration(G.x(), G.y())
            .cast(new SweptCircle(3, 4, 2, 0, -Double.MIN_VALUE), 9)
            .orElseThrow();
    assertThat(impact.time()).isZero();
    assertThat(impact.normal()).isEqualTo(new Vec2(0, 1));
  }

  @Test
  void aBallThrownUpMeetsTheCeilingOrComesBackToTheFloor() {
    Bounds box = new Bounds(0, 0, 10, 6);
    Circle ball = new Circle(5, 1, 1);
    Impact floor = cast(ball, new Vec2(0, 3), box, NEVER).orElseThrow();
    assertThat(floor.time()).isEqualTo(3);
    assertThat(floor.id()).isEqualTo(2);
    assertThat(floor.normal()).isEqualTo(new Vec2(0, 1));
    assertThat(floor.approachSpeed()).isEqualTo(3);
    Impact ceiling = cast(ball, new Vec2(0, 5), box, NEVER).orElseThrow();
    assertThat(ceiling.time()).isEqualTo(1);
    assertThat(ceiling.id()).isEqualTo(3);
    assertThat(ceiling.normal()).isEqualTo(new Vec2(0, -1));
    assertThat(ceiling.approachSpeed()).isEqualTo(3);
    // With 4 it reaches the ceiling's distance at its apex: a graze.
    Impact graze = cast(ball, new Vec2(0, 4), box, NEVER).orElseThrow();
    assertThat(graze.id()).isEqualTo(2);
    assertThat(graze.time()).isEqualTo(4);
  }

  @Test
  void oneOfTwoWallsThatAreHitAtOnceIsTheVerticalOne() {
    Bounds box = new Bounds(0, 0, 10, 10);
    Impact impact = cast(new Circle(3, 5, 1), new Vec2(-1, 0), box, NEVER).orElseThrow();
    assertThat(impact.time()).isEqualTo(2);
    assertThat(impact.id()).isZero();
    assertThat(impact.normal()).isEqualTo(new Vec2(1, 0));
    assertThat(impact.point()).isEqualTo(new Vec2(0, 1));
  }

  @Test
  void touchingWithoutNormalSpeedTheAccelerationDecides() {
    Impact rests = cast(new Circle(5, 1, 1), Vec2.ZERO, FLOOR, 0).orElseThrow();
    assertThat(rests.time()).isZero();
    assertThat(rests.approachSpeed()).isZero();
    assertThat(rests.normal()).isEqualTo(new Vec2(0, 1));
    assertThat(cast(new Circle(5, 1, 1), new Vec2(3, 0), FLOOR, 9)).isPresent();
    assertThat(cast(new Circle(5, -1, 1), Vec2.ZERO, FLOOR, 9)).isEmpty();
    // Over an end the way bends, too: v.v + d.g > 0.
    assertThat(cast(new Circle(0, 1, 1), new Vec2(-2, 0), FLOOR, 9)).isEmpty();
    assertThat(cast(new Circle(0, 1, 1), new Vec2(-1, 0), FLOOR, 9)).isPresent();
  }

  @Test
  void turnedBackWhileItOverlapsItHitsThen() {
    Impact impact = cast(new Circle(5, 0.25, 1), new Vec2(0, 1), FLOOR, NEVER).orElseThrow();
    assertThat(impact.time()).isEqualTo(0.5);
    assertThat(impact.approachSpeed()).isZero();
    assertThat(impact.feature()).isEqualTo(Feature.SIDE);
    assertThat(cast(new Circle(5, 0.25, 1), new Vec2(0, 1), FLOOR, Math.nextDown(0.5))).isEmpty();
    Impact after = cast(new Circle(5, 0, 1), new Vec2(0, 3), FLOOR, NEVER).orElseThrow();
    assertThat(after.time()).isEqualTo((3 + Math.sqrt(5)) / 2);
  }

  @Test
  void aGrazeAtTheApexIsNone() {
    Line ceiling = new Line(0, 6, 10, 6);
    assertThat(cast(new Circle(5, 1, 1), new Vec2(0, 4), ceiling, NEVER)).isEmpty();
    assertThat(cast(new Circle(5, 1, 1), new Vec2(0, Math.nextUp(4.0)), ceiling, NEVER))
        .isPresent();
  }

  @Test
  void theWindowIsClosed() {
    assertThat(new SweptCircle(5, 5, 1, 0, 0, 0, -2).timeToLine(0, 0, 10, 0, 2)).isEqualTo(2);
    assertThat(new SweptCircle(5, 5, 1, 0, 0, 0, -2).timeToLine(0, 0, 10, 0, Math.nextDown(2.0)))
        .isEqualTo(NEVER);
    assertThat(new SweptCircle(5, 5, 1, 0, 0, 0, -2).timeToPeg(5, -1, 1, 2)).isEqualTo(2);
    assertThat(new SweptCircle(5, 5, 1, 0, 0, 0, -2).timeToPeg(5, -1, 1, Math.nextDown(2.0)))
        .isEqualTo(NEVER);
    assertThat(new SweptCircle(5, 5, 1, 0, 0, 0, -2).timeToBounds(0, 0, 10, 10, 2)).isEqualTo(2);
    assertThat(new SweptCircle(5, 5, 1, 0, 0, 0, -2).timeToBounds(0, 0, 10, 10, Math.nextDown(2.0)))
        .isEqualTo(NEVER);
  }

  @ParameterizedTest
  @ValueSource(ints = {-1000, -500, -100, 100, 400, 900})
  void sizeDoesNotMatter(int exponent) {
    double s = Math.scalb(1.0, exponent);
    assertThat(new SweptCircle(5 * s, 5 * s, s, s, 0, 0, -2 * s).timeToLine(0, 0, 10 * s, 0, NEVER))
        .isEqualTo(2);
    assertThat(new SweptCircle(5 * s, 5 * s, s, 0, 0, 0, -2 * s).timeToPeg(5 * s, -s, s, NEVER))
        .isEqualTo(2);
    assertThat(
            new SweptCircle(5 * s, 5 * s, s, s, 0, 0, -2 * s)
                .timeToBounds(0, 0, 9 * s, 9 * s, NEVER))
        .isEqualTo(2);
  }

  static Stream<Family<Query>> families() {
    return Families.all().stream();
  }

  /** Without acceleration the answers are those of the straight forms, bit for bit. */
  @ParameterizedTest
  @MethodSource("families")
  void noAccelerationGivesTheBitsOfTheStraightForms(Family<Query> family) {
    Draw draw = new Draw(11);
    for (int i = 0; i < 100; i++) {
      Query query = family.next(draw);
      double straight = query.ask(LibraryDetector.STRAIGHT).time();
      for (double none : new double[] {0.0, -0.0}) {
        double time = query.ask(LibraryDetector.falling(none, none)).time();
        assertThat(time).as(query.hex()).isEqualTo(straight);
      }
    }
  }

  // Where both move.

  /** The line rises at 3: it meets the ball, which is 5 - t^2 high, at 3 t, when t = 1. */
  @Test
  void aFallingBallMeetsALineThatRises() {
    SweptCircle ball = new SweptCircle(5, 5, 1, 1, 0, 0, -2);
    assertThat(ball.timeToLine(0, 0, 10, 0, 0, 3, NEVER)).isEqualTo(1);
    Impact impact = ball.cast(FLOOR, new Vec2(0, 3), NEVER).orElseThrow();
    assertThat(impact.time()).isEqualTo(1);
    assertThat(impact.feature()).isEqualTo(Feature.SIDE);
    assertThat(impact.point()).isEqualTo(new Vec2(6, 3));
    assertThat(impact.approachSpeed()).isEqualTo(5);
  }

  /** Relative to the other one it falls at 2: from 6 apart they touch, at 2, after 2. */
  @Test
  void twoBallsMayFallDifferently() {
    SweptCircle fast = new SweptCircle(5, 6, 1, 1, 0, 0, -3);
    SweptCircle slow = new SweptCircle(5, 0, 1, 1, 0, 0, -1);
    assertThat(fast.timeToCircle(slow, NEVER)).isEqualTo(2);
    assertThat(slow.timeToCircle(fast, NEVER)).isEqualTo(2);
    Impact impact = fast.cast(slow, NEVER).orElseThrow();
    assertThat(impact.time()).isEqualTo(2);
    assertThat(impact.normal()).isEqualTo(new Vec2(0, 1));
    assertThat(impact.point()).as("-2 + 1").isEqualTo(new Vec2(7, -1));
    assertThat(impact.approachSpeed()).isEqualTo(4);
    Impact other = slow.cast(fast, NEVER).orElseThrow();
    assertThat(other.normal()).isEqualTo(new Vec2(0, -1));
    assertThat(other.point()).isEqualTo(new Vec2(7, -1));
    assertThat(other.approachSpeed()).isEqualTo(4);
  }

  /** They approach at 3, from 8 apart to 2, and fall by 4 meanwhile. */
  @Test
  void twoBallsThatFallAlikeMoveStraightRelativeToEachOther() {
    SweptCircle left = new SweptCircle(0, 0, 1, 2, 0, 0, -2);
    SweptCircle right = new SweptCircle(8, 0, 1, -1, 0, 0, -2);
    assertThat(left.timeToCircle(right, NEVER)).isEqualTo(2);
    assertThat(left.timeToCircle(right, Math.nextDown(2.0))).isEqualTo(NEVER);
    Impact impact = left.cast(right, NEVER).orElseThrow();
    assertThat(impact.time()).isEqualTo(2);
    assertThat(impact.point()).isEqualTo(new Vec2(5, -4));
    assertThat(impact.normal()).isEqualTo(new Vec2(-1, 0));
    assertThat(impact.approachSpeed()).isEqualTo(3);
  }

  /** Against the same circle that takes off the other one's fall, on numbers of few bits. */
  @Test
  void theDifferenceOfTwoFallsDecides() {
    Random random = new Random(1);
    int hits = 0;
    for (int i = 0; i < 20_000; i++) {
      double[] n = random.ints(14, -9, 10).asDoubleStream().toArray();
      SweptCircle a = new SweptCircle(n[0], n[1], Math.abs(n[2]), n[3], n[4], n[5], n[6]);
      SweptCircle b = new SweptCircle(n[7], n[8], Math.abs(n[9]), n[10], n[11], n[12], n[13]);
      SweptCircle straight = b.withAcceleration(0, 0);
      SweptCircle relative = a.withAcceleration(n[5] - n[12], n[6] - n[13]);
      double time = a.timeToCircle(b, 99);
      assertThat(time).isEqualTo(relative.timeToCircle(straight, 99));
      assertThat(time).isEqualTo(b.timeToCircle(a, 99));
      assertThat(a.cast(b, 99).map(Impact::time).orElse(NEVER)).isEqualTo(time);
      hits += time < NEVER ? 1 : 0;
      Impact impact = a.cast(b, 99).orElse(null);
      if (impact != null && time > 0) {
        Vec2 onB = b.at(time).center();
        double r = b.radius();
        double size = 1e-13 * (1 + Math.abs(onB.x()) + Math.abs(onB.y()) + time * time);
        assertThat(impact.point().x()).isCloseTo(onB.x() + r * impact.normal().x(), within(size));
        assertThat(impact.point().y()).isCloseTo(onB.y() + r * impact.normal().y(), within(size));
      }
    }
    assertThat(hits).isGreaterThan(5_000);
  }

  /** At opposite ends of the range their difference is none: the largest double stands for it. */
  @Test
  void aDifferenceBeyondTheRangeOfDoublesIsTheLargestOne() {
    SweptCircle down = new SweptCircle(0, 0x1p1000, 1, 0, 0, 0, -Double.MAX_VALUE);
    SweptCircle up = new SweptCircle(0, 0, 1, 0, 0, 0, Double.MAX_VALUE);
    assertThat(down.timeToCircle(up, NEVER))
        .isEqualTo(down.timeToCircle(up.withAcceleration(0, 0), NEVER))
        .isPositive();
  }

  @Test
  void theCircleAtATime() {
    SweptCircle ball = new SweptCircle(1, 2, 3, 4, 5, 6, 8);
    assertThat(ball.at(0)).isEqualTo(new Circle(1, 2, 3));
    assertThat(ball.at(2)).isEqualTo(new Circle(1 + 8 + 12, 2 + 10 + 16, 3));
    assertThat(ball.at(-1)).isEqualTo(new Circle(0, 1, 3));
    assertThat(ball.withAcceleration(0, 0).at(2)).isEqualTo(new Circle(9, 12, 3));
    assertThat(ball.withVelocity(0, -2).at(1)).isEqualTo(new Circle(4, 4, 3));
    assertThat(ball.at(1e300)).isEqualTo(new Circle(Double.MAX_VALUE, Double.MAX_VALUE, 3));
  }

  /** The centre is beside the line by 1e-168, which the square of the time, 1e-318, cannot tell. */
  @Test
  void aTimeWhoseSquareUnderflowsTellsSideFromEnd() {
    Line line =
        new Line(
            -0x1.20276261c6e8bp-484,
            0x1.7b0727c03a331p-557,
            0x1.d58d8e9b41876p-768,
            -0x1.06e7405c28233p43);
    Circle circle =
        new Circle(-0x1.0322d51c24aaep-490, -0x1.0106073d115f8p-492, 0x1.a2847b0153c5dp-594);
    Vec2 velocity = new Vec2(-0x1.bd3eda17e178ap43, 0x1.98a0b29b75eefp36);
    SweptCircle falling =
        new SweptCircle(circle, velocity)
            .withAcceleration(-0x1.477f4d99d393p566, -0x1.44d3d51c41295p564);
    Impact impact = falling.cast(line, NEVER).orElseThrow();
    assertThat(impact.feature()).isEqualTo(Feature.SIDE);
    assertThat(impact.normal().x()).isEqualTo(1);
  }

  /** Squares of the height underflow at the small scale: it is then as if it touched the strip. */
  @Test
  void aDiskBeyondAnEndHitsTheSideAtEveryScale() {
    double large = timeBesideAnEnd(0, 0);
    assertThat(large).isLessThan(0.3);
    assertThat(timeBesideAnEnd(-120, 84)).isEqualTo(Math.scalb(large, -204));
  }

  /** With lengths and speeds times powers of two. */
  private static double timeBesideAnEnd(int length, int speed) {
    double[] n = {0.2334, 2.344, 0.15625, 0.125, -0.625, -0.03125, 0.15625, 1.6432, 0.3918, 2.2831};
    for (int i = 0; i < n.length; i++) {
      boolean isSpeed = i == 3 || i == 4;
      n[i] = Math.scalb(n[i], i == 5 ? 2 * speed - length : isSpeed ? speed : length);
    }
    return new SweptCircle(n[0], n[1], n[2], n[3], n[4], 0, n[5])
        .timeToLine(n[6], n[7], n[8], n[9], NEVER);
  }
}
