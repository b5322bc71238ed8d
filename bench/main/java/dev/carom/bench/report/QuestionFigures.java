// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Dot;
import dev.carom.bench.charts.DotChart;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;

/** Single questions: how long an answer takes, and how often it is wrong. */
final class QuestionFigures {

  private static final Setting PLAIN = new Setting("plain", "");
  private static final List<Setting> TESTS =
      List.of(
          Metrics.CAROM,
          PLAIN,
          new Setting("textbook-double", ""),
          new Setting("textbook-float", ""));

  private final Results results;

  /** Carom in each class of questions that was asked and timed. */
  private final List<Standing> classes;

  QuestionFigures(Results results) {
    this.results = results;
    List<String> timed = results.scenes(Metrics.QUERY_TIME);
    classes =
        Standing.ours(results, Metrics.DECISIONS).stream()
            .filter(ours -> timed.contains(ours.scene()))
            .toList();
  }

  private static double wrong(Standing s) {
    return s.only(Metrics.MISSED) + s.only(Metrics.INVENTED);
  }

  /** How many times as long as a test Carom takes in a class. */
  private static double factor(Standing ours, Setting test) {
    return ours.only(Metrics.QUERY_TIME) / ours.with(test).only(Metrics.QUERY_TIME);
  }

  /** The factors, in one line. */
  private String title() {
    return "An exact answer to a single question costs %s times a plain test, by class of questions"
        .formatted(
            ReportNumbers.range(
                classes.stream().mapToDouble(ours -> factor(ours, PLAIN)), ReportNumbers::times));
  }

  /** Where plain doubles do as well. */
  String asGood() {
    List<String> good =
        classes.stream()
            .filter(ours -> wrong(ours.with(PLAIN)) == 0)
            .map(ours -> Metrics.queryClass(ours.scene()))
            .toList();
    return "In %d of %d classes plain doubles made no wrong decision either: %s. There exactness buys nothing but the proof."
        .formatted(good.size(), classes.size(), String.join(", ", good));
  }

  /** A table of classes, if plain doubles were asked, too. */
  List<Figure> figures() {
    if (classes.stream().allMatch(ours -> Double.isNaN(factor(ours, PLAIN)))) {
      return List.of();
    }
    List<Column> columns = new ArrayList<>();
    columns.add(new Column("class of questions", s -> Metrics.queryClass(s.scene())));
    for (Setting test : TESTS) {
      columns.add(column(Glossary.name(test.method()), test, QuestionFigures::time));
      if (!test.equals(Metrics.CAROM)) {
        columns.add(
            new Column("Carom takes", s -> ReportNumbers.times(factor(s, test)) + Figure.TIMES));
      }
      columns.add(column("wrong", test, s -> ReportNumbers.count(wrong(s))));
      columns.add(column("ulps", test, QuestionFigures::ulps));
    }
    ReportTable table = Column.table(classes, columns.toArray(Column[]::new));
    return List.of(Figure.of("questions", title(), List.of(), table, asGood()));
  }

  private static Column column(String head, Setting test, Function<Standing, String> cell) {
    return new Column(head, s -> cell.apply(s.with(test)));
  }

  private static String time(Standing s) {
    return ReportNumbers.time(s.only(Metrics.QUERY_TIME));
  }

  private static String ulps(Standing s) {
    return s.spread(Metrics.TIME_ERROR, "max")
        .map(ulps -> ReportNumbers.error(ulps.middle()))
        .orElse("-");
  }

  /** Wrong decisions against the time of a question, over all classes: a panel, or none. */
  List<Panel> decisions() {
    Answers ours = Answers.ours(results);
    List<Dot> dots =
        Answers.all(results).stream()
            .filter(answers -> Settings.isDrawn(answers.setting()))
            .filter(answers -> answers.total() == ours.total())
            .map(this::dot)
            .filter(dot -> !Double.isNaN(dot.time()))
            .toList();
    if (!ours.asked() || dots.isEmpty()) {
      return List.of();
    }
    double time = mean(Metrics.CAROM, Spread::middle);
    String title =
        "One question: Carom is "
            + (ours.wrong() == 0 ? "never wrong" : "wrong in " + ReportNumbers.count(ours.wrong()))
            + (dots.stream().allMatch(dot -> dot.time() <= time) ? ", but slowest" : "");
    DotChart chart =
        new DotChart(
            "Time of a question against the number of wrong answers.",
            Settings.marks(results),
            List.of(
                "wrong answers of " + ReportNumbers.count(ours.total()),
                "median time of a question"),
            Double.NaN,
            Map.of(title, dots));
    return chart.panels(DotChart.TALL);
  }

  private Dot dot(Answers answers) {
    Setting setting = answers.setting();
    return new Dot(
        setting.method(),
        Glossary.shortKnob(setting),
        answers.wrong(),
        mean(setting, Spread::low),
        mean(setting, Spread::middle),
        mean(setting, Spread::high));
  }

  /** The mean time over all classes; NaN if it was not timed in one of them. */
  private double mean(Setting setting, ToDoubleFunction<Spread> number) {
    return classes.stream()
        .map(ours -> results.only(ours.scene(), setting, Metrics.QUERY_TIME))
        .mapToDouble(time -> time.map(number::applyAsDouble).orElse(Double.NaN))
        .average()
        .orElse(Double.NaN);
  }
}
