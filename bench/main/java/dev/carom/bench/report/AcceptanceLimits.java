// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.measures.RoundingPart;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Spread;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.stream.Stream;

/** The limits that Carom is to keep, and whether it does: by rule, where they were measured. */
final class AcceptanceLimits {

  /**
   * One limit.
   *
   * @param what is limited
   * @param where a scene, or questions
   * @param limit what is allowed
   * @param measured what was found
   */
  private record Limit(String what, String where, String limit, String measured, boolean holds) {

    List<String> cells() {
      return List.of(what, where, limit, measured, holds ? "yes" : "no");
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
            all.decisions(),
            SLOW.stream().flatMap(all::frameError),
            all.roundings(),
            results.scenes(Metrics.FRAME_ERROR).stream().flatMap(all::beaten),
            slowestFrames(results).stream().flatMap(AcceptanceLimits::budget),
            results.scenes("escaped").stream().map(all::solid),
            all.forks())
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
    List<Limit> all = of(results);
    List<String> missed = all.stream().filter(limit -> !limit.holds).map(Limit::toString).toList();
    return all.isEmpty()
        ? "Limits: not measured."
        : "Limits: %d of the %d that were measured hold%s."
            .formatted(
                all.size() - missed.size(),
                all.size(),
                missed.isEmpty() ? "" : "; missed: " + String.join("; ", missed));
  }

  private Stream<Limit> decisions() {
    Answers ours = Answers.ours(results);
    return ours.asked()
        ? Stream.of(
            new Limit("wrong answers", "all questions", "0", ours.text(), ours.wrong() == 0))
        : Stream.empty();
  }

  private Standing carom(String scene) {
    return new Standing(results, scene, Metrics.CAROM);
  }

  private static Stream<Limit> atMost(
      double limit,
      String what,
      Standing s,
      String metric,
      String stat,
      DoubleFunction<String> text) {
    return s.spread(metric, stat).stream()
        .mapToDouble(Spread::middle)
        .mapToObj(
            found ->
                new Limit(what, s.scene(), text.apply(limit), text.apply(found), found <= limit));
  }

  private Stream<Limit> frameError(String scene) {
    return atMost(
        FRAME_ERROR,
        "worst error of one frame, in radii",
        carom(scene),
        Metrics.FRAME_ERROR,
        "max",
        ReportNumbers::error);
  }

  private Stream<Limit> roundings() {
    Standing fast = carom(FAST);
    return Stream.concat(
        atMost(
            RoundingPart.LIMIT,
            "worst error of one circle in one frame, in 2^-53 x its conditioning",
            fast,
            RoundingPart.METRIC,
            "max",
            units -> ReportNumbers.ratio(units) + (units > RoundingPart.LIMIT ? above(fast) : "")),
        atMost(
            RoundingPart.LIMIT,
            "worst error of one frame, in 2^-53 x the greatest conditioning in it",
            fast,
            RoundingPart.METRIC,
            RoundingPart.OF_FRAMES,
            ReportNumbers::ratio));
  }

  /** How many of how many are above the limit. */
  private static String above(Standing s) {
    return s.spread(RoundingPart.METRIC, RoundingPart.ABOVE)
        .map(
            above ->
                ", %s of %s circle-frames above"
                    .formatted(
                        ReportNumbers.count(above.middle()),
                        ReportNumbers.count((double) above.n())))
        .orElse("");
  }

  /** A scene without times is none to be fast in. */
  private Stream<Limit> beaten(String scene) {
    Standing ours = carom(scene);
    if (ours.time().forks() == 0) {
      return Stream.empty();
    }
    List<String> better = Standing.better(results, List.of(scene));
    String measured = better.isEmpty() ? "none" : String.join(", ", better);
    return Stream.of(
        new Limit(
            "both faster and more accurate than Carom",
            scene,
            "none",
            measured,
            better.isEmpty() && !ours.failed()));
  }

  /** Carom in the scenes where not only its usual frames were measured. */
  static List<Standing> slowestFrames(Results results) {
    return results.scenes(Metrics.FRAME_TIME).stream()
        .map(scene -> new Standing(results, scene, Metrics.CAROM))
        .filter(s -> s.spread(Metrics.FRAME_TIME, "worst").isPresent())
        .toList();
  }

  private static Stream<Limit> budget(Standing s) {
    return atMost(BUDGET, "slowest frame", s, Metrics.FRAME_TIME, "worst", ReportNumbers::time);
  }

  private Limit solid(String scene) {
    double most =
        GOT_OUT.stream()
            .flatMap(metric -> results.only(scene, Metrics.CAROM, metric).stream())
            .mapToDouble(Spread::middle)
            .reduce(0, Math::max); // NaN if one of them is
    String what = "circles through a line or out of bounds";
    return new Limit(what, scene, "0", ReportNumbers.count(most), most == 0);
  }

  /** The number of forks, of the time of a frame that has the fewest. */
  private Stream<Limit> forks() {
    return results.scenes(Metrics.FRAME_TIME).stream()
        .flatMap(scene -> Standing.of(results, scene, Metrics.FRAME_TIME).stream())
        .flatMap(s -> s.spread(Metrics.FRAME_TIME, "median").stream())
        .map(Spread::forks)
        .min(Integer::compare)
        .stream()
        .map(
            least ->
                new Limit(
                    "forks of each time, least",
                    "all frames",
                    "at least " + FORKS,
                    least.toString(),
                    least >= FORKS));
  }
}
