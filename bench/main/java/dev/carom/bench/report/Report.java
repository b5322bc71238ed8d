// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Style;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.ResultsJson;
import dev.carom.bench.results.Row;
import dev.carom.bench.results.WholeFile;
import dev.carom.bench.series.ScalePlan;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * Writes a report: results as JSON and CSV, the verdict as text, one page, and each figure as PNG
 * and SVG. The CSV leaves out the raw times of single frames, which are most of the rows; the JSON
 * has them.
 */
public final class Report {

  /** The file that all others can be made from. */
  public static final String RESULTS = "results.json";

  /** The page. */
  public static final String PAGE = "report.html";

  /** The first screen of the page, for where a folder of results is shown. */
  static final String README = "README.md";

  /** The file that holds the printed text. */
  private static final String SUMMARY = "verdict.txt";

  private Report() {}

  /**
   * Returns the result without pictures.
   *
   * @param results what was measured
   * @return the verdict, a sentence a line, and the limits
   */
  public static String summary(Results results) {
    return String.join("\n", Verdict.of(results)) + "\n\n" + AcceptanceLimits.table(results).text();
  }

  /**
   * Writes all files.
   *
   * @param results what was measured
   * @param dir where; it is created if need be, and files of these names are replaced
   * @throws IOException if a file cannot be written; the message names it
   * @throws IllegalStateException if there is no font
   */
  public static void write(Results results, Path dir) throws IOException {
    Style.requireFonts();
    Files.createDirectories(dir);
    ResultsJson.write(results, dir.resolve(RESULTS));
    List<Row> rows =
        results.rows().stream().filter(row -> !row.metric().equals(Metrics.FRAME_RAW)).toList();
    ResultsCsv.write(rows, dir.resolve("results.csv"));
    WholeFile.write(dir.resolve(SUMMARY), summary(results));
    List<Figure> figures = figures(results);
    WholeFile.write(dir.resolve(PAGE), Page.of(results, figures));
    WholeFile.write(dir.resolve(README), ResultsReadme.of(results, figures));
    for (Figure figure : figures) {
      if (!figure.panels().isEmpty()) {
        writePictures(figure, dir);
      }
    }
  }

  /**
   * Writes a figure as PNG and SVG, named after it.
   *
   * @param dir a folder that exists
   * @throws IOException if a file cannot be written; the message names it
   */
  public static void writePictures(Figure figure, Path dir) throws IOException {
    WholeFile.write(dir.resolve(figure.id() + ".png"), figure.picture().png());
    WholeFile.write(dir.resolve(figure.id() + ".svg"), figure.picture().svg());
  }

  /**
   * The figures that the results have numbers for.
   *
   * @param results what was measured
   * @return in the order of the page
   */
  static List<Figure> figures(Results results) {
    WorkFigures work = new WorkFigures(results);
    PeerFigures peers = new PeerFigures(results);
    RunFigures runs = new RunFigures(results);
    return Stream.of(
            work.figures(),
            work.frames(),
            peers.engines(),
            new QuestionFigures(results).figures(),
            new FeatureFigures(results).figures(),
            new StabilityMatrix(results).figures(),
            new StabilityFigures(results).figures(),
            runs.drift(),
            peers.heap(),
            runs.bounce(),
            runs.trust(),
            peers.gas(),
            new ScaleFigures(results, 1e6 * ScalePlan.LIMIT_MILLIS).figures(),
            peers.start(),
            new SweepFigures(results).figures())
        .flatMap(List::stream)
        .toList();
  }
}
