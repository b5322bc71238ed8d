// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.report.Figure;
import dev.carom.bench.report.Report;
import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Option;

/** Options of the commands that play random scenes along an axis, and where they write. */
final class SeriesOptions {

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Of the random scenes (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Option(
      names = "--turns",
      paramLabel = "N",
      description = "Seed of the order in which methods take turns (default: that of --seed).")
  private Long turns;

  @Option(names = "--csv", paramLabel = "FILE", description = "Write the rows as CSV.")
  private Path csv;

  @Option(
      names = "--pictures",
      paramLabel = "DIR",
      description = "Write the chart as PNG and SVG, named after the command.")
  private Path pictures;

  long seed() {
    return seed;
  }

  long turns() {
    return turns == null ? seed : turns;
  }

  /** Makes the folders of what is to be written, before anything long begins. */
  void prepare() throws IOException {
    if (csv != null) {
      OutputFile.prepare(csv);
    }
    if (pictures != null) {
      OutputFile.prepareFolder(pictures);
    }
  }

  void write(List<Row> rows) throws IOException {
    if (csv != null) {
      ResultsCsv.write(rows, csv);
    }
  }

  void draw(List<Figure> figures) throws IOException {
    if (pictures != null) {
      for (Figure figure : figures) {
        Report.writePictures(figure, pictures);
      }
    }
  }
}
