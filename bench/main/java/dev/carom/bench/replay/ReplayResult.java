// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.results.Row;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * The result of a run: the figures of each method, and one replay's raw frame times for a chart.
 */
public final class ReplayResult {

  private final ReplayPlan plan;
  private final Map<Contender, List<Samples>> samples;
  private final Machine machine;
  private final Map<Contender, Figures> figures = new LinkedHashMap<>();

  ReplayResult(ReplayPlan plan, Map<Contender, List<Samples>> samples, Machine machine) {
    this.plan = plan;
    this.samples = samples;
    this.machine = machine;
    for (Contender contender : plan.contenders()) {
      try (Method method = contender.start(plan.scene())) {
        Counts counts = Counts.of(method, plan.frames());
        figures.put(contender, Figures.of(contender.id(), counts, samples.get(contender)));
      }
    }
  }

  /** Returns the plan of the run. */
  public ReplayPlan plan() {
    return plan;
  }

  /** Where it was replayed. */
  public Machine machine() {
    return machine;
  }

  /** The figures of every method: one row a method, in the order of the plan. */
  public List<Figures> figures() {
    return List.copyOf(figures.values());
  }

  /**
   * The figures of one method.
   *
   * @param contender who replayed
   * @return its row
   */
  public Figures figures(Contender contender) {
    return figures.get(contender);
  }

  /** The figures as rows: times of a frame and what it allocates; impacts of one replay. */
  public List<Row> rows() {
    return figures.values().stream().flatMap(f -> f.rows(plan.name()).stream()).toList();
  }

  /**
   * How many times faster than the published algorithm we are: the ratio of the two means; empty if
   * that one did not replay.
   */
  public OptionalDouble ratioToPoster() {
    return plan.contenders().contains(Methods.POSTER)
        ? OptionalDouble.of(figures(Methods.POSTER).mean() / figures(Methods.CAROM).mean())
        : OptionalDouble.empty();
  }

  /**
   * The raw frame times of the replay by Carom whose slowest frame is the median one: nanoseconds,
   * one for each frame.
   */
  public double[] typicalReplay() {
    List<double[]> replays =
        samples.get(Methods.CAROM).stream()
            .flatMap(fork -> fork.replays().stream())
            .map(nanos -> Arrays.stream(nanos).asDoubleStream().toArray())
            .sorted(Comparator.comparingDouble(ReplayResult::greatest))
            .toList();
    return replays.get((replays.size() - 1) / 2);
  }

  private static double greatest(double[] nanos) {
    return Arrays.stream(nanos).max().orElseThrow();
  }
}
