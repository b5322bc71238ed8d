// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.charts.WorkPrecisionChart.Work;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class WorkPrecisionChartTest {

  private static final List<String> METHODS = List.of("carom", "overlap", "peer", "substeps");

  private static Dot dot(String method, String knob, double error, double work) {
    return new Dot(method, knob, error, 0.9 * work, work, 1.1 * work, knob.equals("defaults"));
  }

  private static String svg(double budget, Map<String, List<Dot>> panels) {
    return new WorkPrecisionChart(
            "A title",
            "what is shown",
            new Marks(METHODS),
            List.of("error", "time"),
            Work.TIME,
            budget,
            panels)
        .picture(Picture.WIDE)
        .svg("d");
  }

  private static String svg(Dot... dots) {
    return svg(Double.NaN, Map.of("", List.of(dots)));
  }

  @Test
  void everyKnobIsPrintedAndEveryMethodNamed() {
    assertThat(
            svg(
                dot("carom", "", 1e-15, 1000),
                dot("substeps", "2", 0.5, 2000),
                dot("substeps", "4", 0.2, 4000),
                dot("peer", "defaults", 0.1, 5000),
                dot("peer", "30 iterations", 0.05, 9000)))
        .contains(">carom<", ">2<", ">substeps 4<", ">peer defaults<", ">peer 30 iterations<");
  }

  @Test
  void dotsThatCoverEachOtherShareAText() {
    assertThat(
            svg(
                dot("carom", "", 1e-15, 1e6),
                dot("substeps", "2", 0.5, 2000),
                dot("substeps", "4", 0.499, 2001),
                dot("peer", "defaults", 0.1, 9000),
                dot("peer", "best", 0.101, 9001)))
        .contains(">substeps 2 .. 4<", ">peer defaults, best<")
        .doesNotContain(">2<");
  }

  @Test
  void methodsWhoseDotsCoverEachOtherShareAText() {
    assertThat(
            svg(
                dot("carom", "", 1e-15, 1e6),
                dot("overlap", "", 0.5, 2000),
                dot("peer", "best", 0.5, 2001),
                dot("substeps", "4", 1e-5, 2000)))
        .contains(">overlap, peer best<", ">substeps 4<", ">carom<");
  }

  @Test
  void aFailureIsDrawnInAGutter() {
    String without = svg(dot("carom", "", 1e-15, 1000));
    assertThat(without).doesNotContain(">failed<", ">no error<");
    assertThat(svg(dot("carom", "", 1e-15, 1000), dot("overlap", "", Double.NaN, 900)))
        .contains(">failed<", ">overlap<");
    assertThat(svg(dot("carom", "", 1e-15, 1000), dot("overlap", "", 1, Double.NaN)))
        .contains(">failed<", ">overlap<");
    assertThat(svg(dot("carom", "", 0, 1000))).contains(">no error<").doesNotContain(">failed<");
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
    String svg = svg(Double.NaN, panels);
    assertThat(svg).contains(">grazing<", ">head-on<");
    assertThat(svg.split(">10 ms<", -1)).hasSize(3);
  }

  @Test
  void marksDifferAndOursIsTheSameWhateverTheOthersAre() {
    Marks marks = new Marks(METHODS);
    assertThat(marks.of("overlap")).isNotEqualTo(marks.of("peer"));
    assertThat(marks.of("carom")).isEqualTo(new Marks(List.of("x", "y", "carom")).of("carom"));
  }
}
