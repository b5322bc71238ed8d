// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.report.ScaleTimes.Per;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.series.Growth;
import dev.carom.bench.series.Scale;
import dev.carom.bench.series.ScalePlan.Model;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** How times and memory grow with the number of circles, in sentences. */
final class ScaleGrowth {

  private static final int LEAST_POINTS = 3;
  private static final String ENGINE = "gdx-box2d";

  private final Results results;
  private final ScaleTimes times;

  ScaleGrowth(Results results) {
    this.results = results;
    times = new ScaleTimes(results);
  }

  /** The fit of all places that have a time, if there are enough. */
  private static Optional<Growth> fit(Curve curve) {
    int n = (int) Arrays.stream(curve.middle()).filter(v -> !Double.isNaN(v)).count();
    return n < LEAST_POINTS
        ? Optional.empty()
        : Optional.of(Growth.of(Arrays.copyOf(curve.x(), n), Arrays.copyOf(curve.middle(), n)));
  }

  private static String power(Growth fit) {
    return String.format(
        Locale.ROOT,
        "to the power %.2f (%.2f .. %.2f at 95 %%)",
        fit.slope(),
        fit.low(),
        fit.high());
  }

  /** For each model and method, how the time of a frame grows, and of an impact. */
  List<String> sentences() {
    List<String> sentences = new ArrayList<>();
    for (Model model : Model.values()) {
      for (Per per : List.of(Per.FRAME, Per.IMPACT)) {
        for (Curve curve : times.curves(model, per)) {
          fit(curve)
              .ifPresent(
                  fit ->
                      sentences.add(
                          "%s: %s, the time of %s grows with the circles %s."
                              .formatted(
                                  model.label(),
                                  new Setting(Glossary.name(curve.method()), curve.knob()),
                                  per.words,
                                  power(fit))));
        }
      }
    }
    return sentences;
  }

  /** The memory of a world, or nothing if it was not measured. */
  Optional<String> memory() {
    return results.scenes(Scale.MEMORY).stream()
        .findFirst()
        .map(
            scene ->
                String.format(
                    Locale.ROOT,
                    "A world of %s circles and lines takes %.0f bytes a circle and %.0f a line.",
                    ReportNumbers.count(
                        Double.parseDouble(scene.substring(scene.indexOf('=') + 1))),
                    results.value(scene, Metrics.CAROM, Scale.MEMORY, "circle"),
                    results.value(scene, Metrics.CAROM, Scale.MEMORY, "line")));
  }

  /** How many circles a frame may have. */
  String title() {
    String ours = within(Metrics.OURS);
    String theirs = within(ENGINE);
    return ours.isEmpty()
        ? "Time against the number of circles"
        : "At 60 frames a second Carom moves "
            + ours
            + (theirs.isEmpty() ? "" : "; " + Glossary.name(ENGINE) + " " + theirs);
  }

  private String within(String method) {
    List<String> all = new ArrayList<>();
    for (Model model : Model.values()) {
      times
          .within(model, method, 1e6 * Budget.MILLIS)
          .ifPresent(n -> all.add(n + (model == Model.GAS ? " that collide" : " circles")));
    }
    return String.join(", or ", all);
  }

  /** The growth of carom in each model, and the methods that became too slow. */
  String verdict() {
    List<String> models = new ArrayList<>();
    List<String> late = new ArrayList<>();
    for (Model model : Model.values()) {
      for (Curve curve : times.curves(model, Per.FRAME)) {
        int last = curve.x().length - 1;
        if (curve.method().equals(Metrics.OURS)) {
          fit(curve).ifPresent(fit -> models.add(ours(model, curve, fit)));
        }
        if (Double.isNaN(curve.middle()[last])) {
          late.add(
              "%s at %s (%s)"
                  .formatted(
                      Glossary.name(curve.method()),
                      ReportNumbers.count(curve.x()[last]),
                      model == Model.GAS ? "colliding" : "alone"));
        }
      }
    }
    if (models.isEmpty()) {
      return "Growth: not measured.";
    }
    String whole = "Growth: the time of a frame of Carom grows " + String.join("; ", models);
    return late.isEmpty()
        ? whole + "."
        : whole + "; too slow to go on: " + String.join(", ", late) + ".";
  }

  private static String ours(Model model, Curve curve, Growth fit) {
    int last = curve.x().length - 1;
    return "with %s %s, up to %s for %s"
        .formatted(
            model.words(),
            power(fit),
            ReportNumbers.time(curve.middle()[last]),
            ReportNumbers.count(curve.x()[last]));
  }
}
