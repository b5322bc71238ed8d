// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

import java.util.Arrays;

/**
 * A number over the forks that measured it.
 *
 * @param low its 5th percentile over forks, between ranks by linear interpolation
 * @param middle its median over forks
 * @param high its 95th percentile over forks
 * @param forks how many there are; a number that does not depend on them has one
 * @param n how many values the forks' numbers stand for together
 */
public record Spread(double low, double middle, double high, int forks, long n) {

  /**
   * Returns the spread of values of forks. One NaN makes all of it NaN.
   *
   * @param n how many values they stand for
   * @param values one a fork, at least one
   */
  public static Spread of(long n, double... values) {
    if (Arrays.stream(values).anyMatch(Double::isNaN)) {
      return new Spread(Double.NaN, Double.NaN, Double.NaN, values.length, n);
    }
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return new Spread(
        quantile(sorted, 0.05), quantile(sorted, 0.5), quantile(sorted, 0.95), values.length, n);
  }

  private static double quantile(double[] sorted, double share) {
    double rank = share * (sorted.length - 1);
    int below = (int) rank;
    if (below == rank || sorted[below] == sorted[below + 1]) {
      return sorted[below];
    }
    return sorted[below] + (rank - below) * (sorted[below + 1] - sorted[below]);
  }

  /**
   * Whether it is surely below another: the intervals do not touch.
   *
   * @param other the other number
   * @return false if they overlap, or one of them is NaN
   */
  public boolean isBelow(Spread other) {
    return high < other.low;
  }

  /** Whether the method gave no number, but NaN. */
  public boolean failed() {
    return Double.isNaN(middle);
  }
}
