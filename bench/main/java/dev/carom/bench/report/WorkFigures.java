// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.BarChart;
import dev.carom.bench.charts.BarChart.Bar;
import dev.carom.bench.charts.Dot;
import dev.carom.bench.charts.DotChart;
import dev.carom.bench.charts.Marks;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/** Charts of speed against accuracy: a large one, and small ones of the other scenes. */
final class WorkFigures {

  private static final String ERROR = "worst error of one frame, in radii";

  /** So many of the other scenes are drawn; the table has all. */
  private static final int PANELS = 4;

  /** Shorter than in the list of all methods: one line for both. */
  private static final Map<String, String> EXPLAINED = new TreeMap<>();

  static {
    EXPLAINED.put("plain-grid", "plain doubles with a grid like Carom's");
    EXPLAINED.put(
        "poster", "the algorithm published then, every circle against every line, in float");
  }

  private final Results results;
  private final Marks marks;

  WorkFigures(Results results) {
    this.results = results;
    marks = Settings.marks(results);
  }

  /** The one of the first scene, with that of questions beside it, then one of all others. */
  List<Figure> figures() {
    List<String> timed =
        results.scenes(Metrics.FRAME_ERROR).stream()
            .filter(scene -> standings(scene).stream().anyMatch(s -> !s.time().failed()))
            .toList();
    List<Figure> figures = new ArrayList<>();
    timed.stream().limit(1).map(this::lead).forEach(figures::add);
    timed.stream().limit(1).flatMap(scene -> engines(scene).stream()).forEach(figures::add);
    if (timed.size() > 1) {
      figures.add(multiples(timed.subList(1, timed.size())));
    }
    return figures;
  }

  private Figure lead(String scene) {
    List<Standing> all = standings(scene);
    String caption =
        "Median time of a frame against the worst error of one frame in %s. ".formatted(scene)
            + caption(all, true);
    List<Panel> panels =
        new ArrayList<>(
            chart(Map.of("A frame" + Scenes.size(scene), dots(scene)), caption)
                .panels(DotChart.TALL));
    new QueryFigures(results).decisions().ifPresent(panels::add);
    return new Figure(
        "work-" + scene,
        "Speed against accuracy",
        title(scene, all),
        "Lower is faster, further left is more accurate. In the shaded area a method would be both faster and more accurate than Carom."
            + new QueryFigures(results).price()
            + explained(),
        caption,
        panels,
        table(List.of(scene)));
  }

  /** What the names of those at the dots mean that do not say it: a sentence, or nothing. */
  private String explained() {
    List<String> told = new ArrayList<>();
    EXPLAINED.forEach(
        (method, what) -> {
          if (results.methods().contains(method)) {
            told.add(Glossary.name(method) + ": " + what);
          }
        });
    return told.isEmpty() ? "" : " " + String.join("; ", told) + ".";
  }

  /** Carom and the engines at their best settings, as bars; none if no engine was timed. */
  private Optional<Figure> engines(String scene) {
    List<Standing> timed =
        standings(scene).stream()
            .filter(s -> !s.time().failed() && !Metrics.isDefault(s.setting()))
            .filter(s -> s.setting().equals(Metrics.CAROM) || isTuned(s))
            .sorted(Comparator.comparingDouble(s -> s.time().middle()))
            .toList();
    Optional<Standing> ours = Standing.ours(timed);
    if (ours.isEmpty() || timed.size() < 2) {
      return Optional.empty();
    }
    List<String> times =
        timed.stream()
            .filter(s -> !s.equals(ours.get()))
            .map(s -> ReportNumbers.count(s.time().middle() / ours.get().time().middle()))
            .toList();
    String title =
        "Carom is %s times as fast as the engines"
            .formatted(
                times.size() == 1
                    ? times.get(0)
                    : times.get(0) + " to " + times.get(times.size() - 1));
    List<Bar> bars =
        timed.stream()
            .map(
                s ->
                    new Bar(
                        Glossary.name(s.setting().method()),
                        marks.color(s.setting().method()),
                        s.time().middle(),
                        ReportNumbers.time(s.time().middle())))
            .toList();
    String note =
        "The median frame of this one scene%s; the circles do not collide with each other. Each engine has the best settings found.";
    return Optional.of(
        new Figure(
            "engines",
            "Carom and three engines",
            title,
            note.formatted(Scenes.size(scene)),
            title + ".",
            List.of(new Panel("", new BarChart(title, bars).picture())),
            table(List.of(scene))));
  }

