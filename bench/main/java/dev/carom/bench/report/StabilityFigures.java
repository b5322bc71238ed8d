// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.FailureMapChart;
import dev.carom.bench.charts.FailureMapChart.Board;
import dev.carom.bench.charts.FailureMapChart.Side;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.Axis;
import dev.carom.bench.stability.CellLimit;
import dev.carom.bench.stability.CellOutcome;
import dev.carom.bench.stability.FailureMap;
import dev.carom.bench.stability.Survey;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BinaryOperator;
import java.util.stream.Collectors;

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
    Standing any = new Standing(results, Survey.SCENE + map.name(), tallies.get(0).setting());
    List<Boolean> dark =
        MapTally.values(any, Survey.LIMIT).stream()
            .map(limit -> limit != CellLimit.NONE.ordinal())
            .toList();
    StabilityMatrix matrix = new StabilityMatrix(tallies);
    List<Board> boards = drawn(tallies, matrix).stream().map(StabilityFigures::board).toList();
    String title = matrix.title();
    FailureMapChart chart =
        new FailureMapChart(
            title,
            Settings.marks(results),
            side(any, map.x(), Survey.X),
            side(any, map.y(), Survey.Y),
            legend(boards, dark),
            dark,
            boards);
    return Figure.of(
        PREFIX + map.name(),
        title,
        List.of(new Panel("", chart.picture())),
        ReportTable.NONE,
        map.heading(),
        map.run(),
        absent(tallies));
  }

  private static Side side(Standing any, Axis axis, String metric) {
    return new Side(
        axis.label(), MapTally.values(any, metric).stream().map(axis.text()::apply).toList());
  }

  private static Board board(MapTally tally) {
    return new Board(
        tally.setting().method(),
        Glossary.shortKnob(tally.setting()),
        MapTally.share(List.of(tally)),
        tally.outcomes());
  }

  /** Who the title names, and of each other method that is drawn its best setting. */
  private static Collection<MapTally> drawn(List<MapTally> tallies, StabilityMatrix matrix) {
    List<Setting> named = matrix.rivals();
    Map<String, MapTally> best = new LinkedHashMap<>();
    tallies.stream()
        .filter(MapTally::played)
        .filter(tally -> Settings.isDrawn(tally.setting()) || named.contains(tally.setting()))
        .forEach(
            tally ->
                best.merge(
                    tally.setting().method(),
                    tally,
                    BinaryOperator.maxBy(Comparator.comparing(List::of, MapTally.BY_RIGHT))));
    return best.values();
  }

  /** The classes that occur, then the dark corner; nothing in place of the others. */
  private static List<String> legend(List<Board> boards, List<Boolean> dark) {
    List<String> legend = new ArrayList<>();
    for (CellOutcome outcome : CellOutcome.values()) {
      boolean occurs = boards.stream().anyMatch(b -> b.classes().contains(outcome.ordinal()));
      legend.add(occurs ? WORDS.get(outcome) : "");
    }
    legend.add(dark.contains(true) ? "nobody can be right" : "");
    return legend;
  }

  /** A sentence about those who have no panel, or nothing. */
  private static String absent(List<MapTally> tallies) {
    String names =
        tallies.stream()
            .filter(t -> !t.played())
            .map(tally -> Glossary.name(tally.setting().method()))
            .distinct()
            .collect(Collectors.joining(", "));
    return names.isEmpty() ? "" : " " + names + " cannot play such scenes.";
  }
}
