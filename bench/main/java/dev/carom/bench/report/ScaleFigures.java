// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Course;
import dev.carom.bench.charts.ScaleChart;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.scale.Scale;
import dev.carom.bench.scale.ScalePlan.Model;
import dev.carom.bench.sweep.Growth;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Time per frame, per impact and per circle, against the number of circles. */
public final class ScaleFigures {

  private static final int LEAST_POINTS = 3;

  private final Results results;
  private final double limit;

  /**
   * Prepares the figure.
   *
   * @param results what was measured
   * @param limit the time of a frame that was too long, in nanoseconds
   */
  public ScaleFigures(Results results, double limit) {
    this.results = results;
    this.limit = limit;
  }

  /** What a time is divided by. */
  private enum Per {
    FRAME("a frame"),
    IMPACT("an impact"),
    CIRCLE("a circle and frame");

    private final String words;

    Per(String words) {
      this.words = words;
    }
  }

  /**
   * Makes the figure.
   *
   * @return the figure
   */
  public Figure figure() {
    Map<String, List<Course>> panels = new LinkedHashMap<>();
    for (Model model : Model.values()) {
      for (Per per : Per.values()) {
        List<Course> courses = courses(model, per);
        if (!courses.isEmpty()) {
          panels.put(
              model.words() + ": time of " + per.words,
              courses.stream().map(ScaleFigures::unset).toList());
        }
      }
    }
    String title = "Time against the number of circles";
    ScaleChart chart =
        new ScaleChart(
            title,
            "Line: median; band: from the fastest to the slowest round. A crossed ring: one frame took longer than %s."
                .formatted(Numbers.time(limit)),
            Settings.marks(results),
            panels,
            limit);
    String caption = title + ". " + String.join(" ", growth());
    return new Figure("scale", title, caption, chart::picture, table());
  }

  /** Each method stands there in one setting: it needs no name. */
  private static Course unset(Course c) {
    return new Course(c.method(), "", c.x(), c.low(), c.middle(), c.high());
  }

  /**
   * How the time of a frame, and of an impact, grows with the number of circles.
   *
   * @return a sentence for each model and method
   */
  public List<String> growth() {
    List<String> sentences = new ArrayList<>();
    for (Model model : Model.values()) {
      for (Per per : List.of(Per.FRAME, Per.IMPACT)) {
        for (Course course : courses(model, per)) {
          int n = (int) Arrays.stream(course.middle()).filter(v -> !Double.isNaN(v)).count();
          if (n >= LEAST_POINTS) {
            Growth fit = Growth.of(Arrays.copyOf(course.x(), n), Arrays.copyOf(course.middle(), n));
            sentences.add(
                String.format(
                    Locale.ROOT,
                    "%s: %s, the time of %s grows with the circles to the power %.2f (%.2f .. %.2f at 95 %%).",
                    model.label(),
                    new Setting(course.method(), course.knob()),
                    per.words,
                    fit.slope(),
                    fit.low(),
                    fit.high()));
          }
        }
      }
    }
    return sentences;
  }

  private List<Course> courses(Model model, Per per) {
    Map<Setting, List<Integer>> places = new LinkedHashMap<>();
    String prefix = Scale.SCENE + model.label() + "=";
    for (String scene : results.scenes(Scale.TIME)) {
      if (scene.startsWith(prefix)) {
        int at = Integer.parseInt(scene.substring(prefix.length()));
        for (Setting setting : Settings.of(results, scene, Scale.TIME)) {
          if (per != Per.IMPACT || impacts(scene, setting) > 0) {
            places.computeIfAbsent(setting, none -> new ArrayList<>()).add(at);
          }
        }
      }
    }
    List<Course> courses = new ArrayList<>();
    places.forEach((setting, at) -> courses.add(course(prefix, setting, at, per)));
    return courses;
  }

  private Course course(String prefix, Setting setting, List<Integer> places, Per per) {
    double[] x = places.stream().mapToDouble(i -> i).sorted().toArray();
    double[][] values = new double[3][x.length];
    String[] stats = {"min", "median", "max"};
    for (int i = 0; i < x.length; i++) {
      String scene = prefix + (int) x[i];
      double share =
          switch (per) {
            case FRAME -> 1;
            case IMPACT -> impacts(scene, setting);
            case CIRCLE -> x[i];
          };
      for (int k = 0; k < stats.length; k++) {
        values[k][i] = results.value(scene, setting, Scale.TIME, stats[k]) / share;
      }
    }
    return new Course(setting.method(), setting.knob(), x, values[0], values[1], values[2]);
  }

  /** Not above 0 for a method that does not tell, or did not come so far. */
  private double impacts(String scene, Setting setting) {
    return results.value(scene, setting, Scale.IMPACTS, "mean");
  }

  /**
   * The numbers.
   *
   * @return a row for each scene and method
   */
  public ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "model", "circles", "method", "a frame", "least", "greatest", "an impact", "a circle");
    for (Model model : Model.values()) {
      String prefix = Scale.SCENE + model.label() + "=";
      for (Course course : courses(model, Per.FRAME)) {
        Setting setting = new Setting(course.method(), course.knob());
        for (int i = 0; i < course.x().length; i++) {
          double n = course.x()[i];
          double time = course.middle()[i];
          double impacts = impacts(prefix + (int) n, setting);
          boolean cut = Double.isNaN(time);
          table.row(
              model.label(),
              Numbers.count(n),
              course.method(),
              cut ? "over " + Numbers.time(limit) : Numbers.time(time),
              cut ? "-" : Numbers.time(course.low()[i]),
              cut ? "-" : Numbers.time(course.high()[i]),
              impacts > 0 ? Numbers.time(time / impacts) : "-",
              cut ? "-" : Numbers.time(time / n));
        }
      }
    }
    return table.build();
  }
}
