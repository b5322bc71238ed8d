// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.report.Figure;
import dev.carom.bench.report.Report;
import dev.carom.bench.report.StabilityFigures;
import dev.carom.bench.report.StabilityMatrix;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.stability.FailureMap;
import dev.carom.bench.stability.Survey;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Where methods fail. */
@Command(
    name = "stability",
    description = {
      "Maps where methods fail, on grids of small scenes.",
      "Carom, other methods and other engines play each cell. The true course"
          + " judges them: right, drifted, far off, of wrong speed, or escaped. Takes less"
          + " than a minute."
    },
    footer = {"", "Example: carom-bench stability --quick --map angle --pictures ."})
final class StabilityCommand extends BenchCommand {

  @Option(
      names = "--map",
      paramLabel = "NAME",
      split = ",",
      description = "Play these maps only: angle, frame, corner, origin, gap, mass (default: all).")
  private List<String> names;

  @Option(names = "--quick", description = "Every third value of each axis: seconds.")
  private boolean quick;

  @Option(names = "--pictures", paramLabel = "DIR", description = "Write each map as PNG and SVG.")
  private Path pictures;

  @Mixin private RowFiles files;

  @Override
  void run() throws IOException {
    List<FailureMap> maps = chosen();
    files.prepare();
    if (pictures != null) {
      OutputFile.prepareFolder(pictures);
    }
    List<Row> rows = new ArrayList<>();
    try (Progress progress = Progress.start("stability", maps.size())) {
      for (FailureMap map : maps) {
        rows.addAll(Survey.of(map, Survey.contenders()));
        progress.step(map.name());
      }
    }
    Results results = files.write(Map.of(), quick, rows);
    List<Figure> figures = new StabilityFigures(results).figures();
    print(new StabilityMatrix(results).table().text());
    if (pictures != null) {
      for (Figure figure : figures) {
        Report.writePictures(figure, pictures);
      }
    }
  }

  private List<FailureMap> chosen() {
    List<FailureMap> all = FailureMap.all(quick);
    if (names == null) {
      return all;
    }
    List<String> known = all.stream().map(FailureMap::name).toList();
    for (String name : names) {
      if (!known.contains(name)) {
        throw refused("--map has %s: expected %s".formatted(name, String.join(", ", known)));
      }
    }
    return all.stream().filter(map -> names.contains(map.name())).toList();
  }
}
