// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.report.FeatureFigures;
import dev.carom.bench.report.Figure;
import dev.carom.bench.report.SeriesTables;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.Features;
import dev.carom.bench.series.Heaps;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Measures the cost of each thing that a scene uses. */
@Command(
    name = "features",
    description = {
      "Measures what each thing that a scene uses costs.",
      "In time a frame and in memory: circles alone, walls, lines, sensors, a recording,"
          + " bounds of the errors, edits, collisions; and 100 lines that move among 10,000, beside as many that rest;"
          + " gravity, also of 10,000 circles, and of a gas of 1,000.",
      "In 101 rounds of 600 frames (60 of the scenes with most circles), after 2000 ms to warm"
          + " up. Takes minutes."
    },
    footer = {
      "",
      "Example: carom-bench measure features --rounds 11 --no-memory",
      "         carom-bench measure features --rounds 5 --heaps 1000"
    })
final class FeaturesCommand extends SeriesCommand {

  private static final int LEAST_HEAP = 10;

  /** Heaps are played one after the other, and no chart shows them. */
  private static final List<String> FEATURES_ONLY = List.of("--turns", "--pictures", "--no-memory");

  private static final int ROUNDS = 101;
  private static final int WARM_UP_MILLIS = 2000;

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
  void check() {
    rounds(ROUNDS);
    warmUpMillis(WARM_UP_MILLIS);
    if (heaps != null) {
      Bounded.atLeast(LEAST_HEAP, "--heaps", heaps, spec);
      for (String option : FEATURES_ONLY) {
        if (isGiven(option)) {
          throw refused("--heaps and " + option + " exclude each other");
        }
      }
    }
  }

  @Override
  List<Row> measure() throws CannotPlaceException {
    int rounds = rounds(ROUNDS);
    int warmUpMillis = warmUpMillis(WARM_UP_MILLIS);
    return heaps == null
        ? new Features(seed, turns()).run(rounds, warmUpMillis, !noMemory)
        : new Heaps(heaps, seed).run(rounds, warmUpMillis);
  }

  @Override
  String text(Results results) {
    if (heaps != null) {
      return SeriesTables.heaps(results).text();
    }
    return new FeatureFigures(results).table().text();
  }

  @Override
  List<Figure> figures(Results results) {
    return new FeatureFigures(results).figures();
  }
}
