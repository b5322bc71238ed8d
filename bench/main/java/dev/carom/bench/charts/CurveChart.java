// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.stream.DoubleStream;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.ValueAxis;

/**
 * Lines with bands against a logarithmic height, a panel for each title, all of the same heights;
 * the names of lines stand at their right ends. A value of 0 stands below a break of the axis.
 */
public final class CurveChart {

  /** What is measured upwards. */
  @SuppressWarnings("ImmutableEnumChecker") // each text is made by a function without state
  public enum Unit {
    /** Nanoseconds. */
    TIME(v -> Durations.text(v, 1), v -> Durations.text(v, 3)),
    /** A share, shown in percent. */
    SHARE(v -> Durations.number(100 * v, 2) + " %", v -> Durations.number(100 * v, 2) + " %"),
    /** A number, by its power of ten. */
    POWER(CurveChart::power, v -> Durations.number(v, 3));

    private final DoubleFunction<String> tick;
    private final DoubleFunction<String> exact;

    Unit(DoubleFunction<String> tick, DoubleFunction<String> exact) {
      this.tick = tick;
      this.exact = exact;
    }
  }

  private record Level(double value, String text) {}

  private record Point(double x, double y, String text) {}

  private static final int HEIGHT = 300;
  private static final double NAMES = 140;
  private static final double SPACING = 90;
  private static final int FEW = 3;
  private static final double BAND = 0.18;
  private static final double RING = 16;

  /** From the last decade to the rings beyond it, with the break of the axis half-way. */
  private static final double GAP = 8;

  /** About the height of the floor. */
  private static final double FLOOR = 240;

  private final String description;
  private final Marks marks;
  private final Map<String, List<Curve>> panels;
  private final Unit unit;
  private final String heightLabel;
  private String placeLabel;
  private DoubleFunction<String> decades;
  private Level height = new Level(Double.NaN, "");
  private Level lower = new Level(Double.NaN, "");
  private Level place = new Level(Double.NaN, "");
  private Point point = new Point(Double.NaN, Double.NaN, "");
  private double limit = Double.NaN;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param marks how methods are drawn
   * @param unit what is measured upwards
   * @param label what stands beside that axis; null for nothing
   * @param panels the lines of each panel by its title
   */
  public CurveChart(
      String description, Marks marks, Unit unit, String label, Map<String, List<Curve>> panels) {
    this.description = description;
    this.marks = marks;
    this.unit = unit;
    this.heightLabel = label;
    this.panels = new LinkedHashMap<>(panels);
  }

  /** Names the axis to the right, which is in equal steps. */
  public CurveChart along(String label) {
    placeLabel = label;
    return this;
  }

  /** Names the axis to the right, which is in decades of numbers of things. */
  public CurveChart alongCounts(String label) {
    decades = CurveChart::count;
    return along(label);
  }

  /** Names the axis to the right, which is in powers of ten. */
  public CurveChart alongPowers(String label) {
    decades = CurveChart::power;
    return along(label);
  }

  /** Marks a height, with words above it. */
  public CurveChart level(double value, String text) {
    height = new Level(value, text);
    return this;
  }

  /** Marks a second height, with words below it. */
  public CurveChart levelBelow(double value, String text) {
    lower = new Level(value, text);
    return this;
  }

  /** Marks a place, with words beside it. */
  public CurveChart place(double value, String text) {
    place = new Level(value, text);
    return this;
  }

  /** Puts our mark at a point of our line, with words beside it, and no other mark near. */
  public CurveChart point(double x, double y, String text) {
    point = new Point(x, y, text);
    return this;
  }

  /** Draws a crossed ring beyond a height, above a break of the axis, where a line has no value. */
  public CurveChart limit(double value) {
    limit = value;
    return this;
  }

  /** Draws it. */
  public List<Panel> panels() {
    return panels.entrySet().stream()
        .map(
            panel ->
                new Panel(
                    panel.getKey(),
                    new Picture(
                        Picture.PANEL, HEIGHT, description, g -> draw(g, panel.getValue()))))
        .toList();
  }

