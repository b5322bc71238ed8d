// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.List;
import java.util.Optional;

/** Circles that collide: how true methods and engines stay to a gas, beside their time. */
final class GasTable {

  private static final String SCENE = "gas";

  private final Results results;

  GasTable(Results results) {
    this.results = results;
  }

  boolean isEmpty() {
    return results.settings(SCENE, Metrics.GAS_ENERGY).isEmpty();
  }

  ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "method",
            "time of a frame",
            "energy gained or lost, worst frame",
            "deepest overlap, in radii",
            "circles lost, of 100");
    for (Setting setting : Settings.of(results, SCENE, Metrics.GAS_ENERGY)) {
      double energy = value(setting, Metrics.GAS_ENERGY, "max");
      table.row(
          Metrics.shortName(setting),
          results
              .spread(SCENE, setting, Metrics.FRAME_TIME, "median")
              .map(ReportNumbers::spread)
              .orElse("not measured"),
          percent(energy),
          ReportNumbers.error(value(setting, Metrics.GAS_OVERLAP, "max")),
          ReportNumbers.count(value(setting, Metrics.GAS_LOST, "circles")));
    }
    return table.build();
  }

  private static String percent(double share) {
    if (Double.isNaN(share)) {
      return "failed";
    }
    double percent = 100 * share;
    return (percent >= 1000 ? ReportNumbers.count(percent) : ReportNumbers.error(percent)) + " %";
  }

  /** Why an engine gains that much, or nothing where it does not. */
  String note() {
    boolean gains =
        Settings.of(results, SCENE, Metrics.GAS_ENERGY).stream()
            .filter(setting -> setting.method().equals("dyn4j"))
            .anyMatch(setting -> value(setting, Metrics.GAS_ENERGY, "max") > 0.5);
    return gains
        ? "dyn4j gains energy where a circle has two contacts in one frame: it bounces each by itself,"
            + " and together they return more than came in. With one contact it gains none. No setting"
            + " that we tried prevents it; without its continuous detection it gains less, but circles"
            + " leave the box."
        : "";
  }

  private double value(Setting setting, String metric, String stat) {
    return results.value(SCENE, setting, metric, stat);
  }

  private Optional<Spread> time(Setting setting) {
    return results
        .spread(SCENE, setting, Metrics.FRAME_TIME, "median")
        .filter(spread -> !spread.failed());
  }

  String title() {
    List<String> faster =
        Settings.of(results, SCENE, Metrics.GAS_ENERGY).stream()
            .filter(
                s ->
                    time(s).isPresent()
                        && time(Metrics.CAROM).isPresent()
                        && time(s).get().isBelow(time(Metrics.CAROM).get()))
            .map(Metrics::shortName)
            .toList();
    return "Colliding circles: Carom keeps energy to %s and overlaps by %s radii; faster: %s"
        .formatted(
            percent(value(Metrics.CAROM, Metrics.GAS_ENERGY, "max")),
            ReportNumbers.error(value(Metrics.CAROM, Metrics.GAS_OVERLAP, "max")),
            faster.isEmpty() ? "none" : String.join(", ", faster));
  }
}
