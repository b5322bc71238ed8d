// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.stability.CellLimit;
import dev.carom.bench.stability.CellOutcome;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A map of failures in words and in a table, made by rule from its numbers. */
final class StabilityWords {

  private static final int MOST_NAMES = 3;

  private final List<MapTally> tallies;

  /**
   * Takes the tallies of all methods, of this library too, whether or not they could play the map.
   */
  StabilityWords(List<MapTally> tallies) {
    this.tallies = tallies;
  }

  private MapTally ours() {
    return tallies.get(0);
  }

  String title() {
    int wrong = ours().wrongWithin();
    String scenes =
        ReportNumbers.count(ours().within())
            + " scenes"
            + (isLimited() ? " within its limits" : "");
    String whole =
        wrong == 0
            ? "Carom is right in all " + scenes
            : "Carom is wrong in %s of %s".formatted(ReportNumbers.count(wrong), scenes);
    int cells = ours().outcomes().size();
    if (isLimited()) { // others are counted in all
      whole +=
          ", and right in %s of all %s"
              .formatted(share(ours().count(CellOutcome.RIGHT), cells), ReportNumbers.count(cells));
    }
    Optional<MapTally> engine = best(t -> Metrics.isEngine(t.setting()));
    List<String> rest = new ArrayList<>();
    // No engine is praised or blamed where something simpler does better: that is named, too.
    best(t -> !Metrics.isEngine(t.setting()) && Settings.isDrawn(t.setting()))
        .filter(t -> engine.isEmpty() || MapTally.BY_RIGHT.compare(t, engine.get()) > 0)
        .ifPresent(t -> rest.add(Metrics.shortName(t.setting()) + " in " + right(t)));
    engine.ifPresent(
        t -> rest.add("the best engine, " + Metrics.shortName(t.setting()) + ", in " + right(t)));
    return rest.isEmpty() ? whole : whole + "; " + String.join("; ", rest);
  }

  private Optional<MapTally> best(Predicate<MapTally> who) {
    return tallies.stream().skip(1).filter(t -> t.played() && who.test(t)).max(MapTally.BY_RIGHT);
  }

  /** Where none is right, a coarser limit tells more. */
  private static String right(MapTally t) {
    int n = t.outcomes().size();
    int right = t.count(CellOutcome.RIGHT);
    return share(right, n)
        + (right == 0 && t.coarse() > 0
            ? " (to 0.1 radius " + share((int) t.coarse(), n) + ")"
            : "");
  }

  /** One sentence. */
  String caption(String heading) {
    String ours =
        "Wrong cells of %s%s, by %s: %s"
            .formatted(
                Glossary.name(ours().setting().method()),
                isLimited() ? " within its limits" : "",
                heading,
                ReportNumbers.failures(ours().wrongWithin(), ours().within()));
    return ours + beyond() + others() + cannot() + ".";
  }

  private boolean isLimited() {
    return ours().within() < ours().outcomes().size();
  }

  private String beyond() {
    StringBuilder text = new StringBuilder();
    for (CellLimit limit : CellLimit.values()) {
      int cells = ours().count(outcome -> true, limit::equals);
      if (limit != CellLimit.NONE && cells > 0) {
        text.append(
            "; in %d more, where %s, it is right in %d"
                .formatted(
                    cells,
                    limit.meaning(),
                    ours().count(CellOutcome.RIGHT::equals, limit::equals)));
      }
    }
    return text.toString();
  }

  private String others() {
    List<MapTally> others = tallies.stream().skip(1).filter(MapTally::played).toList();
    if (others.isEmpty()) {
      return "";
    }
    int most = others.stream().mapToInt(t -> t.count(CellOutcome.RIGHT)).max().orElseThrow();
    int least = others.stream().mapToInt(t -> t.count(CellOutcome.RIGHT)).min().orElseThrow();
    int n = ours().outcomes().size();
    String all =
        "; of all %d cells it is right in %s, "
            .formatted(n, share(ours().count(CellOutcome.RIGHT), n));
    if (most == least) {
      return all + "each of the others in " + share(most, n);
    }
    return all
        + "of the others %s in most, %s, and %s in fewest, %s"
            .formatted(names(others, most), share(most, n), names(others, least), share(least, n));
  }

  private static String names(List<MapTally> tallies, int right) {
    List<String> names =
        tallies.stream()
            .filter(t -> t.count(CellOutcome.RIGHT) == right)
            .map(t -> Metrics.shortName(t.setting()))
            .toList();
    return names.size() > MOST_NAMES ? names.size() + " settings" : String.join(", ", names);
  }

  private String cannot() {
    String names = unplayed();
    return names.isEmpty() ? "" : "; such scenes cannot be played by " + names;
  }

  /** A sentence about those who have no panel, or nothing. */
  String absent() {
    String names = unplayed();
    return names.isEmpty() ? "" : " " + names + " cannot play such scenes.";
  }

  private String unplayed() {
    return tallies.stream()
        .filter(t -> !t.played())
        .map(t -> Metrics.shortName(t.setting()))
        .collect(Collectors.joining(", "));
  }

  /** Shares of each class, and the wrong ones within the limits. */
  static ReportTable table(List<MapTally> tallies) {
    List<String> head = new ArrayList<>(List.of("setting"));
    Stream.of(CellOutcome.values()).forEach(outcome -> head.add(outcome.label()));
    head.add("wrong within the limits");
    ReportTable.Builder table = new ReportTable.Builder(head);
    for (MapTally tally : tallies) {
      List<String> row = new ArrayList<>(List.of(Metrics.shortName(tally.setting())));
      for (CellOutcome outcome : CellOutcome.values()) {
        row.add(tally.played() ? share(tally.count(outcome), tally.outcomes().size()) : "-");
      }
      row.add(
          tally.played()
              ? ReportNumbers.failures(tally.wrongWithin(), tally.within())
              : "cannot play such scenes");
      table.row(row);
    }
    return table.build();
  }

  /** To a tenth of a percent; all and none only if it is. */
  static String share(int part, int whole) {
    if (part == 0 || part == whole) {
      return part == 0 ? "0 %" : "100 %";
    }
    return String.format(
        Locale.ROOT, "%.1f %%", Math.max(0.1, Math.min(99.9, 100.0 * part / whole)));
  }
}
