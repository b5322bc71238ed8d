// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How impacts in one place are counted, and what ends them, on a line that rises to the right. */
class ObstacleResponseTest {

  private static final int PATIENCE = 1_000;

  private final ObstacleResponse response =
      new ObstacleResponse(Obstacles.of(Scene.builder().line(0, 0, 10, 10).build()), PATIENCE);
  private final ImpactLog log = new ImpactLog(1);
  private final Mover m = new Mover();

  /** On the upper side, in no time, after so many impacts. */
  private void hit(double vx, double vy, int stuck) {
    m.start(0, 4, 6, 1, vx, vy, 1);
    m.stuck = stuck;
    m.next = Obstacles.WALLS;
    m.contact = SegmentSweep.LEFT;
    log.clear();
    response.resolve(m, log);
  }

  @Test
  void anImpactCountsOnce() {
    hit(1, -1, 7);
    assertThat(m.stuck).isEqualTo(8);
    assertThat(m.vx).isEqualTo(-1);
    assertThat(m.vy).isOne();
    assertThat(log.jammed(0)).isFalse();
  }

  /** A 32nd of the patience, and one more. */
  @Test
  void oneThatApproachesByRoundingCountsAsMany() {
    hit(1, 1 - 0x1p-50, 7);
    assertThat(m.stuck).isEqualTo(8 + PATIENCE / 32);
  }

  @Test
  void whoIsOutOfPatienceDoesNotBounce() {
    hit(1, -1, PATIENCE - 1);
    assertThat(m.vx).isEqualTo(-1);
    hit(1, -1, PATIENCE);
    assertThat(m.vx).isZero();
    assertThat(m.vy).isZero();
    assertThat(log.jammed(0)).isFalse();
  }

  @Test
  void thenItStops() {
    hit(1, 0.5, 2 * PATIENCE - 1);
    assertThat(log.jammed(0)).isFalse();
    assertThat(m.vx).isEqualTo(0.75);
    hit(1, 0.5, 2 * PATIENCE);
    assertThat(log.jammed(0)).isTrue();
    assertThat(m.vx).isZero();
    assertThat(m.vy).isZero();
    assertThat(response.seizes()).isTrue();
  }

  @Test
  void orSlidesAlongIfThatIsAllItDoes() {
    hit(1, 1 - 0x1p-50, 2 * PATIENCE);
    assertThat(log.jammed(0)).isTrue();
    assertThat(m.vx).isBetween(1 - 0x1p-49, 1.0);
    assertThat(m.vy).isEqualTo(m.vx);
    assertThat(m.jam.makesInert(Obstacles.WALLS)).isTrue();
    assertThat(response.seizes()).isFalse();
  }

  /** A place of 4 ulps, at most: for a circle of radius 1 at 1. */
  private static final double PLACE = 0x1p-51;

  /** Far from where its impacts began to count, with speed 1, after a flight of so long. */
  private boolean counts(double flown, double approach, int stuck) {
    m.start(0, 1, 0, 1, 0, 1, 1);
    m.anchorY = -1;
    m.stuck = stuck;
    m.flown = flown;
    response.countStuck(m, 1, 1, approach);
    return m.stuck > stuck;
  }

  /** As long as it came no nearer to what it slides along than a place is wide. */
  @Test
  void whoSlidesCountsWhereverItIs() {
    double faint = 0x1p-48;
    assertThat(counts(PLACE / faint, -faint, 7)).isTrue();
    assertThat(counts(2 * PLACE / faint, -faint / 2, 7)).isTrue();
    assertThat(counts(Math.nextUp(PLACE / faint), -faint, 7)).as("too long").isFalse();
    assertThat(counts(0, -Math.nextUp(faint), 7)).as("too fast").isFalse();
    assertThat(counts(1e9, -faint, 2 * PATIENCE)).as("too long").isFalse();
    assertThat(m.stuck).isZero();
  }

  @Test
  void whoIsJammedAndSlidesOnStaysSo() {
    counts(1e9, -0x1p-48, 2 * PATIENCE + 1);
    assertThat(response.isJammed(m)).isTrue();
    counts(1e9, -0x1p-47, 2 * PATIENCE + 1);
    assertThat(response.isJammed(m)).isFalse();
  }

  @Test
  void sharesOfRadiiOfAnySize() {
    assertThat(ObstacleResponse.share(1, 3)).isEqualTo(0.25);
    assertThat(ObstacleResponse.share(0x1p1023, 0x1p1023)).isEqualTo(0.5);
    assertThat(ObstacleResponse.share(0x1p1022, 0x1.8p1023)).isEqualTo(0.25);
    assertThat(ObstacleResponse.share(0, 0)).isZero();
  }

  /** On the upper side of a line of length 8, sliding to the right, after all patience. */
  private void slide(ObstacleResponse response, double vx, double vy) {
    m.start(0, 4, 1, 1, vx, vy, 1);
    m.stuck = 2 * PATIENCE;
    m.next = Obstacles.WALLS;
    m.contact = SegmentSweep.LEFT;
    log.clear();
    response.resolve(m, log);
  }

