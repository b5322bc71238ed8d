// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.SweptCircleAnswers.assertImpact;
import static dev.carom.SweptCircleAnswers.assertVector;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The detector against bounds, pegs, endpoints and moving circles, on cases like 3-4-5. */
class SweptCircleOtherObstaclesTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  // Bounds.

  private static final Bounds ROOM = new Bounds(0, 0, 80, 60);

  private static double walls(Circle c, Vec2 v, double T) {
    double t =
        new SweptCircle(c.x(), c.y(), c.radius(), v.x(), v.y()).timeToBounds(0, 0, 80, 60, T);
    assertThat(new SweptCircle(c, v).cast(ROOM, T).map(Impact::time).orElse(NEVER)).isEqualTo(t);
    return t;
  }

  @ParameterizedTest
  @CsvSource({
    "-4, 1,   9,   0, 32.25, 1, 0, 4",
    " 4, 1,   9,  80, 39,   -1, 0, 4",
    " 1,-4,   6.5, 46.5, 0,  0, 1, 4",
    " 1, 4,   6.5, 46.5, 60, 0,-1, 4"
  })
  void eachWall(
      double vx, double vy, double t, double x, double y, double nx, double ny, double speed) {
    // From (40, 30) with radius 4: 36 to the left and right, 26 down and up.
    Circle circle = new Circle(40, 30, 4);
    double expectedY = nx == 0 ? y : 30 + vy * t;
    Impact impact = new SweptCircle(circle, new Vec2(vx, vy)).cast(ROOM, NEVER).orElseThrow();
    assertImpact(
        impact,
        SweptCircleAnswers.impact(
            t,
            Kind.WALL,
            nx > 0 ? 0 : nx < 0 ? 1 : ny > 0 ? 2 : 3,
            Feature.SIDE,
            new Vec2(x, expectedY),
            new Vec2(nx, ny),
            speed));
    assertThat(walls(circle, new Vec2(vx, vy), t)).isEqualTo(t);
    assertThat(walls(circle, new Vec2(vx, vy), Math.nextDown(t))).isEqualTo(NEVER);
  }

  @Test
  void inACornerTheVerticalWallIsReported() {
    Impact impact = new SweptCircle(10, 10, 4, -2, -2).cast(ROOM, 10).orElseThrow();
    assertThat(impact.time()).isEqualTo(3);
    assertVector(impact.normal(), new Vec2(1, 0), 1e-15);
    assertThat(impact.point()).isEqualTo(new Vec2(0, 4));
  }

  @Test
  void wallsAreHalfPlanes() {
    assertThat(walls(new Circle(-30, 30, 4), new Vec2(-1, 0), 1)).as("beyond, deeper").isZero();
    assertThat(walls(new Circle(-30, 30, 4), new Vec2(1, 0), 40))
        .as("beyond, out")
        .isEqualTo(NEVER);
    assertThat(walls(new Circle(4, 30, 4), new Vec2(0, 1), 1))
        .as("touching, along")
        .isEqualTo(NEVER);
    assertThat(walls(new Circle(4, 30, 4), new Vec2(-1, 0), 0)).as("touching, in").isZero();
    assertThat(walls(new Circle(4, 30, 4), Vec2.ZERO, NEVER)).as("at rest").isEqualTo(NEVER);
  }

  // Pegs, endpoints, pairs.

  @Test
  void aPeg() {
    Circle peg = new Circle(0, 0, 7);
    Impact impact = new SweptCircle(9 + 3, 12 + 4, 8, -3, -4).cast(peg, 10).orElseThrow();
    assertThat(impact.time()).isEqualTo(1);
    assertThat(impact.kind()).isEqualTo(Kind.PEG);
    assertThat(impact.feature()).isEqualTo(Feature.CIRCLE);
    assertVector(impact.normal(), new Vec2(0.6, 0.8), 1e-15);
    assertThat(impact.point().x()).isCloseTo(4.2, within(1e-15));
    assertThat(impact.point().y()).isCloseTo(5.6, within(1e-15));
    assertThat(impact.approachSpeed()).isEqualTo(5);
    assertThat(new SweptCircle(12, 16, 8, -3, -4).timeToPeg(0, 0, 7, 1)).isEqualTo(1);
    assertThat(new SweptCircle(12, 16, 8, -3, -4).timeToPeg(0, 0, 7, Math.nextDown(1.0)))
        .isEqualTo(NEVER);
  }

  @Test
  void insideAPegTheCircleStillCannotComeNearerToItsCentre() {
    assertThat(new SweptCircle(3, 4, 1, -3, -4).timeToPeg(0, 0, 20, 1)).as("inward").isZero();
    assertThat(new SweptCircle(3, 4, 1, 3, 4).timeToPeg(0, 0, 20, 9))
        .as("outward")
        .isEqualTo(NEVER);
    assertThat(new SweptCircle(0, 0, 1, 3, 4).timeToPeg(0, 0, 20, 9))
        .as("concentric")
        .isEqualTo(NEVER);
  }

  /** Beyond both, by more on the second: both are hit now, and then the vertical one is told. */
  @Test
  void twoWallsThatAreOverlappedAreHitAtTheSameTime() {
    SweptCircle circle = new SweptCircle(1, 1, 5, -1, -9);
    for (SweptCircle any : List.of(circle, circle.withAcceleration(1, -3))) {
      Impact impact = any.cast(ROOM, 9).orElseThrow();
      assertThat(impact.time()).isZero();
      assertThat(impact.id()).as("left").isZero();
      assertThat(impact.approachSpeed()).isEqualTo(1);
    }
  }

  @Test
  void anEndpointIsAPegOfRadiusZero() {
    Circle end = new Circle(10, 0, 0);
    Impact impact = new SweptCircle(16, 8, 5, -3, -4).cast(end, 1).orElseThrow();
    assertImpact(
        impact,
        SweptCircleAnswers.impact(
            1, Kind.PEG, -1, Feature.CIRCLE, new Vec2(10, 0), new Vec2(0.6, 0.8), 5));
  }

  /** The gap of 10 closes at 2 + 3 a frame; they touch at x = 4 + 1. */
  @Test
  void aPairHeadOn() {
    Circle first = new Circle(0, 0, 1);
    Circle second = new Circle(13, 0, 2);
    Impact impact =
        new SweptCircle(first, new Vec2(2, 0))
            .cast(new SweptCircle(second, new Vec2(-3, 0)), 2)
            .orElseThrow();
    assertImpact(
        impact,
        SweptCircleAnswers.impact(
            2, Kind.CIRCLE, -1, Feature.CIRCLE, new Vec2(5, 0), new Vec2(-1, 0), 5));
    assertThat(new SweptCircle(0, 0, 1, 2, 0).timeToCircle(new SweptCircle(13, 0, 2, -3, 0), 2))
        .isEqualTo(2);
    assertThat(
            new SweptCircle(0, 0, 1, 2, 0)
                .timeToCircle(new SweptCircle(13, 0, 2, -3, 0), Math.nextDown(2.0)))
        .isEqualTo(NEVER);
  }

  /** 20 apart along (0.6, 0.8), and closing at 5; both move across besides. */
  @Test
  void aPairMetAtAnAngle() {
    Circle first = new Circle(18, 24, 5);
    Circle second = new Circle(0, 0, 5);
    Impact impact =
        new SweptCircle(first, new Vec2(-4, 3))
            .cast(new SweptCircle(second, new Vec2(3 - 4, 4 + 3)), 9)
            .orElseThrow();
    assertThat(impact.time()).isEqualTo(4);
    assertVector(impact.normal(), new Vec2(0.6, 0.8), 1e-15);
    assertThat(impact.approachSpeed()).isCloseTo(5, within(1e-15));
    assertVector(impact.point(), new Vec2(-1, 32), 1e-14);
  }

  @Test
  void aPairThatMovesTogetherNeverMeets() {
    assertThat(new SweptCircle(0, 0, 1, 7, 5).timeToCircle(new SweptCircle(13, 0, 2, 7, 5), NEVER))
        .isEqualTo(NEVER);
    assertThat(new SweptCircle(0, 0, 8, 7, 5).timeToCircle(new SweptCircle(13, 0, 8, 7, 5), NEVER))
        .as("overlapping")
        .isEqualTo(NEVER);
    assertThat(new SweptCircle(0, 0, 1, 7, 5).timeToCircle(new SweptCircle(0, 0, 2, -1, 0), NEVER))
        .as("concentric")
        .isEqualTo(NEVER);
  }

  /** A faster circle catches up from behind: 10 at 5 - 3 a frame. */
  @Test
  void aPairFromBehind() {
    assertThat(new SweptCircle(0, 0, 1, 5, 0).timeToCircle(new SweptCircle(13, 0, 2, 3, 0), NEVER))
        .isEqualTo(5);
    assertThat(new SweptCircle(0, 0, 1, 3, 0).timeToCircle(new SweptCircle(13, 0, 2, 5, 0), NEVER))
        .isEqualTo(NEVER);
  }

  @Test
  void aPairThatGrazesIsNone() {
    assertThat(new SweptCircle(0, 0, 1, 1, 0).timeToCircle(new SweptCircle(20, 3, 2, -1, 0), NEVER))
        .isEqualTo(NEVER);
    // sqrt(2 R h) before they are beside each other, with R = 3 and h = 2^-51, at a speed of 2
    assertThat(
            new SweptCircle(0, 0, 1, 1, 0)
                .timeToCircle(new SweptCircle(20, Math.nextDown(3.0), 2, -1, 0), NEVER))
        .isCloseTo(10 - Math.sqrt(2 * 3 * 0x1p-51) / 2, within(Math.ulp(10.0)));
  }
}
