// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class BounceFigureTest {

  private static Sample sample() {
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
    List<Figure> figures = BounceFigure.of(sample().results());
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
  void withoutThePartThePageLeavesItOut() {
    assertThat(BounceFigure.of(Sample.complete().results())).isEmpty();
    String page = Page.of(Sample.complete().results(), Report.figures(Sample.complete().results()));
    assertThat(page).doesNotContain("id=\"bounce\"");
    String with = Page.of(sample().results(), Report.figures(sample().results()));
    assertThat(with).containsOnlyOnce("<section id=\"bounce\">");
  }
}
