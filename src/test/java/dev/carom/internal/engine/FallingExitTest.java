// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where and when cells are left. The quick way under gravity has the bits of the complete one. */
class FallingExitTest {

  private final FallingExit exit = new FallingExit();

  @RepeatedTest(10)
  void exitAheadIsTheExit(RepetitionInfo repetition) {
    Random random = new Random(repetition.getCurrentRepetition());
    int quick = 0;
    for (int k = 0; k < 10_000; k++) {
      quick += exitIsTheSame(random) ? 1 : 0;
    }
    assertThat(quick).as("most exits are ahead").isGreaterThan(6_000);
  }

  /**
   * Follows a circle from cell to cell; returns whether its last exit was found in the quick way.
   */
  private boolean exitIsTheSame(Random random) {
    CellAxis axis = new CellAxis(1 + random.nextDouble(), 16);
    double p = 100 * random.nextGaussian();
    double v = random.nextGaussian();
    double g = Math.scalb(random.nextInt(3) - 1.0, -random.nextInt(12));
    double cell = axis.cell(p);
    double since = 0;
    boolean quick = false;
    for (int k = random.nextInt(6); k >= 0; k--) {
      exit.find(p, v, g, since, cell, axis);
      double ahead = FallingExit.ahead(p, v, g, since, cell, axis);
      quick = !Double.isNaN(ahead);
      if (quick) {
        assertThat(ahead).isEqualTo(exit.after);
        assertThat(exit.direction).isEqualTo(Math.signum(v));
      }
      cell += exit.direction;
      since = exit.after;
    }
    return quick;
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0.5, 0", // stands still
    "-1, 2, 0", // turns back before the edge
    "-1, 0.1, 10", // has turned back
    "-1, 0.1, 20",
    "-1e-320, 1e-10, 0", // too slow for its square
    "-1e155, 1e150, 0", // too fast
    "-1e-10, 1e300, 1e-310"
  })
  void inDoubtThereIsNoQuickWay(double v, double g, double since) {
    assertThat(FallingExit.ahead(0.5, v, g, since, 0, new CellAxis(2, 16))).isNaN();
  }

  /**
   * From 0.5 it is at 0.5 + 3 t - t^2 with cells of width 2: up through 2 at (3 - sqrt 3) / 2, over
   * the top at 1.5, down again through 2 and 0. With 2 t it turns below 2. With 2.5 t - 6.25 t^2 it
   * just reaches 0.75; with 1 t + t^2 and none at all it only goes along.
   */
  @ParameterizedTest
  @CsvSource({
    "2, 3, -2, 0, 0, 0.6339745962155614, 1",
    "2, 3, -2, 0.6339745962155614, 1, 2.3660254037844386, -1",
    "2, 3, -2, 2.3660254037844386, 0, 3.1583123951777, -1",
    "2, 2, -2, 0, 0, 2.224744871391589, -1",
    "2, 2, -2, 2.224744871391589, -1, 2.8708286933869707, -1",
    "0.75, 2.5, -12.5, 0, 0, 0.2, 1",
    "2, 1, 2, 0, 0, 0.8228756555322954, 1",
    "2, 0, 2, 0, 0, 1.224744871391589, 1",
    "2, 0, -2, 0, 0, 0.7071067811865476, -1",
    "2, -3, 2, 0, 0, 0.17712434446770464, -1",
    "2, -3, 2, 0.17712434446770464, -1, 2.8228756555322954, 1",
    "2, -3, 0, 0, 0, 0.16666666666666666, -1",
    "2, 3, 0, 0, 0, 0.5, 1",
    "2, 0, 0, 0, 0, Infinity, 1",
  })
  void leavesWhereTheParabolaCrossesAnEdge(
      double width, double v, double g, double since, double cell, double after, double way) {
    exit.find(0.5, v, g, since, cell, new CellAxis(width, 16));
    assertThat(exit.after).isEqualTo(after, within(1e-14));
    if (after < Double.POSITIVE_INFINITY) {
      assertThat(exit.direction).isEqualTo(way);
    }
  }

  /** Over the edge that is reached first, in the direction of flight. */
  @ParameterizedTest
  @CsvSource({
    "0, 1, 2, 5, 7, 1, 0",
    "3, 1, 2, -5, 7, -1, 0",
    "1, 2, 1, 5, 7, 0, 1",
    "2, 2, 1, 5, -7, 0, -1",
    "9, Infinity, 1, 0, -7, 0, -1",
    "4, 1, Infinity, -5, 0, -1, 0",
  })
  void theWayOutNamesTheNextCell(
      int level, double dx, double dy, double vx, double vy, int columns, int rows) {
    int way = CellExit.way(level, dx, dy, vx, vy);
    assertThat(CellExit.level(way)).isEqualTo(level);
    assertThat(CellExit.columns(way)).isEqualTo(columns);
    assertThat(CellExit.rows(way)).isEqualTo(rows);
  }
}
