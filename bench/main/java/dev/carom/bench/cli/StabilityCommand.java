// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.report.Figure;
import dev.carom.bench.report.Origin;
import dev.carom.bench.report.Report;
import dev.carom.bench.report.ReportTable;
import dev.carom.bench.report.StabilityFigures;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.Row;
import dev.carom.bench.stability.FailureMap;
import dev.carom.bench.stability.Survey;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Where methods fail. */
@Command(
    name = "stability",
    description = {
      "Maps where methods fail, on grids of small scenes.",
      "Carom, other methods and other engines play each cell. The true course"
          + " judges them: right, drifted, far off, of wrong speed, or escaped. Takes less"
          + " than a minute."
    },
    footer = {"", "Example: carom-bench stability --quick --map angle --out ."},
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class StabilityCommand implements Callable<Integer> {

  @Spec private CommandSpec spec;

  @Option(
      names = "--map",
      paramLabel = "NAME",
      split = ",",
      description = "Play these maps only: angle, frame, corner, origin, gap, mass (default: all).")
  private List<String> names;

  @Option(names = "--quick", description = "Every third value of each axis: seconds.")
  private boolean quick;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Write each map as PNG and SVG, and all classes as stability.csv.")
  private Path out;

  @Override
  public Integer call() throws IOException {
    List<FailureMap> maps = chosen();
    if (out != null) {
      OutputFile.prepareFolder(out);
    }
    List<Row> rows = new ArrayList<>();
    try (Progress progress = Progress.start("stability", maps.size())) {
      for (FailureMap map : maps) {
        rows.addAll(Survey.of(map, Survey.contenders()));
        progress.step(map.name());
      }
    }
    List<Figure> figures =
        new StabilityFigures(new Results(Origin.of(Map.of(), "", quick), rows)).figures();
    figures.forEach(this::print);
    if (out != null) {
      ResultsCsv.write(rows, out.resolve("stability.csv"));
      for (Figure figure : figures) {
        Report.writePictures(figure, out);
      }
    }
    return 0;
  }

  private List<FailureMap> chosen() {
    List<FailureMap> all = FailureMap.all(quick);
    if (names == null) {
      return all;
    }
    List<String> known = all.stream().map(FailureMap::name).toList();
    for (String name : names) {
      if (!known.contains(name)) {
        throw new ParameterException(
            spec.commandLine(),
            "--map has %s: expected %s".formatted(name, String.join(", ", known)));
      }
    }
    return all.stream().filter(map -> names.contains(map.name())).toList();
  }

  private void print(Figure figure) {
    PrintWriter printer = spec.commandLine().getOut();
    ReportTable table = figure.table();
    printer.println(figure.heading());
    print(printer, table.head());
    table.rows().forEach(row -> print(printer, row));
    printer.println(figure.caption());
    printer.println();
    printer.flush();
  }

  private static void print(PrintWriter printer, List<String> cells) {
    StringBuilder line = new StringBuilder();
    int last = cells.size() - 1;
    for (int i = 0; i < last; i++) {
      line.append(String.format(i == 0 ? "%-20s" : "%11s", cells.get(i)));
    }
    printer.println(line.append("   ").append(cells.get(last)));
  }
}
