// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

/**
 * One method in a chart of speed against accuracy.
 *
 * @param method its label
 * @param knob its setting; may be empty
 * @param error how wrong it is: at least 0; NaN or infinite if it failed
 * @param low the 5th percentile of its time over forks, in nanoseconds
 * @param time the median; NaN if there is none
 * @param high the 95th percentile
 */
public record Dot(String method, String knob, double error, double low, double time, double high) {

  /** Whether it stands in the gutter of those that failed. */
  boolean failed() {
    return !Double.isFinite(error) || !Double.isFinite(time);
  }

  /** Whether it stands in the gutter of those without any error. */
  public boolean exact() {
    return !failed() && error == 0;
  }
}