  private void draw(Graphics2D g, List<Curve> curves) {
    Rectangle2D inner = new Rectangle2D.Double(2, 0, Picture.PANEL - 4 - NAMES, HEIGHT - 4);
    boolean cut = curves.stream().anyMatch(CurveChart::isCut);
    DecadeAxis heights = heights(cut ? limit / DecadeAxis.ROOM : Double.NaN);
    if (cut && !Double.isNaN(limit)) {
      double room = GAP + RING * rings(curves);
      heights.withBeyond("> " + unit.tick.apply(limit), room / (FLOOR - room), GAP / 2 / room);
    }
    Axes axes = Axes.draw(g, inner, places(curves), heights);
    curves.forEach(curve -> band(g, axes, curve, curves.size()));
    curves.forEach(curve -> line(g, axes, heights, curve));
    point(g, axes);
    names(g, axes, curves);
    level(g, axes, height, -5);
    level(g, axes, lower, 13);
    place(g, axes);
    if (cut && !Double.isNaN(limit)) {
      rings(g, axes, axes.y(heights.most()) - GAP - RING / 2, curves);
    }
  }

  private DecadeAxis heights(double further) {
    double[] all =
        panels.values().stream()
            .flatMap(List::stream)
            .flatMapToDouble(
                c ->
                    DoubleStream.concat(
                        Arrays.stream(c.middle()),
                        DoubleStream.concat(Arrays.stream(c.low()), Arrays.stream(c.high()))))
            .toArray();
    DoubleStream marked = DoubleStream.of(height.value, lower.value, further);
    DoubleStream shown = DoubleStream.concat(Arrays.stream(all), marked);
    if (!Double.isNaN(further)) {
      shown = shown.map(value -> Math.min(value, further)); // the axis ends there
    }
    DecadeAxis axis = DecadeAxis.covering(shown, unit.tick);
    axis.setLabel(heightLabel);
    axis.withTexts(unit.exact);
    return Arrays.stream(all).anyMatch(value -> value == 0) ? axis.withZero() : axis;
  }

  /** From the smallest to the largest place of all lines, a little room at either end. */
  private ValueAxis places(List<Curve> curves) {
    double[] all = curves.stream().flatMapToDouble(c -> Arrays.stream(c.x())).sorted().toArray();
    if (decades != null) {
      // One thing stands at the end of the axis: nothing is less.
      DoubleStream shown = Arrays.stream(all).map(x -> x == 1 ? 1.25 : x);
      DecadeAxis axis = DecadeAxis.covering(shown, decades);
      axis.setLabel(placeLabel);
      return axis;
    }
    double least = all.length == 0 ? 0 : all[0];
    double most = all.length == 0 ? 1 : all[all.length - 1];
    NumberAxis axis = new NumberAxis(placeLabel);
    axis.setStandardTickUnits(NumberAxis.createIntegerTickUnits());
    double room = Math.max(0.02 * (most - least), 1e-9);
    axis.setRange(least - room, most + room);
    return axis;
  }

  private static String power(double value) {
    return Math.abs(Math.log10(value)) < 2.5
        ? Durations.number(value, 1)
        : "1e" + Math.round(Math.log10(value));
  }

  /** Short, for the last one stands at the edge. */
  private static String count(double n) {
    return n < 1e3
        ? Durations.number(n, 1)
        : n < 1e6 ? Durations.number(n / 1e3, 1) + "k" : Durations.number(n / 1e6, 1) + "M";
  }

  private static boolean isCut(Curve curve) {
    return Arrays.stream(curve.middle()).anyMatch(Double::isNaN);
  }

  /** Where there are many, only our band is drawn: through a dozen nobody can see. */
  private void band(Graphics2D g, Axes axes, Curve curve, int curves) {
    if (curves > FEW && !Marks.isOurs(curve.method())) {
      return;
    }
    int n = curve.x().length;
    Path2D band = new Path2D.Double();
    for (int i = 0; i < 2 * n; i++) {
      int k = i < n ? i : 2 * n - 1 - i;
      double value = i < n ? curve.high()[k] : curve.low()[k];
      if (!Double.isNaN(value) && band.getCurrentPoint() == null) {
        band.moveTo(axes.x(curve.x()[k]), axes.y(value));
      } else if (!Double.isNaN(value)) {
        band.lineTo(axes.x(curve.x()[k]), axes.y(value));
      }
    }
    Shape clip = g.getClip();
    g.clip(axes.area());
    g.setColor(Style.veil(marks.color(curve.method()), BAND));
    g.fill(band);
    g.setClip(clip);
  }

