// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.List;

/**
 * The answers of one setting to yes/no questions, over all classes that it was asked in.
 *
 * @param wrong missed hits and false hits
 * @param total how many questions it was asked
 */
record Answers(Setting setting, double wrong, double total) {

  static Answers ours(Results results) {
    return of(results, Metrics.CAROM);
  }

  /** Those of all settings, in their order. */
  static List<Answers> all(Results results) {
    List<Setting> asked =
        results.scenes(Metrics.DECISIONS).stream()
            .flatMap(scene -> results.settings(scene, Metrics.DECISIONS).stream())
            .distinct()
            .toList();
    return Settings.sorted(asked).stream().map(setting -> of(results, setting)).toList();
  }

  private static Answers of(Results results, Setting setting) {
    return new Answers(
        setting,
        sum(results, setting, Metrics.MISSED) + sum(results, setting, Metrics.INVENTED),
        sum(results, setting, Metrics.DECISIONS));
  }

  private static double sum(Results results, Setting setting, String metric) {
    return results.scenes(metric).stream()
        .flatMap(scene -> results.only(scene, setting, metric).stream())
        .mapToDouble(Spread::middle)
        .sum();
  }

  boolean asked() {
    return total > 0;
  }

  /** How many are wrong of how many, and what that proves. */
  String text() {
    return ReportNumbers.failures(wrong, total);
  }
}
