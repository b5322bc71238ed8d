// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * How one setting did in one scene.
 *
 * @param setting the method and its knob
 * @param error its worst error of one frame in radii; NaN if it failed
 * @param time of a frame: the medians of the forks
 */
record Standing(Setting setting, double error, Spread time) {

  private static final Spread NO_TIME = new Spread(Double.NaN, Double.NaN, Double.NaN, 0, 0);

  /** All settings of a scene for which there is an error or a time. */
  static List<Standing> all(Results results, String scene) {
    return Stream.concat(
            results.settings(scene, Metrics.FRAME_ERROR).stream(),
            results.settings(scene, Metrics.FRAME_TIME).stream())
        .distinct()
        .filter(setting -> !setting.method().equals(Metrics.NEIGHBOUR))
        .map(setting -> of(results, scene, setting))
        .toList();
  }

  static Optional<Standing> ours(List<Standing> all) {
    return all.stream().filter(s -> s.setting.equals(Metrics.CAROM)).findFirst();
  }

  private static Standing of(Results results, String scene, Setting setting) {
    return new Standing(
        setting,
        results.value(scene, setting, Metrics.FRAME_ERROR, "max"),
        results.spread(scene, setting, Metrics.FRAME_TIME, "median").orElse(NO_TIME));
  }

  boolean failed() {
    return !Double.isFinite(error) || time.failed();
  }

  boolean isFasterThan(Standing other) {
    return time.isBelow(other.time);
  }

  /** Neither is surely faster. */
  boolean isLevelWith(Standing other) {
    return !failed() && !other.failed() && !isFasterThan(other) && !other.isFasterThan(this);
  }

  boolean isMoreAccurateThan(Standing other) {
    return error < other.error || (!Double.isNaN(error) && Double.isNaN(other.error));
  }

  boolean beats(Standing other) {
    return isFasterThan(other) && isMoreAccurateThan(other);
  }
}
