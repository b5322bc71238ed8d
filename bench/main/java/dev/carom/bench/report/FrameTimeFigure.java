// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.FrameStripsChart;
import dev.carom.bench.charts.FrameStripsChart.Strip;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import java.util.Arrays;
import java.util.List;

/** All frame times of a replay of each method, against the budget. */
final class FrameTimeFigure {

  private FrameTimeFigure() {}

  /** That of the first scene, or none if no frame was kept. */
  static List<Figure> of(Results results) {
    return results.scenes(Metrics.FRAME_RAW).stream()
        .limit(1)
        .map(scene -> figure(results, scene))
        .toList();
  }

  private static Figure figure(Results results, String scene) {
    List<Strip> strips =
        Standing.drawn(results, scene, Metrics.FRAME_RAW).stream()
            .map(s -> new Strip(s.method(), Glossary.shortKnob(s.setting()), nanos(s)))
            .filter(strip -> strip.nanos().length > 0)
            .toList();
    Strip first = strips.get(0);
    String title =
        "%s's slowest of %s frames takes %s of the 16.67 ms allowed"
            .formatted(
                Glossary.name(first.method()),
                ReportNumbers.count(first.nanos().length),
                ReportNumbers.time(Arrays.stream(first.nanos()).max().orElseThrow()));
    return new Figure(
        "frames",
        "All frame times",
        title,
        "Each dot is one frame%s, on a logarithmic scale. Thick line: median; thin line: the slowest. Dashed: 16.67 ms, all that 60 frames a second allow."
            .formatted(Scenes.size(scene)),
        List.of(
            new Panel(
                "",
                new FrameStripsChart(title, Settings.marks(results), strips, 1e6 * Budget.MILLIS)
                    .picture())),
        ReportTable.NONE);
  }

  private static double[] nanos(Standing s) {
    return s.results().series(s.scene(), s.setting(), Metrics.FRAME_RAW, "frame").values().stream()
        .mapToDouble(nanos -> nanos)
        .filter(nanos -> !Double.isNaN(nanos))
        .toArray();
  }
}
