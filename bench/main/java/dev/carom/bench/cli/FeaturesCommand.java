// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.report.FeatureFigures;
import dev.carom.bench.report.HeapFigures;
import dev.carom.bench.report.Origin;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.Features;
import dev.carom.bench.series.Heaps;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Measures the cost of each thing that a scene uses. */
@Command(
    name = "features",
    description = {
      "Measures what each thing that a scene uses costs.",
      "In time a frame and in memory: circles alone, walls, lines, sensors, a recording,"
          + " bounds of the errors, edits, collisions; and 100 lines that move among 10,000, beside as many that rest;"
          + " gravity, also of 10,000 circles, and of a gas of 1,000."
    },
    footer = {
      "",
      "Example: carom-bench features --rounds 11 --no-memory",
      "         carom-bench features --rounds 5 --heaps 1000"
    },
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class FeaturesCommand implements Callable<Integer> {

  private static final int LEAST_HEAP = 10;

  @Spec private CommandSpec spec;

  @Mixin private SeriesOptions series;

  @Option(
      names = "--rounds",
      paramLabel = "N",
      defaultValue = "101",
      description =
          "In which the scenes take turns, 600 frames each (60 of those with most circles); the"
              + " time is the median over them"
              + " (default: ${DEFAULT-VALUE}).")
  private int rounds;

  @Option(
      names = "--warm-up",
      paramLabel = "MILLIS",
      defaultValue = "2000",
      description = "How long they play before that (default: ${DEFAULT-VALUE}).")
  private int warmUpMillis;

  @Option(names = "--no-memory", description = "Do not measure what a world takes of memory.")
  private boolean noMemory;

  @Option(
      names = "--heaps",
      paramLabel = "N",
      description =
          "Measure heaps of 10, 30, 100 and 1,000 circles instead, up to N; restitution 0.5, in a"
              + " box, for six seconds from the fall on. A frame's time is its median over the"
              + " rounds.")
  private Integer heaps;

  @Override
  public Integer call() throws IOException, CannotPlaceException {
    Bounded.atLeast(1, "--rounds", rounds, spec);
    Bounded.atLeast(0, "--warm-up", warmUpMillis, spec);
    if (heaps != null) {
      Bounded.atLeast(LEAST_HEAP, "--heaps", heaps, spec);
    }
    series.prepare();
    List<Row> rows =
        heaps == null
            ? new Features(series.seed(), series.turns()).run(rounds, warmUpMillis, !noMemory)
            : new Heaps(heaps, series.seed()).run(rounds, warmUpMillis);
    series.write(rows);
    Results results = new Results(Origin.of(Map.of("features", series.seed()), "", false), rows);
    spec.commandLine().getOut().print(text(results));
    spec.commandLine().getOut().flush();
    return 0;
  }

  private String text(Results results) {
    if (heaps != null) {
      return new HeapFigures(results).table().text();
    }
    FeatureFigures figures = new FeatureFigures(results);
    return figures.table().text() + "\n" + figures.uncertainty() + "\n";
  }
}
