// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.measures.Part;
import dev.carom.bench.measures.Parts;
import dev.carom.bench.report.Origin;
import dev.carom.bench.report.ReadmeFigures;
import dev.carom.bench.report.Report;
import dev.carom.bench.report.ReportRun;
import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsJson;
import dev.carom.bench.series.SeriesParts;
import dev.carom.bench.stability.StabilityPart;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Measures everything and writes the report, or writes it anew from stored results. */
@Command(
    name = "report",
    description = {
      "Measures speed and accuracy of all methods and engines, and writes a report.",
      "The report is a page, its charts as PNG and SVG, and all numbers as JSON and"
          + " CSV. Takes 50 minutes on two cores, with --quick about 10. A run that"
          + " was interrupted goes on where it was."
    },
    footer = {"", "Example: carom-bench report --quick --out report"},
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class ReportCommand implements Callable<Integer> {

  private static final String PARTS = "parts";

  @Spec private CommandSpec spec;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Where to write (default: the folder report, or that of --from).")
  private Path out;

  @Option(
      names = "--from",
      paramLabel = "DIR",
      description = "Measure nothing: write the report anew from the results of a folder.")
  private Path from;

  @Option(
      names = "--quick",
      description = "One scene, fewer settings and queries, shorter replays: about 10 minutes.")
  private boolean quick;

  @Option(
      names = "--scenes",
      paramLabel = "NAME",
      split = ",",
      description =
          "Play these scenes (default: all, and base-1 with --quick); questions and sweep stay.")
  private List<String> scenes;

  @Option(
      names = "--untimed",
      description =
          "Leave out all times: what is left is the same on every machine, however busy it is.")
  private boolean untimed;

  @Option(
      names = "--date",
      paramLabel = "DATE",
      description = "The date that the report bears (default: today).")
  private String date;

  @Option(
      names = "--readme",
      paramLabel = "FILE",
      split = ",",
      description =
          "Write the figures of --from between the marks of these pages, and nothing else.")
  private List<Path> pages;

  @Override
  public Integer call() throws IOException {
    if (pages != null) {
      fill();
      return 0;
    }
    for (String option : List.of("--quick", "--scenes", "--untimed", "--date")) {
      if (from != null && spec.commandLine().getParseResult().hasMatchedOption(option)) {
        throw refused("--from and " + option + " exclude each other");
      }
    }
    if (from != null) {
      Results results = ResultsJson.read(from.resolve(Report.RESULTS));
      write(results, out == null ? from : out);
    } else {
      measure(out == null ? Path.of("report") : out);
    }
    return 0;
  }

  private void fill() throws IOException {
    if (from == null || out != null) {
      throw refused("--readme needs --from, and excludes --out");
    }
    Results results = ResultsJson.read(from.resolve(Report.RESULTS));
    for (Path page : pages) {
      ReadmeFigures.write(page, results);
    }
  }

  private void measure(Path dir) throws IOException {
    List<Part> parts = chosen();
    String day = date == null ? LocalDate.now(ZoneId.systemDefault()).toString() : date;
    Metadata metadata = Origin.of(Map.of("sweep", 1L, "scale", 1L), day, quick);
    ReportRun run = new ReportRun(metadata, dir.resolve(PARTS));
    if (quick) {
      spec.commandLine().getErr().println(Parts.leftOut());
    }
    Results results;
    try (Progress progress = Progress.withoutTime("report", parts.size())) {
      Remaining remaining = new Remaining(parts, progress, spec.commandLine().getErr());
      results = run.run(parts, remaining::tell);
    }
    write(results, dir);
    run.forget();
  }

  private List<Part> chosen() {
    List<Part> parts = new ArrayList<>(ofScenes());
    for (int fork = 0; fork < Parts.FORKS; fork++) {
      parts.add(SeriesParts.sweep(fork, quick));
    }
    for (int fork = 0; fork < Parts.FORKS; fork++) {
      parts.add(SeriesParts.scale(fork, quick));
    }
    for (int fork = 0; fork < Parts.FORKS; fork++) {
      parts.add(SeriesParts.features(fork, quick));
    }
    parts.add(SeriesParts.worlds(quick));
    parts.addAll(StabilityPart.all(false));
    return untimed ? PartChoice.untimed(parts) : parts;
  }

  private List<Part> ofScenes() {
    try {
      return scenes == null ? Parts.of(quick) : Parts.of(quick, scenes);
    } catch (IllegalArgumentException e) {
      throw refused(e.getMessage());
    }
  }

  private ParameterException refused(String message) {
    return new ParameterException(spec.commandLine(), message);
  }

  private void write(Results results, Path dir) throws IOException {
    Report.write(results, dir);
    PrintWriter printer = spec.commandLine().getOut();
    printer.println(Report.summary(results));
    printer.println("report: " + dir.resolve(Report.PAGE));
    printer.flush();
  }
}
