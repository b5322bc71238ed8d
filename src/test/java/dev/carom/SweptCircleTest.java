// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.SweptCircleAnswers.assertImpact;
import static dev.carom.SweptCircleAnswers.assertVector;
import static dev.carom.SweptCircleAnswers.hit;
import static dev.carom.SweptCircleAnswers.time;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The detector against lines, on cases whose answers can be worked out by hand: right triangles
 * 3-4-5 and numbers of few bits, so that every expected value is exact. In the drawings {@code o}
 * is the centre, {@code *} the end that is hit, {@code =} the line.
 */
class SweptCircleTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** From (0, 0) to (10, 0). */
  private static final Line FLOOR = new Line(0, 0, 10, 0);

  private static Impact impact(
      double t, Feature feature, double x, double y, double nx, double ny, double speed) {
    return SweptCircleAnswers.impact(
        t, Kind.LINE, -1, feature, new Vec2(x, y), new Vec2(nx, ny), speed);
  }

  // The six edge cases of the article.

  /**
   *
   *
   * <pre>
   *         o
   *         |
   *         v
   *   =============
   * </pre>
   */
  @Test
  void case1SurfaceHit() {
    Circle circle = new Circle(4, 10, 2);
    assertImpact(hit(circle, new Vec2(0, -4), FLOOR), impact(2, Feature.SIDE, 4, 0, 0, 1, 4));
    assertImpact(hit(circle, new Vec2(1, -4), FLOOR), impact(2, Feature.SIDE, 6, 0, 0, 1, 4));
  }

  /**
   * The circle starts over the line and moves out over its end; its flank catches on the end. At
   * contact the centre stands at (13, 4), 3 beyond the end and 4 above it.
   *
   * <pre>
   *            o
   *             \
   *              v
   *   ==========*
   * </pre>
   */
  @Test
  void case2FlankMeetsAnEndpointComingFromTheLinesSide() {
    Impact impact = hit(new Circle(9, 12, 5), new Vec2(1, -2), FLOOR);
    assertImpact(impact, impact(4, Feature.END, 10, 0, 0.6, 0.8, 1));
  }

  /**
   * The centre passes 3 above the line and never comes to it.
   *
   * <pre>
   *   o -------------------->
   *            *=========
   * </pre>
   */
  @Test
  void case3MotionMissesTheLineButTheCircleMeetsAnEndpoint() {
    Impact impact = hit(new Circle(-10, 3, 5), new Vec2(1, 0), FLOOR);
    assertImpact(impact, impact(6, Feature.START, 0, 0, -0.8, 0.6, 0.8));
  }

  /**
   * The path crosses the infinite line at t = -1, behind the start; ahead it only leaves it, and
   * still the circle catches the end.
   *
   * <pre>
   *                   _.->
   *          o  _.--
   *   . . x . . . . . . . . *=========
   *     t=-1
   * </pre>
   */
  @Test
  void case4ShallowAngleWithTheCrossingBehindTheMotion() {
    Impact impact = hit(new Circle(-10, 1, 5), new Vec2(3, 1), FLOOR);
    assertThat(impact.time()).isEqualTo(2);
    assertThat(impact.feature()).isEqualTo(Feature.START);
    assertVector(impact.normal(), new Vec2(-0.8, 0.6), 1e-15);
    assertThat(impact.approachSpeed()).isCloseTo(1.8, within(1e-15));
  }

  /**
   * The centre would cross the infinite line at (11, 0), beyond the end; at contact it stands at
   * (14, 3).
   *
   * <pre>
   *                    o
   *                  /
   *                v
   *   ==========* x . . .
   * </pre>
   */
  @Test
  void case5CrossingBeyondTheEndpoint() {
    Impact impact = hit(new Circle(18, 7, 5), new Vec2(-1, -1), FLOOR);
    assertThat(impact.time()).isEqualTo(4);
    assertThat(impact.feature()).isEqualTo(Feature.END);
    assertThat(impact.point()).isEqualTo(new Vec2(10, 0));
    assertVector(impact.normal(), new Vec2(0.8, 0.6), 1e-15);
    assertThat(impact.approachSpeed()).isCloseTo(1.4, within(1e-15));
  }

  /**
   * Both paths lead exactly through the end. From outside, the end is hit head-on; from over the
   * line, the side is hit before.
   *
   * <pre>
   *      o             o
   *        \         /
   *          \     /
   *   =========\ *
   * </pre>
   */
  @Test
  void case6PathContainsAnEndpointAndCrossesTheLine() {
    assertImpact(
        hit(new Circle(16, 8, 5), new Vec2(-3, -4), FLOOR),
        impact(1, Feature.END, 10, 0, 0.6, 0.8, 5));
    assertImpact(
        hit(new Circle(2.5, 10, 5), new Vec2(3, -4), FLOOR),
        impact(1.25, Feature.SIDE, 6.25, 0, 0, 1, 4));
  }

  // Hits beside the six.

  @Test
  void aLineIsSolidFromBothSides() {
    assertImpact(
        hit(new Circle(4, -10, 2), new Vec2(0, 4), FLOOR), impact(2, Feature.SIDE, 4, 0, 0, -1, 4));
  }

  @Test
  void alongTheLineIntoItsEnd() {
    assertImpact(
        hit(new Circle(20, 0, 3), new Vec2(-2, 0), FLOOR),
        impact(3.5, Feature.END, 10, 0, 1, 0, 2));
    assertImpact(
        hit(new Circle(-5, 0, 3), new Vec2(2, 0), FLOOR), impact(1, Feature.START, 0, 0, -1, 0, 2));
  }

  /** The centre comes down exactly over the end: that is the endpoint, never the side. */
  @Test
  void aProjectionExactlyOnAnEndIsThatEnd() {
    assertThat(hit(new Circle(10, 9, 5), new Vec2(0, -1), FLOOR).feature()).isEqualTo(Feature.END);
    assertThat(hit(new Circle(0, 9, 5), new Vec2(0, -1), FLOOR).feature()).isEqualTo(Feature.START);
    assertThat(hit(new Circle(Math.nextDown(10.0), 9, 5), new Vec2(0, -1), FLOOR).feature())
        .isEqualTo(Feature.SIDE);
    assertThat(hit(new Circle(Double.MIN_VALUE, 9, 5), new Vec2(0, -1), FLOOR).feature())
        .isEqualTo(Feature.SIDE);
  }

  /** A line along (3, 4), its left normal (-0.8, 0.6). */
  @Test
  void aSlantedLine() {
    Line slope = new Line(0, 0, 30, 40);
    Impact impact = hit(new Circle(15 - 12, 20 + 9, 5), new Vec2(4, -3), slope);
    assertImpact(impact, impact(2, Feature.SIDE, 15, 20, -0.8, 0.6, 5));
  }

  /**
   * 1,000 px a frame over a line of zero thickness: at both frame ends the circle is far from it,
   * which is all that a discrete test can see.
   */
  @Test
  void aFastCircleDoesNotJumpOverTheLine() {
    Circle circle = new Circle(5, 500, 2);
    Vec2 velocity = new Vec2(0, -1000);
    assertThat(overlapsAtFrameEnd(circle, Vec2.ZERO, FLOOR)).isFalse();
    assertThat(overlapsAtFrameEnd(circle, velocity, FLOOR)).isFalse();

    assertImpact(hit(circle, velocity, FLOOR, 1), impact(0.498, Feature.SIDE, 5, 0, 0, 1, 1000));
  }

  private static boolean overlapsAtFrameEnd(Circle circle, Vec2 v, Line line) {
    Vec2 end = new Vec2(circle.x() + v.x(), circle.y() + v.y());
    Vec2 closest = line.closestPoint(end);
    return Math.hypot(end.x() - closest.x(), end.y() - closest.y()) <= circle.radius();
  }

  // Already in contact at the start.

  @Test
  void overlappingAndApproachingIsAnImpactNow() {
    assertImpact(
        hit(new Circle(4, 1, 2), new Vec2(0, -3), FLOOR), impact(0, Feature.SIDE, 4, 0, 0, 1, 3));
    assertImpact(
        hit(new Circle(13, 4, 6), new Vec2(-3, -4), FLOOR),
        impact(0, Feature.END, 10, 0, 0.6, 0.8, 5));
  }

  @Test
  void touchingAndApproachingIsAnImpactNow() {
    assertThat(time(new Circle(4, 2, 2), new Vec2(7, -1e-300), FLOOR, 0)).isZero();
    assertThat(time(new Circle(13, 4, 5), new Vec2(-1, 0), FLOOR, 0)).isZero();
  }

  @ParameterizedTest
  @CsvSource({"4,1,0,3", "4,1,5,1e-300", "4,2,0,3", "13,4,3,4", "13,4,0,1", "12,3,3,4"})
  void overlappingOrTouchingAndSeparatingIsNone(double x, double y, double vx, double vy) {
    assertThat(time(new Circle(x, y, 5), new Vec2(vx, vy), FLOOR)).isEqualTo(NEVER);
  }

  @ParameterizedTest
  @CsvSource({
    "4,2,2,1,0", // on the side, along it
    "4,1,2,-1,0", // inside, parallel
    "13,4,5,4,-3", // on the end, tangential
    "13,4,6,4,-3", // overlapping the end, tangential: the distance does not fall
    "4,2,2,0,0", // at rest
    "4,1,2,0,0"
  })
  void touchingAndMovingTangentiallyIsNone(double x, double y, double r, double vx, double vy) {
    assertThat(time(new Circle(x, y, r), new Vec2(vx, vy), FLOOR)).isEqualTo(NEVER);
  }

  /** Out of the strip over the line, tangentially at first, the path turns round the other end. */
  @Test
  void slidingOffOneLineMeetsTheNextOne() {
    Line wall = new Line(20, -5, 20, 5);
    Circle circle = new Circle(4, 2, 2);
    assertThat(time(circle, new Vec2(1, 0), FLOOR)).isEqualTo(NEVER);
    assertThat(time(circle, new Vec2(1, 0), wall)).isEqualTo(14);
  }

  @ParameterizedTest
  @CsvSource({"0,-1", "0,1", "1,0", "-1,0", "3,-4", "-1e-300,1e300", "0,0"})
  void aCentreOnTheLineCannotComeNearer(double vx, double vy) {
    for (double x : new double[] {0, 4, 10}) {
      assertThat(time(new Circle(x, 0, 2), new Vec2(vx, vy), FLOOR)).isEqualTo(NEVER);
      assertThat(time(new Circle(x, 0, 0), new Vec2(vx, vy), FLOOR)).isEqualTo(NEVER);
    }
  }

  // Grazes and windows.

  /**
   * The lower edge of the circle passes exactly through the upper end.
   *
   * <pre>
   *    o ---->
   *    . . . . *
   *            |
   * </pre>
   */
  @Test
  void aGrazeIsNone() {
    Line post = new Line(0, 0, 0, -10);
    Vec2 velocity = new Vec2(1, 0);
    assertThat(time(new Circle(-10, 5, 5), velocity, post)).isEqualTo(NEVER);
    assertThat(time(new Circle(-10, Math.nextUp(5.0), 5), velocity, post)).isEqualTo(NEVER);
    Impact impact = hit(new Circle(-10, Math.nextDown(5.0), 5), velocity, post);
    assertThat(impact.feature()).isEqualTo(Feature.START);
    // sqrt(2 r h) before the end, with h = 2^-50 the depth: |d|^2 = r^2 - 2 r h
    assertThat(impact.time()).isCloseTo(10 - Math.sqrt(2 * 5 * 0x1p-50), within(Math.ulp(10.0)));
    assertThat(impact.normal().y()).isCloseTo(1, within(1e-15));
  }

  @Test
  void parallelAtExactlyTheRadiusIsNone() {
    Vec2 velocity = new Vec2(1, 0);
    double[] distances = {Math.nextDown(2.0), 2, Math.nextUp(2.0)};
    for (double y : distances) {
      assertThat(time(new Circle(4, y, 2), velocity, FLOOR))
          .as("over it, y = %s", y)
          .isEqualTo(NEVER);
    }
    assertThat(time(new Circle(-9, 2, 2), velocity, FLOOR)).isEqualTo(NEVER);
    assertThat(time(new Circle(-9, Math.nextUp(2.0), 2), velocity, FLOOR)).isEqualTo(NEVER);
    assertThat(hit(new Circle(-9, Math.nextDown(2.0), 2), velocity, FLOOR).feature())
        .isEqualTo(Feature.START);
  }

  @Test
  void theEndOfTheWindowBelongsToIt() {
    Circle circle = new Circle(4, 10, 2);
    Vec2 velocity = new Vec2(0, -4);
    assertThat(time(circle, velocity, FLOOR, 2)).isEqualTo(2);
    assertThat(time(circle, velocity, FLOOR, Math.nextDown(2.0))).isEqualTo(NEVER);
    assertThat(time(circle, velocity, FLOOR, 0)).isEqualTo(NEVER);
    assertThat(time(new Circle(13, 14, 5), new Vec2(0, -2), FLOOR, 5)).isEqualTo(5);
    assertThat(time(new Circle(13, 14, 5), new Vec2(0, -2), FLOOR, Math.nextDown(5.0)))
        .isEqualTo(NEVER);
  }

  /** 8/3 is no double: rounded down it is earlier, rounded up it is later than the contact. */
  @Test
  void aWindowIsComparedWithTheTrueTimeNotWithItsRounding() {
    Circle circle = new Circle(4, 10, 2);
    Vec2 velocity = new Vec2(0, -3);
    double rounded = 8.0 / 3;
    boolean roundedDown = Math.fma(rounded, 3, -8) < 0;
    double above = roundedDown ? Math.nextUp(rounded) : rounded;
    assertThat(time(circle, velocity, FLOOR, above)).isEqualTo(rounded);
    assertThat(time(circle, velocity, FLOOR, Math.nextDown(above))).isEqualTo(NEVER);
  }

  @Test
  void movingAwayIsNever() {
    assertThat(time(new Circle(4, 10, 2), new Vec2(0, 4), FLOOR)).isEqualTo(NEVER);
    assertThat(time(new Circle(4, 10, 2), new Vec2(4, 0), FLOOR)).isEqualTo(NEVER);
    assertThat(time(new Circle(4, 10, 2), Vec2.ZERO, FLOOR)).isEqualTo(NEVER);
    assertThat(time(new Circle(20, 10, 2), new Vec2(1, -4), FLOOR)).isEqualTo(NEVER);
  }

  // Degenerate sizes.

  @Test
  void aPointParticleHitsTheSide() {
    assertImpact(
        hit(new Circle(4, 8, 0), new Vec2(1, -4), FLOOR), impact(2, Feature.SIDE, 6, 0, 0, 1, 4));
  }

  @Test
  void aPointParticleRunsIntoAnEndAlongTheLine() {
    assertImpact(
        hit(new Circle(14, 0, 0), new Vec2(-2, 0), FLOOR), impact(2, Feature.END, 10, 0, 1, 0, 2));
  }

  /**
   * Reaches the end from over the line: until then the line's side was nearest, so its normal is
   * the limit from before. From beyond the end it is the reversed direction of motion.
   *
   * <pre>
   *     o        o
   *       \    /
   *   =====\ *
   * </pre>
   */
  @Test
  void aPointParticleReachesAnEndExactly() {
    Impact fromAbove = hit(new Circle(4, 8, 0), new Vec2(3, -4), FLOOR);
    assertImpact(fromAbove, impact(2, Feature.END, 10, 0, 0, 1, 4));
    Impact fromBeyond = hit(new Circle(16, 8, 0), new Vec2(-3, -4), FLOOR);
    assertImpact(fromBeyond, impact(2, Feature.END, 10, 0, 0.6, 0.8, 5));
  }

  @Test
  void aPointParticlePassesBesideAnEnd() {
    assertThat(time(new Circle(Math.nextUp(10.0), 8, 0), new Vec2(0, -4), FLOOR)).isEqualTo(NEVER);
    assertThat(time(new Circle(10, 8, 0), new Vec2(0, -4), FLOOR)).isEqualTo(2);
  }

  @Test
  void aLineOfLengthZeroIsItsStart() {
    Line point = new Line(7, 1, 7, 1);
    assertImpact(
        hit(new Circle(13, 9, 5), new Vec2(-3, -4), point),
        impact(1, Feature.START, 7, 1, 0.6, 0.8, 5));
    assertThat(time(new Circle(13, 9, 0), new Vec2(-3, -4), point)).isEqualTo(2);
    assertThat(time(new Circle(7, 9, 5), new Vec2(1, 0), point)).isEqualTo(NEVER);
    assertThat(time(new Circle(7, 1, 5), new Vec2(1, 0), point)).isEqualTo(NEVER);
  }

  /** Vectors compare by their bits. */
  @Test
  void noComponentOfANormalIsMinusZero() {
    Line across = new Line(-8, 0, 8, 0);
    Line up = new Line(0, -8, 0, 8);
    assertThat(hit(new Circle(1, 3, 1), new Vec2(0, -1), across).normal())
        .isEqualTo(new Vec2(0, 1));
    assertThat(hit(new Circle(1, -3, 1), new Vec2(0, 1), across).normal())
        .isEqualTo(new Vec2(0, -1));
    assertThat(hit(new Circle(3, 1, 1), new Vec2(-1, 0), up).normal()).isEqualTo(new Vec2(1, 0));
    assertThat(hit(new Circle(-3, 1, 1), new Vec2(1, 0), up).normal()).isEqualTo(new Vec2(-1, 0));
    assertThat(new SweptCircle(-0.0, 2, 1, 0, -1).cast(new Circle(0, 1, 0), 0).map(Impact::normal))
        .contains(new Vec2(0, 1));
    assertThat(new SweptCircle(2, -0.0, 1, -1, 0).cast(new Circle(1, 0, 0), 0).map(Impact::normal))
        .contains(new Vec2(1, 0));
  }
}
