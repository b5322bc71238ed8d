// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Dot;
import dev.carom.bench.charts.DotChart;
import dev.carom.bench.charts.Marks;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.charts.Picture;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Charts of speed against accuracy: a large one, and small ones of the other scenes. */
final class WorkFigures {

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
  private final QuestionFigures questions;
  private final Marks marks;

  WorkFigures(Results results) {
    this.results = results;
    questions = new QuestionFigures(results);
    marks = Settings.marks(results);
  }

  /** The one of the first scene, with that of questions beside it, then one of all others. */
  List<Figure> figures() {
    List<String> timed =
        results.scenes(Metrics.FRAME_ERROR).stream()
            .filter(scene -> standings(scene).stream().anyMatch(s -> !s.time().failed()))
            .toList();
    List<Figure> figures = new ArrayList<>();
    if (!timed.isEmpty()) {
      figures.add(lead(timed.get(0)));
      figures.addAll(engines(timed.get(0)));
    }
    if (timed.size() > 1) {
      figures.add(others(timed.subList(1, timed.size())));
    }
    return figures;
  }

  private List<Standing> standings(String scene) {
    return Standing.all(results, scene);
  }

  private Figure lead(String scene) {
    String title = title("Nothing measured is both faster and more accurate than Carom", scene);
    List<Panel> panels =
        new ArrayList<>(
            chart(title, Map.of("A frame" + Scenes.size(scene), dots(scene)))
                .panels(DotChart.TALL));
    questions.decisions().ifPresent(panels::add);
    return new Figure(
        "work-" + scene,
        "Speed against accuracy",
        title,
        "Lower is faster, further left is more accurate. In the shaded area a method would be both faster and more accurate than Carom."
            + questions.price()
            + " plain + grid: plain doubles with a grid like Carom's; published 2010: the algorithm published then, every circle against every line, in float.",
        panels,
        table(List.of(scene)));
  }

  /** Carom and the engines at their best settings, as bars; none if no engine was timed. */
  private List<Figure> engines(String scene) {
    List<Standing> timed =
        standings(scene).stream()
            .filter(s -> !s.time().failed() && !Glossary.isDefault(s.setting()))
            .filter(s -> s.isOurs() || Glossary.isEngine(s.setting()))
            .sorted(Comparator.comparingDouble(WorkFigures::middle))
            .toList();
    if (Standing.ours(timed).isEmpty() || timed.size() < 2) {
      return List.of();
    }
    double ours = middle(Standing.ours(timed).get());
    String times =
        ReportNumbers.range(
            timed.stream().filter(s -> !s.isOurs()).mapToDouble(s -> middle(s) / ours),
            ReportNumbers::count);
    String title = "Carom is %s times as fast as the engines".formatted(times);
    String note =
        "The median frame of this one scene%s; the circles do not collide with each other. Each engine has the best settings found.";
    Picture bars =
        Figure.bars(
            title,
            timed,
            s -> Glossary.name(s.method()),
            marks,
            WorkFigures::middle,
            ReportNumbers::time);
    return List.of(
        new Figure(
            "engines",
            "Carom and three engines",
            title,
            note.formatted(Scenes.size(scene)),
            List.of(new Panel("", bars)),
            ReportTable.NONE));
  }

  private static double middle(Standing s) {
    return s.time().middle();
  }

  private DotChart chart(String title, Map<String, List<Dot>> panels) {
    return new DotChart(
        title,
        marks,
        List.of("worst error of one frame, in radii", "median time of a frame"),
        1e6 * Budget.MILLIS,
        panels);
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

  private Figure others(List<String> scenes) {
    Map<String, List<Dot>> panels = new LinkedHashMap<>();
    scenes.stream().limit(PANELS).forEach(scene -> panels.put(Scenes.words(scene), dots(scene)));
    String title =
        title(
            "In the other scenes, too, nothing measured is both faster and more accurate",
            scenes.toArray(String[]::new));
    return new Figure(
        "work",
        "Speed against accuracy in other scenes",
        title,
        "The same chart for other scenes of 100 circles. Lower is faster, further left is more accurate.",
        chart(title, panels).panels(DotChart.SMALL),
        table(scenes));
  }

  private String title(String unbeaten, String... scenes) {
    List<String> better = Standing.better(results, List.of(scenes));
    return better.isEmpty()
        ? unbeaten
        : "Both faster and more accurate than Carom: " + String.join(", ", better);
  }

  private ReportTable table(List<String> scenes) {
    return Column.table(
        scenes.stream().flatMap(scene -> standings(scene).stream()).toList(), COLUMNS);
  }
}
