// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.peers.Contenders;
import dev.carom.bench.report.Origin;
import dev.carom.bench.report.Report;
import dev.carom.bench.report.ReportTable;
import dev.carom.bench.report.ScaleFigures;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.Row;
import dev.carom.bench.scale.Footprint;
import dev.carom.bench.scale.Scale;
import dev.carom.bench.scale.ScalePlan;
import dev.carom.bench.scale.ScalePlan.Model;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Time and memory against the number of circles. */
@Command(
    name = "scale",
    description = {
      "Measures the time of a frame from a hundred circles to a million: circles that ignore each"
          + " other among as many lines, by Carom, the published algorithm and other engines in"
          + " turns; and circles that collide, by Carom. Tells how times grow, and what a world"
          + " of 102,400 circles or more takes of memory."
    },
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class ScaleCommand implements Callable<Integer> {

  private static final int LEAST_CIRCLES = 100;

  /** In smaller scenes the heap's regions and the logs weigh more than what is asked for. */
  private static final int LEAST_SIDE_OF_MEMORY = 32;

  @Spec private CommandSpec spec;

  @Option(
      names = "--max",
      paramLabel = "N",
      defaultValue = "1000000",
      description = "The most circles, at least 100 (default: ${DEFAULT-VALUE}).")
  private int max;

  @Option(
      names = "--limit",
      paramLabel = "MS",
      defaultValue = "1000",
      description =
          "A method one frame of which takes longer plays no larger scenes (default:"
              + " ${DEFAULT-VALUE}).")
  private int limit;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Of the random scenes (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Option(names = "--quick", description = "Up to 1,000 circles only, in short rounds: seconds.")
  private boolean quick;

  @Option(names = "--csv", paramLabel = "FILE", description = "Write the rows as CSV.")
  private Path csv;

  @Option(names = "--pictures", paramLabel = "DIR", description = "Write scale.png and scale.svg.")
  private Path pictures;

  @Override
  public Integer call() throws IOException, CannotPlaceException {
    Bounded.atLeast(LEAST_CIRCLES, "--max", max, spec);
    Bounded.atLeast(1, "--limit", limit, spec);
    if (pictures != null) {
      Files.createDirectories(pictures);
    }
    ScalePlan plan = ScalePlan.of(max, quick, limit, seed);
    List<Row> rows = measure(plan);
    if (csv != null) {
      ResultsCsv.write(rows, csv);
    }
    Results results = new Results(Origin.of(Map.of("scale", seed), "", quick), rows);
    ScaleFigures figures = new ScaleFigures(results, TimeUnit.MILLISECONDS.toNanos(limit));
    print(figures);
    int largest = plan.sides().get(plan.sides().size() - 1);
    print(Footprint.of(Math.max(largest, LEAST_SIDE_OF_MEMORY), seed));
    if (pictures != null) {
      Report.writePictures(figures.figure(), pictures);
    }
    return 0;
  }

  private static List<Row> measure(ScalePlan plan) throws CannotPlaceException {
    List<Contender> alone =
        Stream.of("carom", "poster", "dyn4j-defaults", "jbox2d-defaults", "gdx-box2d-defaults")
            .map(Contenders::byId)
            .toList();
    List<Row> rows = new ArrayList<>();
    try (Progress progress = Progress.start("scale", 2 * plan.sides().size())) {
      Scale scale = new Scale(plan);
      rows.addAll(scale.run(Model.ALONE, alone, progress::step));
      rows.addAll(scale.run(Model.GAS, alone.subList(0, 1), progress::step));
    }
    return rows;
  }

  private void print(ScaleFigures figures) {
    PrintWriter out = spec.commandLine().getOut();
    ReportTable table = figures.table();
    print(out, table.head());
    table.rows().forEach(row -> print(out, row));
    out.println();
    figures.growth().forEach(out::println);
    out.flush();
  }

  private static void print(PrintWriter out, List<String> cells) {
    StringBuilder line = new StringBuilder();
    for (int i = 0; i < cells.size(); i++) {
      line.append(String.format(i == 0 || i == 2 ? "%-10s" : "%12s  ", cells.get(i)));
    }
    out.println(line.toString().stripTrailing());
  }

  private void print(Footprint memory) {
    PrintWriter out = spec.commandLine().getOut();
    out.println();
    out.printf(
        Locale.ROOT,
        "A world of %,d circles and lines takes %.0f bytes a circle and %.0f a line.%n",
        memory.circles(),
        memory.perCircle(),
        memory.perLine());
    out.flush();
  }
}
