// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.measures.Parts;
import java.util.DoubleSummaryStatistics;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ScenesTest {

  /** They are kept as text. */
  @Test
  void theNumbersOfTheScenesAreTheirs() {
    Scenes.all()
        .forEach(
            (name, words) -> {
              Scene scene = Parts.scene(name);
              assertThat(words.get(1)).as(name).isEqualTo(counts(scene));
              assertThat(words.get(2)).as(name).isEqualTo(numbers(scene));
            });
    assertThat(Scenes.all()).hasSizeGreaterThan(5);
  }

  private static String counts(Scene scene) {
    int lines = scene.count(Kind.LINE);
    String circles = scene.count(Kind.CIRCLE) + " circles";
    return lines == 0 ? circles : circles + " among " + lines + " lines";
  }

  private static String numbers(Scene scene) {
    Bounds bounds = scene.bounds().orElseThrow();
    String radius = range(scene, i -> ((Circle) scene.shape(Kind.CIRCLE, i)).radius());
    String speed = range(scene, i -> scene.velocity(Kind.CIRCLE, i).length());
    String size =
        number(bounds.xmax() - bounds.xmin()) + " x " + number(bounds.ymax() - bounds.ymin());
    return "radius "
        + radius
        + ", "
        + (speed.equals("0") ? "at rest" : "speed " + speed)
        + ", "
        + size;
  }

  private static String range(Scene scene, IntToDoubleFunction value) {
    DoubleSummaryStatistics all =
        IntStream.range(0, scene.count(Kind.CIRCLE)).mapToDouble(value).summaryStatistics();
    String from = number(all.getMin());
    String to = number(all.getMax());
    return from.equals(to) ? from : from + " to " + to;
  }

  private static String number(double value) {
    return ReportNumbers.ratio(Math.round(100 * value) / 100.0);
  }
}
