// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Dot;
import dev.carom.bench.charts.DotChart;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Single questions: how long an answer takes, how often it is wrong, and how wrong its time is. */
final class QueryFigures {

  private final Results results;

  QueryFigures(Results results) {
    this.results = results;
  }

  /** Time and error of each class of questions and each method. */
  ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "class", "setting", "time of a question", "error in ulps: worst", "median");
    for (String scene : results.scenes(Metrics.TIME_ERROR)) {
      for (Setting setting : Settings.of(results, scene, Metrics.TIME_ERROR)) {
        table.row(
            Metrics.queryClass(scene),
            Metrics.fullName(setting),
            time(scene, setting).map(ReportNumbers::spread).orElse("not measured"),
            ReportNumbers.error(results.value(scene, setting, Metrics.TIME_ERROR, "max")),
            ReportNumbers.error(results.value(scene, setting, Metrics.TIME_ERROR, "median")));
      }
    }
    return table.build();
  }

  /** What the table says about Carom. */
  String sentence() {
    List<String> classes = results.scenes(Metrics.TIME_ERROR);
    long finest = classes.stream().filter(this::isFinest).count();
    double worst =
        classes.stream()
            .mapToDouble(scene -> results.value(scene, Metrics.CAROM, Metrics.TIME_ERROR, "max"))
            .max()
            .orElse(Double.NaN);
    return "The time of impact: Carom is the most accurate in %d of %d classes, with at worst %s ulps"
        .formatted(finest, classes.size(), ReportNumbers.error(worst));
  }

  private boolean isFinest(String scene) {
    double ours = results.value(scene, Metrics.CAROM, Metrics.TIME_ERROR, "max");
    return Settings.of(results, scene, Metrics.TIME_ERROR).stream()
        .filter(setting -> !setting.equals(Metrics.CAROM))
        .noneMatch(s -> results.value(scene, s, Metrics.TIME_ERROR, "max") <= ours);
  }

  /** The classes of questions that were asked and timed. */
  private List<String> classes() {
    List<String> timed = results.scenes(Metrics.QUERY_TIME);
    return results.scenes(Metrics.DECISIONS).stream().filter(timed::contains).toList();
  }

  private List<Dot> dots(List<String> classes) {
    return classes.isEmpty()
        ? List.of()
        : Settings.of(results, classes.get(0), Metrics.DECISIONS).stream()
            .filter(Settings::isDrawn)
            .map(setting -> decisions(classes, setting))
            .filter(dot -> !Double.isNaN(dot.error()))
            .toList();
  }

  /** How many times as long as plain doubles Carom takes for a question: a sentence, or nothing. */
  String price() {
    List<Dot> dots = dots(classes());
    double ours = time(dots, Metrics.OURS);
    double plain = time(dots, "plain");
    return Double.isNaN(ours / plain)
        ? ""
        : " A question takes Carom %s times as long as plain doubles."
            .formatted(ReportNumbers.count(ours / plain));
  }

  private static double time(List<Dot> dots, String method) {
    return dots.stream()
        .filter(dot -> dot.method().equals(method))
        .mapToDouble(Dot::time)
        .findFirst()
        .orElse(Double.NaN);
  }

  /** Wrong decisions against the time of a question, over all classes: a panel, or none. */
  Optional<Panel> decisions() {
    List<String> classes = classes();
    List<Dot> dots = dots(classes);
    if (dots.isEmpty()) {
      return Optional.empty();
    }
    String asked = ReportNumbers.count(sum(classes, Metrics.CAROM, Metrics.DECISIONS));
    String title =
        dots.stream()
            .filter(d -> d.method().equals(Metrics.OURS))
            .findFirst()
            .map(ours -> wrong(ours, dots))
            .orElse("One question: hit or miss?");
    DotChart chart =
        new DotChart(
            "Time of a question against the number of wrong answers.",
            Settings.marks(results),
            List.of("wrong answers of " + asked, "median time of a question"),
            Double.NaN,
            Map.of(title, dots));
    return Optional.of(chart.panels(DotChart.TALL).get(0));
  }

  private static String wrong(Dot ours, List<Dot> all) {
    boolean slowest = all.size() > 1 && all.stream().allMatch(d -> d.time() <= ours.time());
    return "One question: Carom is "
        + (ours.exact() ? "never wrong" : "wrong in " + ReportNumbers.count(ours.error()))
        + (slowest ? ", but slowest" : "");
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
        times.stream().mapToDouble(Spread::high).average().orElse(Double.NaN));
  }

  private double sum(List<String> classes, Setting setting, String metric) {
    return classes.stream()
        .mapToDouble(c -> results.only(c, setting, metric).map(Spread::middle).orElse(Double.NaN))
        .sum();
  }

  private Optional<Spread> time(String scene, Setting setting) {
    return results
        .spread(scene, setting, Metrics.QUERY_TIME, "median")
        .or(() -> results.only(scene, setting, Metrics.QUERY_TIME));
  }
}
