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

  @Test
  void sharesOfRadiiOfAnySize() {
    assertThat(ObstacleResponse.share(1, 3)).isEqualTo(0.25);
    assertThat(ObstacleResponse.share(0x1p1023, 0x1p1023)).isEqualTo(0.5);
    assertThat(ObstacleResponse.share(0x1p1022, 0x1.8p1023)).isEqualTo(0.25);
    assertThat(ObstacleResponse.share(0, 0)).isZero();
  }
}
