// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Marks;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;

/** The order in which settings are told, however they were measured: carom first, knobs upwards. */
final class Settings {

  private static final Comparator<Setting> ORDER =
      Comparator.comparing((Setting s) -> !s.method().equals(Metrics.OURS))
          .thenComparing(Setting::method)
          .thenComparing(s -> !s.knob().isEmpty() && !Metrics.isDefault(s))
          .thenComparingDouble(Settings::number)
          .thenComparing(Setting::knob);

  private Settings() {}

  static List<Setting> of(Results results, String scene, String metric) {
    return sorted(results.settings(scene, metric));
  }

  static List<Setting> sorted(Collection<Setting> settings) {
    List<Setting> sorted = new ArrayList<>(settings);
    sorted.removeIf(setting -> setting.method().equals(Metrics.NEIGHBOUR));
    sorted.sort(ORDER);
    return sorted;
  }

  /** Marks that do not depend on the order of the rows. */
  static Marks marks(Results results) {
    return new Marks(results.methods().stream().sorted().toList());
  }

  private static double number(Setting setting) {
    try {
      return Double.parseDouble(setting.value());
    } catch (NumberFormatException e) {
      return Double.POSITIVE_INFINITY; // words after numbers
    }
  }
}
