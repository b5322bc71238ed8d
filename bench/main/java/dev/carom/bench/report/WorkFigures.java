// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Dot;
import dev.carom.bench.charts.DotChart;
import dev.carom.bench.charts.FrameStripsChart;
import dev.carom.bench.charts.FrameStripsChart.Strip;
import dev.carom.bench.charts.Marks;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Charts of speed against accuracy, a large one and small ones, and one of all frames. */
final class WorkFigures {

  private static final double BUDGET = 1e6 * Budget.MILLIS;

  /** So many of the other scenes are drawn; the table has all. */
  private static final int PANELS = 4;

  private static final Column[] COLUMNS = {
    Column.SETTING,
    Column.SCENE,
    Column.time("median time of a frame", Metrics.FRAME_TIME, "median"),
    Column.ratio("Carom = 1", Metrics.FRAME_TIME, "median"),
    Column.of("99 %", Metrics.FRAME_TIME, "p99", ReportNumbers::time),
    Column.of("worst", Metrics.FRAME_TIME, "worst", ReportNumbers::time),
    Column.of("error: worst", Metrics.FRAME_ERROR, "max", ReportNumbers::error),
    Column.of("99.9 %", Metrics.FRAME_ERROR, "p99.9", ReportNumbers::error),
    Column.of("tunnelled", "tunnelled", "circles", ReportNumbers::count),
    Column.of("outside at the end", "outside_at_end", "circles", ReportNumbers::count),
    Column.of("penetration", "penetration", "max", ReportNumbers::error),
    Column.of("energy", "energy_drift", "max", ReportNumbers::error),
    Column.of("reversal", "reversal_error", "max", ReportNumbers::error),
  };

  private final Results results;
  private final Marks marks;

  WorkFigures(Results results) {
    this.results = results;
    marks = Settings.marks(results);
  }

  /** The chart of the first scene, with that of questions beside it, then one of all others. */
  List<Figure> figures() {
    List<String> timed =
        results.scenes(Metrics.FRAME_ERROR).stream()
            .filter(scene -> dots(scene).stream().anyMatch(dot -> !Double.isNaN(dot.time())))
            .toList();
    Stream<Figure> first = timed.stream().limit(1).map(this::first);
    return timed.size() < 2
        ? first.toList()
        : Stream.concat(first, Stream.of(others(timed.subList(1, timed.size())))).toList();
  }

  private Figure first(String scene) {
    String title =
        title("Nothing measured is both faster and more accurate than Carom", List.of(scene));
    Stream<Panel> panels =
        Stream.concat(
            chart(title, Map.of("A frame" + Scenes.size(scene), dots(scene)))
                .panels(DotChart.TALL)
                .stream(),
            new QuestionFigures(results).decisions().stream());
    return Figure.of("work-" + scene, title, panels.toList(), table(List.of(scene)));
  }

  private Figure others(List<String> scenes) {
    Map<String, List<Dot>> panels = new LinkedHashMap<>();
    scenes.stream().limit(PANELS).forEach(scene -> panels.put(Scenes.title(scene), dots(scene)));
    String title =
        title(
            "In the other scenes, too, nothing measured is both faster and more accurate", scenes);
    return Figure.of("work", title, chart(title, panels).panels(DotChart.SMALL), table(scenes));
  }

  private String title(String unbeaten, List<String> scenes) {
    List<String> better = Standing.better(results, scenes);
    return better.isEmpty()
        ? unbeaten
        : "Both faster and more accurate than Carom: " + String.join(", ", better);
  }

  private DotChart chart(String title, Map<String, List<Dot>> panels) {
    List<String> axes = List.of("worst error of one frame, in radii", "median time of a frame");
    return new DotChart(title, marks, axes, BUDGET, panels);
  }

  /** One for each method that is drawn, at the setting that errs least. */
  private List<Dot> dots(String scene) {
    return Standing.drawn(results, scene, Metrics.FRAME_ERROR).stream()
        .map(
            s ->
                new Dot(
                    s.method(),
                    Glossary.shortKnob(s.setting()),
                    s.error(),
                    s.time().low(),
                    s.time().middle(),
                    s.time().high()))
        .toList();
  }

  private ReportTable table(List<String> scenes) {
    return Column.table(
        scenes.stream().flatMap(scene -> Standing.all(results, scene).stream()).toList(), COLUMNS);
  }

  /** All frame times of a replay of each method in the first scene, against the budget. */
  List<Figure> frames() {
    return results.scenes(Metrics.FRAME_RAW).stream().limit(1).map(this::frames).toList();
  }

  private Figure frames(String scene) {
    List<Strip> strips =
        Standing.drawn(results, scene, Metrics.FRAME_RAW).stream()
            .map(s -> new Strip(s.method(), Glossary.shortKnob(s.setting()), nanos(s)))
            .filter(strip -> strip.nanos().length > 0)
            .toList();
    Strip first = strips.get(0);
    String title =
        "%s's slowest of %s frames takes %s of the 16.67 ms allowed"
            .formatted(
                Glossary.name(first.method()),
                ReportNumbers.count(first.nanos().length),
                ReportNumbers.time(Arrays.stream(first.nanos()).max().orElseThrow()));
    Panel panel = new Panel("", new FrameStripsChart(title, marks, strips, BUDGET).picture());
    return Figure.of("frames", title, List.of(panel), ReportTable.NONE, Scenes.size(scene));
  }

  private static double[] nanos(Standing s) {
    return s.results().series(s.scene(), s.setting(), Metrics.FRAME_RAW, "frame").values().stream()
        .mapToDouble(nanos -> nanos)
        .filter(nanos -> !Double.isNaN(nanos))
        .toArray();
  }
}
