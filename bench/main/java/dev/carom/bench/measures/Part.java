// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.results.Row;
import java.util.List;

/** A piece of the whole measurement that can be run by itself, in any order. */
public interface Part {

  /**
   * Its name, the same in every run: {@code scene/base-1/poster}.
   *
   * @return words of letters, digits, dots and hyphens, separated by slashes
   */
  String id();

  /**
   * How long it takes on two cores of an AMD EPYC, roughly: what counts is its share of the whole.
   *
   * @return in seconds, greater than 0
   */
  double seconds();

  /**
   * Measures. What fails is told by rows whose value is NaN, among them one of the metric {@code
   * failure} whose stat is the reason.
   */
  List<Row> run();
}
