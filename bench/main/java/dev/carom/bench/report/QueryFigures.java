// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Dot;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.charts.WorkPrecisionChart;
import dev.carom.bench.charts.WorkPrecisionChart.Work;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Single questions: how long an answer takes, and how wrong its time is. */
final class QueryFigures {

  /** In ulps: ten times the time itself. Beyond it there is nothing to compare. */
  private static final double FAILED = 10 * 0x1p53;

  private final Results results;

  QueryFigures(Results results) {
    this.results = results;
  }

  List<Figure> figures() {
    List<Figure> figures = new ArrayList<>();
    if (!results.scenes(Metrics.QUERY_TIME).isEmpty()) {
      figures.add(queries());
    }
    return figures;
  }

  private Figure queries() {
    Map<String, List<Dot>> panels = new LinkedHashMap<>();
    ReportTable.Builder table =
        new ReportTable.Builder(
            "class", "setting", "time of a query", "error in ulps: worst", "median");
    List<String> beaten = new ArrayList<>();
    for (String scene : results.scenes(Metrics.TIME_ERROR)) {
      List<Dot> dots = new ArrayList<>();
      for (Setting setting : Settings.of(results, scene, Metrics.TIME_ERROR)) {
        Dot dot = dot(scene, setting);
        dots.add(dot);
        table.row(
            Metrics.queryClass(scene),
            Metrics.fullName(setting),
            time(scene, setting).map(ReportNumbers::spread).orElse("not measured"),
            ReportNumbers.error(results.value(scene, setting, Metrics.TIME_ERROR, "max")),
            ReportNumbers.error(results.value(scene, setting, Metrics.TIME_ERROR, "median")));
      }
      panels.put(Metrics.queryClass(scene), dots);
      beaten.addAll(better(scene, dots));
    }
    String title =
        beaten.isEmpty()
            ? "No question is answered both faster and more accurately than by Carom"
            : "Some questions are answered both faster and more accurately than by Carom";
    String caption =
        "Time of a query against the worst error of the time of impact, for each class of queries."
            + (beaten.isEmpty()
                ? " Nothing measured is both faster and more accurate than Carom."
                : " Both faster and more accurate than Carom: " + String.join(", ", beaten) + ".")
            + tallies(panels)
            + " A time that is wrong by over ten times itself counts as failed.";
    WorkPrecisionChart chart =
        new WorkPrecisionChart(
            "Time of a query against the worst error of the time of impact.",
            Settings.marks(results),
            List.of("worst error of the time of impact, in ulps", "time of a query"),
            Work.TIME,
            Double.NaN,
            panels);
    return new Figure(
        "queries",
        "Single questions",
        title,
        "Time of a question against the error of the time of impact, a panel for each class.",
        caption,
        chart.panels(WorkPrecisionChart.SMALL),
        table.build());
  }

  /** Wrong decisions against the time of a question, over all classes: a panel, or none. */
  Optional<Panel> decisions() {
    List<String> timed = results.scenes(Metrics.QUERY_TIME);
    List<String> classes =
        results.scenes(Metrics.DECISIONS).stream().filter(timed::contains).toList();
    List<Dot> dots =
        classes.isEmpty()
            ? List.of()
            : Settings.of(results, classes.get(0), Metrics.DECISIONS).stream()
                .map(setting -> decisions(classes, setting))
                .filter(dot -> !Double.isNaN(dot.error()))
                .toList();
    if (dots.isEmpty()) {
      return Optional.empty();
    }
    String asked = ReportNumbers.count(sum(classes, Metrics.CAROM, Metrics.DECISIONS));
    String title =
        "A question, hit or miss: " + ours(dots).map(QueryFigures::wrong).orElse("not asked");
    WorkPrecisionChart chart =
        new WorkPrecisionChart(
            "Time of a question against the number of wrong answers.",
            Settings.marks(results),
            List.of("wrong answers of " + asked, "time of a question"),
            Work.TIME,
            Double.NaN,
            Map.of(title, dots));
    return Optional.of(chart.panels(WorkPrecisionChart.TALL).get(0));
  }

  private static String wrong(Dot dot) {
    return dot.exact()
        ? "only Carom is never wrong"
        : "Carom is wrong in " + ReportNumbers.count(dot.error());
  }

  /** The time is the mean of the medians of all classes. */
  private Dot decisions(List<String> classes, Setting setting) {
    double wrong = sum(classes, setting, Metrics.MISSED) + sum(classes, setting, Metrics.INVENTED);
    List<Spread> times = classes.stream().flatMap(c -> time(c, setting).stream()).toList();
    boolean all = times.size() == classes.size();
    return new Dot(
        setting.method(),
        Metrics.shortKnob(setting),
        all ? wrong : Double.NaN,
        times.stream().mapToDouble(Spread::low).average().orElse(Double.NaN),
        times.stream().mapToDouble(Spread::middle).average().orElse(Double.NaN),
        times.stream().mapToDouble(Spread::high).average().orElse(Double.NaN),
        false);
  }

  private double sum(List<String> classes, Setting setting, String metric) {
    return classes.stream()
        .mapToDouble(c -> results.only(c, setting, metric).map(Spread::middle).orElse(Double.NaN))
        .sum();
  }

  private static String tallies(Map<String, List<Dot>> panels) {
    double worst = 0;
    int fastest = 0;
    int finest = 0;
    for (List<Dot> dots : panels.values()) {
      Optional<Dot> ours = ours(dots);
      if (ours.isPresent()) {
        Dot carom = ours.get();
        worst = Math.max(worst, carom.error());
        fastest += dots.stream().allMatch(d -> d.equals(carom) || carom.high() < d.low()) ? 1 : 0;
        finest +=
            dots.stream().allMatch(d -> d.equals(carom) || !(d.error() <= carom.error())) ? 1 : 0;
      }
    }
    int n = panels.size();
    return " Carom is the most accurate in %d of %d classes, with at worst %s ulps, and the fastest in %d of %d."
        .formatted(finest, n, ReportNumbers.error(worst), fastest, n);
  }

  private static Optional<Dot> ours(List<Dot> dots) {
    return dots.stream().filter(d -> d.method().equals(Metrics.OURS)).findFirst();
  }

  private Optional<Spread> time(String scene, Setting setting) {
    return results
        .spread(scene, setting, Metrics.QUERY_TIME, "median")
        .or(() -> results.only(scene, setting, Metrics.QUERY_TIME));
  }

  private Dot dot(String scene, Setting setting) {
    Spread time = time(scene, setting).orElse(Spread.of(0, Double.NaN));
    double error = results.value(scene, setting, Metrics.TIME_ERROR, "max");
    return new Dot(
        setting.method(),
        Metrics.shortKnob(setting),
        error > FAILED ? Double.POSITIVE_INFINITY : error,
        time.low(),
        time.middle(),
        time.high(),
        Metrics.isDefault(setting));
  }

  private static List<String> better(String scene, List<Dot> dots) {
    Optional<Dot> ours = ours(dots);
    return dots.stream()
        .filter(d -> ours.isPresent() && d.high() < ours.get().low())
        .filter(d -> d.error() < ours.get().error())
        .map(
            d ->
                (Glossary.name(d.method()) + " " + d.knob()).strip()
                    + " ("
                    + Metrics.queryClass(scene)
                    + ")")
        .toList();
  }
}
