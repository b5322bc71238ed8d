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
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Where methods fail: maps of small scenes, one panel a method. */
public final class StabilityFigures {

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
    List<CellLimit> limits = limits(map);
    FailureMapChart chart =
        new FailureMapChart(
            words.caption(map.heading()),
            Settings.marks(results),
            side(map, map.x(), Survey.X),
            side(map, map.y(), Survey.Y),
            legend(limits),
            limits.stream().map(limit -> limit != CellLimit.NONE).toList(),
            tallies.stream().filter(MapTally::played).map(StabilityFigures::panel).toList());
    return new Figure(
        "fails-" + map.name(),
        "Where methods fail: " + map.heading(),
        new MapFailure(map, tallies, ofMap(map, Survey.X)).title() + words.title(),
        map.run() + " " + judged(limits) + words.absent(),
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
        .map(s -> new MapTally(s, outcomes(scene, s), limits, !cannot.contains(s)))
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

  private static String judged(List<CellLimit> limits) {
    String classes =
        Stream.of(CellOutcome.values())
            .map(outcome -> outcome.label() + ": " + outcome.meaning())
            .collect(Collectors.joining("; "));
    String corner =
        reached(limits).stream().map(CellLimit::meaning).collect(Collectors.joining(", or "));
    return "At the end of every frame, "
        + classes
        + (corner.isEmpty() ? "." : ". Dark corner: " + corner + ".");
  }

  private static List<String> legend(List<CellLimit> limits) {
    List<String> legend = new ArrayList<>();
    Arrays.stream(CellOutcome.values()).forEach(outcome -> legend.add(outcome.label()));
    if (!reached(limits).isEmpty()) {
      legend.add("beyond the limits");
    }
    return legend;
  }

  private static List<CellLimit> reached(List<CellLimit> limits) {
    return limits.stream().filter(limit -> limit != CellLimit.NONE).distinct().sorted().toList();
  }
}
