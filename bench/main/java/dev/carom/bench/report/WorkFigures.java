// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Dot;
import dev.carom.bench.charts.Marks;
import dev.carom.bench.charts.WorkPrecisionChart;
import dev.carom.bench.charts.WorkPrecisionChart.Work;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/** Charts of work against precision, two a scene: time, and pair tests. */
final class WorkFigures {

  private static final String ERROR = "worst error of one frame, in radii";

  private final Results results;
  private final Marks marks;

  WorkFigures(Results results) {
    this.results = results;
    marks = Settings.marks(results);
  }

  List<Figure> figures() {
    List<Figure> figures = new ArrayList<>();
    for (String scene : results.scenes(Metrics.FRAME_ERROR)) {
      List<Standing> all = standings(scene);
      if (all.stream().anyMatch(s -> !s.time().failed())) {
        figures.add(time(scene, all));
      }
      if (results.scenes(Metrics.PAIR_TESTS).contains(scene)) {
        figures.add(tests(scene, all));
      }
    }
    return figures;
  }

  private List<Standing> standings(String scene) {
    List<Standing> all = Standing.all(results, scene);
    List<Setting> order = Settings.sorted(all.stream().map(Standing::setting).toList());
    return order.stream()
        .map(
            setting ->
                all.stream().filter(s -> s.setting().equals(setting)).findFirst().orElseThrow())
        .toList();
  }

  private Figure time(String scene, List<Standing> all) {
    List<Dot> dots =
        all.stream().map(s -> dot(s, s.time().low(), s.time().middle(), s.time().high())).toList();
    int forks = all.stream().mapToInt(s -> s.time().forks()).max().orElse(1);
    String subtitle =
        "Scene %s. Left and below is better. Whiskers: 5 to 95 %% over %d forks. Hollow: a peer at its defaults. Dotted: what nothing beats in both."
            .formatted(scene, forks);
    WorkPrecisionChart chart =
        new WorkPrecisionChart(
            title(scene, all),
            subtitle,
            marks,
            List.of(ERROR, "time of a frame"),
            Work.TIME,
            1e6 * Budget.MILLIS,
            Map.of("", dots));
    String caption =
        "Time of a frame against the worst error of one frame. " + caption(all) + peers(all);
    return new Figure(
        "work-" + scene,
        "Speed against accuracy: " + scene,
        caption,
        chart::picture,
        table(scene, all));
  }

  private static Dot dot(Standing s, double low, double work, double high) {
    return new Dot(
        s.setting().method(),
        Metrics.shortKnob(s.setting()),
        s.error(),
        low,
        work,
        high,
        Metrics.isDefault(s.setting()));
  }

  private static String title(String scene, List<Standing> all) {
    Optional<Standing> ours = Standing.ours(all);
    if (ours.isEmpty()) {
      return "Speed and accuracy in " + scene;
    }
    List<Standing> beat = all.stream().filter(s -> s.beats(ours.get())).toList();
    return beat.isEmpty()
        ? "Nothing measured is both faster and more accurate than carom"
        : "Both faster and more accurate than carom: " + names(beat);
  }

  private static String caption(List<Standing> all) {
    StringBuilder text = new StringBuilder();
    Standing.ours(all)
        .ifPresent(
            ours -> {
              text.append(
                  "Carom: %s, %s radii. "
                      .formatted(
                          ReportNumbers.time(ours.time().middle()),
                          ReportNumbers.error(ours.error())));
              tell(text, "Faster than carom", all, s -> s.isFasterThan(ours));
              tell(text, "More accurate than carom", all, s -> s.isMoreAccurateThan(ours));
              tell(
                  text,
                  "Not told apart from it in time",
                  all,
                  s -> !s.equals(ours) && s.isLevelWith(ours));
            });
    tell(text, "Failed", all, Standing::failed);
    return text.toString().strip();
  }

  private static void tell(
      StringBuilder text, String what, List<Standing> all, Predicate<Standing> who) {
    List<Standing> found = all.stream().filter(who).toList();
    text.append(what).append(": ").append(found.isEmpty() ? "none" : names(found)).append(". ");
  }

  private static String names(List<Standing> found) {
    return found.stream().map(WorkFigures::numbers).collect(Collectors.joining(", "));
  }

  private static String numbers(Standing s) {
    String time = ReportNumbers.time(s.time().middle());
    String error = Double.isNaN(s.error()) ? "" : ", " + ReportNumbers.error(s.error()) + " radii";
    return "%s (%s%s)".formatted(name(s), time, error);
  }

