// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Two lines that form a wedge. Unfolded at each reflection, the path of a circle that comes from
 * far away and leaves for far away is one straight line, past pi / alpha copies of the wedge: it
 * makes ceil(pi / alpha) reflections or one less; exactly pi / alpha where that is whole.
 *
 * <pre>
 *                 _.-'
 *            _.-' ___ o    a circle's centre moves in the same wedge,
 *       _.-' ---'          with its apex moved inward
 *    .=====================
 * </pre>
 */
class WedgeTest {

  private static final double LENGTH = 0x1p24;
  private static final double SPEED = 1024;

  /**
   * The impacts of a circle that enters a wedge of the directions (1, 0) and (x, y), given in
   * wedge.
   */
  private static Run enter(double x, double y, double radius, double from, double aside) {
    // It comes along the direction at that share of the angle, from 2^12 radii away, past the apex.
    double alpha = Math.atan2(y, x);
    double direction = from * alpha;
    double cos = Math.cos(direction);
    double sin = Math.sin(direction);
    double start = 0x1p14;
    Scene scene =
        Scene.builder()
            .line(0, 0, LENGTH, 0)
            .line(0, 0, LENGTH * x, LENGTH * y)
            .circle(
                start * cos - aside * sin,
                start * sin + aside * cos,
                radius,
                -SPEED * cos,
                -SPEED * sin)
            .build();
    return Run.advance(new World(scene), 0x1p10);
  }

  private static int count(double x, double y, Random random) {
    double from = 0.05 + 0.9 * random.nextDouble();
    double aside = 20 * (random.nextDouble() - 0.5);
    Run run = enter(x, y, 1, from, aside);
    assertThat(run.impacts()).allMatch(row -> row.feature() == Feature.SIDE);
    assertEnergyKept(run);
    return run.impacts().size();
  }

  private static void assertEnergyKept(Run run) {
    Run.State end = run.end().get(0);
    assertThat(Math.hypot(end.vx(), end.vy())).isCloseTo(SPEED, within(SPEED * 1e-13));
  }

  @ParameterizedTest
  @CsvSource({"0,1,2", "1,1,4"})
  void wholeQuotientsGiveExactlyThatManyReflections(double x, double y, int expected) {
    Random random = new Random(7);
    for (int i = 0; i < 300; i++) {
      assertThat(count(x, y, random)).isEqualTo(expected);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {3, 0.75, 0.7, 0.4, 0.25, 0.1, 0.03125, 0.01})
  void othersGiveTheNextWholeNumberOrOneLess(double slope) {
    int most = (int) Math.ceil(Math.PI / Math.atan(slope));
    Random random = new Random(8);
    boolean[] seen = new boolean[2];
    for (int i = 0; i < 100; i++) {
      int count = count(1, slope, random);
      assertThat(count).isBetween(most - 1, most);
      seen[most - count] = true;
    }
    assertThat(seen).as("both counts occur").containsExactly(true, true);
  }

  /** Out of a right angle a circle goes back where it came from. */
  @Test
  void aRightAngleSendsBack() {
    Run run = enter(0, 1, 1, 0.3, 5);
    Run.State end = run.end().get(0);
    double cos = Math.cos(0.15 * Math.PI);
    double sin = Math.sin(0.15 * Math.PI);
    assertThat(end.vx()).isCloseTo(SPEED * cos, within(1e-13));
    assertThat(end.vy()).isCloseTo(SPEED * sin, within(1e-13));
  }
}