  private static boolean isTuned(Standing s) {
    return Metrics.shortKnob(s.setting()).equals("tuned");
  }

  private DotChart chart(Map<String, List<Dot>> panels, String caption) {
    return new DotChart(
        caption, marks, List.of(ERROR, "median time of a frame"), 1e6 * Budget.MILLIS, panels);
  }

  /** One for each method that is drawn, at the setting that errs least. */
  private List<Dot> dots(String scene) {
    List<Setting> finest = Settings.finest(results, scene, Metrics.FRAME_ERROR);
    return standings(scene).stream()
        .filter(s -> finest.contains(s.setting()) && Settings.isDrawn(s.setting()))
        .map(
            s ->
                new Dot(
                    s.setting().method(),
                    Metrics.shortKnob(s.setting()),
                    s.error(),
                    s.time().low(),
                    s.time().middle(),
                    s.time().high()))
        .toList();
  }

  private Figure multiples(List<String> scenes) {
    Map<String, List<Dot>> panels = new LinkedHashMap<>();
    scenes.stream().limit(PANELS).forEach(scene -> panels.put(Scenes.words(scene), dots(scene)));
    List<String> beaten =
        scenes.stream()
            .flatMap(
                scene -> {
                  List<Standing> all = standings(scene);
                  return Standing.ours(all).stream()
                      .flatMap(ours -> all.stream().filter(s -> s.beats(ours)))
                      .map(s -> name(s) + " in " + scene);
                })
            .toList();
    String title =
        beaten.isEmpty()
            ? "In the other scenes, too, nothing measured is both faster and more accurate"
            : "Both faster and more accurate than Carom: " + String.join(", ", beaten);
    String caption =
        scenes.stream()
            .map(scene -> "Scene %s: %s".formatted(scene, caption(standings(scene), false)))
            .collect(Collectors.joining(" "));
    return new Figure(
        "work",
        "Speed against accuracy in other scenes",
        title,
        "The same chart for other scenes of 100 circles. Lower is faster, further left is more accurate.",
        ("Median time of a frame against the worst error of one frame. " + caption).strip(),
        chart(panels, "Median time of a frame against the worst error of one frame.")
            .panels(DotChart.SMALL),
        table(scenes));
  }

  private List<Standing> standings(String scene) {
    List<Standing> all = Standing.all(results, scene);
    List<Setting> order = Settings.sorted(all.stream().map(Standing::setting).toList());
    return order.stream()
        .map(
            setting ->
                all.stream().filter(s -> s.setting().equals(setting)).findFirst().orElseThrow())
        .toList();
  }

  private static String title(String scene, List<Standing> all) {
    Optional<Standing> ours = Standing.ours(all);
    if (ours.isEmpty()) {
      return "Speed and accuracy in " + scene;
    }
    List<Standing> beat = all.stream().filter(s -> s.beats(ours.get())).toList();
    return beat.isEmpty()
        ? "Nothing measured is both faster and more accurate than Carom"
        : "Both faster and more accurate than Carom: " + names(beat);
  }

  private static String caption(List<Standing> all, boolean settings) {
    StringBuilder text = new StringBuilder();
    Standing.ours(all)
        .ifPresent(
            ours -> {
              text.append(
                  "Carom: %s, %s radii. "
                      .formatted(
                          ReportNumbers.time(ours.time().middle()),
                          ReportNumbers.error(ours.error())));
              tell(text, "Faster than Carom", all, s -> s.isFasterThan(ours));
              tell(text, "More accurate than Carom", all, s -> s.isMoreAccurateThan(ours));
              tell(
                  text,
                  "Not told apart from it in time",
                  all,
                  s -> !s.equals(ours) && s.isLevelWith(ours));
            });
    tell(text, "Failed", all, Standing::failed);
    return text.append(settings ? peers(all) : worse(all)).toString().strip();
  }

