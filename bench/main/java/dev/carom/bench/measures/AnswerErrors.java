// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.results.Row;
import dev.carom.oracle.Contact;
import java.util.ArrayList;
import java.util.List;

/** Counts answers against the truth. */
final class AnswerErrors {

  private int total;
  private int missed;
  private int falseHits;
  private final List<Double> ulps = new ArrayList<>();

  /** One answer; infinite for never. */
  void add(Contact truth, double time) {
    total++;
    boolean hit = Double.isFinite(time);
    if (truth.hit() && !hit) {
      missed++;
    } else if (!truth.hit() && time != Double.POSITIVE_INFINITY) {
      falseHits++;
    } else if (hit && truth.moment().sign() > 0) {
      ulps.add(Math.abs(truth.moment().errorInUlps(time)));
    }
  }

  List<Row> rows(Trial trial) {
    List<Row> rows = new ArrayList<>();
    rows.add(trial.row("decisions_missed", "count", missed, Trial.ONE, total));
    rows.add(trial.row("decisions_false", "count", falseHits, Trial.ONE, total));
    rows.add(trial.row("decisions_total", "count", total, Trial.ONE, total));
    if (!ulps.isEmpty()) {
      Quantiles errors = new Quantiles(ulps.stream().mapToDouble(Double::doubleValue).toArray());
      rows.add(trial.row("time_error", "median", errors.median(), Trial.ULPS, errors.size()));
      rows.add(trial.row("time_error", "max", errors.max(), Trial.ULPS, errors.size()));
    }
    return rows;
  }
}
