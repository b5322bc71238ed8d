// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The rows of a series, in the order in which they are added. */
final class SeriesRows {

  private final String timeMetric;
  private final String impactsMetric;
  private final List<Row> rows = new ArrayList<>();

  /** Takes the metrics of the times of a frame, and of its impacts. */
  SeriesRows(String timeMetric, String impactsMetric) {
    this.timeMetric = timeMetric;
    this.impactsMetric = impactsMetric;
  }

  List<Row> all() {
    return List.copyOf(rows);
  }

  /** One statistic of n times, in nanoseconds. */
  void addTime(String scene, Contender contender, String stat, double nanos, int n) {
    add(scene, contender, timeMetric, stat, nanos, "ns", n);
  }

  /** The middle of some times, as the series defines it, and the least and greatest of them. */
  void addTimes(String scene, Contender contender, String stat, double middle, double[] nanos) {
    addTime(scene, contender, stat, middle, nanos.length);
    addTime(scene, contender, "min", Arrays.stream(nanos).min().orElse(Double.NaN), nanos.length);
    addTime(scene, contender, "max", Arrays.stream(nanos).max().orElse(Double.NaN), nanos.length);
  }

  /** The impacts of a frame, on average. */
  void addImpacts(String scene, Contender contender, long impacts, long frames) {
    double mean = (double) impacts / frames;
    add(scene, contender, impactsMetric, "mean", mean, "1", frames);
  }

  private void add(
      String scene, Contender c, String metric, String stat, double value, String unit, long n) {
    rows.add(new Row(scene, c.method(), c.knob(), metric, stat, value, unit, n, 0));
  }

  /** The median of each frame over all replays: disturbances by the machine fall on few of them. */
  static double[] medians(List<double[]> replays) {
    double[] medians = new double[replays.get(0).length];
    Arrays.setAll(medians, frame -> median(replays.stream().mapToDouble(r -> r[frame]).toArray()));
    return medians;
  }

  /** The mean of both middle values if their number is even. */
  static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
  }
}