  /** The shape of the method stands on the line now and then, so that it reads in grey. */
  private void line(Graphics2D g, Axes axes, DecadeAxis heights, Curve curve) {
    double[][] points = new double[curve.x().length][];
    for (int i = 0; i < points.length; i++) {
      double value = curve.middle()[i];
      points[i] = new double[] {axes.x(curve.x()[i]), Double.isNaN(value) ? value : axes.y(value)};
    }
    Marks.Mark mark = marks.of(curve.method());
    axes.line(g, points, mark.color(), mark.stroke());
    double next = axes.area().getMinX() + SPACING * phase(curve);
    for (int i = 0; i < points.length; i++) {
      double[] point = points[i];
      if (point[0] >= next && !Double.isNaN(point[1])) {
        next = point[0] + SPACING;
        if (Marks.isOurs(curve.method()) && Math.abs(point[0] - axes.x(this.point.x)) < SPACING) {
          continue;
        }
        String text =
            "%s at %s: %s"
                .formatted(
                    (marks.name(curve.method()) + " " + curve.knob()).strip(),
                    Durations.number(curve.x()[i], 3),
                    heights.text(curve.middle()[i]));
        Hover.over(g, text, () -> marks.draw(g, curve.method(), point[0], point[1]));
      }
    }
  }

  /** Shapes of lines that run together do not cover each other. */
  private static double phase(Curve curve) {
    return Math.floorMod(curve.method().hashCode() * 31 + curve.knob().hashCode(), 97) / 97.0;
  }

  private void names(Graphics2D g, Axes axes, List<Curve> curves) {
    Rectangle2D area = axes.area();
    LineLabels labels = new LineLabels(marks);
    for (Curve curve : curves) {
      int last = curve.last();
      if (last >= 0) {
        double y = axes.y(curve.middle()[last]);
        g.setColor(marks.color(curve.method()));
        g.setStroke(Style.dashes(Style.HAIR, 1, 3));
        g.draw(new Line2D.Double(axes.x(curve.x()[last]), y, area.getMaxX(), y));
        labels.add(y, curve.method(), curve.knob());
      }
    }
    labels.draw(g, area.getMaxX(), area.getMinY(), area.getMaxY());
  }

  private static void level(Graphics2D g, Axes axes, Level level, int below) {
    if (!Double.isNaN(level.value)) {
      axes.level(g, level.value, Style.QUIET, Style.dashes(Style.THIN, 7, 4));
      g.setFont(Style.font(11));
      float x = (float) axes.area().getMinX() + 6;
      g.drawString(level.text, x, (float) axes.y(level.value) + below);
    }
  }

  private void place(Graphics2D g, Axes axes) {
    double x = axes.x(place.value);
    if (x >= axes.area().getMinX() && x <= axes.area().getMaxX()) {
      g.setColor(Style.QUIET);
      g.setStroke(Style.dashes(Style.FIRM, 3, 3));
      g.draw(new Line2D.Double(x, axes.area().getMinY(), x, axes.area().getMaxY()));
      g.setFont(Style.font(11));
      double end = axes.area().getMaxX() - g.getFontMetrics().stringWidth(place.text) - 4;
      g.drawString(place.text, (float) Math.min(x + 5, end), (float) axes.area().getMaxY() - 42);
    }
  }

  private void point(Graphics2D g, Axes axes) {
    double x = axes.x(point.x);
    double y = axes.y(point.y);
    if (axes.area().contains(x, y)) {
      marks.draw(g, Marks.OURS, x, y);
      g.setColor(marks.color(Marks.OURS));
      g.setFont(Style.bold(11));
      g.drawString(point.text, (float) x + 11, (float) y + 4);
    }
  }

  /** How many meet at one place. */
  private static int rings(List<Curve> curves) {
    Map<Double, Integer> taken = new HashMap<>();
    for (Curve curve : curves) {
      for (int i = 0; i < curve.x().length; i++) {
        if (Double.isNaN(curve.middle()[i])) {
          taken.merge(curve.x()[i], 1, Integer::sum);
        }
      }
    }
    return taken.values().stream().mapToInt(n -> n).max().orElse(0);
  }

  /** Those that meet at one place stand above each other. */
  private void rings(Graphics2D g, Axes axes, double lowest, List<Curve> curves) {
    Map<Double, Integer> taken = new HashMap<>();
    for (Curve curve : curves) {
      for (int i = 0; i < curve.x().length; i++) {
        if (Double.isNaN(curve.middle()[i])) {
          int above = taken.merge(curve.x()[i], 1, Integer::sum) - 1;
          double x = axes.x(curve.x()[i]);
          double y = lowest - above * RING;
          String text = marks.name(curve.method()) + ": more than " + unit.exact.apply(limit);
          Hover.over(g, text, () -> marks.drawFailure(g, curve.method(), x, y));
        }
      }
    }
  }
}
