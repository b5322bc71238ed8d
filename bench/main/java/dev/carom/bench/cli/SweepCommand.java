// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.report.Figure;
import dev.carom.bench.report.SweepFigures;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.Sweep;
import dev.carom.bench.series.SweepPlan;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The published experiment's own figures. */
@Command(
    name = "sweep",
    description = {
      "Plays the published figures: time against circles, radius, lines and impacts.",
      "Carom and the published algorithm ('poster') take turns in 15 rounds, after 3000 ms to warm"
          + " up; with --quick in 5. Tells how times"
          + " grow. Takes about 5 minutes, with --quick seconds."
    },
    footer = {"", "Example: carom-bench measure sweep --quick --pictures ."})
final class SweepCommand extends SeriesCommand {

  private static final int ROUNDS = 15;
  private static final int QUICK_ROUNDS = 5;
  private static final int WARM_UP_MILLIS = 3000;

  @Option(
      names = "--frames",
      paramLabel = "N",
      defaultValue = "600",
      description = "Frames of one replay (default: ${DEFAULT-VALUE}).")
  private int frames;

  @Option(names = "--quick", description = "A few scenes only, in fewer rounds: seconds.")
  private boolean quick;

  private SweepPlan plan;

  @Override
  void check() {
    Bounded.atLeast(1, "--frames", frames, spec);
    plan = SweepPlan.of(seed, frames, rounds(quick ? QUICK_ROUNDS : ROUNDS), quick);
    warmUpMillis(WARM_UP_MILLIS);
  }

  @Override
  List<Row> measure() throws CannotPlaceException {
    try (Progress progress = Progress.start("sweep", plan.points().size())) {
      return new Sweep(plan, List.of(Methods.CAROM, Methods.POSTER), turns())
          .run(warmUpMillis(WARM_UP_MILLIS), progress::step);
    }
  }

  @Override
  String text(Results results) {
    SweepFigures figures = new SweepFigures(results);
    return figures.table().text() + "\n" + String.join("\n", figures.growth()) + "\n";
  }

  @Override
  List<Figure> figures(Results results) {
    return new SweepFigures(results).figures();
  }

  @Override
  boolean isQuick() {
    return quick;
  }
}
