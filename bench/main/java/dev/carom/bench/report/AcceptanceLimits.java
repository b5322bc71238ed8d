// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.measures.RoundingPart;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.results.Spread;
import dev.carom.bench.series.Scale;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;
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

  /**
   * A number of Carom that has a limit in each of some scenes.
   *
   * @param most the limit
   */
  private record Bound(
      String what,
      List<String> scenes,
      String metric,
      String stat,
      double most,
      DoubleFunction<String> text) {

    Stream<Limit> limits(Results results) {
      return scenes.stream()
          .map(scene -> new Standing(results, scene, Metrics.CAROM))
          .flatMap(s -> s.spread(metric, stat).map(found -> limit(s, found)).stream());
    }

    private Limit limit(Standing s, Spread found) {
      boolean holds = found.middle() <= most;
      String measured = text.apply(found.middle()) + (holds ? "" : above(s));
      return new Limit(what, s.scene(), text.apply(most), measured, holds);
    }

    /** How many of how many are above the limit, if that was counted. */
    private String above(Standing s) {
      return s.spread(metric, RoundingPart.ABOVE)
          .map(
              above ->
                  ", %s of %s circle-frames above"
                      .formatted(
                          ReportNumbers.count(above.middle()),
                          ReportNumbers.count((double) above.n())))
          .orElse("");
    }
  }

  /** Where impacts are many. */
  private static final List<String> FAST = List.of("fast-1");

  private static final List<Bound> ERRORS =
      List.of(
          new Bound(
              "worst error of one frame, in radii",
              List.of("base-1", "base-2", "base-3", "radii"),
              Metrics.FRAME_ERROR,
              "max",
              1e-12,
              ReportNumbers::error),
          new Bound(
              "worst error of one circle in one frame, in 2^-53 x its conditioning",
              FAST,
              RoundingPart.METRIC,
              "max",
              RoundingPart.LIMIT,
              ReportNumbers::ratio),
          new Bound(
              "worst error of one frame, in 2^-53 x the greatest conditioning in it",
              FAST,
              RoundingPart.METRIC,
              RoundingPart.OF_FRAMES,
              RoundingPart.LIMIT,
              ReportNumbers::ratio));

  private static final int FORKS = 5;

  /** Single frames, and times in larger and larger scenes, to which not every fork comes. */
  private static final Set<String> ENDING = Set.of(Metrics.FRAME_RAW, Scale.TIME);

  private static final List<String> GOT_OUT = List.of("tunnelled", "escaped", "outside_at_end");

  private final Results results;

  private AcceptanceLimits(Results results) {
    this.results = results;
  }

  private static List<Limit> of(Results results) {
    AcceptanceLimits all = new AcceptanceLimits(results);
    Bound slowest =
        new Bound(
            "slowest frame",
            results.scenes(Metrics.FRAME_TIME),
            Metrics.FRAME_TIME,
            "worst",
            1e6 * Budget.MILLIS,
            ReportNumbers::time);
    return Stream.of(
            Stream.of(Answers.ours(results))
                .filter(Answers::asked)
                .map(AcceptanceLimits::decisions),
            ERRORS.stream().flatMap(bound -> bound.limits(results)),
            Standing.ours(results, Metrics.FRAME_ERROR).stream()
                .filter(ours -> ours.time().forks() > 0)
                .map(AcceptanceLimits::beaten),
            slowest.limits(results),
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

  private static Limit decisions(Answers ours) {
    return new Limit("wrong answers", "all questions", "0", ours.text(), ours.wrong() == 0);
  }

  private static Limit beaten(Standing ours) {
    List<String> better = Standing.better(ours.results(), List.of(ours.scene()));
    return new Limit(
        "both faster and more accurate than Carom",
        ours.scene(),
        "none",
        better.isEmpty() ? "none" : String.join(", ", better),
        better.isEmpty() && !ours.failed());
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

  /** The number of forks, of the time that has the fewest. */
  private Stream<Limit> forks() {
    Map<String, Set<Integer>> forks =
        results.rows().stream()
            .filter(row -> row.unit().equals("ns") && !ENDING.contains(row.metric()))
            .collect(
                Collectors.groupingBy(
                    row -> row.scene() + " " + row.method() + " " + row.knob(),
                    Collectors.mapping(Row::fork, Collectors.toSet())));
    return forks.values().stream().map(Set::size).min(Integer::compare).stream()
        .map(
            least ->
                new Limit(
                    "forks of each time, least",
                    "all times but of growth",
                    "at least " + FORKS,
                    least.toString(),
                    least >= FORKS));
  }
}
