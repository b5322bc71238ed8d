// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.report.FirstScreen.Tile;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.CellOutcome;
import dev.carom.bench.stability.FailureMap;
import dev.carom.bench.stability.Survey;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Methods by maps: in how many cells each stays within 0.001 and within 0.1 radius. */
final class StabilityMatrix {

  private static final String FINE = "0.001";
  static final String COARSE = "0.1";

  private final Results results;
  private final List<FailureMap> maps;

  StabilityMatrix(Results results) {
    this.results = results;
    List<String> played = results.scenes(Survey.OUTCOME);
    maps =
        FailureMap.all(false).stream()
            .filter(map -> played.contains(Survey.SCENE + map.name()))
            .toList();
  }

  boolean isEmpty() {
    return maps.isEmpty();
  }

  private List<Setting> settings() {
    return Settings.sorted(
        maps.stream()
            .flatMap(map -> results.settings(scene(map), Survey.OUTCOME).stream())
            .distinct()
            .toList());
  }

  private static String scene(FailureMap map) {
    return Survey.SCENE + map.name();
  }

  private int cells(FailureMap map, Setting setting) {
    return results.series(scene(map), setting, Survey.OUTCOME, Survey.CELL).size();
  }

  /** One that has no code for the scenes of a map has no share there. */
  private boolean plays(FailureMap map, Setting setting) {
    return results.settings(scene(map), Survey.OUTCOME).contains(setting)
        && !results.settings(scene(map), ReportRun.FAILURE).contains(setting);
  }

  /** NaN if it was not counted; the finer one can be told from the classes. */
  private double within(FailureMap map, Setting setting, String limit) {
    double counted = results.value(scene(map), setting, Survey.WITHIN, limit);
    if (!Double.isNaN(counted) || limit.equals(COARSE)) {
      return counted;
    }
    return results.series(scene(map), setting, Survey.OUTCOME, Survey.CELL).values().stream()
        .filter(outcome -> outcome == CellOutcome.RIGHT.ordinal())
        .count();
  }

  /** A row for each setting, a column for each map, and one for all that it plays. */
  ReportTable table() {
    List<String> head = new ArrayList<>(List.of("right at 0.001 and at 0.1 radius"));
    maps.forEach(map -> head.add(map.heading()));
    head.add("all it plays");
    ReportTable.Builder table = new ReportTable.Builder(head);
    for (Setting setting : settings()) {
      List<String> row = new ArrayList<>(List.of(Metrics.shortName(setting)));
      maps.forEach(map -> row.add(plays(map, setting) ? share(List.of(map), setting) : "-"));
      row.add(share(played(setting), setting));
      table.row(row);
    }
    return table.build();
  }

  private List<FailureMap> played(Setting setting) {
    return maps.stream().filter(map -> plays(map, setting)).toList();
  }

  private String share(List<FailureMap> some, Setting setting) {
    String coarse = percent(some, setting, COARSE);
    return percent(some, setting, FINE) + (coarse.isEmpty() ? "" : " | " + coarse);
  }

  private double sum(List<FailureMap> some, Setting setting, String limit) {
    return some.stream().mapToDouble(map -> within(map, setting, limit)).sum();
  }

  private int cells(List<FailureMap> some, Setting setting) {
    return some.stream().mapToInt(map -> cells(map, setting)).sum();
  }

  private String percent(List<FailureMap> some, Setting setting, String limit) {
    double right = sum(some, setting, limit);
    int all = cells(some, setting);
    return Double.isNaN(right) || all == 0 ? "" : StabilityWords.share((int) right, all);
  }

  /** The conclusion. */
  String title() {
    return best()
        .map(
            next ->
                "%s is right in %s of the small scenes; next is %s, with %s of those that it plays"
                    .formatted(
                        "Carom",
                        percent(maps, Metrics.CAROM, FINE),
                        Metrics.shortName(next),
                        percent(played(next), next, FINE)))
        .orElse("Where methods are right");
  }

  private Optional<Setting> best() {
    return best(s -> !s.equals(Metrics.CAROM));
  }

  private Optional<Setting> best(Predicate<Setting> who) {
    return settings().stream()
        .filter(s -> who.test(s) && !played(s).isEmpty())
        .max(Comparator.comparingDouble(s -> sum(played(s), s, FINE) / cells(played(s), s)));
  }

  /** The third tile. */
  Optional<Tile> tile() {
    if (isEmpty() || !settings().contains(Metrics.CAROM)) {
      return Optional.empty();
    }
    String rivals =
        Stream.of(best(), best(Metrics::isEngine), best(s -> s.method().equals("poster")))
            .flatMap(Optional::stream)
            .distinct()
            .map(
                s ->
                    (Metrics.isEngine(s) ? "best engine, " : "")
                        + Metrics.shortName(s)
                        + ": "
                        + percent(played(s), s, FINE))
            .collect(Collectors.joining("; "));
    String share = percent(maps, Metrics.CAROM, FINE);
    String what =
        "of %s small scenes right to 0.001 radius"
            .formatted(ReportNumbers.count(cells(maps, Metrics.CAROM)));
    return Optional.of(new Tile("Stability", share, what, rivals));
  }
}
