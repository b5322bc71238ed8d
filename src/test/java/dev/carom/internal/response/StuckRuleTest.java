// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.MovingCircle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which impacts count, and for how much. */
class StuckRuleTest {

  /** Approaches by more than rounding of a speed of 1. */
  private static final double PLAIN = 0.5;

  /** The largest approach that is rounding of a speed of 1. */
  private static final double FAINT = 0x1p-48;

  private final MovingCircle m = new MovingCircle();

  /** A circle of radius 1 at (4, 6) that met a speed of 1. */
  private void start(int stuck) {
    m.start(0, 4, 6, 1, 1, 0, 1);
    m.stuck = stuck;
    m.speedExponent = 0;
  }

  private boolean counts(double way, double e) {
    start(0);
    StuckRule.count(m, way, 1, 1, PLAIN, e, StuckRule.ELASTIC, StuckRule.PUSHED_PLACE);
    return m.stuck > 0;
  }

  private int impactsUntilStuck(double e, int elastic) {
    start(0);
    int impacts = 0;
    while (!StuckRule.isStuck(m)) {
      StuckRule.count(m, 0, 1, 1, PLAIN, e, elastic, StuckRule.PUSHED_PLACE);
      impacts++;
    }
    return impacts;
  }

  @Test
  void elasticImpactsCountWithin2ToTheMinus39OfTheCoordinates() {
    double place = 6 * 0x1p-39;
    assertThat(counts(place, 1)).isTrue();
    assertThat(counts(1.1 * place, 1)).isFalse();
  }

  @Test
  void othersCountWithin2ToTheMinus16OfTheRadius() {
    double place = 0x1p-16;
    assertThat(counts(place, 0.5)).isTrue();
    assertThat(counts(1.1 * place, 0.5)).isFalse();
    assertThat(counts(place, 1)).as("but no elastic one").isFalse();
  }

  /** 16 halvings, no fewer than four impacts, and no more than of elastic ones. */
  @ParameterizedTest
  @CsvSource({
    "1, 1025",
    "0.5, 17",
    "0.9, 106",
    "0.99, 1025",
    "0.25, 9",
    "0.1, 5",
    "0, 5",
    "2, 17",
    "1.5, 28",
    "100, 5"
  })
  void anImpactWeighsByWhatItDoesToTheEnergy(double e, int impacts) {
    assertThat(impactsUntilStuck(e, StuckRule.ELASTIC)).isEqualTo(impacts);
  }

  @Test
  void elasticRowsMayBeLong() {
    assertThat(impactsUntilStuck(1, StuckRule.ELASTIC_PAIR)).isEqualTo(16_385);
  }

  @Test
  void faintImpactsWeighA32nd() {
    start(0);
    for (int impact = 0; impact < 32; impact++) {
      StuckRule.count(m, 0, 1, 1, -FAINT, 1, StuckRule.ELASTIC, StuckRule.PUSHED_PLACE);
    }
    assertThat(StuckRule.isStuck(m)).isFalse();
    StuckRule.count(m, 0, 1, 1, -FAINT, 1, StuckRule.ELASTIC, StuckRule.PUSHED_PLACE);
    assertThat(StuckRule.isStuck(m)).isTrue();
  }

  @Test
  void whoLeavesThePlaceBeginsAnew() {
    start(StuckRule.LIMIT + 1);
    m.jam = IgnoreList.with(null, 7);
    m.turn = 1;
    StuckRule.count(m, 1, 1, 2, PLAIN, 1, StuckRule.ELASTIC, StuckRule.PUSHED_PLACE);
    assertThat(m.stuck).isZero();
    assertThat(m.jam).isNull();
    assertThat(m.turn).isZero();
    assertThat(m.speedExponent).isOne();
  }

  @Test
  void whoseClockDoesNotMoveHasNotLeft() {
    start(0);
    StuckRule.count(m, 0, 1, 1, PLAIN, 1, StuckRule.ELASTIC, StuckRule.PUSHED_PLACE);
    assertThat(m.stuck).isEqualTo(StuckRule.ELASTIC);
  }

  /** Elsewhere: as long as it came no nearer to what it slides along than rounding is wide. */
  private boolean slides(double flown, double approach, int stuck) {
    start(stuck);
    StuckRule.count(m, flown, 1 / flown, 1, approach, 1, StuckRule.ELASTIC, StuckRule.PUSHED_PLACE);
    return m.stuck > 0;
  }

  @Test
  void whoSlidesCountsWhereverItIs() {
    double rounding = 6 * 0x1p-51;
    assertThat(slides(rounding / FAINT, -FAINT, 0)).isTrue();
    assertThat(slides(2 * rounding / FAINT, -FAINT / 2, 0)).isTrue();
    assertThat(slides(1.1 * rounding / FAINT, -FAINT, 0)).as("too long").isFalse();
    assertThat(slides(0x1p-60, -1.1 * FAINT, 0)).as("too fast").isFalse();
    assertThat(slides(1e9, -FAINT, StuckRule.LIMIT)).as("not stuck").isFalse();
    assertThat(slides(1e9, -FAINT, StuckRule.LIMIT + 1)).as("stuck").isTrue();
    assertThat(slides(1e9, -1.1 * FAINT, StuckRule.LIMIT + 1)).as("too fast").isFalse();
  }

  /** A pushed circle has more room: 2^-10 of its radius. */
  @Test
  void whoIsPushedCountsFurtherAway() {
    double place = 0x1p-10;
    start(0);
    m.pushed = true;
    StuckRule.count(m, place, 1, 1, PLAIN, 1, StuckRule.ELASTIC, StuckRule.PUSHED_PLACE);
    assertThat(m.stuck).isEqualTo(StuckRule.ELASTIC);
    start(0);
    m.pushed = true;
    StuckRule.count(m, 1.1 * place, 1, 1, PLAIN, 1, StuckRule.ELASTIC, StuckRule.PUSHED_PLACE);
    assertThat(m.stuck).isZero();
    assertThat(m.pushed).isFalse();
  }

  @Test
  void roundingIsAPartOfTheLargestSpeedSPowerOfTwo() {
    assertThat(isFaint(0x1p-48, 1)).isTrue();
    assertThat(isFaint(-0x1p-48, 1.9)).isTrue();
    assertThat(isFaint(0x1.1p-48, 1.9)).isFalse();
    assertThat(isFaint(0x1p-1070, 0x1p-1022)).isTrue();
    assertThat(isFaint(0x1p-1070, 0x1p-1023)).isFalse();
  }

  private boolean isFaint(double approach, double speed) {
    start(0);
    m.speedExponent = Double.MIN_EXPONENT - 1;
    StuckRule.noteSpeed(m, speed);
    return StuckRule.isFaint(m, approach);
  }

  @Test
  void thePlaceOfWhatWasJustHitIsFourUlpsWide() {
    start(StuckRule.LIMIT);
    assertThat(StuckRule.widthOfPlace(m)).isEqualTo(6 * 0x1p-51);
    start(StuckRule.LIMIT + 1);
    assertThat(StuckRule.widthOfPlace(m)).isEqualTo(0x1p-16);
  }
}
