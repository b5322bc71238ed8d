// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.charts.WorkPrecisionChart.Work;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

class WorkPrecisionChartTest {

  private static final List<String> METHODS = List.of("carom", "overlap", "peer", "substeps");

  private static Dot dot(String method, String knob, double error, double work) {
    return new Dot(method, knob, error, 0.9 * work, work, 1.1 * work, knob.equals("defaults"));
  }

  private static String svg(double budget, Map<String, List<Dot>> panels) {
    return chart(budget, panels).panels(WorkPrecisionChart.TALL).get(0).picture().svg("d");
  }

  private static WorkPrecisionChart chart(double budget, Map<String, List<Dot>> panels) {
    return new WorkPrecisionChart(
        "what is shown", new Marks(METHODS), List.of("error", "time"), Work.TIME, budget, panels);
  }

  private static String svg(Dot... dots) {
    return svg(Double.NaN, Map.of("", List.of(dots)));
  }

  @Test
  void everyMethodIsNamedOnceAndEveryDotTellsItsKnob() {
    assertThat(
            svg(
                dot("carom", "", 1e-15, 1000),
                dot("substeps", "2", 0.5, 2000),
                dot("substeps", "4", 0.2, 4000),
                dot("peer", "defaults", 0.1, 5000)))
        .contains(">carom<", ">substeps<", ">peer<")
        .contains("<title>substeps 2: ", "<title>substeps 4: ", "<title>peer defaults: ");
  }

  @Test
  void methodsWhoseDotsCoverEachOtherShareATextThatBeginsWithTheFirst() {
    assertThat(
            svg(
                dot("carom", "", 0.5, 2002),
                dot("overlap", "", 0.5, 2000),
                dot("peer", "best", 0.5, 2001),
                dot("substeps", "4", 0.5, 2003)))
        .contains(">carom, overlap, peer,<", ">substeps<");
  }

  @Test
  void aFailureIsDrawnInAGutter() {
    String without = svg(dot("carom", "", 1e-15, 1000));
    assertThat(without).doesNotContain(">failed<", ">0<");
    assertThat(svg(dot("carom", "", 1e-15, 1000), dot("overlap", "", Double.NaN, 900)))
        .contains(">failed<", ">overlap<");
    assertThat(svg(dot("carom", "", 1e-15, 1000), dot("overlap", "", 1, Double.NaN)))
        .contains(">failed<", ">overlap<");
    assertThat(svg(dot("carom", "", 0, 1000))).contains(">0<").doesNotContain(">failed<");
  }

  @Test
  void aChartOfNothingButFailuresCanBeDrawn() {
    assertThat(svg(dot("overlap", "", Double.POSITIVE_INFINITY, Double.NaN))).contains(">failed<");
  }

  @Test
  void theBudgetIsMarkedWhereThereIsOne() {
    Map<String, List<Dot>> panel = Map.of("", List.of(dot("carom", "", 1e-15, 1000)));
    assertThat(svg(1e9 / 60, panel)).contains(">budget 16.67 ms<");
    assertThat(svg(Double.NaN, panel)).doesNotContain("budget");
  }

  @Test
  void smallMultiplesHaveTitlesAndTheSameAxes() {
    Map<String, List<Dot>> panels = new LinkedHashMap<>();
    panels.put("grazing", List.of(dot("carom", "", 1e-15, 1000)));
    panels.put("head-on", List.of(dot("carom", "", 1e-3, 5e6)));
    List<Panel> small = chart(Double.NaN, panels).panels(WorkPrecisionChart.SMALL);
    assertThat(small).extracting(Panel::title).containsExactly("grazing", "head-on");
    assertThat(small).allMatch(panel -> panel.picture().svg("d").contains(">10 ms<"));
  }

  @Test
  void failuresAtOneHeightStandSideBySide() {
    String svg =
        svg(
            dot("carom", "", 1e-15, 1000),
            dot("overlap", "", Double.NaN, 900),
            dot("peer", "best", Double.NaN, 900),
            dot("substeps", "2", Double.NaN, 900));
    List<String> rings =
        Pattern.compile("<ellipse cx='([^']*)'|<circle cx='([^']*)'")
            .matcher(svg)
            .results()
            .map(match -> match.group())
            .toList();
    assertThat(rings.stream().distinct().count()).isEqualTo(3);
  }

  /** From the error that few are above to the worst one. */
  @Test
  void aTailGoesFromTheUsualErrorToTheWorst() {
    Dot bare = new Dot("peer", "", 1e-3, 900, 1000, 1100, false);
    Dot tailed = new Dot("peer", "", 1e-3, 900, 1000, 1100, false, 1e-6);
    assertThat(svg(tailed).split("<line", -1).length)
        .isEqualTo(svg(bare).split("<line", -1).length + 2);
  }

  @Test
  void aMarkTellsItsValuesOnHover() {
    assertThat(svg(dot("peer", "best", 0.25, 1500))).contains("<title>peer best: 1.5 µs, 0.25<");
  }

  @Test
  void textsAreAsLongAsTheyWereLaidOut() {
    assertThat(svg(dot("peer", "best", 0.25, 1500)))
        .containsPattern("<text textLength='[0-9.]+' [^>]*>peer<");
  }

  @Test
  void marksDifferAndOursIsTheSameWhateverTheOthersAre() {
    Marks marks = new Marks(METHODS);
    assertThat(marks.of("overlap")).isNotEqualTo(marks.of("peer"));
    assertThat(marks.of("carom")).isEqualTo(new Marks(List.of("x", "y", "carom")).of("carom"));
  }
}
