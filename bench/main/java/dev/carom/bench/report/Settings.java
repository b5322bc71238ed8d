// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Marks;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;

/** The order in which settings are told, however they were measured: carom first, knobs upwards. */
final class Settings {

  static final Comparator<Setting> ORDER =
      Comparator.comparing((Setting s) -> !s.method().equals(Metrics.OURS))
          .thenComparing(Setting::method)
          .thenComparing(s -> !s.knob().isEmpty() && !Glossary.isDefault(s))
          .thenComparingDouble(Settings::number)
          .thenComparing(Setting::knob);

  private Settings() {}

  /** Whether a method stands in charts, not only in tables. */
  static boolean isDrawn(Setting setting) {
    return Glossary.isDrawn(setting.method());
  }

  static List<Setting> sorted(Collection<Setting> settings) {
    return settings.stream()
        .filter(setting -> !setting.method().equals(Metrics.NEIGHBOUR))
        .sorted(ORDER)
        .toList();
  }

  /** Marks that do not depend on the order of the rows. */
  static Marks marks(Results results) {
    return new Marks(
        results.methods().stream().filter(Glossary::isDrawn).sorted().toList(), Glossary::name);
  }

  private static double number(Setting setting) {
    try {
      return Double.parseDouble(setting.value());
    } catch (NumberFormatException e) {
      return Double.POSITIVE_INFINITY; // words after numbers
    }
  }
}
