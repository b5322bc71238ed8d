// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Cells that are alike in the region and twice as wide after each so many. */
class CellAxisTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Four cells of 5 on either side reach to 20, four of 10 to 60, four of 20 to 140. */
  @ParameterizedTest
  @CsvSource({
    "0, 0", "1, 5", "3, 15", "4, 20", "5, 30", "6, 40", "8, 60", "9, 80", "12, 140", "13, 180"
  })
  void eachFourCellsAreTwiceAsWideAsTheFourBefore(double cell, double edge) {
    CellAxis axis = new CellAxis(5, 4);
    assertThat(axis.edge(cell)).isEqualTo(edge);
    assertThat(axis.edge(-cell)).isEqualTo(-edge);
    assertThat(axis.cell(edge + 1)).isEqualTo(cell);
    assertThat(axis.cell(-edge - 1)).isEqualTo(-1 - cell);
    assertThat(axis.holds(cell, edge)).isTrue();
    assertThat(axis.holds(cell - 1, edge)).isTrue();
    assertThat(axis.holds(cell, Math.nextDown(edge))).isFalse();
    assertThat(axis.holds(cell - 1, Math.nextUp(edge))).isFalse();
    assertThat(axis.isFar(cell)).isEqualTo(cell > 4);
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 4, 1024})
  void theRegionHasSoManyCellsOnEitherSide(int near) {
    CellAxis axis = new CellAxis(5, near);
    assertThat(axis.edge(near)).isEqualTo(5.0 * near);
    assertThat(axis.edge(near + 1)).isEqualTo(5.0 * near + 10);
    assertThat(axis.isFar(near)).isFalse();
    assertThat(axis.isFar(near + 1)).isTrue();
    assertThat(axis.isFar(-near)).isFalse();
    assertThat(axis.isFar(-near - 1)).isTrue();
  }

  @Test
  void aPlaceIsInItsCell() {
    Random random = new Random(1);
    for (int k = 0; k < 100_000; k++) {
      double width = Math.scalb(1 + random.nextDouble(), random.nextInt(20) - 10);
      CellAxis axis = new CellAxis(width, 2 << random.nextInt(7));
      double place =
          Math.scalb(random.nextDouble(), random.nextInt(600) - 300) * (random.nextInt(3) - 1);
      double cell = axis.cell(place);
      // Just beside an edge, rounding decides.
      double ulps = 4 * (Math.ulp(place) + Math.ulp(axis.edge(128)));
      assertThat(axis.edge(cell)).isLessThanOrEqualTo(place + ulps);
      assertThat(axis.edge(cell + 1)).isGreaterThanOrEqualTo(place - ulps);
    }
  }

  /** Whatever the width: one wide cell after the other, up to the largest double. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-300, 1, 1e300})
  void cellsGoOnToTheEndOfTheRange(double width) {
    CellAxis axis = new CellAxis(width, 4);
    double last = axis.cell(Double.MAX_VALUE);
    assertThat(axis.cell(NEVER)).isGreaterThanOrEqualTo(last);
    assertThat(axis.cell(-NEVER)).isEqualTo(-1 - axis.cell(NEVER));
    assertThat(axis.edge(last)).isLessThanOrEqualTo(Double.MAX_VALUE);
    for (double c = 0; c < last; c++) {
      double size = axis.edge(c + 1) - axis.edge(c);
      assertThat(size).isBetween(width * (1 - 0x1p-50), NEVER);
      assertThat(axis.edge(-1 - c)).isEqualTo(-axis.edge(c + 1));
    }
    assertThat(last).isLessThan(4 * 2100);
  }

  @Test
  void whoIsBeyondTheRangeOfDoublesLeavesNoCell() {
    for (CellAxis axis : new CellAxis[] {new CellAxis(NEVER, 4), new CellAxis(2, 4)}) {
      for (double place : new double[] {NEVER, -NEVER}) {
        double cell = axis.cell(place);
        for (double v : new double[] {-1, 1}) {
          assertThat(CellExit.untilEdge(place, v, cell, axis) < NEVER)
              .as("%s at %s in %s", v, place, cell)
              .isFalse();
        }
      }
      assertThat(axis.holds(axis.cell(Double.NaN), Double.NaN)).isFalse();
    }
  }
}
