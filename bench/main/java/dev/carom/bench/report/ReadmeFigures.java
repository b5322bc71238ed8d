// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import dev.carom.bench.results.WholeFile;
import dev.carom.bench.series.ScalePlan.Model;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

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
  private static final String POSTER = "poster";
  private static final String KNOWN =
      "time, ratio, spread, impacts, alone, colliding, error, overlap or tunnelled with a colon and the name"
          + " of a method, or published, wrong, worst:error, worst:frame, budget, machine, commit, date, verdict";

  private static final int COMMIT_LENGTH = 10;
  private static final double BUDGET = 1e6 * Budget.MILLIS;
  private static final double PUBLISHED = 1e9 / Budget.PUBLISHED_FPS;

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
    ReadmeFigures figures = new ReadmeFigures(results);
    StringBuilder filled = new StringBuilder();
    Matcher marked = MARKED.matcher(page);
    int end = 0;
    while (marked.find()) {
      filled.append(text(page, end, marked.start()));
      filled.append(marked.group(1)).append(figures.figure(marked.group(2)));
      filled.append(marked.group(3));
      end = marked.end();
    }
    return filled.append(text(page, end, page.length())).toString();
  }

  /** A part of the page that has no mark. */
  private static String text(String page, int from, int to) {
    String text = page.substring(from, to);
    Matcher alone = MARK.matcher(text);
    if (alone.find()) {
      throw new IllegalArgumentException(
          "the mark "
              + alone.group()
              + " stands alone: expected one before and one after a figure");
    }
    return text;
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
      case "worst" -> method.equals("error") ? worstError() : ReportNumbers.time(worstFrame());
      case "published" -> published();
      case "wrong" ->
          ReportNumbers.count(wrong()) + " of " + ReportNumbers.count(sum(Metrics.DECISIONS));
      case "budget" -> "1/" + ReportNumbers.count(BUDGET / worstFrame());
      case "machine" -> machine();
      case "commit" -> shortened(results.metadata().commit());
      case "date" -> results.metadata().date();
      case "verdict" -> verdict();
      default ->
          throw new IllegalArgumentException("no figure \"" + name + "\": expected " + KNOWN);
    };
  }

  private Spread time(String method) {
    return results
        .spread(SCENE, best(SCENE, method, Metrics.FRAME_TIME), Metrics.FRAME_TIME, "median")
        .orElseThrow();
  }

  /** Impacts per frame with lines, pegs and walls. */
  private double impacts(String method) {
    return value(SCENE, method, "impacts", "mean") + value(SCENE, method, "wall_impacts", "mean");
  }

  /** How many circles a method moves in the time that a frame may take. */
  private String circles(Model model, String method) {
    return new ScaleTimes(results)
        .within(model, method, BUDGET)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "circles of \"%s\" at 60 FPS: not measured".formatted(method)));
  }

  /** In the heap, at the setting with which circles overlap least. */
  private double overlap(String method) {
    return results.settings(HEAP, Metrics.HEAP_OVERLAP).stream()
        .filter(setting -> setting.method().equals(method))
        .mapToDouble(setting -> results.value(HEAP, setting, Metrics.HEAP_OVERLAP, "max"))
        .min()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "overlap of \"%s\" in the heap: not measured".formatted(method)));
  }

  private double value(String scene, String method, String metric, String stat) {
    return results.value(scene, best(scene, method, metric), metric, stat);
  }

  private Setting best(String scene, String method, String metric) {
    List<Setting> all =
        results.settings(scene, metric).stream().filter(s -> s.method().equals(method)).toList();
    return all.stream()
        .filter(setting -> all.size() == 1 || !Metrics.isDefault(setting))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "%s of \"%s\" in %s: not measured".formatted(metric, method, scene)));
  }

  /** How many times as long as the same algorithm now the published run took for a frame. */
  private String published() {
    double now = value(SCENE, POSTER, Metrics.FRAME_TIME, "mean");
    return new BigDecimal(PUBLISHED / now).round(new MathContext(2)).toPlainString();
  }

  private double wrong() {
    return sum(Metrics.MISSED) + sum(Metrics.INVENTED);
  }

  /** The sum of a metric of Carom over all classes of questions. */
  private double sum(String metric) {
    return results.scenes(metric).stream()
        .flatMap(scene -> results.only(scene, Metrics.CAROM, metric).stream())
        .mapToDouble(Spread::middle)
        .sum();
  }

  private String worstError() {
    return ReportNumbers.error(
        results.scenes(Metrics.FRAME_ERROR).stream()
            .mapToDouble(s -> results.value(s, Metrics.CAROM, Metrics.FRAME_ERROR, "max"))
            .max()
            .orElse(Double.NaN));
  }

  private double worstFrame() {
    return results.scenes(Metrics.FRAME_TIME).stream()
        .mapToDouble(s -> results.value(s, Metrics.CAROM, Metrics.FRAME_TIME, "worst"))
        .max()
        .orElse(Double.NaN);
  }

  private String machine() {
    Metadata from = results.metadata();
    return String.format(
        Locale.ROOT,
        "%s, %s; %s",
        from.cpu(),
        from.cores() == 1 ? "1 core" : from.cores() + " cores",
        from.jdk());
  }

  private static String shortened(String commit) {
    return commit.substring(0, Math.min(COMMIT_LENGTH, commit.length()));
  }

  /** In a block of its own. */
  private String verdict() {
    StringBuilder text = new StringBuilder("\n```\n");
    Verdict.of(results).forEach(sentence -> text.append(sentence).append('\n'));
    return text.append("```\n").toString();
  }
}