  private static void tell(
      StringBuilder text, String what, List<Standing> all, Predicate<Standing> who) {
    List<Standing> found = all.stream().filter(who).toList();
    text.append(what).append(": ").append(found.isEmpty() ? "none" : names(found)).append(". ");
  }

  private static String names(List<Standing> found) {
    return found.stream().map(WorkFigures::numbers).collect(Collectors.joining(", "));
  }

  private static String numbers(Standing s) {
    String time = ReportNumbers.time(s.time().middle());
    String error = Double.isNaN(s.error()) ? "" : ", " + ReportNumbers.error(s.error()) + " radii";
    return "%s (%s%s)".formatted(name(s), time, error);
  }

  private static String name(Standing s) {
    return Metrics.shortName(s.setting());
  }

  /** The whole setting of a tuned peer, and whether it errs more than at its defaults. */
  private static String peers(List<Standing> all) {
    String tuned =
        all.stream()
            .filter(WorkFigures::isTuned)
            .map(s -> name(s) + ": " + s.setting().value() + errsMore(s, all))
            .collect(Collectors.joining("; "));
    return tuned.isEmpty() ? "" : "Engines: " + tuned + ".";
  }

  private static String errsMore(Standing tuned, List<Standing> all) {
    return isWorse(tuned, all)
        ? " (in this scene its worst error is greater than at its defaults)"
        : "";
  }

  private static boolean isWorse(Standing tuned, List<Standing> all) {
    return all.stream()
        .filter(s -> s.setting().method().equals(tuned.setting().method()))
        .filter(s -> Metrics.isDefault(s.setting()))
        .anyMatch(s -> s.isMoreAccurateThan(tuned));
  }

  /** The tuned peers that err more than at their defaults. */
  private static String worse(List<Standing> all) {
    String names =
        all.stream()
            .filter(s -> isTuned(s) && isWorse(s, all))
            .map(WorkFigures::name)
            .collect(Collectors.joining(", "));
    return names.isEmpty() ? "" : "Worst error greater than at its defaults: " + names + ".";
  }

  private ReportTable table(List<String> scenes) {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "setting",
            "scene",
            "median time of a frame",
            "worst frame",
            "error: worst",
            "99.9 %",
            "median",
            "pair tests",
            "roots",
            "fallbacks",
            "impacts",
            "tunnelled",
            "escaped",
            "outside at the end",
            "penetration",
            "energy",
            "reversal");
    for (String scene : scenes) {
      standings(scene).forEach(s -> row(table, scene, s));
    }
    return table.build();
  }

  private void row(ReportTable.Builder table, String scene, Standing s) {
    table.row(
        Metrics.fullName(s.setting()),
        scene,
        ReportNumbers.spread(s.time()),
        ReportNumbers.time(results.value(scene, s.setting(), Metrics.FRAME_TIME, "worst")),
        ReportNumbers.error(s.error()),
        stat(scene, s, Metrics.FRAME_ERROR, "p99.9"),
        stat(scene, s, Metrics.FRAME_ERROR, "median"),
        only(scene, s, Metrics.PAIR_TESTS),
        only(scene, s, "roots"),
        only(scene, s, "fallbacks"),
        only(scene, s, "impacts"),
        only(scene, s, "tunnelled"),
        only(scene, s, "escaped"),
        only(scene, s, "outside_at_end"),
        stat(scene, s, "penetration", "max"),
        stat(scene, s, "energy_drift", "max"),
        stat(scene, s, "reversal_error", "max"));
  }

  private String stat(String scene, Standing s, String metric, String stat) {
    return results
        .spread(scene, s.setting(), metric, stat)
        .map(spread -> ReportNumbers.error(spread.middle()))
        .orElse("");
  }

  private String only(String scene, Standing s, String metric) {
    return results
        .only(scene, s.setting(), metric)
        .map(spread -> spread.failed() ? "not told" : ReportNumbers.ratio(spread.middle()))
        .orElse("");
  }
}
