// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.charts.Panel;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Titles and tables follow from the data. */
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
  void aTitleNamesWhoIsBetterInBoth() {
    assertThat(svg(figure(Sample.complete(), "work-base-1")))
        .contains(">Nothing measured is both faster and more accurate than Carom<");
    Sample sample = Sample.complete().frames("base-1", "peer", "", 500, 1e-17, 1);
    assertThat(svg(figure(sample, "work-base-1")))
        .contains(">Both faster and more accurate than Carom: peer in base-1<");
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

  /** Carom = 1 is the middle; in brackets the least and the greatest that the forks allow. */
  @Test
  void theTableHasTheRatioOfTimes() {
    ReportTable table = figure(Sample.complete(), "work-base-1").table();
    assertThat(table.rows())
        .anySatisfy(
            row ->
                assertThat(row)
                    .contains("published 2010", "68.6 µs (66.3 µs .. 71 µs)", "66 (61.6 .. 70.7)"));
  }

  @Test
  void otherScenesAreSmallMultiples() {
    assertThat(figure(Sample.complete(), "work").panels())
        .extracting(Panel::title)
        .containsExactly("Ten times the speed");
  }

  @Test
  void questionsTellTimesWrongAnswersAndErrors() {
    Sample sample = Sample.complete();
    assertThat(new QuestionFigures(sample.results()).figures()).isEmpty();
    sample.query("grazing", "plain", "", 10, 7, 2, 1).query("head-on", "plain", "", 15, 1, 0, 0);
    Figure questions = figure(sample, "questions");
    assertThat(questions.title()).contains("costs 2 to 3 times a plain test");
    assertThat(questions.note()).contains("In 1 of 3 classes", ": head-on. There exactness");
    assertThat(questions.table().rows().get(1))
        .startsWith("grazing", "30.6 ns", "0", "0.5", "10.2 ns", "3 x", "3", "7", "45.9 ns");
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
    assertThat(drift.table().rows())
        .containsExactly(List.of("Carom", "230"), List.of("published 2010", "12"));
    assertThat(drift.title())
        .endsWith("until frame 230; if the start is off by one bit, until frame 236");
  }

  @Test
  void theSlowestFrameIsTold() {
    assertThat(figure(Sample.complete(), "frames").title())
        .startsWith("Carom's slowest of 60 frames takes 1.3 µs of the");
  }

  @Test
  void theSweepTellsHowTimesGrow() {
    Figure sweep = figure(Sample.complete(), "sweep");
    assertThat(new SweepFigures(Sample.complete().results()).growth())
        .anyMatch(
            told ->
                told.startsWith(
                    "The time of Carom grows with the number of circles to the power 1.00"))
        .anyMatch(
            told ->
                told.startsWith(
                    "The time of published 2010 grows with the number of circles to the power 1.02"));
    assertThat(sweep.title())
        .startsWith("The mean frame with the most circles: Carom 1 µs")
        .endsWith("; in the publication 52.1 ms");
  }
}
