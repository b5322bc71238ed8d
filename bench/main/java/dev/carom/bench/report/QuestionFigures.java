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
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;

/** Single questions: how long an answer takes, and how often it is wrong. */
final class QuestionFigures {

  private static final Setting PLAIN = new Setting("plain", "");
  private static final List<Setting> TESTS =
      List.of(PLAIN, new Setting("textbook-double", ""), new Setting("textbook-float", ""));

  private final Results results;

  QuestionFigures(Results results) {
    this.results = results;
  }

  /** Carom in each class of questions that was asked and timed. */
  private List<Standing> classes() {
    List<String> timed = results.scenes(Metrics.QUERY_TIME);
    return results.scenes(Metrics.DECISIONS).stream()
        .filter(timed::contains)
        .map(scene -> new Standing(results, scene, Metrics.CAROM))
        .toList();
  }

  private static Optional<Spread> spread(Standing s) {
    return s.results().only(s.scene(), s.setting(), Metrics.QUERY_TIME);
  }

  private static double time(Standing s) {
    return s.only(Metrics.QUERY_TIME);
  }

  private static double wrong(Standing s) {
    return s.only(Metrics.MISSED) + s.only(Metrics.INVENTED);
  }

  /** How many times as long as a plain test Carom takes in each class. */
  private static double factor(Standing ours, Setting test) {
    return time(ours) / time(ours.with(test));
  }

  /** The factors, in one line. */
  String title() {
    return "An exact answer to a single question costs %s times a plain test, by class of questions"
        .formatted(
            ReportNumbers.range(
                classes().stream().mapToDouble(ours -> factor(ours, PLAIN)), ReportNumbers::times));
  }

  /** Where plain doubles do as well. */
  String asGood() {
    List<String> good =
        classes().stream()
            .filter(ours -> wrong(ours.with(PLAIN)) == 0)
            .map(ours -> Metrics.queryClass(ours.scene()))
            .toList();
    return good.isEmpty()
        ? "In every class plain doubles give some wrong answers."
        : "In %d of %d classes plain doubles made no wrong decision either: %s. There exactness buys nothing but the proof."
            .formatted(good.size(), classes().size(), String.join(", ", good));
  }

  /** A table of classes, if plain doubles were asked, too. */
  List<Figure> figures() {
    List<Standing> classes = classes();
    if (classes.stream().allMatch(ours -> Double.isNaN(factor(ours, PLAIN)))) {
      return List.of();
    }
    String note =
        "A question is one circle against one line: whether, and when. Plain doubles are Carom's own formulas without their proof. %s %s."
            .formatted(asGood(), accuracy());
    List<Column> columns = new ArrayList<>();
    columns.add(new Column("class of questions", s -> Metrics.queryClass(s.scene())));
    columns.add(time("Carom", Metrics.CAROM));
    columns.add(wrong(Metrics.CAROM));
    for (Setting test : TESTS) {
      columns.add(time(Glossary.name(test.method()), test));
      columns.add(
          new Column("Carom takes", s -> ReportNumbers.times(factor(s, test)) + Figure.TIMES));
      columns.add(wrong(test));
    }
    return List.of(
        new Figure(
            "questions",
            "Time of a question, and wrong answers",
            title(),
            note,
            List.of(),
            Column.table(classes, columns.toArray(Column[]::new))));
  }

  private static Column time(String head, Setting test) {
    return new Column(head, s -> ReportNumbers.time(time(s.with(test))));
  }

  private static Column wrong(Setting test) {
    return new Column("wrong", s -> ReportNumbers.count(wrong(s.with(test))));
  }

  /** The errors of the times of impact. */
  String accuracy() {
    List<String> classes = results.scenes(Metrics.TIME_ERROR);
    long finest = classes.stream().filter(this::isFinest).count();
    double worst =
        classes.stream().mapToDouble(scene -> ulps(scene, Metrics.CAROM)).max().orElse(0);
    return "The time of impact: Carom is the most accurate in %d of %d classes, with at worst %s ulps"
        .formatted(finest, classes.size(), ReportNumbers.error(worst));
  }

  private boolean isFinest(String scene) {
    return results.settings(scene, Metrics.TIME_ERROR).stream()
        .filter(setting -> !setting.equals(Metrics.CAROM))
        .noneMatch(setting -> ulps(scene, setting) <= ulps(scene, Metrics.CAROM));
  }

  private double ulps(String scene, Setting setting) {
    return results.value(scene, setting, Metrics.TIME_ERROR, "max");
  }

  /** How many times as long as plain doubles Carom takes for a question: a sentence, or nothing. */
  String price() {
    double ours = mean(Metrics.CAROM, Spread::middle);
    double plain = mean(PLAIN, Spread::middle);
    return Double.isNaN(ours / plain)
        ? ""
        : " A question takes Carom %s times as long as plain doubles."
            .formatted(ReportNumbers.count(ours / plain));
  }

  /** The mean over all classes; NaN if it was not timed in one of them. */
  private double mean(Setting setting, ToDoubleFunction<Spread> number) {
    DoubleStream numbers =
        classes().stream()
            .mapToDouble(
                ours -> spread(ours.with(setting)).map(number::applyAsDouble).orElse(Double.NaN));
    return numbers.average().orElse(Double.NaN);
  }

  /** Wrong decisions against the time of a question, over all classes: a panel, or none. */
  Optional<Panel> decisions() {
    Answers ours = Answers.ours(results);
    List<Dot> dots =
        Answers.all(results).stream()
            .filter(answers -> Settings.isDrawn(answers.setting()))
            .filter(answers -> answers.total() == ours.total())
            .map(this::dot)
            .filter(dot -> !Double.isNaN(dot.time()))
            .toList();
    if (!ours.asked() || dots.isEmpty()) {
      return Optional.empty();
    }
    boolean slowest =
        dots.stream().allMatch(dot -> dot.time() <= mean(Metrics.CAROM, Spread::middle));
    String title =
        "One question: Carom is "
            + (ours.wrong() == 0 ? "never wrong" : "wrong in " + ReportNumbers.count(ours.wrong()))
            + (slowest && dots.size() > 1 ? ", but slowest" : "");
    DotChart chart =
        new DotChart(
            "Time of a question against the number of wrong answers.",
            Settings.marks(results),
            List.of(
                "wrong answers of " + ReportNumbers.count(ours.total()),
                "median time of a question"),
            Double.NaN,
            Map.of(title, dots));
    return Optional.of(chart.panels(DotChart.TALL).get(0));
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
}
