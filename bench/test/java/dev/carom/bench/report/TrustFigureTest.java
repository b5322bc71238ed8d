// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class TrustFigureTest {

  private static Sample sample(double exceeded) {
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
    List<Figure> figures = TrustFigure.of(sample(0).results());
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
    Figure figure = TrustFigure.of(sample(2).results()).get(0);
    assertThat(figure.title())
        .isEqualTo("4 of 6,000 places are further from the truth than predicted");
  }

  /** Results of older runs have no such part. */
  @Test
  void withoutThePartThePageLeavesItOut() {
    assertThat(TrustFigure.of(Sample.complete().results())).isEmpty();
    String page = Page.of(Sample.complete().results(), Report.figures(Sample.complete().results()));
    assertThat(page).doesNotContain("id=\"trust\"");
    String with = Page.of(sample(0).results(), Report.figures(sample(0).results()));
    assertThat(with).containsOnlyOnce("<section id=\"trust\">");
  }
}
