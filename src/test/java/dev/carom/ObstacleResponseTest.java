// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

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
}
