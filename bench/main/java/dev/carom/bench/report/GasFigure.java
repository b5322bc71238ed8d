// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import java.util.List;

/** Circles that collide: how true methods and engines stay to a gas, beside their time. */
final class GasFigure {

  private static final String SCENE = "gas";

  /** So much energy from nowhere asks for a reason. */
  private static final double EXPLAINED = 0.5;

  private GasFigure() {}

  /** A table, or none if nothing was measured. */
  static List<Figure> of(Results results) {
    List<Standing> all = Standing.of(results, SCENE, Metrics.GAS_ENERGY);
    return Standing.ours(all).stream().map(ours -> figure(all, ours)).toList();
  }

  private static Figure figure(List<Standing> all, Standing ours) {
    List<String> faster =
        all.stream().filter(s -> s.isFasterThan(ours)).map(Standing::name).toList();
    String title =
        "Colliding circles: Carom keeps energy to %s and overlaps by %s; faster: %s"
            .formatted(
                ReportNumbers.percent(energy(ours)),
                ReportNumbers.radii(ours.value(Metrics.GAS_OVERLAP, "max")),
                faster.isEmpty() ? "none" : String.join(", ", faster));
    boolean gains = all.stream().anyMatch(s -> s.method().equals("dyn4j") && energy(s) > EXPLAINED);
    return new Figure(
        SCENE,
        "A gas of colliding circles",
        title,
        "A gas of 100 elastic circles in four walls, 600 frames. Its energy should not change, and circles should not overlap."
            + (gains
                ? " dyn4j gains energy where a circle has two contacts in one frame: it bounces each by itself, and together they return more than came in. No setting that we tried prevents it."
                : ""),
        List.of(),
        Column.table(
            all,
            Column.SHORT_SETTING,
            Column.time("time of a frame", Metrics.FRAME_TIME, "median"),
            Column.ratio("Carom = 1", Metrics.FRAME_TIME, "median"),
            Column.of(
                "energy gained or lost, worst frame",
                Metrics.GAS_ENERGY,
                "max",
                ReportNumbers::percent),
            Column.of(
                "deepest overlap, in radii", Metrics.GAS_OVERLAP, "max", ReportNumbers::error),
            Column.of("circles lost, of 100", Metrics.GAS_LOST, "circles", ReportNumbers::count)));
  }

  private static double energy(Standing s) {
    return s.value(Metrics.GAS_ENERGY, "max");
  }
}
