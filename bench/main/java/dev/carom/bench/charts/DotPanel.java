// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoubleFunction;

/**
 * Work against precision of one scene or one class of queries: a dot for each setting, those of one
 * method joined, whiskers over forks, the staircase of those that nothing beats in both. What
 * failed stands in a gutter at the right, what has no error at all in one at the left.
 */
final class DotPanel {

  private static final double GUTTER = 0.13;
  private static final double DOT = 6;
  private static final double WHISKER = 3;
  private static final double SIDE_BY_SIDE = 2.4 * DOT;

  private final Graphics2D g;
  private final Axes axes;
  private final DecadeAxis errors;
  private final Marks marks;
  private final List<Dot> dots;
  private final DotLabels labels;
  private final DotNames names = new DotNames();
  private DoubleFunction<String> workText = value -> Durations.number(value, 3);

  private DotPanel(Graphics2D g, Axes axes, DecadeAxis errors, Marks marks, List<Dot> dots) {
    this.g = g;
    this.axes = axes;
    this.errors = errors;
    this.marks = marks;
    this.dots = dots;
    Rectangle2D a = axes.area();
    labels =
        new DotLabels(
            new Rectangle2D.Double(
                a.getX() + 2, a.getY() + 2, a.getWidth() - 4, a.getHeight() - 4));
  }

  /** An axis of errors with the gutters that these dots need. */
  static DecadeAxis errors(List<Dot> dots, String label) {
    DecadeAxis axis =
        DecadeAxis.covering(
            dots.stream().filter(dot -> !dot.failed()).mapToDouble(Dot::error), DotPanel::power);
    axis.setLabel(label);
    boolean exact = dots.stream().anyMatch(Dot::exact);
    boolean failed = dots.stream().anyMatch(Dot::failed);
    return axis.withGutters(exact ? GUTTER : 0, failed ? GUTTER : 0);
  }

  private static String power(double value) {
    double exponent = Math.log10(value);
    return Math.abs(exponent) < 3.5 ? Durations.number(value, 1) : "1e" + Math.round(exponent);
  }

  /** Draws a panel; the budget is a height marked by a line, NaN for none. */
  static void draw(
      Graphics2D g,
      Rectangle2D where,
      DecadeAxis errors,
      DecadeAxis work,
      Marks marks,
      List<Dot> dots,
      double budget) {
    Axes axes = Axes.draw(g, where, errors, work);
    DotPanel panel = new DotPanel(g, axes, errors, marks, dots);
    panel.workText = work::text;
    panel.gutters();
    panel.budget(budget);
    panel.staircase();
    panel.lines();
    panel.dots();
    panel.names.addTo(panel.labels);
    panel.labels.draw(g);
  }

  private void gutters() {
    Rectangle2D a = axes.area();
    if (dots.stream().anyMatch(Dot::exact)) {
      gutter(a.getMinX(), axes.x(errors.least()), "0");
    }
    if (dots.stream().anyMatch(Dot::failed)) {
      gutter(axes.x(errors.most()), a.getMaxX(), "failed");
    }
  }

  private void gutter(double left, double right, String text) {
    Rectangle2D a = axes.area();
    g.setColor(Style.PAPER);
    g.fill(new Rectangle2D.Double(left, a.getY(), right - left, a.getHeight()));
    g.setFont(Style.bold(11));
    g.setColor(Style.QUIET);
    double width = g.getFontMetrics().stringWidth(text);
    double x = (left + right - width) / 2;
    g.drawString(text, (float) x, (float) (a.getMaxY() - 6));
    labels.avoid(new Rectangle2D.Double(x, a.getMaxY() - 17, width, 14));
  }

  private void budget(double budget) {
    if (Double.isNaN(budget)) {
      return;
    }
    axes.level(g, budget, Style.VERMILION, Style.dashes(Style.FIRM, 9, 5));
    double level = axes.y(budget);
    labels.avoid(axes.area().getMinX(), level, axes.area().getMaxX(), level);
    String text = "budget " + Durations.text(budget, 4);
    g.setFont(Style.bold(12));
    double width = g.getFontMetrics().stringWidth(text);
    double y = level - 6;
    Rectangle2D box = new Rectangle2D.Double(axes.x(errors.most()) - width - 8, y - 12, width, 18);
    while (isTaken(box) && box.getX() - width > axes.area().getMinX()) {
      box.setRect(box.getX() - width / 2, box.getY(), width, box.getHeight());
    }
    g.drawString(text, (float) box.getX(), (float) y);
    labels.avoid(box);
  }

  /** Whether a dot, or the whisker of one, is there. */
  private boolean isTaken(Rectangle2D box) {
    return dots.stream()
        .anyMatch(
            dot ->
                new Rectangle2D.Double(x(dot) - DOT, y(dot) - DOT, 2 * DOT, 2 * DOT)
                    .intersects(box));
  }

  private double x(Dot dot) {
    if (dot.failed()) {
      return aside(dot);
    }
    return dot.exact() ? (axes.x(errors.least()) + axes.area().getMinX()) / 2 : axes.x(dot.error());
  }

  /** Failures stand side by side from left to right, so that none covers another. */
  private double aside(Dot dot) {
    List<Dot> failed = dots.stream().filter(Dot::failed).toList();
    double left = axes.x(errors.most()) + DOT + 2;
    double right = axes.area().getMaxX() - DOT - 2;
    double each = Math.min(SIDE_BY_SIDE, (right - left) / Math.max(1, failed.size() - 1));
    double first = (left + right - (failed.size() - 1) * each) / 2;
    return first + failed.indexOf(dot) * each;
  }

