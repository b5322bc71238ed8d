// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.peers.Contenders;
import dev.carom.bench.report.Figure;
import dev.carom.bench.report.ScaleFigures;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.Footprint;
import dev.carom.bench.series.Scale;
import dev.carom.bench.series.ScalePlan;
import dev.carom.bench.series.ScalePlan.Model;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Time and memory against the number of circles. */
@Command(
    name = "scale",
    description = {
      "Measures time and memory from a hundred circles to a million.",
      "Circles that ignore each other, among as many lines: Carom, the published"
          + " algorithm and other engines take turns. Circles that collide: Carom and the"
          + " engines. Tells how times grow, and the memory of a world of 102,400 circles"
          + " or more. In 5 rounds, after 2000 ms to"
          + " warm up; with --quick in 3, after 500 ms. Takes about 4 minutes, with --quick seconds."
    },
    footer = {"", "Example: carom-bench measure scale --max 10000 --csv scale.csv"})
final class ScaleCommand extends SeriesCommand {

  private static final int LEAST_CIRCLES = 100;

  /** In smaller scenes the heap's regions and the logs weigh more than what is asked for. */
  private static final int LEAST_SIDE_OF_MEMORY = 32;

  private static final List<String> ALONE =
      List.of("carom", "poster", "dyn4j-defaults", "jbox2d-defaults", "gdx-box2d-defaults");

  /** The published algorithm knows no pairs. */
  private static final List<String> COLLIDING =
      List.of("carom", "dyn4j-defaults", "jbox2d-defaults", "gdx-box2d-defaults");

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

  @Option(names = "--no-memory", description = "Do not measure what a world takes of memory.")
  private boolean noMemory;

  @Option(names = "--quick", description = "Up to 1,000 circles only, in short rounds: seconds.")
  private boolean quick;

  private ScalePlan plan;

  @Override
  void check() {
    Bounded.atLeast(LEAST_CIRCLES, "--max", max, spec);
    Bounded.atLeast(1, "--limit", limit, spec);
    ScalePlan byDefault = ScalePlan.of(max, quick, limit, seed);
    plan = byDefault.lasting(rounds(byDefault.rounds()), warmUpMillis(byDefault.warmUpMillis()));
  }

  /** Memory first: engines leave things behind that the heap gives up late. */
  @Override
  List<Row> measure() throws CannotPlaceException {
    List<Row> rows = new ArrayList<>();
    if (!noMemory) {
      int largest = plan.sides().get(plan.sides().size() - 1);
      int side = Math.max(largest, LEAST_SIDE_OF_MEMORY);
      rows.addAll(Footprint.of(side, seed).rows(Methods.CAROM.method()));
    }
    try (Progress progress = Progress.start("scale", 2 * plan.sides().size())) {
      Scale scale = new Scale(plan, turns());
      rows.addAll(scale.run(Model.ALONE, contenders(ALONE), progress::step));
      rows.addAll(scale.run(Model.GAS, contenders(COLLIDING), progress::step));
    }
    return rows;
  }

  @Override
  String text(Results results) {
    ScaleFigures figures = shown(results);
    return figures.table().text() + "\n" + String.join("\n", figures.told()) + "\n";
  }

  @Override
  List<Figure> figures(Results results) {
    return shown(results).figures();
  }

  private ScaleFigures shown(Results results) {
    return new ScaleFigures(results, TimeUnit.MILLISECONDS.toNanos(limit));
  }

  @Override
  boolean isQuick() {
    return quick;
  }

  private static List<Contender> contenders(List<String> ids) {
    return ids.stream().map(Contenders::byId).toList();
  }
}
