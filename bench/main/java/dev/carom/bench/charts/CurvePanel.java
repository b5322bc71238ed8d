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

  private CurvePanel(Graphics2D g, Axes axes, Marks marks) {
    this.g = g;
    this.axes = axes;
    this.marks = marks;
  }

  /** The heights that lines and bands need, and others. */
  static DecadeAxis heights(
      List<Curve> courses, String label, DoubleFunction<String> text, double... others) {
    DoubleStream all =
        courses.stream()
            .flatMapToDouble(
                c ->
                    DoubleStream.concat(
                        Arrays.stream(c.middle()),
                        DoubleStream.concat(Arrays.stream(c.low()), Arrays.stream(c.high()))));
    DecadeAxis axis = DecadeAxis.covering(DoubleStream.concat(all, Arrays.stream(others)), text);
    axis.setLabel(label);
    return axis;
  }

  /** From the smallest to the largest place of all lines, a little room at either end. */
  static NumberAxis places(List<Curve> courses, String label) {
    double least = courses.stream().flatMapToDouble(c -> Arrays.stream(c.x())).min().orElse(0);
    double most = courses.stream().flatMapToDouble(c -> Arrays.stream(c.x())).max().orElse(1);
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
      List<Curve> courses) {
    Rectangle2D inner =
        new Rectangle2D.Double(
            where.getX(), where.getY(), where.getWidth() - names, where.getHeight());
    Axes axes = Axes.draw(g, inner, places, heights);
    CurvePanel panel = new CurvePanel(g, axes, marks);
    courses.forEach(course -> panel.band(course, courses.size()));
    courses.forEach(panel::line);
    panel.names(courses);
    return axes;
  }

  /** Where there are many, only our band is drawn: through a dozen nobody can see. */
  private void band(Curve course, int courses) {
    if (courses > FEW && !Marks.isOurs(course.method())) {
      return;
    }
    int n = course.x().length;
    Path2D band = new Path2D.Double();
    boolean empty = true;
    for (int i = 0; i < 2 * n; i++) {
      int k = i < n ? i : 2 * n - 1 - i;
      double value = i < n ? course.high()[k] : course.low()[k];
      if (!Double.isNaN(value)) {
        point(band, empty, course.x()[k], value);
        empty = false;
      }
    }
    Shape clip = g.getClip();
    g.clip(axes.area());
    g.setColor(Style.veil(marks.of(course.method()).color(), BAND));
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
  private void line(Curve course) {
    double[][] points = new double[course.x().length][];
    for (int i = 0; i < points.length; i++) {
      double value = course.middle()[i];
      points[i] = new double[] {axes.x(course.x()[i]), Double.isNaN(value) ? value : axes.y(value)};
    }
    Marks.Mark mark = marks.of(course.method());
    axes.line(g, points, mark.color(), mark.stroke());
    double next = axes.area().getMinX() + SPACING * phase(course);
    for (double[] point : points) {
      if (point[0] >= next && !Double.isNaN(point[1])) {
        marks.draw(g, course.method(), point[0], point[1], false);
        next = point[0] + SPACING;
      }
    }
  }

  /** Shapes of lines that run together do not cover each other. */
  private static double phase(Curve course) {
    return Math.floorMod(course.method().hashCode() * 31 + course.knob().hashCode(), 97) / 97.0;
  }

  private void names(List<Curve> courses) {
    Rectangle2D area = axes.area();
    LineLabels labels = LineLabels.of(marks);
    for (Curve course : courses) {
      int last = course.last();
      if (last >= 0) {
        double y = axes.y(course.middle()[last]);
        double x = axes.x(course.x()[last]);
        g.setColor(marks.of(course.method()).color());
        g.setStroke(Style.dashes(Style.HAIR, 1, 3));
        g.draw(new Line2D.Double(x, y, area.getMaxX(), y));
        labels.add(y, course.method(), course.knob(), marks.of(course.method()).color());
      }
    }
    labels.draw(g, area.getMaxX(), area.getMinY(), area.getMaxY());
  }
}
