// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.stream.DoubleStream;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.ValueAxis;

/** Lines with bands against a logarithmic height, their names at their right ends. */
final class CurvePanel {

  private static final double SPACING = 90;
  private static final int FEW = 3;
  private static final double BAND = 0.18;

  private final Graphics2D g;
  private final Axes axes;
  private final Marks marks;
  private final DecadeAxis heights;

  private CurvePanel(Graphics2D g, Axes axes, Marks marks, DecadeAxis heights) {
    this.heights = heights;
    this.g = g;
    this.axes = axes;
    this.marks = marks;
  }

  /** The heights that lines and bands need, and others; with a tick named 0 if one of them is 0. */
  static DecadeAxis heights(
      List<Curve> curves, String label, DoubleFunction<String> text, double... others) {
    double[] all =
        curves.stream()
            .flatMapToDouble(
                c ->
                    DoubleStream.concat(
                        Arrays.stream(c.middle()),
                        DoubleStream.concat(Arrays.stream(c.low()), Arrays.stream(c.high()))))
            .toArray();
    DoubleStream shown = DoubleStream.concat(Arrays.stream(all), Arrays.stream(others));
    DecadeAxis axis = DecadeAxis.covering(shown, text);
    axis.setLabel(label);
    return Arrays.stream(all).anyMatch(value -> value == 0) ? axis.withZero() : axis;
  }

  /** From the smallest to the largest place of all lines, a little room at either end. */
  static NumberAxis places(List<Curve> curves, String label) {
    double least = curves.stream().flatMapToDouble(c -> Arrays.stream(c.x())).min().orElse(0);
    double most = curves.stream().flatMapToDouble(c -> Arrays.stream(c.x())).max().orElse(1);
    NumberAxis axis = new NumberAxis(label);
    axis.setStandardTickUnits(NumberAxis.createIntegerTickUnits());
    double room = Math.max(0.02 * (most - least), 1e-9);
    axis.setRange(least - room, most + room);
    return axis;
  }

  /** Draws axes, bands, lines and names; the right part of the rectangle is left to the names. */
  static Axes draw(
      Graphics2D g,
      Rectangle2D where,
      double names,
      ValueAxis places,
      DecadeAxis heights,
      Marks marks,
      List<Curve> curves) {
    Rectangle2D inner =
        new Rectangle2D.Double(
            where.getX(), where.getY(), where.getWidth() - names, where.getHeight());
    Axes axes = Axes.draw(g, inner, places, heights);
    CurvePanel panel = new CurvePanel(g, axes, marks, heights);
    curves.forEach(curve -> panel.band(curve, curves.size()));
    curves.forEach(panel::line);
    panel.names(curves);
    return axes;
  }

  /** Where there are many, only our band is drawn: through a dozen nobody can see. */
  private void band(Curve curve, int curves) {
    if (curves > FEW && !Marks.isOurs(curve.method())) {
      return;
    }
    int n = curve.x().length;
    Path2D band = new Path2D.Double();
    boolean empty = true;
    for (int i = 0; i < 2 * n; i++) {
      int k = i < n ? i : 2 * n - 1 - i;
      double value = i < n ? curve.high()[k] : curve.low()[k];
      if (!Double.isNaN(value)) {
        point(band, empty, curve.x()[k], value);
        empty = false;
      }
    }
    Shape clip = g.getClip();
    g.clip(axes.area());
    g.setColor(Style.veil(marks.of(curve.method()).color(), BAND));
    g.fill(band);
    g.setClip(clip);
  }

  private void point(Path2D path, boolean first, double x, double value) {
    if (first) {
      path.moveTo(axes.x(x), axes.y(value));
    } else {
      path.lineTo(axes.x(x), axes.y(value));
    }
  }

  /** The shape of the method stands on the line now and then, so that it reads in grey. */
  private void line(Curve curve) {
    double[][] points = new double[curve.x().length][];
    for (int i = 0; i < points.length; i++) {
      double value = curve.middle()[i];
      points[i] = new double[] {axes.x(curve.x()[i]), Double.isNaN(value) ? value : axes.y(value)};
    }
    Marks.Mark mark = marks.of(curve.method());
    axes.line(g, points, mark.color(), mark.stroke());
    double next = axes.area().getMinX() + SPACING * phase(curve);
    for (double[] point : points) {
      if (point[0] >= next && !Double.isNaN(point[1])) {
        String text = text(curve, point[0]);
        Hover.over(g, text, () -> marks.draw(g, curve.method(), point[0], point[1]));
        next = point[0] + SPACING;
      }
    }
  }

  private String text(Curve curve, double at) {
    int i = 0;
    while (i < curve.x().length - 1 && axes.x(curve.x()[i]) < at) {
      i++;
    }
    return "%s at %s: %s"
        .formatted(
            (marks.name(curve.method()) + " " + curve.knob()).strip(),
            Durations.number(curve.x()[i], 3),
            heights.text(curve.middle()[i]));
  }

  /** Shapes of lines that run together do not cover each other. */
  private static double phase(Curve curve) {
    return Math.floorMod(curve.method().hashCode() * 31 + curve.knob().hashCode(), 97) / 97.0;
  }

  private void names(List<Curve> curves) {
    Rectangle2D area = axes.area();
    LineLabels labels = LineLabels.of(marks);
    for (Curve curve : curves) {
      int last = curve.last();
      if (last >= 0) {
        double y = axes.y(curve.middle()[last]);
        double x = axes.x(curve.x()[last]);
        g.setColor(marks.of(curve.method()).color());
        g.setStroke(Style.dashes(Style.HAIR, 1, 3));
        g.draw(new Line2D.Double(x, y, area.getMaxX(), y));
        labels.add(y, curve.method(), curve.knob(), marks.of(curve.method()).color());
      }
    }
    labels.draw(g, area.getMaxX(), area.getMinY(), area.getMaxY());
  }
}