  private static String name(Standing s) {
    return Metrics.shortName(s.setting());
  }

  /** What stands for a peer at its best: the whole setting. */
  private static String peers(List<Standing> all) {
    String peers =
        all.stream()
            .map(Standing::setting)
            .filter(setting -> Metrics.shortKnob(setting).equals("best"))
            .map(setting -> setting.method() + ": " + setting.value())
            .collect(Collectors.joining("; "));
    return peers.isEmpty() ? "" : " Peers at their best: " + peers + ".";
  }

  private ReportTable table(String scene, List<Standing> all) {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "setting",
            "time of a frame",
            "worst frame",
            "error: worst",
            "99.9 %",
            "median",
            "pair tests",
            "roots",
            "fallbacks",
            "impacts",
            "tunnelled",
            "escaped",
            "outside at the end",
            "penetration",
            "energy",
            "reversal");
    for (Standing s : all) {
      table.row(
          s.setting().toString(),
          ReportNumbers.spread(s.time()),
          ReportNumbers.time(results.value(scene, s.setting(), Metrics.FRAME_TIME, "worst")),
          ReportNumbers.error(s.error()),
          stat(scene, s, Metrics.FRAME_ERROR, "p99.9"),
          stat(scene, s, Metrics.FRAME_ERROR, "median"),
          only(scene, s, Metrics.PAIR_TESTS),
          only(scene, s, "roots"),
          only(scene, s, "fallbacks"),
          only(scene, s, "impacts"),
          only(scene, s, "tunnelled"),
          only(scene, s, "escaped"),
          only(scene, s, "outside_at_end"),
          stat(scene, s, "penetration", "max"),
          stat(scene, s, "energy_drift", "max"),
          stat(scene, s, "reversal_error", "max"));
    }
    return table.build();
  }

  private String stat(String scene, Standing s, String metric, String stat) {
    return results
        .spread(scene, s.setting(), metric, stat)
        .map(spread -> ReportNumbers.error(spread.middle()))
        .orElse("");
  }

  private String only(String scene, Standing s, String metric) {
    return results
        .only(scene, s.setting(), metric)
        .map(spread -> spread.failed() ? "not told" : ReportNumbers.ratio(spread.middle()))
        .orElse("");
  }

  /** What has no count of pair tests, as a peer that does not tell, is not drawn but named. */
  private Figure tests(String scene, List<Standing> all) {
    List<Dot> dots = new ArrayList<>();
    List<String> silent = new ArrayList<>();
    for (Standing s : all) {
      double tests =
          results
              .only(scene, s.setting(), Metrics.PAIR_TESTS)
              .map(Spread::middle)
              .orElse(Double.NaN);
      if (Double.isNaN(tests)) {
        silent.add(name(s));
      } else {
        dots.add(dot(s, tests, tests, tests));
      }
    }
    String quiet = silent.isEmpty() ? "" : " No count from: " + String.join(", ", silent) + ".";
    WorkPrecisionChart chart =
        new WorkPrecisionChart(
            "Accuracy, and work that does not depend on the machine",
            "Scene " + scene + ". How often a circle and an obstacle are looked at in a frame.",
            marks,
            List.of(ERROR, "pair tests in a frame"),
            Work.COUNT,
            Double.NaN,
            Map.of("", dots));
    ReportTable.Builder table =
        new ReportTable.Builder("setting", "error: worst", "pair tests in a frame");
    for (Dot dot : dots) {
      table.row(
          (dot.method() + " " + dot.knob()).strip(),
          ReportNumbers.error(dot.error()),
          ReportNumbers.ratio(dot.work()));
    }
    String caption =
        "Pair tests in a frame against the worst error of one frame. "
            + dots.stream()
                .filter(d -> d.method().equals(Metrics.OURS))
                .map(d -> "Carom: " + ReportNumbers.ratio(d.work()) + " pair tests. ")
                .collect(Collectors.joining())
            + fewest(dots)
            + quiet;
    return new Figure(
        "tests-" + scene,
        "Work against accuracy: " + scene,
        caption,
        chart::picture,
        table.build());
  }

  private static String fewest(List<Dot> dots) {
    return dots.stream()
        .min(Comparator.comparingDouble(Dot::work))
        .map(
            d ->
                "Fewest: %s, with %s."
                    .formatted(
                        (d.method() + " " + d.knob()).strip(), ReportNumbers.ratio(d.work())))
        .orElse("");
  }
}
