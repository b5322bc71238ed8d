// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.report.FirstScreen.Tile;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.FailureMap;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Methods by maps: in how many cells each stays within 0.001 and within 0.1 radius. */
final class StabilityMatrix {

  private final List<FailureMap> maps = new ArrayList<>();

  /** Of each setting the maps that it plays, by name. */
  private final Map<Setting, Map<String, MapTally>> played = new LinkedHashMap<>();

  StabilityMatrix(Results results) {
    for (FailureMap map : FailureMap.all(false)) {
      List<MapTally> tallies = MapTally.of(results, map);
      if (!tallies.isEmpty()) {
        maps.add(map);
      }
      tallies.stream()
          .filter(MapTally::played)
          .forEach(
              t ->
                  played
                      .computeIfAbsent(t.setting(), none -> new LinkedHashMap<>())
                      .put(map.name(), t));
    }
  }

  /** A table, if Carom played a map. */
  List<Figure> figures() {
    if (!played.containsKey(Metrics.CAROM)) {
      return List.of();
    }
    String next =
        best(s -> true)
            .map(
                s ->
                    "; next is %s, with %s of those that it plays"
                        .formatted(Glossary.shortName(s), share(s)))
            .orElse("");
    return List.of(
        new Figure(
            "stability",
            "Share of scenes that are right",
            "Carom is right in %s of the small scenes%s".formatted(share(Metrics.CAROM), next),
            "Six maps: each of their cells is a small scene, judged against its true course. The table has the share of scenes in which no circle was ever more than 0.001 radius off, and the share for 0.1 radius. A dark corner marks scenes in which no method can promise to be right: their course multiplies the rounding of doubles beyond 0.001 radius, or impacts pile up without end.",
            List.of(),
            table()));
  }

  private String share(Setting setting) {
    return MapTally.share(played.get(setting).values());
  }

  /** A row for each setting, a column for each map, and one for all that it plays. */
  private ReportTable table() {
    List<String> head = new ArrayList<>(List.of("right at 0.001 and at 0.1 radius"));
    maps.forEach(map -> head.add(map.heading()));
    head.add("all it plays");
    return new ReportTable(head, Settings.sorted(played.keySet()).stream().map(this::row).toList());
  }

  private List<String> row(Setting setting) {
    Map<String, MapTally> tallies = played.get(setting);
    List<String> row = new ArrayList<>(List.of(Glossary.shortName(setting)));
    for (FailureMap map : maps) {
      MapTally tally = tallies.get(map.name());
      row.add(tally == null ? "-" : MapTally.shares(List.of(tally)));
    }
    row.add(MapTally.shares(tallies.values()));
    return row;
  }

  /** Of all others the one that is right in the largest part of what it plays. */
  private Optional<Setting> best(Predicate<Setting> who) {
    return Settings.sorted(played.keySet()).stream()
        .filter(setting -> !setting.equals(Metrics.CAROM) && who.test(setting))
        .max(Comparator.comparingDouble(this::right));
  }

  private double right(Setting setting) {
    Collection<MapTally> tallies = played.get(setting).values();
    return (double) tallies.stream().mapToInt(MapTally::right).sum()
        / tallies.stream().mapToInt(MapTally::cells).sum();
  }

  /** The third tile. */
  Optional<Tile> tile() {
    if (!played.containsKey(Metrics.CAROM)) {
      return Optional.empty();
    }
    String rivals =
        Stream.of(
                best(s -> true),
                best(Glossary::isEngine),
                best(s -> s.method().equals(FirstScreen.PUBLISHED)))
            .flatMap(Optional::stream)
            .distinct()
            .map(
                s ->
                    (Glossary.isEngine(s) ? "best engine, " : "")
                        + Glossary.shortName(s)
                        + ": "
                        + share(s))
            .collect(Collectors.joining("; "));
    int cells = played.get(Metrics.CAROM).values().stream().mapToInt(MapTally::cells).sum();
    return Optional.of(
        new Tile(
            "Stability",
            share(Metrics.CAROM),
            "of %s small scenes right to 0.001 radius".formatted(ReportNumbers.count(cells)),
            rivals));
  }
}
