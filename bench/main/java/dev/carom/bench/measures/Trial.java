// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.results.Row;
import java.util.List;
import java.util.function.Supplier;

/**
 * One contender on one scene: what all rows of a measure have in common.
 *
 * @param scene the first column of the rows
 * @param contender who is measured
 * @param fork the virtual machine, -1 where it does not matter
 */
record Trial(String scene, Contender contender, int fork) {

  /** The fork of results that do not depend on the virtual machine. */
  static final int ANY_FORK = -1;

  static final String RADII = "radii";
  static final String NANOS = "ns";
  static final String ULPS = "ulps";
  static final String FRAMES = "frames";
  static final String ONE = "1";

  Trial(String scene, Contender contender) {
    this(scene, contender, ANY_FORK);
  }

  Row row(String metric, String stat, double value, String unit, long n) {
    return new Row(scene, contender.method(), contender.knob(), metric, stat, value, unit, n, fork);
  }

  /** What the measure finds, or the row that tells why the contender cannot play. */
  List<Row> rows(Supplier<List<Row>> measure) {
    try {
      return measure.get();
    } catch (UnsupportedOperationException | LinkageError e) {
      return List.of(failure(e));
    }
  }

  /** Tells why there is nothing, or nothing more. */
  Row failure(String reason) {
    return row("failure", reason, Double.NaN, ONE, 0);
  }

  Row failure(Throwable cause) {
    String message = cause.getMessage();
    return failure(message == null ? cause.getClass().getSimpleName() : message);
  }
}
