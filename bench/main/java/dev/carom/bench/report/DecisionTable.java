// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.ArrayList;
import java.util.List;

/** Wrong answers to yes/no questions: a row for each method, a column for each class. */
final class DecisionTable {

  private final Results results;
  private final List<String> scenes;

  DecisionTable(Results results) {
    this.results = results;
    scenes = results.scenes(Metrics.DECISIONS);
  }

  private double number(String scene, Setting setting, String metric) {
    return results.only(scene, setting, metric).map(Spread::middle).orElse(Double.NaN);
  }

  /** Missed hits and false hits; none of n stands with the share that it proves. */
  ReportTable table() {
    List<String> head = new ArrayList<>(List.of("missed | false hits"));
    scenes.forEach(scene -> head.add(Metrics.queryClass(scene)));
    ReportTable.Builder table = new ReportTable.Builder(head);
    List<Setting> settings =
        Settings.sorted(
            scenes.stream()
                .flatMap(scene -> results.settings(scene, Metrics.DECISIONS).stream())
                .distinct()
                .toList());
    for (Setting setting : settings) {
      List<String> row = new ArrayList<>(List.of(Metrics.shortName(setting)));
      scenes.forEach(scene -> row.add(cell(scene, setting)));
      table.row(row);
    }
    return table.build();
  }

  private String cell(String scene, Setting setting) {
    double missed = number(scene, setting, Metrics.MISSED);
    double invented = number(scene, setting, Metrics.INVENTED);
    if (Double.isNaN(missed + invented)) {
      return "not asked";
    }
    return missed + invented == 0
        ? "0 of " + ReportNumbers.count(number(scene, setting, Metrics.DECISIONS))
        : ReportNumbers.count(missed) + " | " + ReportNumbers.count(invented);
  }

  /** By decades of the share that is wrong, so that one in ten thousand is told from one in ten. */
  String heat(String cell) {
    if (!cell.contains("|")) {
      return "";
    }
    String[] parts = cell.replace(",", "").split(" \\| ", -1);
    double wrong = Double.parseDouble(parts[0]) + Double.parseDouble(parts[1]);
    double most =
        scenes.stream()
            .mapToDouble(scene -> number(scene, Metrics.CAROM, Metrics.DECISIONS))
            .max()
            .orElse(Double.NaN);
    double share = wrong / most;
    return share < 0.001 ? "h1" : share < 0.01 ? "h2" : share < 0.1 ? "h3" : "h4";
  }
}
