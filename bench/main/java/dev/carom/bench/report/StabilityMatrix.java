// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.report.FirstScreen.Tile;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.FailureMap;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Methods by maps: in how many cells each stays within 0.001 and within 0.1 radius. */
public final class StabilityMatrix {

  /** Of each setting the maps that it plays. */
  private final Map<Setting, List<MapTally>> played;

  /**
   * Takes what is shown.
   *
   * @param results what was measured
   */
  public StabilityMatrix(Results results) {
    this(
        FailureMap.all(false).stream().flatMap(map -> MapTally.of(results, map).stream()).toList());
  }

  StabilityMatrix(List<MapTally> tallies) {
    played =
        tallies.stream()
            .filter(MapTally::played)
            .collect(
                Collectors.groupingBy(
                    MapTally::setting, () -> new TreeMap<>(Settings.ORDER), Collectors.toList()));
  }

  /** A table, if Carom played a map. */
  List<Figure> figures() {
    if (!played.containsKey(Metrics.CAROM)) {
      return List.of();
    }
    return List.of(Figure.of("stability", title(), List.of(), table()));
  }

  /** How Carom does, and the best of the others. */
  String title() {
    return "Carom is right in %s of %s scenes; %s".formatted(share(Metrics.CAROM), cells(), told());
  }

  private String cells() {
    return ReportNumbers.count(MapTally.cells(played.get(Metrics.CAROM)));
  }

  private static String name(Setting setting) {
    return Glossary.shortName(setting);
  }

  private String share(Setting setting) {
    return MapTally.share(played.get(setting));
  }

  /** A row for each setting, a column for each map, and one for all that it plays. */
  public ReportTable table() {
    List<String> maps =
        played.values().stream()
            .flatMap(List::stream)
            .map(tally -> tally.map().heading())
            .distinct()
            .toList();
    List<String> head = new ArrayList<>(List.of("right at 0.001 and at 0.1 radius"));
    head.addAll(maps);
    head.add("all it plays");
    return new ReportTable(
        head, played.keySet().stream().map(setting -> row(setting, maps)).toList());
  }

  private List<String> row(Setting setting, List<String> maps) {
    List<MapTally> tallies = played.get(setting);
    List<String> row = new ArrayList<>(List.of(name(setting)));
    for (String map : maps) {
      row.add(
          tallies.stream()
              .filter(tally -> tally.map().heading().equals(map))
              .findFirst()
              .map(tally -> MapTally.shares(List.of(tally)))
              .orElse("-"));
    }
    row.add(MapTally.shares(tallies));
    return row;
  }

  /** Of all others the one that is right in the largest part of what it plays. */
  private Optional<Setting> best(Predicate<Setting> who) {
    return played.keySet().stream()
        .filter(setting -> !setting.equals(Metrics.CAROM) && who.test(setting))
        .max(
            Comparator.<Setting, List<MapTally>>comparing(played::get, MapTally.BY_RIGHT)
                .thenComparing(Settings::isDrawn));
  }

  /** The third tile. */
  Optional<Tile> tile() {
    if (!played.containsKey(Metrics.CAROM)) {
      return Optional.empty();
    }
    return Optional.of(
        new Tile(
            "Stability",
            share(Metrics.CAROM),
            "of %s small scenes right to 0.001 radius".formatted(cells()),
            told()));
  }

  /** The best of the others, the best engine, and the published method. */
  List<Setting> rivals() {
    return Stream.of(
            best(s -> true),
            best(Glossary::isEngine),
            best(s -> s.method().equals(FirstScreen.PUBLISHED)))
        .flatMap(Optional::stream)
        .distinct()
        .toList();
  }

  private String told() {
    return rivals().stream().map(this::rival).collect(Collectors.joining("; "));
  }

  private String rival(Setting setting) {
    String who = (Glossary.isEngine(setting) ? "best engine, " : "") + name(setting);
    return who + ": " + share(setting);
  }
}
