// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.report.Origin;
import dev.carom.bench.report.SweepFigures;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.Sweep;
import dev.carom.bench.series.SweepPlan;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The published experiment's own figures. */
@Command(
    name = "sweep",
    description = {
      "Plays the published figures: time against circles, radius, lines and impacts.",
      "Carom and the published algorithm ('poster') take turns. Tells how times"
          + " grow. Takes about 5 minutes, with --quick seconds."
    },
    footer = {"", "Example: carom-bench sweep --quick --pictures ."},
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class SweepCommand implements Callable<Integer> {

  private static final int REPLAYS = 15;
  private static final int QUICK_REPLAYS = 5;

  @Spec private CommandSpec spec;

  @Mixin private SeriesOptions series;

  @Option(
      names = "--frames",
      paramLabel = "N",
      defaultValue = "600",
      description = "Frames of one replay (default: ${DEFAULT-VALUE}).")
  private int frames;

  @Option(
      names = "--replays",
      paramLabel = "N",
      description =
          "Replays of each scene by each method; the time of a frame is its median over them"
              + " (default: 15, or 5 with --quick).")
  private Integer replays;

  @Option(
      names = "--warm-up",
      paramLabel = "MILLIS",
      defaultValue = "3000",
      description = "How long both play before the first scene (default: ${DEFAULT-VALUE}).")
  private int warmUpMillis;

  @Option(names = "--quick", description = "A few scenes only: seconds instead of a minute.")
  private boolean quick;

  @Override
  public Integer call() throws IOException, CannotPlaceException {
    int times = replays == null ? (quick ? QUICK_REPLAYS : REPLAYS) : replays;
    Bounded.atLeast(1, "--frames", frames, spec);
    Bounded.atLeast(1, "--replays", times, spec);
    Bounded.atLeast(0, "--warm-up", warmUpMillis, spec);
    series.prepare();
    SweepPlan plan = SweepPlan.of(series.seed(), frames, times, quick);
    List<Row> rows = measure(plan);
    series.write(rows);
    SweepFigures figures =
        new SweepFigures(new Results(Origin.of(Map.of("sweep", series.seed()), "", quick), rows));
    TextTable.print(
        figures.table(), figures.growth(), spec.commandLine().getOut(), "%-9s", "%16s  ");
    series.draw(figures.figures());
    return 0;
  }

  private List<Row> measure(SweepPlan plan) throws CannotPlaceException {
    List<Contender> contenders = List.of(Methods.CAROM, Methods.POSTER);
    try (Progress progress = Progress.start("sweep", plan.points().size())) {
      return new Sweep(plan, contenders, series.turns()).run(warmUpMillis, progress::step);
    }
  }
}
