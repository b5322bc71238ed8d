// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.measures.RoundingPart;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
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
  private record Limit(String what, String where, String limit, String measured, boolean holds) {

    boolean known() {
      return !measured.isEmpty();
    }

    List<String> cells() {
      return known()
          ? List.of(what, where, limit, measured, holds ? "yes" : "no")
          : List.of(what, where, limit, "not measured", "");
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

  private AcceptanceLimits(Results results) {
    this.results = results;
  }

  private static List<Limit> of(Results results) {
    AcceptanceLimits all = new AcceptanceLimits(results);
    return Stream.of(
            Stream.of(all.decisions()),
            SLOW.stream().map(all::frameError),
            all.roundings(),
            all.timedScenes().map(all::alone),
            slowestFrames(results).stream().map(AcceptanceLimits::budget),
            results.scenes("escaped").stream().map(all::solid),
            Stream.of(all.forks()))
        .flatMap(limits -> limits)
        .toList();
  }

  static ReportTable table(Results results) {
    return new ReportTable(
        List.of("what", "where", "limit", "measured", "holds"),
        of(results).stream().map(Limit::cells).toList());
  }

  /** One sentence: how many hold, and each that does not. */
  static String sentence(Results results) {
    List<Limit> known = of(results).stream().filter(Limit::known).toList();
    List<Limit> missed = known.stream().filter(limit -> !limit.holds).toList();
    return known.isEmpty()
        ? "Limits: not measured."
        : "Limits: %d of the %d that were measured hold%s."
            .formatted(
                known.size() - missed.size(),
                known.size(),
                missed.isEmpty()
                    ? ""
                    : missed.stream()
                        .map(Limit::toString)
                        .collect(Collectors.joining("; ", "; missed: ", "")));
  }

  private Limit decisions() {
    Answers ours = Answers.ours(results);
    String measured = ours.asked() ? ours.text() : "";
    return new Limit("wrong answers", "all questions", "0", measured, ours.wrong() == 0);
  }

  private Limit frameError(String scene) {
    return atMost(
        FRAME_ERROR,
        "worst error of one frame, in radii",
        new Standing(results, scene, Metrics.CAROM).spread(Metrics.FRAME_ERROR, "max"),
        scene,
        ReportNumbers::error);
  }

  private Stream<Limit> roundings() {
    String above = rounding(RoundingPart.ABOVE).map(a -> ", " + above(a)).orElse("");
    return Stream.of(
        atMost(
            RoundingPart.LIMIT,
            "worst error of one circle in one frame, in 2^-53 x its conditioning",
            rounding("max"),
            FAST,
            units -> ReportNumbers.ratio(units) + (units > RoundingPart.LIMIT ? above : "")),
        atMost(
            RoundingPart.LIMIT,
            "worst error of one frame, in 2^-53 x the greatest conditioning in it",
            rounding(RoundingPart.OF_FRAMES),
            FAST,
            ReportNumbers::ratio));
  }

  private Optional<Spread> rounding(String stat) {
    return results.spread(FAST, Metrics.CAROM, RoundingPart.METRIC, stat);
  }

  private static String above(Spread above) {
    return "%s of %s circle-frames above"
        .formatted(ReportNumbers.count(above.middle()), ReportNumbers.count((double) above.n()));
  }

  /** Explains the limit of a frame with many impacts; nothing if it was not measured. */
  static Optional<String> note(Results results) {
    AcceptanceLimits all = new AcceptanceLimits(results);
    return all.rounding(RoundingPart.ABOVE)
        .map(
            above ->
                "Errors of single frames of %s: %s %s x 2^-53 times their conditioning; the worst, of %s, has %s impacts. A place is a double by contract, the start of each flight: exact arithmetic that rounds nothing but the places of these impacts errs there by %s."
                    .formatted(
                        FAST,
                        above(above),
                        ReportNumbers.ratio(RoundingPart.LIMIT),
                        all.told("max"),
                        all.told(RoundingPart.IMPACTS),
                        all.told(RoundingPart.ROUNDED)));
  }

  private String told(String stat) {
    return ReportNumbers.ratio(rounding(stat).map(Spread::middle).orElse(Double.NaN));
  }

  private static Limit atMost(
      double limit,
      String what,
      Optional<Spread> found,
      String where,
      DoubleFunction<String> text) {
    String measured = found.map(spread -> text.apply(spread.middle())).orElse("");
    boolean holds = found.filter(spread -> spread.middle() <= limit).isPresent();
    return new Limit(what, where, text.apply(limit), measured, holds);
  }

  /** A scene without times is none to be fast in. */
  private Stream<String> timedScenes() {
    return Stream.concat(
            ALONE.stream(),
            results.scenes(Metrics.FRAME_TIME).stream()
                .filter(results.scenes(Metrics.FRAME_ERROR)::contains))
        .distinct();
  }

  private Limit alone(String scene) {
    Standing ours = new Standing(results, scene, Metrics.CAROM);
    List<String> better =
        Standing.all(results, scene).stream()
            .filter(s -> s.beats(ours))
            .map(s -> Glossary.fullName(s.setting()))
            .toList();
    String measured = better.isEmpty() ? "none" : String.join(", ", better);
    return new Limit(
        "both faster and more accurate than Carom",
        scene,
        "none",
        ours.time().forks() > 0 ? measured : "",
        better.isEmpty() && !ours.failed());
  }

  /** Carom in the scenes where not only its usual frames were measured. */
  static List<Standing> slowestFrames(Results results) {
    return results.scenes(Metrics.FRAME_TIME).stream()
        .map(scene -> new Standing(results, scene, Metrics.CAROM))
        .filter(s -> s.spread(Metrics.FRAME_TIME, "worst").isPresent())
        .toList();
  }

  private static Limit budget(Standing s) {
    return atMost(
        BUDGET,
        "slowest frame",
        s.spread(Metrics.FRAME_TIME, "worst"),
        s.scene(),
        ReportNumbers::time);
  }

  private Limit solid(String scene) {
    double most =
        GOT_OUT.stream()
            .flatMap(metric -> results.only(scene, Metrics.CAROM, metric).stream())
            .mapToDouble(Spread::middle)
            .reduce(0, Math::max); // NaN if one of them is
    return new Limit(
        "circles through a line or out of bounds",
        scene,
        "0",
        ReportNumbers.count(most),
        most == 0);
  }

  /** The number of forks, of the time that has the fewest. */
  private Limit forks() {
    ScaleTimes scale = new ScaleTimes(results);
    Map<Standing, Set<Integer>> forks =
        results.rows().stream()
            .filter(row -> row.unit().equals("ns") && !row.metric().equals(Metrics.FRAME_RAW))
            .collect(
                Collectors.groupingBy(
                    row ->
                        new Standing(results, row.scene(), new Setting(row.method(), row.knob())),
                    Collectors.mapping(Row::fork, Collectors.toSet())));
    Optional<Integer> least =
        forks.entrySet().stream()
            .filter(entry -> !scale.isBeyond(entry.getKey()))
            .map(entry -> entry.getValue().size())
            .min(Integer::compare);
    return new Limit(
        "forks of each time, least",
        "all times",
        "at least " + FORKS,
        least.map(String::valueOf).orElse(""),
        least.filter(n -> n >= FORKS).isPresent());
  }
}
