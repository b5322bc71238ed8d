// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import java.util.Arrays;

/** Quantiles by nearest rank. NaN counts as greater than all numbers: it is a failure. */
final class Quantiles {

  private final double[] sorted;

  Quantiles(double... values) {
    if (values.length == 0) {
      throw new IllegalArgumentException("expected at least one value");
    }
    sorted = values.clone();
    Arrays.sort(sorted);
  }

  /** The least value that a given share of all values does not exceed. */
  double at(double share) {
    return sorted[Math.max(0, (int) Math.ceil(share * sorted.length) - 1)];
  }

  double median() {
    return at(0.5);
  }

  double max() {
    return sorted[sorted.length - 1];
  }

  double mean() {
    return Arrays.stream(sorted).average().orElseThrow();
  }

  int size() {
    return sorted.length;
  }
}
