// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class RunFiguresTest {

  private static RunFigures runs(Sample sample) {
    return new RunFigures(sample.results());
  }

  private static Sample bounces() {
    Sample sample = Sample.complete();
    for (int bounces : List.of(1, 10, 100)) {
      bounce(sample, "carom", "", bounces, bounces == 1 ? 0 : 2e-16);
      bounce(sample, "dyn4j", "setting=defaults, 30 px/m", bounces, 1e-3 * bounces);
      bounce(sample, "dyn4j", "setting=continuous, 10+ px/m", bounces, 1e-5 * bounces);
    }
    return sample;
  }

  private static void bounce(Sample sample, String method, String knob, int bounces, double error) {
    sample.add("bounce", method, knob, "bounce_energy", "worst@" + bounces, error, "1", -1);
  }

  @Test
  void everyMethodIsALineAndEverySettingARow() {
    List<Figure> figures = runs(bounces()).bounce();
    assertThat(figures).hasSize(1);
    Figure figure = figures.get(0);
    assertThat(figure.title())
        .isEqualTo("After 100 bounces the energy of Carom's ball is off by at most 2.0e-16");
    assertThat(figure.table().rows())
        .containsExactly(
            List.of("Carom", "100", "2.0e-14 %"),
            List.of("dyn4j defaults", "100", "10 %"),
            List.of("dyn4j tuned", "100", "0.1 %"));
    assertThat(new String(figure.picture().svg(), StandardCharsets.UTF_8))
        .contains(">number of bounces<", ">0<", ">tuned<")
        .doesNotContain(">defaults<");
  }

  /** Results from before there was gravity have no such part. */
  @Test
  void withoutBouncesThePageLeavesThemOut() {
    assertThat(runs(Sample.complete()).bounce()).isEmpty();
    String page = Page.of(Sample.complete().results(), Report.figures(Sample.complete().results()));
    assertThat(page).doesNotContain("id=\"bounce\"");
    String with = Page.of(bounces().results(), Report.figures(bounces().results()));
    assertThat(with).containsOnlyOnce("<section id=\"bounce\">");
  }

  private static Sample bounds(double exceeded) {
    Sample sample = Sample.complete();
    for (String scene : List.of("base-1", "falling")) {
      for (int decade = -15; decade < -1; decade++) {
        double bound = Math.pow(10, decade + 1.5);
        sample.add(scene, "carom", "", "error_bound", "p5@" + decade, bound / 4, "radii", -1);
        sample.add(scene, "carom", "", "error_bound", "median@" + decade, bound, "radii", -1);
        sample.add(scene, "carom", "", "error_bound", "p95@" + decade, 9 * bound, "radii", -1);
      }
      sample.add(scene, "carom", "", "error_bound_ratio", "median", 10, "1", -1);
      sample.add(scene, "carom", "", "error_bound_exceeded", "count", exceeded, "1", -1);
      sample.add(scene, "carom", "", "error_bound_exceeded", "of", 3000, "1", -1);
    }
    return sample;
  }

  @Test
  void everySceneIsAPanelAndARow() {
    List<Figure> figures = runs(bounds(0)).trust();
    assertThat(figures).hasSize(1);
    Figure figure = figures.get(0);
    assertThat(figure.title())
        .isEqualTo("Carom predicts its own error: none of 6,000 places is further off");
    assertThat(figure.panels()).hasSize(2);
    assertThat(figure.table().rows())
        .containsExactly(
            List.of("base-1", "3,000", "0", "10"), List.of("falling", "3,000", "0", "10"));
    assertThat(new String(figure.picture().svg(), StandardCharsets.UTF_8))
        .contains(">true error of a place, in radii<", ">With gravity<")
        .contains(">true error<");
  }

  @Test
  void aBrokenPromiseIsInTheTitle() {
    Figure figure = runs(bounds(2)).trust().get(0);
    assertThat(figure.title())
        .isEqualTo("4 of 6,000 places are further from the truth than predicted");
  }

  /** Results of older runs have no such part. */
  @Test
  void withoutBoundsThePageLeavesThemOut() {
    assertThat(runs(Sample.complete()).trust()).isEmpty();
    String page = Page.of(Sample.complete().results(), Report.figures(Sample.complete().results()));
    assertThat(page).doesNotContain("id=\"trust\"");
    String with = Page.of(bounds(0).results(), Report.figures(bounds(0).results()));
    assertThat(with).containsOnlyOnce("<section id=\"trust\">");
  }
}
