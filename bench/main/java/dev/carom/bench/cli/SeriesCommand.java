// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.report.Figure;
import dev.carom.bench.report.Report;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** A series of random scenes that are played in turns: measured, written, printed and drawn. */
abstract class SeriesCommand extends BenchCommand {

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Of the random scenes (default: ${DEFAULT-VALUE}).")
  long seed;

  @Option(
      names = "--turns",
      paramLabel = "N",
      description = "Seed of the order in which methods take turns (default: that of --seed).")
  private Long turns;

  @Option(
      names = {"--rounds", "--replays"},
      paramLabel = "N",
      description =
          "Rounds in which they take turns; a time is the median over them (default: see above).")
  private Integer rounds;

  @Option(
      names = "--warm-up",
      paramLabel = "MS",
      description = "How long they play before anything is measured (default: see above).")
  private Integer warmUpMillis;

  @Option(
      names = "--pictures",
      paramLabel = "DIR",
      description = "Write the chart as PNG and SVG, named after the series.")
  private Path pictures;

  @Mixin private RowFiles files;

  final long turns() {
    return turns == null ? seed : turns;
  }

  final int rounds(int byDefault) {
    int n = rounds == null ? byDefault : rounds;
    Bounded.atLeast(1, "--rounds", n, spec);
    return n;
  }

  final int warmUpMillis(int byDefault) {
    int millis = warmUpMillis == null ? byDefault : warmUpMillis;
    Bounded.atLeast(0, "--warm-up", millis, spec);
    return millis;
  }

  @Override
  final void run() throws IOException, CannotPlaceException {
    check();
    files.prepare();
    if (pictures != null) {
      OutputFile.prepareFolder(pictures);
    }
    Results results = files.write(Map.of(spec.name(), seed), isQuick(), measure());
    print(text(results).replace('\u00b5', 'u')); // in any encoding
    if (pictures != null) {
      for (Figure figure : figures(results)) {
        Report.writePictures(figure, pictures);
      }
    }
  }

  /** Refuses options, before anything is written. */
  abstract void check();

  abstract List<Row> measure() throws CannotPlaceException;

  abstract String text(Results results);

  abstract List<Figure> figures(Results results);

  boolean isQuick() {
    return false;
  }
}
