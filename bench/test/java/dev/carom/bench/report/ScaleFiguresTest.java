// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class ScaleFiguresTest {

  /** Carom in proportion to the circles; slow by their square, too slow at 900 in one fork. */
  private static Sample sample() {
    Sample sample = Sample.complete();
    for (int n : List.of(100, 400, 900, 3600)) {
      for (int fork = 0; fork < Sample.FORKS; fork++) {
        time(sample, "alone", n, "carom", fork, 10.0 * n);
        time(sample, "gas", n, "carom", fork, 500.0 * n);
        if (n == 900 && fork == 3) {
          sample.add("scale:alone=900", "slow", "", "scale_time", "timed out", 1.1e9, "ns", fork);
        } else if (n <= 900) {
          time(sample, "alone", n, "slow", fork, 1000.0 * n * n);
        }
      }
      sample.add("scale:alone=" + n, "carom", "", "scale_impacts", "mean", n / 10.0, "1", 0);
    }
    sample.add("scale:alone=3600", "slow", "", "scale_time", "median", 1e9, "ns", 0);
    sample.add("scale:alone=102400", "carom", "", "scale_memory", "circle", 120, "bytes", 0);
    sample.add("scale:alone=102400", "carom", "", "scale_memory", "line", 30, "bytes", 0);
    return sample;
  }

  private static void time(
      Sample sample, String model, int n, String method, int fork, double nanos) {
    String scene = "scale:" + model + "=" + n;
    double time = nanos * (1 + 0.01 * fork);
    sample.add(scene, method, "", "scale_time", "median", time, "ns", fork);
    sample.add(scene, method, "", "scale_time", "min", time, "ns", fork);
    sample.add(scene, method, "", "scale_time", "max", time, "ns", fork);
  }

  private static Figure figure() {
    return Report.figures(sample().results()).stream()
        .filter(figure -> figure.id().equals("scale"))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void theCirclesAtSixtyFramesLieBetweenMeasuredSizes() {
    assertThat(
            ReadmeFigures.fill(
                "<!--alone:slow-->?<!--/alone:slow--> <!--alone:carom-->?<!--/alone:carom-->",
                sample().results()))
        .contains(">130<", ">over 3,600<");
  }

  @Test
  void theReportShowsItAndFitsTheGrowth() {
    assertThat(new ScaleFigures(sample().results(), 1e9).told())
        .anyMatch(
            told ->
                told.startsWith(
                    "The time of Carom grows with the number of circles that collide to the power 1.00"))
        .endsWith("A world of 102,400 circles and lines takes 120 bytes a circle and 30 a line.");
    assertThat(figure().title()).startsWith("At 60 frames a second Carom moves over 3,600 circles");
    assertThat(new String(figure().picture().svg(), StandardCharsets.UTF_8))
        .contains(">Colliding circles<", ">number of circles<", ">60 FPS<", ">&gt; 1 s<");
  }

  @Test
  void whoWasTooSlowInOneForkHasNoTimeThereNorBeyond() {
    List<List<String>> slow =
        figure().table().rows().stream().filter(row -> row.get(2).equals("slow")).toList();
    assertThat(slow).hasSize(3);
    assertThat(slow.get(1)).startsWith("alone", "400", "slow", "163 ms");
    assertThat(slow.get(2)).startsWith("alone", "900", "slow", "over 1 s");
  }

  @Test
  void theVerdictTellsTheFitAndWhoFellBehind() {
    assertThat(Verdict.of(sample().results()).get(4))
        .startsWith(
            "Growth: the time of a frame of Carom grows with circles that ignore each other")
        .contains("to the power 1.00 (1.00 .. 1.00 at 95 %), up to 36.7 µs for 3,600")
        .contains("with circles that collide to the power 1.00")
        .endsWith("; too slow to go on: slow at 900 (alone).");
  }

  @Test
  void whatWasNotMeasuredHasNoFigure() {
    assertThat(Report.figures(Sample.complete().results()))
        .extracting(Figure::id)
        .doesNotContain("scale");
  }
}
