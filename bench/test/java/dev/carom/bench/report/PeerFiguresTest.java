// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class PeerFiguresTest {

  private static Sample heap() {
    Sample sample = Sample.complete();
    heap(sample, "carom", "", 0, 120, 9e5);
    heap(sample, "gdx-box2d", "setting=defaults, 30 px/m", 0.5, 100, 6e4);
    heap(sample, "gdx-box2d", "setting=best", 0.25, Double.POSITIVE_INFINITY, 8e6);
    return sample;
  }

  private static void heap(
      Sample sample, String method, String knob, double overlap, double rest, double nanos) {
    sample.add("heap", method, knob, "heap_overlap", "max", overlap, "radii", -1);
    sample.add("heap", method, knob, "heap_energy", "gained", 0.01, "1", -1);
    sample.add("heap", method, knob, "heap_rest", "frame", rest, "frames", -1);
    for (int fork = 0; fork < Sample.FORKS; fork++) {
      sample.add("heap", method, knob, "frame_time", "mean", nanos + fork, "ns", fork);
    }
  }

  @Test
  void theTitleTellsOverlapsAndWhoIsFaster() {
    Figure heap =
        Report.figures(heap().results()).stream()
            .filter(figure -> figure.id().equals("heap"))
            .findFirst()
            .orElseThrow();

    assertThat(heap.title())
        .isEqualTo(
            "In a heap, Carom's circles touch; those of the engines, each at its better setting,"
                + " sink 0.25 radii into each other");
    assertThat(new String(heap.picture().svg(), StandardCharsets.UTF_8))
        .contains("Mean frame; faster than Carom: Box2D defaults<", ">0.25<", ">900 µs<");
    assertThat(heap.table().rows().get(2)).contains("not in 10 s", "1 %");
  }

  /** Most frames of a heap are at rest: medians would compare frames in which nothing moves. */
  @Test
  void theRatiosAreThoseOfMeansAsTheChart() {
    ReportTable table = new PeerFigures(heap().results()).heap().get(0).table();
    int ratio = table.head().indexOf("Carom = 1");

    assertThat(table.rows().stream().map(row -> row.get(ratio)))
        .anyMatch(cell -> cell.startsWith("0.0667 (0.0667"))
        .anyMatch(cell -> cell.startsWith("8.89 (8.89"));
  }

  @Test
  void aPageQuotesTheOverlap() {
    assertThat(
            ReadmeFigures.fill(
                "<!--overlap:gdx-box2d-->?<!--/overlap:gdx-box2d-->", heap().results()))
        .contains(">0.25<");
  }

  private static Figure gas(double gain) {
    Sample sample = new Sample();
    sample.add("gas", "carom", "", "gas_energy", "max", 1e-15, "1", -1);
    sample.add("gas", "carom", "", "gas_overlap", "max", 0, "radii", -1);
    sample.add("gas", "dyn4j", "setting=tuned", "gas_energy", "max", gain, "1", -1);
    return new PeerFigures(sample.results()).gas().get(0);
  }

  @Test
  void aGainOfEnergyIsInPercent() {
    assertThat(gas(10.5).table().text()).contains("1,050 %");
  }

  @Test
  void theTitleTellsEnergyAndOverlap() {
    assertThat(gas(1).title())
        .isEqualTo(
            "Colliding circles: Carom keeps energy to 1.0e-13 % and overlaps by 0 radii; faster: none");
  }
}