  /** The approach is taken along a normal of length 1, whatever the line's is. */
  @Test
  void slidingIsToApproachByRoundingOfTheSpeedAtMost() {
    ObstacleResponse level =
        new ObstacleResponse(Obstacles.of(Scene.builder().line(0, 0, 8, 0).build()), PATIENCE);
    slide(level, 0x1p48, -1);
    assertThat(m.vx).isEqualTo(0x1p48);
    slide(level, 0x1p48, -1.0001);
    assertThat(m.vx).isZero();
  }

  @Test
  void soItIsAlongAnUprightLine() {
    ObstacleResponse upright =
        new ObstacleResponse(Obstacles.of(Scene.builder().line(5, 5, 5, -3).build()), PATIENCE);
    slide(upright, -1, 0x1p48);
    assertThat(m.vy).isEqualTo(0x1p48);
    slide(upright, -1.0001, 0x1p48);
    assertThat(m.vy).isZero();
  }

  @Test
  void roundingIsAPartOfTheSpeedSPowerOfTwo() {
    assertThat(ObstacleResponse.isRounding(0x1p-48, 1)).isTrue();
    assertThat(ObstacleResponse.isRounding(-0x1p-48, 1.9)).isTrue();
    assertThat(ObstacleResponse.isRounding(0x1.1p-48, 1.9)).isFalse();
    assertThat(ObstacleResponse.isRounding(0x1p-1070, 0x1p-1022)).isTrue();
    assertThat(ObstacleResponse.isRounding(0x1p-1070, 0x1p-1023)).isFalse();
  }

  /** Whether an impact counts of one who came from (anchor, 6 + off) and flew for so long. */
  private boolean counts(double off, double way, double flown, double approach, int stuck) {
    m.start(0, 4, 6, 1, 1, 0, 1);
    m.anchorY = 6 + off;
    m.flown = flown;
    m.stuck = stuck;
    response.countStuck(m, way, 1, approach);
    return m.stuck > 0;
  }

  @Test
  void impactsInOnePlaceCount() {
    double place = 6 * 0x1p-51;
    assertThat(counts(0, place, 1, 1, 0)).isTrue();
    assertThat(counts(0, 1.1 * place, 1, 1, 0)).isFalse();
    assertThat(counts(0x1p-48, place, 1, 1, 0)).isFalse();
  }

  @Test
  void thePlaceEndsFourUlpsAway() {
    m.start(0, 4, 4, 1, 1, 0, 1);
    m.anchorY = 4 + 0x1p-48;
    assertThat(ObstacleResponse.isInPlace(m)).isFalse();
    m.anchorY = 4 - 0x1p-49;
    assertThat(ObstacleResponse.isInPlace(m)).isTrue();
    m.anchorY = 4;
    m.anchorX = 4 - 0x1p-49;
    assertThat(ObstacleResponse.isInPlace(m)).isTrue();
  }

  /** Elsewhere: approaching by rounding only, and by no more than a place in all the time. */
  @Test
  void impactsOfOneThatSlidesCount() {
    double faint = 0x1p-48;
    double place = 7 * 0x1p-51;
    assertThat(counts(1, 1, place / faint, faint, 0)).isTrue();
    assertThat(counts(1, 1, 1.1 * place / faint, faint, 0)).isFalse();
    assertThat(counts(1, 1, 0x1p-20, 1.1 * faint, 0)).isFalse();
  }

  @Test
  void aJammedOneSlidesHoweverFar() {
    double faint = 0x1p-48;
    assertThat(counts(1, 1, 10, faint, 2 * PATIENCE)).isFalse();
    assertThat(counts(1, 1, 10, faint, 2 * PATIENCE + 1)).isTrue();
    assertThat(counts(1, 1, 10, 1.1 * faint, 2 * PATIENCE + 1)).isFalse();
  }

  @Test
  void theLargestSpeedIsOneYet() {
    m.start(0, 4, 6, 1, -Double.MAX_VALUE, Double.MAX_VALUE, 1);
    ObstacleResponse.stopBeyondRange(m);
    assertThat(m.vx).isEqualTo(-Double.MAX_VALUE);
    assertThat(m.vy).isEqualTo(Double.MAX_VALUE);
  }

  /** So long, or so short, that its length has no square. */
  @ParameterizedTest
  @ValueSource(doubles = {0x1p600, 0x1p-600})
  void theContactPointOfALineOfAnyLength(double unit) {
    World world =
        new World(
            Scene.builder()
                .line(0, 0, 8 * unit, 0)
                .circle(2 * unit, 3 * unit, unit, 0, -unit)
                .build());
    world.step(3);
    assertThat(world.impacts().time(0)).isEqualTo(2);
    assertThat(world.impacts().x(0)).isEqualTo(2 * unit);
    assertThat(world.impacts().y(0)).isZero();
  }
}
