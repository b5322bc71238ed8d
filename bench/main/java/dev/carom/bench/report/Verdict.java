// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.series.ScalePlan;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiPredicate;
import java.util.function.DoubleFunction;

/**
 * Six sentences by rule from the data, each with its number: decisions, accuracy, budget, the place
 * between speed and accuracy, growth, and the limits that are to be kept. What beats Carom anywhere
 * is named; where intervals overlap, nobody is.
 */
public final class Verdict {

  private static final double BUDGET = 1e6 * Budget.MILLIS;

  private final Results results;

  private Verdict(Results results) {
    this.results = results;
  }

  /**
   * Judges.
   *
   * @param results what was measured
   * @return six sentences
   */
  public static List<String> of(Results results) {
    Verdict verdict = new Verdict(results);
    return List.of(
        verdict.decisions(),
        verdict.accuracy(),
        verdict.budget(),
        verdict.place(),
        new ScaleFigures(results, 1e6 * ScalePlan.LIMIT_MILLIS).verdict(),
        AcceptanceLimits.sentence(results));
  }

  private String decisions() {
    Answers ours = Answers.ours(results);
    if (!ours.asked()) {
      return "Decisions: not measured.";
    }
    Map<Setting, Double> others = new LinkedHashMap<>();
    Answers.all(results).stream()
        .filter(answers -> answers.total() == ours.total())
        .forEach(answers -> others.put(answers.setting(), answers.wrong()));
    return "Decisions: wrong answers of Carom: %s; %s."
        .formatted(
            ours.text(),
            next(others, ours.wrong(), "as many has", "fewer has", ReportNumbers::count));
  }

  /** Who of the others has the least, and whether that is less than ours. */
  private static String next(
      Map<Setting, Double> numbers,
      double ours,
      String asGood,
      String better,
      DoubleFunction<String> text) {
    return numbers.entrySet().stream()
        .filter(e -> !e.getKey().method().equals(Metrics.OURS) && !e.getValue().isNaN())
        .min(Map.Entry.comparingByValue())
        .map(
            best -> {
              double theirs = best.getValue();
              String rank = theirs == ours ? asGood : theirs < ours ? better : "next is";
              return "%s %s, with %s"
                  .formatted(rank, Glossary.fullName(best.getKey()), text.apply(theirs));
            })
        .orElse("no other has all");
  }

  private String accuracy() {
    List<String> scenes = results.scenes(Metrics.FRAME_ERROR);
    double ours = worstError(scenes, Metrics.CAROM);
    if (scenes.isEmpty() || Double.isNaN(ours)) {
      return "Accuracy: Carom has no error to show: "
          + (scenes.isEmpty() ? "not measured." : "it failed in a scene.");
    }
    Map<Setting, Double> others = new LinkedHashMap<>();
    for (Standing s : Standing.of(results, scenes.get(0), Metrics.FRAME_ERROR)) {
      others.put(s.setting(), worstError(scenes, s.setting()));
    }
    return "Accuracy: in %s the worst error of one frame of Carom is %s; %s."
        .formatted(
            scenes(scenes.size()),
            ReportNumbers.radii(ours),
            next(others, ours, "as accurate is", "more accurate is", ReportNumbers::error));
  }

  /** NaN if it failed, or was not measured, in one of them. */
  private double worstError(List<String> scenes, Setting setting) {
    return scenes.stream()
        .mapToDouble(scene -> results.value(scene, setting, Metrics.FRAME_ERROR, "max"))
        .reduce(0, Math::max); // NaN if one of them is
  }

  private String budget() {
    List<Standing> timed =
        Standing.ours(results, Metrics.FRAME_TIME).stream()
            .filter(s -> !Double.isNaN(worst(s)))
            .toList();
    if (timed.isEmpty()) {
      return "Budget: not measured.";
    }
    Standing slowest = timed.stream().max(Comparator.comparingDouble(Verdict::worst)).orElseThrow();
    double worst = worst(slowest);
    boolean met = worst <= BUDGET;
    return "Budget: %s; the slowest frame of Carom in %s takes %s (%s, median over forks), %s of the 16.67 ms of 60 FPS."
        .formatted(
            met ? "met" : "missed",
            scenes(timed.size()),
            ReportNumbers.time(worst),
            slowest.scene(),
            met
                ? "1/" + ReportNumbers.count(BUDGET / worst)
                : ReportNumbers.ratio(worst / BUDGET) + " times");
  }

  private static double worst(Standing s) {
    return s.value(Metrics.FRAME_TIME, "worst");
  }

  /** Where something is both faster and more accurate; else what comes close. */
  private String place() {
    List<Standing> ours =
        Standing.ours(results, Metrics.FRAME_ERROR).stream()
            .filter(s -> s.time().forks() > 0) // else nobody's frames were timed
            .toList();
    if (ours.isEmpty()) {
      return "Place: not measured.";
    }
    List<String> scenes = ours.stream().map(Standing::scene).toList();
    List<String> better = Standing.better(results, scenes);
    if (!better.isEmpty()) {
      return "Place: Carom is beaten: both faster and more accurate %s %s."
          .formatted(better.size() == 1 ? "is" : "are", String.join(", ", better));
    }
    List<String> level =
        Standing.who(
            results, scenes, (s, carom) -> s.isLevelWith(carom) && s.isMoreAccurateThan(carom));
    long alone = ours.stream().filter(carom -> carom.others().allMatch(carom::beats)).count();
    return "Place: in %s nothing measured is both faster and more accurate than Carom; in %d of %d it is itself faster and more accurate than all others%s."
        .formatted(
            scenes(ours.size()),
            alone,
            ours.size(),
            level.isEmpty()
                ? ""
                : "; more accurate, and not told apart in time: " + String.join(", ", level));
  }

  /** Where Carom is not the best in speed or accuracy: a sentence for each way that occurs. */
  static List<String> shortcomings(Results results) {
    Map<String, BiPredicate<Standing, Standing>> ways = new LinkedHashMap<>();
    ways.put("Faster than Carom", Standing::isFasterThan);
    ways.put("More accurate than Carom", Standing::isMoreAccurateThan);
    ways.put("As accurate as Carom", (s, ours) -> s.error() == ours.error());
    List<String> told = new ArrayList<>();
    ways.forEach(
        (what, way) -> {
          List<String> who = Standing.who(results, results.scenes(Metrics.FRAME_ERROR), way);
          if (!who.isEmpty()) {
            told.add(what + ": " + String.join(", ", who) + ".");
          }
        });
    return told;
  }

  private static String scenes(int n) {
    return n == 1 ? "1 scene" : n + " scenes";
  }
}
