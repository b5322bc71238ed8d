// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.bench.results.Row;
import java.util.Arrays;
import java.util.List;
import java.util.stream.LongStream;

/**
 * The figures of one method, over all samples of all forks. Frame times are in microseconds and
 * include the two time stamps of each frame; quantiles are by nearest rank.
 *
 * @param name the method's label
 * @param counts what happens in one replay
 * @param samples the number of frame times
 * @param leastForkMean the mean of the fork whose mean is least
 * @param mostForkMean the mean of the fork whose mean is greatest
 * @param p95 the 95th percentile
 * @param p99 the 99th percentile
 * @param worst the slowest frame of a replay: the median over replays
 * @param worstOfAll the slowest of all samples
 * @param framesOverBudget how many samples exceed {@link Budget#MILLIS}
 * @param coldMean the mean of the first {@value #COLD_FRAMES} frames of a fresh virtual machine:
 *     the median over forks
 * @param coldWorst the slowest of these frames: the median over forks
 * @param bytesPerFrame allocated after the warm-up: the median over forks
 * @param emptyPairNanos the cost of the two time stamps: the median over forks
 */
public record Figures(
    String name,
    Counts counts,
    long samples,
    double mean,
    double leastForkMean,
    double mostForkMean,
    double median,
    double p95,
    double p99,
    double worst,
    double worstOfAll,
    long framesOverBudget,
    double coldMean,
    double coldWorst,
    double bytesPerFrame,
    double emptyPairNanos) {

  static final int COLD_FRAMES = 60;

  private static final double NANOS = 1e3;

  /**
   * Computes the figures of one method.
   *
   * @param name the method's label
   * @param counts what happens in one replay
   * @param forks at least one, each with at least one replay of at least one frame
   */
  static Figures of(String name, Counts counts, List<Samples> forks) {
    long[] all = forks.stream().flatMapToLong(Figures::samplesOf).sorted().toArray();
    double[] forkMeans =
        sorted(forks.stream().mapToDouble(fork -> mean(samplesOf(fork))).toArray());
    double[] worst =
        forks.stream()
            .flatMap(fork -> fork.replays().stream())
            .mapToDouble(Figures::greatest)
            .toArray();
    return new Figures(
        name,
        counts,
        all.length,
        mean(Arrays.stream(all)),
        forkMeans[0],
        forkMeans[forkMeans.length - 1],
        rank(all, 0.5),
        rank(all, 0.95),
        rank(all, 0.99),
        median(worst),
        greatest(all),
        Arrays.stream(all).filter(nanos -> nanos / NANOS > Budget.MICROS).count(),
        median(forks.stream().mapToDouble(fork -> mean(coldFrames(fork))).toArray()),
        median(forks.stream().mapToDouble(f -> greatest(coldFrames(f).toArray())).toArray()),
        median(forks.stream().mapToDouble(Figures::bytesPerFrame).toArray()),
        median(forks.stream().mapToDouble(Samples::emptyPairNanos).toArray()));
  }

  /** As rows of a scene. */
  List<Row> rows(String scene) {
    return List.of(
        time(scene, "mean", mean),
        time(scene, "median", median),
        time(scene, "p95", p95),
        time(scene, "p99", p99),
        time(scene, "worst", worst),
        time(scene, "worst of all", worstOfAll),
        row(scene, "over_budget", "frames", (double) framesOverBudget, "1"),
        row(scene, "impacts", "replay", (double) counts.impacts(), "1"),
        row(scene, "allocated", "mean", bytesPerFrame, "bytes"));
  }

  private Row time(String scene, String stat, double micros) {
    return row(scene, "frame_time", stat, micros * NANOS, "ns");
  }

  private Row row(String scene, String metric, String stat, double value, String unit) {
    return new Row(scene, name, "", metric, stat, value, unit, samples, -1);
  }

  /** The frames per second that the mean allows: 10^6 / mean. */
  public double fps() {
    return 1e6 / mean;
  }

  /** The part of the budget of a frame that the mean takes: 1 for all of it. */
  public double shareOfBudget() {
    return mean / Budget.MICROS;
  }

  private static LongStream samplesOf(Samples fork) {
    return fork.replays().stream().flatMapToLong(Arrays::stream);
  }

  private static LongStream coldFrames(Samples fork) {
    return Arrays.stream(fork.cold()).limit(COLD_FRAMES);
  }

  private static double bytesPerFrame(Samples fork) {
    return (double) fork.bytesAllocated() / fork.cold().length;
  }

  private static double mean(LongStream nanos) {
    return nanos.average().orElseThrow() / NANOS;
  }

  private static double greatest(long[] nanos) {
    return Arrays.stream(nanos).max().orElseThrow() / NANOS;
  }

  /** The least value that a given share of all values does not exceed. */
  private static double rank(long[] sortedNanos, double share) {
    return sortedNanos[(int) Math.ceil(share * sortedNanos.length) - 1] / NANOS;
  }

  private static double median(double[] values) {
    double[] sorted = sorted(values);
    return sorted[(sorted.length - 1) / 2];
  }

  private static double[] sorted(double[] values) {
    double[] copy = values.clone();
    Arrays.sort(copy);
    return copy;
  }
}
