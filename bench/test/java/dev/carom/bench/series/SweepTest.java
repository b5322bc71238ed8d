// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Kind;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.series.SweepPlan.Axis;
import dev.carom.bench.series.SweepPlan.Point;
import java.util.List;
import org.junit.jupiter.api.Test;

class SweepTest {

  @Test
  void theFullPlanIsThePublishedOne() {
    List<Point> points = SweepPlan.of(1, 600, 15, false).points();
    assertThat(places(points, Axis.CIRCLES)).hasSize(100).startsWith(1).endsWith(100);
    assertThat(places(points, Axis.RADIUS)).hasSize(20).startsWith(1).endsWith(20);
    assertThat(points)
        .allSatisfy(p -> assertThat(p.at()).isEqualTo(varied(p)))
        .filteredOn(p -> p.axis() != Axis.LINES)
        .allSatisfy(p -> assertThat(p.crosses().crosses()).isEqualTo(50));
  }

  private static List<Integer> places(List<Point> points, Axis axis) {
    return points.stream().filter(p -> p.axis() == axis).map(Point::at).toList();
  }

  private static int varied(Point point) {
    return switch (point.axis()) {
      case CIRCLES -> point.crosses().circles();
      case RADIUS -> (int) point.crosses().radius();
      case LINES -> 2 * point.crosses().crosses();
    };
  }

  @Test
  void everySceneHasRoom() throws CannotPlaceException {
    for (Point point : SweepPlan.of(1, 600, 15, false).points()) {
      assertThat(point.crosses().scene().count(Kind.LINE)).isEqualTo(2 * point.crosses().crosses());
    }
  }

  @Test
  void growthIsTheSlopeOfTheLogarithms() {
    Growth square = Growth.of(new double[] {1, 2, 5, 10}, new double[] {3, 12, 75, 300});
    assertThat(square.slope()).isCloseTo(2, within(1e-12));
    assertThat(square.low()).isCloseTo(2, within(1e-6));
    Growth noisy = Growth.of(new double[] {1, 2, 4, 8}, new double[] {1, 3, 3, 9});
    assertThat(noisy.low()).isLessThan(noisy.slope() - 0.1);
    assertThat(noisy.high()).isGreaterThan(noisy.slope() + 0.1);
  }
}
