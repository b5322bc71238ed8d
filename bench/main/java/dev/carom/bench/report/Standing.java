// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiPredicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * How one setting did in one scene.
 *
 * @param setting the method and its knob
 */
record Standing(Results results, String scene, Setting setting) {

  private static final Spread NO_TIME = new Spread(Double.NaN, Double.NaN, Double.NaN, 0, 0);

  /** All settings of a scene for which one of these metrics was measured, in their order. */
  static List<Standing> of(Results results, String scene, String... metrics) {
    return Settings.sorted(
            Stream.of(metrics)
                .flatMap(metric -> results.settings(scene, metric).stream())
                .distinct()
                .toList())
        .stream()
        .map(setting -> new Standing(results, scene, setting))
        .toList();
  }

  /** Carom in each scene in which a metric was measured. */
  static List<Standing> ours(Results results, String metric) {
    return results.scenes(metric).stream()
        .map(scene -> new Standing(results, scene, Metrics.CAROM))
        .toList();
  }

  /** All settings of a scene for which there is an error or a time. */
  static List<Standing> all(Results results, String scene) {
    return of(results, scene, Metrics.FRAME_ERROR, Metrics.FRAME_TIME);
  }

  /**
   * One setting of each method, the one with the least error in a scene: for charts that have no
   * room for all. Where there is no error to go by, the last one.
   */
  static Collection<Standing> drawn(Results results, String scene, String metric) {
    Map<String, Standing> finest = new LinkedHashMap<>();
    of(results, scene, metric).stream()
        .filter(s -> Settings.isDrawn(s.setting))
        .forEach(s -> finest.merge(s.method(), s, (a, b) -> a.isMoreAccurateThan(b) ? a : b));
    return finest.values();
  }

  static Optional<Standing> ours(List<Standing> all) {
    return all.stream().filter(Standing::isOurs).findFirst();
  }

  /** Who compares with Carom in a way, and where: method, setting and scene. */
  static List<String> who(
      Results results, List<String> scenes, BiPredicate<Standing, Standing> compares) {
    return scenes.stream()
        .map(scene -> new Standing(results, scene, Metrics.CAROM))
        .flatMap(
            ours ->
                ours.others()
                    .filter(other -> compares.test(other, ours))
                    .map(other -> Glossary.fullName(other.setting) + " in " + other.scene))
        .toList();
  }

  /** Who is both faster and more accurate than Carom, and where. */
  static List<String> better(Results results, List<String> scenes) {
    return who(results, scenes, Standing::beats);
  }

  /** All other settings in the same scene. */
  Stream<Standing> others() {
    return all(results, scene).stream().filter(other -> !other.setting.equals(setting));
  }

  /** Who is surely faster than Carom by a stat of the times of frames, in words. */
  static String faster(List<Standing> all, String stat) {
    Optional<Spread> ours = ours(all).flatMap(s -> s.spread(Metrics.FRAME_TIME, stat));
    String names =
        all.stream()
            .filter(s -> ours.isPresent())
            .filter(
                s ->
                    s.spread(Metrics.FRAME_TIME, stat).stream()
                        .anyMatch(t -> t.isBelow(ours.get())))
            .map(Standing::name)
            .collect(Collectors.joining(", "));
    return names.isEmpty() ? "none" : names;
  }

  boolean isOurs() {
    return setting.equals(Metrics.CAROM);
  }

  /** Another setting in the same scene. */
  Standing with(Setting other) {
    return new Standing(results, scene, other);
  }

  String method() {
    return setting.method();
  }

  /** The method in words and what stands at its dot. */
  String name() {
    return Glossary.shortName(setting);
  }

  /** The median over forks of one number; NaN if it failed or was not measured. */
  double value(String metric, String stat) {
    return results.value(scene, setting, metric, stat);
  }

  Optional<Spread> spread(String metric, String stat) {
    return results.spread(scene, setting, metric, stat);
  }

  /** The number of a metric that has but one stat; NaN if it failed or was not measured. */
  double only(String metric) {
    return results.only(scene, setting, metric).map(Spread::middle).orElse(Double.NaN);
  }

  /** Its worst error of one frame in radii; NaN if it failed. */
  double error() {
    return value(Metrics.FRAME_ERROR, "max");
  }

  /** The time of a frame: the medians of the forks. */
  Spread time() {
    return spread(Metrics.FRAME_TIME, "median").orElse(NO_TIME);
  }

  boolean failed() {
    return !Double.isFinite(error()) || time().failed();
  }

  boolean isFasterThan(Standing other) {
    return time().isBelow(other.time());
  }

  /** Neither is surely faster. */
  boolean isLevelWith(Standing other) {
    return !failed() && !other.failed() && !isFasterThan(other) && !other.isFasterThan(this);
  }

  boolean isMoreAccurateThan(Standing other) {
    return error() < other.error() || (!Double.isNaN(error()) && Double.isNaN(other.error()));
  }

  boolean beats(Standing other) {
    return isFasterThan(other) && isMoreAccurateThan(other);
  }
}
