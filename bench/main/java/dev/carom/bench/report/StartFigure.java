// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import java.util.Comparator;
import java.util.List;

/** The first second of a small game, by Carom and by the engines. */
final class StartFigure {

  private static final String SCENE = "start";
  private static final String TIME = "start_time";
  private static final String FIRST = "first";
  private static final String WORST = "worst";

  private StartFigure() {}

  /** One of two panels, or none if nothing was measured. */
  static List<Figure> of(Results results) {
    List<Standing> all = Standing.of(results, SCENE, TIME);
    return all.stream()
        .min(Comparator.comparingDouble(s -> s.value(TIME, WORST)))
        .map(best -> figure(all, best))
        .stream()
        .toList();
  }

  private static Figure figure(List<Standing> all, Standing best) {
    String title =
        "The first frame comes after %s; the slowest later frame is shortest with %s"
            .formatted(
                ReportNumbers.range(
                    all.stream().mapToDouble(s -> s.value(TIME, FIRST)), ReportNumbers::time),
                Glossary.name(best.method()));
    return new Figure(
        SCENE,
        "The first second",
        title,
        "A small game in a fresh virtual machine: 30 circles that collide, among 12 lines. The engines have their defaults.",
        List.of(
            panel("From the start of Java to the first frame", all, FIRST),
            panel("Slowest of the next 99 frames", all, WORST)),
        ReportTable.NONE);
  }

  private static Panel panel(String title, List<Standing> all, String stat) {
    return new Panel(
        title,
        Figure.bars(
            title,
            all,
            s -> Glossary.name(s.method()),
            Settings.marks(all.get(0).results()),
            s -> s.value(TIME, stat),
            ReportNumbers::time));
  }
}
