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
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Where methods fail: maps of small scenes, one panel a method. */
public final class StabilityFigures {

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
    List<String> played = results.scenes(Survey.LIMIT);
    return FailureMap.all(false).stream()
        .filter(map -> played.contains(Survey.SCENE + map.name()))
        .map(this::figure)
        .toList();
  }

  private Figure figure(FailureMap map) {
    List<MapTally> tallies = tallies(map);
    StabilityWords words = new StabilityWords(tallies);
    List<Board> boards = drawn(tallies).stream().map(StabilityFigures::panel).toList();
    List<CellLimit> limits = limits(map);
    FailureMapChart chart =
        new FailureMapChart(
            words.caption(map.heading()),
            Settings.marks(results),
            side(map, map.x(), Survey.X),
            side(map, map.y(), Survey.Y),
            legend(boards, limits),
            limits.stream().map(limit -> limit != CellLimit.NONE).toList(),
            boards);
    return new Figure(
        "fails-" + map.name(),
        "Where methods fail: " + map.heading(),
        words.title(),
        map.run()
            + " Each small square is one such scene, and the number above how many are right."
            + words.absent(),
        words.caption(map.heading()),
        List.of(new Panel("", chart.picture())),
        StabilityWords.table(tallies));
  }

  /** Those who play the map, then those who cannot. */
  private List<MapTally> tallies(FailureMap map) {
    String scene = Survey.SCENE + map.name();
    List<Setting> cannot = results.settings(scene, ReportRun.FAILURE);
    List<CellLimit> limits = limits(map);
    return Settings.of(results, scene, Survey.OUTCOME).stream()
        .map(
            s ->
                new MapTally(
                    s,
                    outcomes(scene, s),
                    limits,
                    results.value(scene, s, Survey.WITHIN, StabilityMatrix.COARSE),
                    !cannot.contains(s)))
        .sorted((a, b) -> Boolean.compare(b.played(), a.played()))
        .toList();
  }

  private List<CellOutcome> outcomes(String scene, Setting setting) {
    CellOutcome[] all = CellOutcome.values();
    return series(scene, setting, Survey.OUTCOME).stream().map(i -> all[i.intValue()]).toList();
  }

  private List<CellLimit> limits(FailureMap map) {
    CellLimit[] all = CellLimit.values();
    return ofMap(map, Survey.LIMIT).stream().map(i -> all[i.intValue()]).toList();
  }

  /** Values of a metric that depends on the map only, not on the method. */
  private Collection<Double> ofMap(FailureMap map, String metric) {
    String scene = Survey.SCENE + map.name();
    return series(scene, results.settings(scene, metric).get(0), metric);
  }

  private Collection<Double> series(String scene, Setting setting, String metric) {
    return results.series(scene, setting, metric, Survey.CELL).values();
  }

  private Side side(FailureMap map, Axis axis, String metric) {
    return new Side(axis.label(), ofMap(map, metric).stream().map(axis.text()::apply).toList());
  }

  private static Board panel(MapTally tally) {
    Setting setting = tally.setting();
    return new Board(
        setting.method(),
        Metrics.shortKnob(setting),
        StabilityWords.share(tally.count(CellOutcome.RIGHT), tally.outcomes().size()),
        tally.outcomes().stream().map(CellOutcome::ordinal).toList());
  }

  /** Of each method the setting that is right most often, to 0.001 radius, then to 0.1. */
  private static Collection<MapTally> drawn(List<MapTally> tallies) {
    Map<String, MapTally> best = new LinkedHashMap<>();
    tallies.stream()
        .filter(tally -> tally.played() && Settings.isDrawn(tally.setting()))
        .forEach(tally -> best.merge(tally.setting().method(), tally, StabilityFigures::better));
    return best.values();
  }

  private static MapTally better(MapTally one, MapTally other) {
    return MapTally.BY_RIGHT.compare(other, one) > 0 ? other : one;
  }

  /** The classes that occur, then the dark corner; nothing in place of the others. */
  private static List<String> legend(List<Board> boards, List<CellLimit> limits) {
    List<String> legend = new ArrayList<>();
    for (CellOutcome outcome : CellOutcome.values()) {
      boolean occurs = boards.stream().anyMatch(b -> b.classes().contains(outcome.ordinal()));
      legend.add(occurs ? WORDS.get(outcome) : "");
    }
    legend.add(reached(limits).isEmpty() ? "" : "nobody can be right");
    return legend;
  }

  private static List<CellLimit> reached(List<CellLimit> limits) {
    return limits.stream().filter(limit -> limit != CellLimit.NONE).distinct().sorted().toList();
  }
}
