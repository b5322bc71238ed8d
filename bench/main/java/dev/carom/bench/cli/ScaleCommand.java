// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.peers.Contenders;
import dev.carom.bench.report.Origin;
import dev.carom.bench.report.ScaleFigures;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.Footprint;
import dev.carom.bench.series.Scale;
import dev.carom.bench.series.ScalePlan;
import dev.carom.bench.series.ScalePlan.Model;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Time and memory against the number of circles. */
@Command(
    name = "scale",
    description = {
      "Measures time and memory from a hundred circles to a million.",
      "Circles that ignore each other, among as many lines: Carom, the published"
          + " algorithm and other engines take turns. Circles that collide: Carom and the"
          + " engines. Tells how times grow, and the memory of a world of 102,400 circles"
          + " or more. Takes about 4 minutes, with --quick seconds."
    },
    footer = {"", "Example: carom-bench scale --max 10000 --csv scale.csv"},
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class ScaleCommand implements Callable<Integer> {

  private static final int LEAST_CIRCLES = 100;

  /** In smaller scenes the heap's regions and the logs weigh more than what is asked for. */
  private static final int LEAST_SIDE_OF_MEMORY = 32;

  private static final List<String> ALONE =
      List.of("carom", "poster", "dyn4j-defaults", "jbox2d-defaults", "gdx-box2d-defaults");

  /** The published algorithm knows no pairs. */
  private static final List<String> COLLIDING =
      List.of("carom", "dyn4j-defaults", "jbox2d-defaults", "gdx-box2d-defaults");

  @Spec private CommandSpec spec;

  @Mixin private SeriesOptions series;

  @Option(
      names = "--max",
      paramLabel = "N",
      defaultValue = "1000000",
      description = "The most circles, at least 100 (default: ${DEFAULT-VALUE}).")
  private int max;

  @Option(
      names = "--limit",
      paramLabel = "MS",
      defaultValue = "" + ScalePlan.LIMIT_MILLIS,
      description =
          "A method one frame of which takes longer plays no larger scenes (default:"
              + " ${DEFAULT-VALUE}).")
  private int limit;

  @Option(
      names = "--rounds",
      paramLabel = "N",
      description = "In which methods take turns (default: 5, or 3 with --quick).")
  private Integer rounds;

  @Option(
      names = "--warm-up",
      paramLabel = "MILLIS",
      description = "How long each plays before the first scene (default: 2000, or 500).")
  private Integer warmUpMillis;

  @Option(names = "--no-memory", description = "Do not measure what a world takes of memory.")
  private boolean noMemory;

  @Option(names = "--quick", description = "Up to 1,000 circles only, in short rounds: seconds.")
  private boolean quick;

  @Override
  public Integer call() throws IOException, CannotPlaceException {
    Bounded.atLeast(LEAST_CIRCLES, "--max", max, spec);
    Bounded.atLeast(1, "--limit", limit, spec);
    series.prepare();
    List<Row> rows = measure(plan());
    series.write(rows);
    Results results = new Results(Origin.of(Map.of("scale", series.seed()), "", quick), rows);
    ScaleFigures figures = new ScaleFigures(results, TimeUnit.MILLISECONDS.toNanos(limit));
    TextTable.print(
        figures.table(), figures.told(), spec.commandLine().getOut(), "%-10s", "%12s  ");
    series.draw(figures.figures());
    return 0;
  }

  private ScalePlan plan() {
    ScalePlan plan = ScalePlan.of(max, quick, limit, series.seed());
    int times = rounds == null ? plan.rounds() : rounds;
    int millis = warmUpMillis == null ? plan.warmUpMillis() : warmUpMillis;
    Bounded.atLeast(1, "--rounds", times, spec);
    Bounded.atLeast(0, "--warm-up", millis, spec);
    return plan.lasting(times, millis);
  }

  /** Memory first: engines leave things behind that the heap gives up late. */
  private List<Row> measure(ScalePlan plan) throws CannotPlaceException {
    List<Row> rows = new ArrayList<>();
    if (!noMemory) {
      int largest = plan.sides().get(plan.sides().size() - 1);
      int side = Math.max(largest, LEAST_SIDE_OF_MEMORY);
      rows.addAll(Footprint.of(side, series.seed()).rows(Methods.CAROM.method()));
    }
    try (Progress progress = Progress.start("scale", 2 * plan.sides().size())) {
      Scale scale = new Scale(plan, series.turns());
      rows.addAll(scale.run(Model.ALONE, contenders(ALONE), progress::step));
      rows.addAll(scale.run(Model.GAS, contenders(COLLIDING), progress::step));
    }
    return rows;
  }

  private static List<Contender> contenders(List<String> ids) {
    return ids.stream().map(Contenders::byId).toList();
  }
}
