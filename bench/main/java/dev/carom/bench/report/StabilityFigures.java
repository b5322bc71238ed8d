// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.FailureMapChart;
import dev.carom.bench.charts.FailureMapChart.Board;
import dev.carom.bench.charts.FailureMapChart.Side;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import dev.carom.bench.stability.Axis;
import dev.carom.bench.stability.CellLimit;
import dev.carom.bench.stability.CellOutcome;
import dev.carom.bench.stability.FailureMap;
import dev.carom.bench.stability.Survey;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BinaryOperator;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Where methods fail: maps of small scenes, one panel a method. */
public final class StabilityFigures {

  /** Of the ids of all its figures. */
  static final String PREFIX = "fails-";

  /** Short enough for a legend. */
  private static final Map<CellOutcome, String> WORDS =
      Map.of(
          CellOutcome.RIGHT, "right (to 0.001 radius)",
          CellOutcome.DRIFTED, "up to 1 radius off",
          CellOutcome.FAR_OFF, "further off",
          CellOutcome.LOST_SPEED, "wrong speed",
          CellOutcome.ESCAPED, "through a line",
          CellOutcome.NO_ANSWER, "no answer");

  private final Results results;

  /**
   * Takes what is drawn.
   *
   * @param results what was measured
   */
  public StabilityFigures(Results results) {
    this.results = results;
  }

  /** The maps that the results have. */
  public List<Figure> figures() {
    return FailureMap.all(false).stream()
        .map(map -> MapTally.of(results, map))
        .filter(tallies -> !tallies.isEmpty())
        .map(this::figure)
        .toList();
  }

  private Figure figure(List<MapTally> tallies) {
    FailureMap map = tallies.get(0).map();
    List<CellLimit> limits = tallies.get(0).limits();
    List<Board> boards = drawn(tallies).stream().map(StabilityFigures::board).toList();
    String title = title(tallies);
    FailureMapChart chart =
        new FailureMapChart(
            title,
            Settings.marks(results),
            side(map, map.x(), Survey.X),
            side(map, map.y(), Survey.Y),
            legend(boards, limits),
            limits.stream().map(limit -> limit != CellLimit.NONE).toList(),
            boards);
    return new Figure(
        PREFIX + map.name(),
        "Where methods fail: " + map.heading(),
        title,
        map.run()
            + " Each small square is one such scene, and the number above how many are right."
            + absent(tallies),
        List.of(new Panel("", chart.picture())),
        table(tallies));
  }

  private Side side(FailureMap map, Axis axis, String metric) {
    return new Side(
        axis.label(),
        MapTally.values(results, map, metric).stream().map(axis.text()::apply).toList());
  }

  private static Board board(MapTally tally) {
    return new Board(
        tally.setting().method(),
        Glossary.shortKnob(tally.setting()),
        MapTally.share(List.of(tally)),
        tally.outcomes().stream().map(CellOutcome::ordinal).toList());
  }

  /** Of each method the setting that is right most often, to 0.001 radius, then to 0.1. */
  private static Collection<MapTally> drawn(List<MapTally> tallies) {
    Map<String, MapTally> best = new LinkedHashMap<>();
    tallies.stream()
        .filter(tally -> tally.played() && Settings.isDrawn(tally.setting()))
        .forEach(
            tally ->
                best.merge(
                    tally.setting().method(), tally, BinaryOperator.maxBy(MapTally.BY_RIGHT)));
    return best.values();
  }

  /** The classes that occur, then the dark corner; nothing in place of the others. */
  private static List<String> legend(List<Board> boards, List<CellLimit> limits) {
    List<String> legend = new ArrayList<>();
    for (CellOutcome outcome : CellOutcome.values()) {
      boolean occurs = boards.stream().anyMatch(b -> b.classes().contains(outcome.ordinal()));
      legend.add(occurs ? WORDS.get(outcome) : "");
    }
    boolean limited = limits.stream().anyMatch(limit -> limit != CellLimit.NONE);
    legend.add(limited ? "nobody can be right" : "");
    return legend;
  }

  /** No engine is praised or blamed where something simpler does better: that is named, too. */
  private static String title(List<MapTally> tallies) {
    Optional<MapTally> engine = best(tallies, t -> Glossary.isEngine(t.setting()));
    Optional<MapTally> simpler =
        best(tallies, t -> !Glossary.isEngine(t.setting()) && Settings.isDrawn(t.setting()))
            .filter(t -> engine.isEmpty() || MapTally.BY_RIGHT.compare(t, engine.get()) > 0);
    return Stream.of(
            Optional.of(ours(tallies.get(0))),
            simpler.map(t -> t.name() + " in " + right(t)),
            engine.map(t -> "the best engine, " + t.name() + ", in " + right(t)))
        .flatMap(Optional::stream)
        .collect(Collectors.joining("; "));
  }

  private static String ours(MapTally ours) {
    boolean limited = ours.within() < ours.cells();
    String scenes =
        ReportNumbers.count(ours.within()) + " scenes" + (limited ? " within its limits" : "");
    String words =
        ours.wrongWithin() == 0
            ? "Carom is right in all " + scenes
            : "Carom is wrong in %s of %s"
                .formatted(ReportNumbers.count(ours.wrongWithin()), scenes);
    return limited // others are counted in all
        ? "%s, and right in %s of all %s"
            .formatted(words, MapTally.share(List.of(ours)), ReportNumbers.count(ours.cells()))
        : words;
  }

  private static Optional<MapTally> best(List<MapTally> tallies, Predicate<MapTally> who) {
    return tallies.stream().skip(1).filter(t -> t.played() && who.test(t)).max(MapTally.BY_RIGHT);
  }

  /** Where none is right, a coarser limit tells more. */
  private static String right(MapTally t) {
    String share = MapTally.share(List.of(t));
    return t.right() == 0 && t.coarse() > 0
        ? share + " (to 0.1 radius " + ReportNumbers.share(t.coarse(), t.cells()) + ")"
        : share;
  }

  /** A sentence about those who have no panel, or nothing. */
  private static String absent(List<MapTally> tallies) {
    String names =
        tallies.stream()
            .filter(t -> !t.played())
            .map(MapTally::name)
            .collect(Collectors.joining(", "));
    return names.isEmpty() ? "" : " " + names + " cannot play such scenes.";
  }

  /** Shares of each class, and the wrong ones within the limits, of all who can play. */
  private static ReportTable table(List<MapTally> tallies) {
    List<String> head = new ArrayList<>(List.of("setting"));
    Stream.of(CellOutcome.values()).map(CellOutcome::label).forEach(head::add);
    head.add("wrong within the limits");
    return new ReportTable(
        head, tallies.stream().filter(MapTally::played).map(StabilityFigures::row).toList());
  }

  private static List<String> row(MapTally tally) {
    List<String> row = new ArrayList<>(List.of(tally.name()));
    for (CellOutcome outcome : CellOutcome.values()) {
      row.add(ReportNumbers.share(tally.count(outcome), tally.cells()));
    }
    row.add(ReportNumbers.failures(tally.wrongWithin(), tally.within()));
    return row;
  }
}
