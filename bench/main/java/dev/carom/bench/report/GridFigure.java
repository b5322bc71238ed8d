// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;

/** What a grid gives, and what exactness costs a frame, by two controls: in words. */
final class GridFigure {

  private static final Setting PLAIN_GRID = new Setting("plain-grid", "");
  private static final Setting GRID = new Setting("textbook-grid", "");
  private static final Setting TEXTBOOK = new Setting("textbook-double", "");

  private final Results results;

  private GridFigure(Results results) {
    this.results = results;
  }

  /** One, or none if a control was not timed. */
  static List<Figure> of(Results results) {
    GridFigure grid = new GridFigure(results);
    boolean timed =
        results.methods().contains(PLAIN_GRID.method())
            && grid.ratios(Metrics.CAROM, PLAIN_GRID).findAny().isPresent();
    return timed ? List.of(grid.figure()) : List.of();
  }

  private Figure figure() {
    String title =
        "The grid makes frames %s times as fast; a frame of Carom takes %s times as long as one of a simple program in plain doubles"
            .formatted(
                ReportNumbers.range(ratios(TEXTBOOK, GRID), ReportNumbers::times),
                ReportNumbers.range(
                    ratios(Metrics.CAROM, PLAIN_GRID),
                    ratio -> String.format(Locale.ROOT, "%.2f", ratio)));
    return new Figure(
        "grid",
        "What a grid gives",
        title,
        "Two controls share Carom's event loop and kind of grid. They are short programs, not tuned as Carom is, so less than 1 says that tuning weighs more than exactness, not that exactness is free. What they lack is right decisions where it is close, which single frames of these scenes hardly meet."
            + precision(),
        List.of(),
        ReportTable.NONE);
  }

  /** In each scene that both were timed in: how many times as long one takes as the other. */
  private DoubleStream ratios(Setting one, Setting other) {
    return results.scenes(Metrics.FRAME_ERROR).stream()
        .map(scene -> new Standing(results, scene, one))
        .mapToDouble(s -> s.time().middle() / s.with(other).time().middle())
        .filter(ratio -> !Double.isNaN(ratio));
  }

  /** Which precision decided in the frames of all scenes: a sentence, or nothing. */
  private String precision() {
    double asked = pairs("asked");
    double left = asked - pairs("double");
    return asked == 0
        ? ""
        : " Of %s pairs of circle and line that frames looked at, plain doubles decided %s."
            .formatted(
                ReportNumbers.count(asked),
                left == 0 ? "all" : "all but " + ReportNumbers.count(left));
  }

  private double pairs(String stat) {
    return results.scenes(Metrics.RUNGS).stream()
        .filter(scene -> !Metrics.isQuery(scene))
        .mapToDouble(scene -> results.value(scene, Metrics.CAROM, Metrics.RUNGS, stat))
        .sum();
  }
}
