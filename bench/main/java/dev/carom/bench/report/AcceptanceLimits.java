// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.measures.RoundingPart;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.results.Spread;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The limits that Carom is to keep, what was measured, and whether it does: by rule. */
final class AcceptanceLimits {

  /**
   * One limit.
   *
   * @param what is limited
   * @param where a scene, or questions
   * @param limit what is allowed
   * @param measured what was found, empty if it was not measured
   * @param holds whether it does; false if it was not measured
   */
  record Limit(String what, String where, String limit, String measured, boolean holds) {

    boolean known() {
      return !measured.isEmpty();
    }

    @Override
    public String toString() {
      return "%s, %s: %s (limit: %s)".formatted(what, where, measured, limit);
    }
  }

  /** In radii, where impacts are few. */
  private static final double FRAME_ERROR = 1e-12;

  private static final List<String> SLOW = List.of("base-1", "base-2", "base-3", "radii");

  /** Where impacts are many. */
  private static final String FAST = "fast-1";

  /** The canonical scene, and the same with smaller circles. */
  private static final List<String> ALONE = List.of("base-1", "base-1-r5");

  private static final double BUDGET = 1e6 * Budget.MILLIS;
  private static final int FORKS = 5;
  private static final List<String> GOT_OUT = List.of("tunnelled", "escaped", "outside_at_end");

  private final Results results;
  private final List<Limit> limits = new ArrayList<>();

  private AcceptanceLimits(Results results) {
    this.results = results;
  }

  static List<Limit> of(Results results) {
    AcceptanceLimits all = new AcceptanceLimits(results);
    all.decisions();
    SLOW.forEach(all::frameError);
    all.roundings();
    all.alone();
    all.budget();
    all.solid();
    all.forks();
    return List.copyOf(all.limits);
  }

  static ReportTable table(Results results) {
    ReportTable.Builder table =
        new ReportTable.Builder("what", "where", "limit", "measured", "holds");
    for (Limit limit : of(results)) {
      table.row(
          limit.what,
          limit.where,
          limit.limit,
          limit.known() ? limit.measured : "not measured",
          limit.known() ? (limit.holds ? "yes" : "no") : "");
    }
    return table.build();
  }

  /** One sentence: how many hold, and each that does not. */
  static String sentence(Results results) {
    List<Limit> known = of(results).stream().filter(Limit::known).toList();
    if (known.isEmpty()) {
      return "Limits: not measured.";
    }
    List<Limit> missed = known.stream().filter(limit -> !limit.holds).toList();
    String all =
        "Limits: %d of the %d that were measured hold"
            .formatted(known.size() - missed.size(), known.size());
    return missed.isEmpty()
        ? all + "."
        : all
            + "; missed: "
            + missed.stream().map(Limit::toString).collect(Collectors.joining("; "))
            + ".";
  }

  private void decisions() {
    double wrong = sum(Metrics.MISSED) + sum(Metrics.INVENTED);
    double asked = sum(Metrics.DECISIONS);
    String measured = asked > 0 ? ReportNumbers.failures(wrong, asked) : "";
    limits.add(new Limit("wrong answers", "all questions", "0", measured, wrong == 0));
  }

  private double sum(String metric) {
    return results.scenes(metric).stream()
        .flatMap(scene -> results.only(scene, Metrics.CAROM, metric).stream())
        .mapToDouble(Spread::middle)
        .sum();
  }

  private void frameError(String scene) {
    atMost(
        "worst error of one frame, in radii",
        scene,
        FRAME_ERROR,
        ReportNumbers::error,
        results.spread(scene, Metrics.CAROM, Metrics.FRAME_ERROR, "max"));
  }

