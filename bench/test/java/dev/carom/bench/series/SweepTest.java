// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.SweepPlan.Axis;
import dev.carom.bench.series.SweepPlan.Point;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
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
      assertThat(point.crosses().scene().lineCount()).isEqualTo(2 * point.crosses().crosses());
    }
  }

  @Test
  void eachPlaceHasMeanLeastAndGreatest() throws CannotPlaceException {
    SweepPlan all = SweepPlan.of(1, 60, 3, true);
    List<Point> few = all.points().stream().filter(p -> p.at() == 5).toList();
    AtomicInteger steps = new AtomicInteger();
    List<Row> rows =
        new Sweep(new SweepPlan(60, 3, few), List.of(Methods.CAROM), 7)
            .run(0, steps::incrementAndGet);

    assertThat(steps).hasValue(2);
    assertThat(value(rows, "sweep:radius=5", "min"))
        .isLessThanOrEqualTo(value(rows, "sweep:radius=5", "mean"));
    assertThat(value(rows, "sweep:radius=5", "mean"))
        .isPositive()
        .isLessThanOrEqualTo(value(rows, "sweep:radius=5", "max"));
    assertThat(rows).extracting(Row::scene).contains("sweep:circles=5");
    long framesByImpacts =
        rows.stream()
            .filter(r -> r.scene().startsWith("sweep:impacts=") && r.stat().equals("mean"))
            .peek(r -> assertThat(r.n()).isGreaterThanOrEqualTo(5))
            .mapToLong(Row::n)
            .sum();
    assertThat(framesByImpacts).isPositive().isLessThanOrEqualTo(60);
  }

  private static double value(List<Row> rows, String scene, String stat) {
    return rows.stream()
        .filter(r -> r.scene().equals(scene) && r.metric().equals(Sweep.TIME))
        .filter(r -> r.stat().equals(stat))
        .findFirst()
        .orElseThrow()
        .value();
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
