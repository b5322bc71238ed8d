// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.results.Row;
import java.util.List;

/** Finds a number among rows. */
final class Found {

  private Found() {}

  /** The value of the one row of this metric and stat. */
  static double value(List<Row> rows, String metric, String stat) {
    List<Row> found =
        rows.stream().filter(r -> r.metric().equals(metric) && r.stat().equals(stat)).toList();
    if (found.size() != 1) {
      throw new AssertionError(found.size() + " rows of " + metric + " " + stat);
    }
    return found.get(0).value();
  }

  /** The reason of the one failure. */
  static String reason(List<Row> rows) {
    return rows.stream().filter(r -> r.metric().equals("failure")).findFirst().orElseThrow().stat();
  }
}
