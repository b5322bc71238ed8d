// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Feature;
import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Outcome;
import java.util.ArrayList;
import java.util.List;

/** A row of a log, copied; two are equal if all their bits are. */
record ImpactRow(
    double time,
    int circle,
    Kind kind,
    int id,
    Feature feature,
    double x,
    double y,
    double nx,
    double ny,
    double speed,
    Outcome outcome) {

  static List<ImpactRow> of(ImpactLog log) {
    List<ImpactRow> rows = new ArrayList<>(log.size());
    for (int i = 0; i < log.size(); i++) {
      rows.add(
          new ImpactRow(
              log.time(i),
              log.circle(i),
              log.kind(i),
              log.id(i),
              log.feature(i),
              log.x(i),
              log.y(i),
              log.nx(i),
              log.ny(i),
              log.approachSpeed(i),
              log.outcome(i)));
    }
    return rows;
  }
}
