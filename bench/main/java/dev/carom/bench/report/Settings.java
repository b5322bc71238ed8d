// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Marks;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The order in which settings are told, however they were measured: carom first, knobs upwards. */
final class Settings {

  private static final Comparator<Setting> ORDER =
      Comparator.comparing((Setting s) -> !s.method().equals(Metrics.OURS))
          .thenComparing(Setting::method)
          .thenComparing(s -> !s.knob().isEmpty() && !Metrics.isDefault(s))
          .thenComparingDouble(Settings::number)
          .thenComparing(Setting::knob);

  /**
   * Methods that charts leave out, since each says what another one says: a chart of a dozen marks
   * is not read. All tables have them.
   */
  private static final Set<String> IN_TABLES_ONLY =
      Set.of(
          "advancement",
          "closest-point",
          "overlap",
          "poster-double",
          "substeps",
          "textbook-double",
          "textbook-float",
          "textbook-grid");

  private Settings() {}

  /** Whether a method stands in charts, not only in tables. */
  static boolean isDrawn(Setting setting) {
    return !IN_TABLES_ONLY.contains(setting.method());
  }

  static List<Setting> of(Results results, String scene, String metric) {
    return sorted(results.settings(scene, metric));
  }

  static List<Setting> sorted(Collection<Setting> settings) {
    List<Setting> sorted = new ArrayList<>(settings);
    sorted.removeIf(setting -> setting.method().equals(Metrics.NEIGHBOUR));
    sorted.sort(ORDER);
    return sorted;
  }

  /**
   * One setting of each method, the one with the least error in a scene: for charts that have no
   * room for all. Where there is no error to go by, the last one.
   */
  static List<Setting> finest(Results results, String scene, String metric) {
    Map<String, Setting> finest = new LinkedHashMap<>();
    for (Setting setting : of(results, scene, metric)) {
      finest.merge(
          setting.method(),
          setting,
          (best, other) ->
              error(results, scene, best) < error(results, scene, other) ? best : other);
    }
    return List.copyOf(finest.values());
  }

  private static double error(Results results, String scene, Setting setting) {
    double error = results.value(scene, setting, Metrics.FRAME_ERROR, "max");
    return Double.isNaN(error) ? Double.POSITIVE_INFINITY : error;
  }

  /** Marks that do not depend on the order of the rows. */
  static Marks marks(Results results) {
    return new Marks(
        results.methods().stream().filter(m -> !IN_TABLES_ONLY.contains(m)).sorted().toList(),
        Glossary::name);
  }

  private static double number(Setting setting) {
    try {
      return Double.parseDouble(setting.value());
    } catch (NumberFormatException e) {
      return Double.POSITIVE_INFINITY; // words after numbers
    }
  }
}