  private void roundings() {
    Optional<Spread> worst = results.spread(FAST, Metrics.CAROM, RoundingPart.METRIC, "max");
    String above = new RoundingNote(results, FAST).above().map(t -> ", " + t).orElse("");
    atMost(
        "worst error of one circle in one frame, in 2^-53 x its conditioning",
        FAST,
        RoundingPart.LIMIT,
        units -> ReportNumbers.ratio(units) + (units > RoundingPart.LIMIT ? above : ""),
        worst);
    atMost(
        "worst error of one frame, in 2^-53 x the greatest conditioning in it",
        FAST,
        RoundingPart.LIMIT,
        ReportNumbers::ratio,
        results.spread(FAST, Metrics.CAROM, RoundingPart.METRIC, RoundingPart.OF_FRAMES));
  }

  /** Explains a limit that needs words. */
  static Optional<String> note(Results results) {
    return new RoundingNote(results, FAST).sentences();
  }

  private void atMost(
      String what,
      String where,
      double limit,
      DoubleFunction<String> text,
      Optional<Spread> found) {
    String measured = found.map(spread -> text.apply(spread.middle())).orElse("");
    boolean holds = found.isPresent() && found.get().middle() <= limit;
    limits.add(new Limit(what, where, text.apply(limit), measured, holds));
  }

  /** A scene without times is none to be fast in. */
  private void alone() {
    List<String> scenes =
        Stream.concat(ALONE.stream(), results.scenes(Metrics.FRAME_TIME).stream())
            .distinct()
            .filter(s -> ALONE.contains(s) || results.scenes(Metrics.FRAME_ERROR).contains(s))
            .toList();
    for (String scene : scenes) {
      List<Standing> all = Standing.all(results, scene);
      Optional<Standing> ours = Standing.ours(all).filter(s -> s.time().forks() > 0);
      List<String> better =
          all.stream()
              .filter(s -> ours.isPresent() && s.beats(ours.get()))
              .map(s -> Metrics.fullName(s.setting()))
              .toList();
      String measured = better.isEmpty() ? "none" : String.join(", ", better);
      limits.add(
          new Limit(
              "both faster and more accurate than Carom",
              scene,
              "none",
              ours.isPresent() ? measured : "",
              ours.isPresent() && better.isEmpty() && !ours.get().failed()));
    }
  }

  private void budget() {
    for (String scene : results.scenes(Metrics.FRAME_TIME)) {
      if (results.spread(scene, Metrics.CAROM, Metrics.FRAME_TIME, "worst").isEmpty()) {
        continue; // only its usual frames were measured
      }
      double worst = results.value(scene, Metrics.CAROM, Metrics.FRAME_TIME, "worst");
      limits.add(
          new Limit(
              "slowest frame",
              scene,
              ReportNumbers.time(BUDGET),
              ReportNumbers.time(worst),
              worst <= BUDGET));
    }
  }

  private void solid() {
    for (String scene : results.scenes("escaped")) {
      double most =
          GOT_OUT.stream()
              .flatMap(metric -> results.only(scene, Metrics.CAROM, metric).stream())
              .mapToDouble(Spread::middle)
              .reduce(0, Math::max); // NaN if one of them is
      limits.add(
          new Limit(
              "circles through a line or out of bounds",
              scene,
              "0",
              ReportNumbers.count(most),
              most == 0));
    }
  }

  /** The number of forks, of the time that has the fewest. */
  private void forks() {
    ScaleTimes scale = new ScaleTimes(results);
    Map<String, Set<Integer>> forks =
        results.rows().stream()
            .filter(row -> row.unit().equals("ns") && !row.metric().equals(Metrics.FRAME_RAW))
            .filter(row -> !scale.isBeyond(row))
            .collect(
                Collectors.groupingBy(
                    row -> row.scene() + " " + row.method() + " " + row.knob(),
                    Collectors.mapping(Row::fork, Collectors.toSet())));
    int least = forks.values().stream().mapToInt(Set::size).min().orElse(0);
    limits.add(
        new Limit(
            "forks of each time, least",
            "all times",
            "at least " + FORKS,
            forks.isEmpty() ? "" : Integer.toString(least),
            least >= FORKS));
  }
}
