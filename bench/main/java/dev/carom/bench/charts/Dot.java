// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

/**
 * One setting of one method in a chart of work against precision.
 *
 * @param method its label
 * @param knob what is printed at the dot; may be empty
 * @param error how wrong it is: at least 0; NaN or infinite if it failed
 * @param low the 5th percentile of its work over forks
 * @param work the median: a time in nanoseconds or a count; NaN if there is none
 * @param high the 95th percentile
 * @param hollow whether it is a peer at its defaults
 * @param usual an error that few are above, where a whisker to the worst one begins; NaN for none
 */
public record Dot(
    String method,
    String knob,
    double error,
    double low,
    double work,
    double high,
    boolean hollow,
    double usual) {

  /** A dot without a whisker to the side. */
  public Dot(
      String method,
      String knob,
      double error,
      double low,
      double work,
      double high,
      boolean hollow) {
    this(method, knob, error, low, work, high, hollow, Double.NaN);
  }

  /** Whether it stands in the gutter of those that failed. */
  boolean failed() {
    return !Double.isFinite(error) || !Double.isFinite(work);
  }

  /** Whether it stands in the gutter of those without any error. */
  public boolean exact() {
    return !failed() && error == 0;
  }
}
