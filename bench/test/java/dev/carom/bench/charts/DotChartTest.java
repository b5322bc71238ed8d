// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

class DotChartTest {

  private static final List<String> METHODS = List.of("carom", "overlap", "peer", "substeps");

  private static Dot dot(String method, String knob, double error, double work) {
    return new Dot(method, knob, error, 0.9 * work, work, 1.1 * work);
  }

  private static String svg(double budget, Map<String, List<Dot>> panels) {
    return chart(budget, panels).panels(DotChart.TALL).get(0).picture().svg("d");
  }

  private static DotChart chart(double budget, Map<String, List<Dot>> panels) {
    return new DotChart(
        "what is shown",
        new Marks(METHODS, name -> name),
        List.of("error", "time"),
        budget,
        panels);
  }

  private static String svg(Dot... dots) {
    return svg(Double.NaN, Map.of("", List.of(dots)));
  }

  @Test
  void everyDotIsNamedAndTellsItsKnob() {
    assertThat(svg(dot("carom", "", 1e-15, 1000), dot("peer", "best", 0.1, 5000)))
        .contains(">carom<", ">peer<", "<title>carom: 1 µs, ", "<title>peer best: ");
  }

  @Test
  void namesOfDotsAtOnePlaceDoNotCoverEachOther() {
    String svg =
        svg(
            dot("carom", "", 0.5, 2002),
            dot("overlap", "", 0.5, 2000),
            dot("peer", "best", 0.5, 2001),
            dot("substeps", "4", 0.5, 2003));
    assertThat(
            METHODS.stream()
                .map(
                    name -> Pattern.compile(" x='[^']*' y='[^']*'[^>]*>" + name + "<").matcher(svg))
                .map(match -> match.find() ? match.group().replaceAll("[^>]*>", "") : "")
                .toList())
        .containsExactlyElementsOf(METHODS.stream().map(name -> name + "<").toList());
  }

  /** The right one of two marks that overlap would be named at the left, the left one above. */
  @Test
  void theLeftOneOfTwoDotsHasTheLeftName() {
    String svg =
        svg(
            dot("carom", "", 1e-13, 1000),
            dot("peer", "", 2.0, 260_000),
            dot("overlap", "", 1.3, 235_000),
            dot("substeps", "", 2.2, 150_000));
    assertThat(nameX(svg, "overlap")).isLessThan(nameX(svg, "peer"));
  }

  private static double nameX(String svg, String name) {
    Matcher match = Pattern.compile(" x='([^']*)' y='[^']*'[^>]*>" + name + "<").matcher(svg);
    assertThat(match.find()).isTrue();
    return Double.parseDouble(match.group(1));
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

  /** Nothing has fewer than no wrong answers: left of 0 there is no area in which one could be. */
  @Test
  void aDotWithoutErrorStandsAtTheAxisAndShadesNothing() {
    String shade = "opacity:0.149";
    assertThat(svg(dot("carom", "", 1e-15, 1000))).contains(shade);
    assertThat(svg(dot("carom", "", 0, 1000), dot("peer", "", 4000, 100)))
        .doesNotContain(shade)
        .contains(">0<", ">1,000<", ">10,000<");
  }

  @Test
  void aChartOfNothingButFailuresCanBeDrawn() {
    assertThat(svg(dot("overlap", "", Double.POSITIVE_INFINITY, Double.NaN))).contains(">failed<");
  }

  @Test
  void theBudgetIsMarkedWhereThereIsOne() {
    Map<String, List<Dot>> panel = Map.of("", List.of(dot("carom", "", 1e-15, 1000)));
    assertThat(svg(1e9 / 60, panel)).contains(">16.67 ms: 60 frames a second<");
    assertThat(svg(Double.NaN, panel)).doesNotContain("frames a second");
  }

  @Test
  void smallMultiplesHaveTitlesAndTheSameAxes() {
    Map<String, List<Dot>> panels = new LinkedHashMap<>();
    panels.put("grazing", List.of(dot("carom", "", 1e-15, 1000)));
    panels.put("head-on", List.of(dot("carom", "", 1e-3, 5e6)));
    List<Panel> small = chart(Double.NaN, panels).panels(DotChart.SMALL);
    assertThat(small).extracting(Panel::title).containsExactly("grazing", "head-on");
    assertThat(small).allMatch(panel -> panel.picture().svg("d").contains(">10 ms<"));
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
    Marks marks = new Marks(METHODS, name -> name);
    assertThat(marks.of("overlap")).isNotEqualTo(marks.of("peer"));
    assertThat(marks.of("carom"))
        .isEqualTo(new Marks(List.of("x", "y", "carom"), name -> name).of("carom"));
  }
}
