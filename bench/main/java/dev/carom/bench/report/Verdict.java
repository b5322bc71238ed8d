// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.ArrayList;
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
        new ScaleGrowth(results).verdict(),
        AcceptanceLimits.sentence(results));
  }

  /** Wrong answers of one setting to all queries. */
  private record WrongAnswers(Setting setting, double wrong, double total) {}

  private String decisions() {
    List<WrongAnswers> tallies = tallies();
    Optional<WrongAnswers> ours =
        tallies.stream().filter(t -> t.setting.equals(Metrics.CAROM)).findFirst();
    if (ours.isEmpty()) {
      return "Decisions: not measured.";
    }
    WrongAnswers carom = ours.get();
    String all =
        "Decisions: wrong answers of Carom: " + ReportNumbers.failures(carom.wrong, carom.total);
    Optional<WrongAnswers> next =
        tallies.stream()
            .filter(t -> !t.setting.method().equals(Metrics.OURS) && t.total == carom.total)
            .min(Comparator.comparingDouble(WrongAnswers::wrong));
    if (next.isEmpty()) {
      return all + ".";
    }
    String other =
        Metrics.fullName(next.get().setting)
            + ", with "
            + ReportNumbers.count(next.get().wrong)
            + ".";
    if (next.get().wrong == carom.wrong) {
      return all + "; as many has " + other;
    }
    return next.get().wrong < carom.wrong
        ? all + "; fewer has " + other
        : all + "; next is " + other;
  }

  private List<WrongAnswers> tallies() {
    List<String> classes = results.scenes(Metrics.DECISIONS);
    return classes.stream()
        .flatMap(scene -> results.settings(scene, Metrics.DECISIONS).stream())
        .distinct()
        .map(
            setting ->
                new WrongAnswers(
                    setting,
                    sum(classes, setting, Metrics.MISSED) + sum(classes, setting, Metrics.INVENTED),
                    sum(classes, setting, Metrics.DECISIONS)))
        .toList();
  }

  /** Over the classes that the setting was asked in. */
  private double sum(List<String> scenes, Setting setting, String metric) {
    return scenes.stream()
        .flatMap(scene -> results.only(scene, setting, metric).stream())
        .mapToDouble(Spread::middle)
        .sum();
  }

  private String accuracy() {
    List<String> scenes = results.scenes(Metrics.FRAME_ERROR);
    double ours = worstError(scenes, Metrics.CAROM);
    if (scenes.isEmpty() || Double.isNaN(ours)) {
      return "Accuracy: Carom has no error to show: "
          + (scenes.isEmpty() ? "not measured." : "it failed in a scene.");
    }
    String all =
        "Accuracy: in %s the worst error of one frame of Carom is %s radii"
            .formatted(scenes(scenes.size()), ReportNumbers.error(ours));
    Optional<Setting> next =
        settings(scenes, Metrics.FRAME_ERROR)
            .filter(s -> !Double.isNaN(worstError(scenes, s)))
            .min(Comparator.comparingDouble(s -> worstError(scenes, s)));
    if (next.isEmpty()) {
      return all + "; all others failed in one of them.";
    }
    double theirs = worstError(scenes, next.get());
    String other = Metrics.fullName(next.get()) + ", with " + ReportNumbers.error(theirs) + ".";
    if (theirs == ours) {
      return all + "; as accurate is " + other;
    }
    return all + (theirs < ours ? "; more accurate is " : "; next is ") + other;
  }

  /** NaN if it failed, or was not measured, in one of them. */
  private double worstError(List<String> scenes, Setting setting) {
    return scenes.stream()
        .mapToDouble(scene -> results.value(scene, setting, Metrics.FRAME_ERROR, "max"))
        .reduce(0, Math::max); // NaN if one of them is
  }

  private Stream<Setting> settings(List<String> scenes, String metric) {
    return scenes.stream()
        .flatMap(scene -> results.settings(scene, metric).stream())
        .distinct()
        .filter(s -> !s.method().equals(Metrics.OURS) && !s.method().equals(Metrics.NEIGHBOUR));
  }

  private String budget() {
    String slowest = null;
    double worst = 0;
    List<String> scenes =
        results.scenes(Metrics.FRAME_TIME).stream()
            .filter(s -> results.settings(s, Metrics.FRAME_TIME).contains(Metrics.CAROM))
            .filter(s -> results.spread(s, Metrics.CAROM, Metrics.FRAME_TIME, "worst").isPresent())
            .toList();
    for (String scene : scenes) {
      double time = results.value(scene, Metrics.CAROM, Metrics.FRAME_TIME, "worst");
      if (Double.isNaN(time)) {
        return "Budget: Carom has no time in " + scene + ".";
      }
      if (time >= worst) {
        worst = time;
        slowest = scene;
      }
    }
    if (slowest == null) {
      return "Budget: not measured.";
    }
    return "Budget: %s; the slowest frame of Carom in %s takes %s (%s, median over forks), %s of the 16.67 ms of 60 FPS."
        .formatted(
            worst <= BUDGET ? "met" : "missed",
            scenes(scenes.size()),
            ReportNumbers.time(worst),
            slowest,
            worst <= BUDGET
                ? "1/" + ReportNumbers.count(BUDGET / worst)
                : ReportNumbers.ratio(worst / BUDGET) + " times");
  }

  /** Where something is both faster and more accurate; else what comes close. */
  private String place() {
    List<String> beaten = new ArrayList<>();
    List<String> level = new ArrayList<>();
    int scenes = 0;
    int alone = 0;
    for (String scene : results.scenes(Metrics.FRAME_ERROR)) {
      List<Standing> all = Standing.all(results, scene);
      Optional<Standing> ours = Standing.ours(all).filter(s -> s.time().forks() > 0);
      if (ours.isEmpty()) {
        continue; // nobody's frames were timed
      }
      scenes++;
      Standing carom = ours.get();
      all.stream()
          .filter(s -> s.beats(carom))
          .forEach(s -> beaten.add(Metrics.fullName(s.setting()) + " in " + scene));
      all.stream()
          .filter(s -> !s.equals(carom) && s.isLevelWith(carom) && s.isMoreAccurateThan(carom))
          .forEach(s -> level.add(Metrics.fullName(s.setting()) + " in " + scene));
      alone += all.stream().allMatch(s -> s.equals(carom) || carom.beats(s)) ? 1 : 0;
    }
    if (scenes == 0) {
      return "Place: not measured.";
    }
    if (!beaten.isEmpty()) {
      return "Place: Carom is beaten: both faster and more accurate %s %s."
          .formatted(beaten.size() == 1 ? "is" : "are", String.join(", ", beaten));
    }
    String close =
        level.isEmpty()
            ? ""
            : "; more accurate, and not told apart in time: " + String.join(", ", level);
    return "Place: in %s nothing measured is both faster and more accurate than Carom; in %d of %d it is itself faster and more accurate than all others%s."
        .formatted(scenes(scenes), alone, scenes, close);
  }

  private static String scenes(int n) {
    return n == 1 ? "1 scene" : n + " scenes";
  }
}
