// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.charts.Panel;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Captions and titles follow from the data. */
class FiguresOfReportTest {

  private static Figure figure(Sample sample, String id) {
    return Report.figures(sample.results()).stream()
        .filter(figure -> figure.id().equals(id))
        .findFirst()
        .orElseThrow();
  }

  private static String svg(Figure figure) {
    return new String(figure.picture().svg(), StandardCharsets.UTF_8);
  }

  @Test
  void aCaptionTellsWhoIsFasterMoreAccurateLevelOrFailed() {
    String caption = figure(Sample.complete(), "work-base-1").caption();
    assertThat(caption)
        .contains("Carom: 1.04 µs, 3.0e-16 radii. Faster than Carom: none.")
        .contains("Failed: overlap test (1.56 µs)")
        .contains("Engines: dyn4j tuned: continuous, 10+ px/m; Box2D tuned: tuned.");
    Sample sample = Sample.complete().frames("base-1", "peer", "", 500, 0.1, 1);
    sample.frames("base-1", "flawless", "", 1010, 0, 1);
    assertThat(figure(sample, "work-base-1").caption())
        .contains("Faster than Carom: peer (520 ns, 0.1 radii).")
        .contains("More accurate than Carom: flawless (1.05 µs, 0 radii).")
        .contains("Not told apart from it in time: flawless (1.05 µs, 0 radii).");
  }

  @Test
  void aTitleNamesWhoIsBetterInBoth() {
    assertThat(svg(figure(Sample.complete(), "work-base-1")))
        .contains(">Nothing measured is both faster and more accurate than Carom<");
    Sample sample = Sample.complete().frames("base-1", "peer", "", 500, 1e-17, 1);
    assertThat(svg(figure(sample, "work-base-1")))
        .contains(">Both faster and more accurate than Carom: peer (520 ns, 1.0e-17 radii)<");
  }

  /** Of the two settings of an engine the one that errs less. */
  @Test
  void eachMethodHasOneDot() {
    String svg = svg(figure(Sample.complete(), "work-base-1"));
    assertThat(svg).contains("<title>dyn4j tuned: ").doesNotContain("<title>dyn4j defaults: ");
  }

  @Test
  void methodsThatSayWhatOthersSayStandInTheTableAlone() {
    Sample sample = Sample.complete().frames("base-1", "substeps", "steps=4", 900, 0.1, 1);
    Figure lead = figure(sample, "work-base-1");
    assertThat(svg(lead)).doesNotContain("substeps");
    assertThat(lead.table().rows()).anyMatch(row -> row.get(0).startsWith("substeps"));
  }

  @Test
  void aTunedPeerThatErrsMoreThanAtItsDefaultsIsNamed() {
    Sample sample = Sample.complete().frames("base-1", "dyn4j", "setting=worse", 1e5, 0.9, 1);
    assertThat(figure(sample, "work-base-1").caption())
        .contains(
            "dyn4j tuned: worse (in this scene its worst error is greater than at its defaults)")
        .contains("dyn4j tuned: continuous, 10+ px/m;");
  }

  @Test
  void otherScenesAreSmallMultiples() {
    assertThat(figure(Sample.complete(), "work").panels())
        .extracting(Panel::title)
        .containsExactly("Ten times the speed");
  }

  @Test
  void questionsTellWhereWeAreMostAccurate() {
    Sample sample = Sample.complete();
    assertThat(new QueryFigures(sample.results()).sentence())
        .endsWith("the most accurate in 3 of 3 classes, with at worst 0.5 ulps");
    sample.query("head-on", "fine", "", 5, 0.25, 0, 0);
    assertThat(new QueryFigures(sample.results()).sentence()).contains("in 2 of 3 classes");
  }

  @Test
  void withoutTimesThereIsNoChartOfTimes() {
    Sample untimed = Sample.complete().without(row -> row.unit().equals("ns"));
    assertThat(Report.figures(untimed.results()))
        .extracting(Figure::id)
        .containsExactly("drift-base-1");
  }

  @Test
  void whatDiffersMostIsDrawnAndAllIsInTheTable() {
    Sample sample = Sample.complete();
    for (String use : List.of("circles", "lines", "tiles", "gravity")) {
      sample.add("feature:" + use, "carom", "", "feature_time", "median", 1000, "ns", 0);
    }
    Figure features = figure(sample, "features");
    assertThat(svg(features)).contains("with gravity<").doesNotContain("10,000 circles");
    assertThat(features.table().rows()).hasSize(4);
  }

  @Test
  void horizonsAreTold() {
    Figure drift = figure(Sample.complete(), "drift-base-1");
    assertThat(drift.caption())
        .contains("Carom 230, published 2010 12, the reference started 1 ulp away 236.");
    assertThat(svg(drift)).contains("until frame 230; if the start");
  }

  @Test
  void framesOverTheBudgetAreCounted() {
    Figure frames = figure(Sample.complete(), "frames");
    assertThat(frames.title()).startsWith("Carom's slowest of 60 frames takes ");
    assertThat(frames.caption()).startsWith("No frame of any method exceeds the budget");
    assertThat(frames.table().rows().get(0))
        .startsWith("Carom", "base-1", "60")
        .endsWith("0 of 60 (below 5 % at 95 %)");
  }

  @Test
  void theSweepTellsHowTimesGrow() {
    assertThat(figure(Sample.complete(), "sweep").caption())
        .contains("The time of Carom grows with the number of circles to the power 1.00")
        .contains("The time of published 2010 grows with the number of circles to the power 1.02")
        .contains("The mean frame with the most circles: ", "; in the publication 52.1 ms");
  }
}
