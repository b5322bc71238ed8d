// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Spread;
import dev.carom.bench.results.WholeFile;
import dev.carom.bench.series.ScalePlan.Model;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The figures that a page quotes. Each stands between two marks, {@code <!--ratio:poster-->} and
 * {@code <!--/ratio:poster-->}, which no reader sees, and is written there from stored results.
 *
 * <p>Times, ratios and errors are those of the experiment's scene. Of an engine that was measured
 * at several settings the best one counts, not its defaults.
 */
public final class ReadmeFigures {

  private static final Pattern MARK = Pattern.compile("<!--/?[a-z][a-z0-9:-]*-->");

  private static final Pattern MARKED =
      Pattern.compile("(<!--([a-z][a-z0-9:-]*)-->)[^<]*(?:<(?!!--)[^<]*)*(<!--/\\2-->)");

  private static final String SCENE = "base-1";
  private static final String FAST = "fast-1";
  private static final String HEAP = "heap";
  private static final String KNOWN =
      "time, ratio, spread, impacts, alone, colliding, error, overlap or tunnelled with a colon and the name"
          + " of a method, or published, wrong, machine, commit, date, verdict";

  private static final int COMMIT_LENGTH = 10;
  private static final double BUDGET = 1e6 * Budget.MILLIS;

  private final Results results;

  private ReadmeFigures(Results results) {
    this.results = results;
  }

  /**
   * Writes the figures of results into a page.
   *
   * @param page a file that has marks
   * @param results what was measured
   * @throws IOException if the file cannot be read or written; the message names it
   * @throws IllegalArgumentException if a mark is unknown or stands alone, or a figure was not
   *     measured; the page stays as it was, and the message names it
   */
  public static void write(Path page, Results results) throws IOException {
    String filled;
    try {
      filled = fill(Files.readString(page), results);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(page + ": " + e.getMessage(), e);
    }
    WholeFile.write(page, filled);
  }

  /** Replaces what stands between marks, and returns the page with the figures of these results. */
  static String fill(String page, Results results) {
    Matcher alone = MARK.matcher(MARKED.matcher(page).replaceAll(""));
    if (alone.find()) {
      throw new IllegalArgumentException(
          "the mark %s stands alone: expected one before and one after a figure"
              .formatted(alone.group()));
    }
    ReadmeFigures figures = new ReadmeFigures(results);
    return MARKED
        .matcher(page)
        .replaceAll(
            mark ->
                Matcher.quoteReplacement(
                    mark.group(1) + figures.figure(mark.group(2)) + mark.group(3)));
  }

  private String figure(String name) {
    int colon = name.indexOf(':');
    String method = name.substring(colon + 1);
    return switch (colon < 0 ? name : name.substring(0, colon)) {
      case "time" -> ReportNumbers.time(time(method).middle());
      case "ratio" -> ReportNumbers.count(time(method).middle() / time(Metrics.OURS).middle());
      case "spread" ->
          ReportNumbers.count(time(method).low() / time(Metrics.OURS).high())
              + " to "
              + ReportNumbers.count(time(method).high() / time(Metrics.OURS).low());
      case "impacts" -> ReportNumbers.ratio(impacts(method));
      case "alone" -> circles(Model.ALONE, method);
      case "colliding" -> circles(Model.GAS, method);
      case "error" -> ReportNumbers.error(value(SCENE, method, Metrics.FRAME_ERROR, "max"));
      case "overlap" -> ReportNumbers.error(overlap(method));
      case "tunnelled" -> ReportNumbers.count(value(FAST, method, "tunnelled", "circles"));
      case "published" -> published();
      case "wrong" -> wrong();
      case "machine" -> machine();
      case "commit" -> shortened(results.metadata().commit());
      case "date" -> results.metadata().date();
      case "verdict" ->
          Verdict.of(results).stream().collect(Collectors.joining("\n", "\n```\n", "\n```\n"));
      default ->
          throw new IllegalArgumentException("no figure \"" + name + "\": expected " + KNOWN);
    };
  }

  private Spread time(String method) {
    return best(SCENE, method, Metrics.FRAME_TIME)
        .spread(Metrics.FRAME_TIME, "median")
        .orElseThrow();
  }

  /** Impacts per frame with lines, pegs and walls. */
  private double impacts(String method) {
    return value(SCENE, method, "impacts", "mean") + value(SCENE, method, "wall_impacts", "mean");
  }

  /** How many circles a method moves in the time that a frame may take. */
  private String circles(Model model, String method) {
    return ScaleTimes.within(results, model, method, BUDGET)
        .orElseThrow(() -> notMeasured("circles at 60 FPS", method, model.label()));
  }

  /** In the heap, at the setting with which circles overlap least. */
  private double overlap(String method) {
    return settings(HEAP, method, Metrics.HEAP_OVERLAP).stream()
        .mapToDouble(s -> s.value(Metrics.HEAP_OVERLAP, "max"))
        .min()
        .orElseThrow(() -> notMeasured(Metrics.HEAP_OVERLAP, method, HEAP));
  }

  private double value(String scene, String method, String metric, String stat) {
    return best(scene, method, metric).value(metric, stat);
  }

  private Standing best(String scene, String method, String metric) {
    List<Standing> all = settings(scene, method, metric);
    return all.stream()
        .filter(s -> all.size() == 1 || !Glossary.isDefault(s.setting()))
        .findFirst()
        .orElseThrow(() -> notMeasured(metric, method, scene));
  }

  private List<Standing> settings(String scene, String method, String metric) {
    return Standing.of(results, scene, metric).stream()
        .filter(s -> s.method().equals(method))
        .toList();
  }

  private static IllegalArgumentException notMeasured(String what, String method, String scene) {
    return new IllegalArgumentException(
        "%s of \"%s\" in %s: not measured".formatted(what, method, scene));
  }

  /** How many times as long as the same algorithm now the published run took for a frame. */
  private String published() {
    double now = value(SCENE, FirstScreen.PUBLISHED, Metrics.FRAME_TIME, "mean");
    return ReportNumbers.rounded(1e9 / Budget.PUBLISHED_FPS / now, 2);
  }

  private String wrong() {
    Answers ours = Answers.ours(results);
    return ReportNumbers.count(ours.wrong()) + " of " + ReportNumbers.count(ours.total());
  }

  private String machine() {
    Metadata from = results.metadata();
    String cores = from.cores() == 1 ? "1 core" : from.cores() + " cores";
    return from.cpu() + ", " + cores + "; " + from.jdk();
  }

  private static String shortened(String commit) {
    return commit.substring(0, Math.min(COMMIT_LENGTH, commit.length()));
  }
}
