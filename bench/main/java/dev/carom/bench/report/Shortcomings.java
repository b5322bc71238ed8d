// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import dev.carom.bench.series.Scale;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiPredicate;

/** Where Carom is not the best, by rule from the data; and what it cannot do, or was not asked. */
final class Shortcomings {

  private static final String REVERSAL = "reversal_error";

  private final Results results;
  private final List<String> told = new ArrayList<>();

  private Shortcomings(Results results) {
    this.results = results;
  }

  static List<String> of(Results results) {
    Shortcomings all = new Shortcomings(results);
    all.scenes("Faster than Carom, though less accurate", Standing::isFasterThan);
    all.scenes("More accurate than Carom", Standing::isMoreAccurateThan);
    all.scenes("As accurate as Carom", (s, ours) -> s.error() == ours.error());
    all.questions();
    results.scenes(Metrics.FRAME_ERROR).forEach(all::leftOut);
    results.scenes(Metrics.HORIZON).forEach(all::horizon);
    results.scenes(REVERSAL).forEach(all::reversal);
    all.told.add(
        results.scenes(Scale.TIME).isEmpty()
            ? "Not measured here: circles that collide with each other, thousands of circles, other"
                + " processors, more than one thread."
            : "Of circles that collide no true course was computed: only energy, overlap, lost circles"
                + " and time were measured; of thousands of circles only time and memory; not measured"
                + " at all: other processors, more than one thread.");
    all.told.add(
        "The engines were set up by us, as well as their documentation allows; they do what Carom"
            + " does not: rotation, friction, polygons, joints.");
    return List.copyOf(all.told);
  }

  private void scenes(String what, BiPredicate<Standing, Standing> who) {
    for (String scene : results.scenes(Metrics.FRAME_ERROR)) {
      List<Standing> all = Standing.all(results, scene);
      Optional<Standing> ours = Standing.ours(all);
      List<String> found =
          all.stream()
              .filter(s -> ours.isPresent() && !s.equals(ours.get()) && who.test(s, ours.get()))
              .map(s -> Metrics.shortName(s.setting()))
              .toList();
      if (!found.isEmpty()) {
        told.add("%s in %s: %s.".formatted(what, scene, String.join(", ", found)));
      }
    }
  }

  /** In how many classes others are faster: what carom pays for answers that are never wrong. */
  private void questions() {
    List<String> classes = results.scenes(Metrics.QUERY_TIME);
    Map<String, Integer> faster = new LinkedHashMap<>();
    double longest = 0;
    for (String scene : classes) {
      Optional<Spread> ours = results.only(scene, Metrics.CAROM, Metrics.QUERY_TIME);
      longest = Math.max(longest, ours.map(Spread::middle).orElse(Double.NaN));
      for (Setting setting : Settings.of(results, scene, Metrics.QUERY_TIME)) {
        if (ours.isPresent() && isFaster(scene, setting, ours.get())) {
          faster.merge(Metrics.shortName(setting), 1, Integer::sum);
        }
      }
    }
    if (!faster.isEmpty()) {
      List<String> all = new ArrayList<>();
      faster.forEach((name, n) -> all.add(name + " in " + n));
      told.add(
          "Of %d classes of single questions, of which Carom's slowest takes %s, others answer faster, though not always rightly: %s."
              .formatted(classes.size(), ReportNumbers.time(longest), String.join(", ", all)));
    }
  }

  private boolean isFaster(String scene, Setting setting, Spread ours) {
    return results
        .only(scene, setting, Metrics.QUERY_TIME)
        .filter(time -> time.isBelow(ours))
        .isPresent();
  }

  /** Lists the methods that played other scenes but not this one. */
  private void leftOut(String scene) {
    List<Setting> here = results.settings(scene, Metrics.FRAME_ERROR);
    List<String> others =
        Settings.sorted(
                results.scenes(Metrics.FRAME_ERROR).stream()
                    .flatMap(other -> results.settings(other, Metrics.FRAME_ERROR).stream())
                    .distinct()
                    .filter(setting -> !here.contains(setting))
                    .toList())
            .stream()
            .map(Metrics::shortName)
            .toList();
    if (!others.isEmpty()) {
      told.add(
          "Left out in %s, though played in other scenes: %s."
              .formatted(scene, String.join(", ", others)));
    }
  }

  private void horizon(String scene) {
    double ours = results.value(scene, Metrics.CAROM, Metrics.HORIZON, "median");
    double limit =
        results.value(scene, new Setting(Metrics.NEIGHBOUR, ""), Metrics.HORIZON, "median");
    if (!Double.isNaN(ours) && !Double.isNaN(limit)) {
      told.add(
          "In %s half of Carom's circles have left the true course by frame %s; of a start that differs in the last bit, by frame %s: no method in doubles follows it much longer."
              .formatted(scene, ReportNumbers.count(ours), ReportNumbers.count(limit)));
    }
  }

  private void reversal(String scene) {
    double error = results.value(scene, Metrics.CAROM, REVERSAL, "max");
    if (!Double.isNaN(error)) {
      told.add(
          "Sent back after some 30 radii of %s, the worst circle of Carom misses its start by %s radii."
              .formatted(scene, ReportNumbers.error(error)));
    }
  }
}