  /** Something that took no time at all cannot be had: what has none stands at the top. */
  private double y(Dot dot) {
    return Double.isFinite(dot.work()) ? axes.y(dot.work()) : axes.area().getMinY() + 2 * DOT;
  }

  /** From the left, each step down to the next dot that is the cheapest so far. */
  private void staircase() {
    List<double[]> steps = new ArrayList<>();
    for (Dot dot : dots.stream().filter(d -> !d.failed()).sorted(byError()).toList()) {
      double y = y(dot);
      double last = steps.isEmpty() ? axes.area().getMinY() : steps.get(steps.size() - 1)[1];
      if (y > last) {
        steps.add(new double[] {x(dot), last});
        steps.add(new double[] {x(dot), y});
      }
    }
    if (!steps.isEmpty()) {
      double last = steps.get(steps.size() - 1)[1];
      boolean failed = dots.stream().anyMatch(Dot::failed);
      double end = failed ? axes.x(errors.most()) : axes.area().getMaxX();
      steps.add(new double[] {end, last});
      double[][] points = steps.toArray(double[][]::new);
      axes.line(g, points, Style.QUIET, Style.dashes(Style.THIN, 2, 4));
      avoid(points);
    }
  }

  private static Comparator<Dot> byError() {
    return Comparator.comparingDouble(Dot::error).thenComparingDouble(Dot::work);
  }

  private void lines() {
    for (List<Dot> ofMethod : byMethod().values()) {
      List<Dot> shown = ofMethod.stream().filter(dot -> !dot.failed()).toList();
      double[][] points =
          shown.stream().map(dot -> new double[] {x(dot), y(dot)}).toArray(double[][]::new);
      String method = ofMethod.get(0).method();
      axes.line(g, points, Style.veil(marks.of(method).color(), 0.55), marks.of(method).stroke());
      avoid(points);
    }
  }

  private void avoid(double[][] points) {
    for (int i = 1; i < points.length; i++) {
      labels.avoid(points[i - 1][0], points[i - 1][1], points[i][0], points[i][1]);
    }
  }

  private Map<String, List<Dot>> byMethod() {
    Map<String, List<Dot>> byMethod = new LinkedHashMap<>();
    for (Dot dot : dots) {
      byMethod.computeIfAbsent(dot.method(), none -> new ArrayList<>()).add(dot);
    }
    return byMethod;
  }

  /** Ours last, on top. */
  private void dots() {
    byMethod().values().stream()
        .sorted(Comparator.comparing(ofMethod -> Marks.isOurs(ofMethod.get(0).method())))
        .forEach(this::dots);
    byMethod().values().forEach(this::name);
  }

  private void dots(List<Dot> ofMethod) {
    for (Dot dot : ofMethod) {
      whisker(dot);
      tail(dot);
    }
    for (Dot dot : ofMethod) {
      Hover.over(g, text(dot), () -> mark(dot));
      labels.avoid(x(dot), y(dot), DOT);
    }
  }

  private void name(List<Dot> ofMethod) {
    Dot last = ofMethod.get(ofMethod.size() - 1);
    names.add(x(last), y(last), marks.name(last.method()));
  }

  private void mark(Dot dot) {
    if (dot.failed()) {
      marks.drawFailure(g, dot.method(), x(dot), y(dot));
    } else {
      marks.draw(g, dot.method(), x(dot), y(dot), dot.hollow());
    }
  }

  private String text(Dot dot) {
    String work = Double.isFinite(dot.work()) ? workText.apply(dot.work()) : "no time";
    String error = dot.failed() ? "failed" : error(dot.error());
    return (marks.name(dot.method()) + " " + dot.knob()).strip() + ": " + work + ", " + error;
  }

  private static String error(double value) {
    return value == 0 || (value > 1e-3 && value < 1e6)
        ? Durations.number(value, 2)
        : String.format(Locale.ROOT, "%.1e", value);
  }

  /** To the left, down to the error that only few are above. */
  private void tail(Dot dot) {
    if (dot.failed() || dot.exact() || !(dot.usual() < dot.error())) {
      return;
    }
    double from = axes.x(Math.max(errors.least(), dot.usual()));
    double y = y(dot);
    g.setColor(Style.veil(marks.of(dot.method()).color(), 0.7));
    g.setStroke(Style.line(Style.THIN));
    g.draw(new Line2D.Double(from, y, x(dot), y));
    g.draw(new Line2D.Double(from, y - WHISKER, from, y + WHISKER));
    labels.avoid(from, y, x(dot), y);
  }

  /** Below the dot in the gutter, too: a failure has a time. */
  private void whisker(Dot dot) {
    if (!(dot.high() > dot.low())) {
      return;
    }
    double x = x(dot);
    double top = axes.y(dot.high());
    double bottom = axes.y(dot.low());
    g.setColor(marks.of(dot.method()).color());
    g.setStroke(Style.line(Style.THIN));
    g.draw(new Line2D.Double(x, top, x, bottom));
    g.draw(new Line2D.Double(x - WHISKER, top, x + WHISKER, top));
    g.draw(new Line2D.Double(x - WHISKER, bottom, x + WHISKER, bottom));
    labels.avoid(x, top, x, bottom);
  }
}
