// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.series.ScalePlan;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

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
    String next =
        Answers.all(results).stream()
            .filter(a -> !a.setting().method().equals(Metrics.OURS) && a.total() == ours.total())
            .min(Comparator.comparingDouble(Answers::wrong))
            .map(
                best ->
                    rank(best.wrong(), ours.wrong(), "as many has", "fewer has")
                        + rival(best.setting(), ReportNumbers.count(best.wrong())))
            .orElse("");
    return "Decisions: wrong answers of Carom: %s%s.".formatted(ours.text(), next);
  }

  /** How the best of the others does against Carom, the less the better. */
  private static String rank(double theirs, double ours, String asGood, String better) {
    if (theirs == ours) {
      return "; " + asGood + " ";
    }
    return theirs < ours ? "; " + better + " " : "; next is ";
  }

  private static String rival(Setting setting, String number) {
    return Glossary.fullName(setting) + ", with " + number;
  }

  private String accuracy() {
    List<String> scenes = results.scenes(Metrics.FRAME_ERROR);
    double ours = worstError(scenes, Metrics.CAROM);
    if (scenes.isEmpty() || Double.isNaN(ours)) {
      return "Accuracy: Carom has no error to show: "
          + (scenes.isEmpty() ? "not measured." : "it failed in a scene.");
    }
    Optional<Setting> next =
        rivals(scenes)
            .filter(s -> !Double.isNaN(worstError(scenes, s)))
            .min(Comparator.comparingDouble(s -> worstError(scenes, s)));
    String rest =
        next.map(
                best -> {
                  double theirs = worstError(scenes, best);
                  return rank(theirs, ours, "as accurate is", "more accurate is")
                      + rival(best, ReportNumbers.error(theirs));
                })
            .orElse("; all others failed in one of them");
    return "Accuracy: in %s the worst error of one frame of Carom is %s%s."
        .formatted(scenes(scenes.size()), ReportNumbers.radii(ours), rest);
  }

  /** NaN if it failed, or was not measured, in one of them. */
  private double worstError(List<String> scenes, Setting setting) {
    return scenes.stream()
        .mapToDouble(scene -> results.value(scene, setting, Metrics.FRAME_ERROR, "max"))
        .reduce(0, Math::max); // NaN if one of them is
  }

  private Stream<Setting> rivals(List<String> scenes) {
    return scenes.stream()
        .flatMap(scene -> results.settings(scene, Metrics.FRAME_ERROR).stream())
        .distinct()
        .filter(s -> !s.method().equals(Metrics.OURS) && !s.method().equals(Metrics.NEIGHBOUR));
  }

  private String budget() {
    List<Standing> timed = AcceptanceLimits.slowestFrames(results);
    if (timed.isEmpty()) {
      return "Budget: not measured.";
    }
    // A time that failed is greater than all.
    Standing slowest = timed.stream().max(Comparator.comparingDouble(Verdict::worst)).orElseThrow();
    double worst = worst(slowest);
    if (Double.isNaN(worst)) {
      return "Budget: Carom has no time in " + slowest.scene() + ".";
    }
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
        results.scenes(Metrics.FRAME_ERROR).stream()
            .map(scene -> new Standing(results, scene, Metrics.CAROM))
            .filter(s -> s.time().forks() > 0) // else nobody's frames were timed
            .toList();
    if (ours.isEmpty()) {
      return "Place: not measured.";
    }
    List<String> better = Standing.better(results, ours.stream().map(Standing::scene).toList());
    if (!better.isEmpty()) {
      return "Place: Carom is beaten: both faster and more accurate %s %s."
          .formatted(better.size() == 1 ? "is" : "are", String.join(", ", better));
    }
    List<String> level =
        ours.stream()
            .flatMap(
                carom ->
                    others(carom)
                        .filter(s -> s.isLevelWith(carom) && s.isMoreAccurateThan(carom))
                        .map(s -> Glossary.fullName(s.setting()) + " in " + s.scene()))
            .toList();
    long alone = ours.stream().filter(carom -> others(carom).allMatch(carom::beats)).count();
    return "Place: in %s nothing measured is both faster and more accurate than Carom; in %d of %d it is itself faster and more accurate than all others%s."
        .formatted(
            scenes(ours.size()),
            alone,
            ours.size(),
            level.isEmpty()
                ? ""
                : "; more accurate, and not told apart in time: " + String.join(", ", level));
  }

  private Stream<Standing> others(Standing carom) {
    return Standing.all(results, carom.scene()).stream().filter(s -> !s.isOurs());
  }

  private static String scenes(int n) {
    return n == 1 ? "1 scene" : n + " scenes";
  }
}
