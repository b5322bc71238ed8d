// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.data.xy.DefaultXYDataset;

/** Axes and a grid that JFreeChart has drawn, and where values lie between them, in pixels. */
final class Axes {

  /** The width of the strip where an axis is broken. */
  private static final double CUT = 4;

  private final XYPlot plot;
  private final Rectangle2D area;

  private Axes(XYPlot plot, Rectangle2D area) {
    this.plot = plot;
    this.area = area;
  }

  /** Draws axes, their labels and a light grid so that all of it fills a rectangle. */
  static Axes draw(Graphics2D g, Rectangle2D where, ValueAxis x, ValueAxis y) {
    XYPlot plot = new XYPlot(new DefaultXYDataset(), x, y, null);
    JFreeChart chart = ChartStyle.bare(plot);
    plot.setDomainGridlinesVisible(x instanceof DecadeAxis);
    plot.setDomainGridlinePaint(Style.GRID);
    plot.setDomainGridlineStroke(Style.line(Style.HAIR));
    plot.setInsets(RectangleInsets.ZERO_INSETS);
    double right = x instanceof DecadeAxis decades ? Math.max(18, decades.halfLast(g)) : 8;
    chart.setPadding(new RectangleInsets(8, 2, x.isTickLabelsVisible() ? 2 : 8, right));
    ChartRenderingInfo info = new ChartRenderingInfo();
    chart.draw(g, where, info);
    Style.smooth(g);
    Axes axes = new Axes(plot, info.getPlotInfo().getDataArea());
    if (y instanceof DecadeAxis decades) {
      axes.cut(g, decades.breakAt());
      axes.cut(g, decades.breakAbove());
    }
    if (x instanceof DecadeAxis decades) {
      axes.cutAcross(g, decades.breakAt());
    }
    return axes;
  }

  Rectangle2D area() {
    return area;
  }

  double x(double value) {
    return plot.getDomainAxis().valueToJava2D(value, area, plot.getDomainAxisEdge());
  }

  double y(double value) {
    return plot.getRangeAxis().valueToJava2D(value, area, plot.getRangeAxisEdge());
  }

  /**
   * Shows that the axis is broken at a height, if it is: a strip of paper through it and through
   * the floor.
   */
  private void cut(Graphics2D g, double value) {
    if (Double.isNaN(value)) {
      return;
    }
    double left = area.getMinX() - CUT;
    g.setColor(Style.PAPER);
    g.fill(new Rectangle2D.Double(left, y(value) - CUT / 2, area.getMaxX() - left, CUT));
    g.setColor(Style.QUIET);
    g.setStroke(Style.line(Style.HAIR));
    for (double y = y(value) - CUT / 2; y <= y(value) + CUT; y += CUT) {
      g.draw(new Line2D.Double(left, y + 2, area.getMinX() + CUT, y - 2));
    }
  }

  /** The same for the axis at the bottom. */
  private void cutAcross(Graphics2D g, double value) {
    if (Double.isNaN(value)) {
      return;
    }
    double floor = area.getMaxY();
    g.setColor(Style.PAPER);
    g.fill(
        new Rectangle2D.Double(
            x(value) - CUT / 2, area.getMinY(), CUT, floor + CUT - area.getMinY()));
    g.setColor(Style.QUIET);
    g.setStroke(Style.line(Style.HAIR));
    for (double x = x(value) - CUT / 2; x <= x(value) + CUT; x += CUT) {
      g.draw(new Line2D.Double(x - 2, floor + CUT, x + 2, floor - CUT));
    }
  }

  /** A line at one height through the whole area. */
  void level(Graphics2D g, double value, Color color, BasicStroke stroke) {
    g.setColor(color);
    g.setStroke(stroke);
    g.draw(new Line2D.Double(area.getMinX(), y(value), area.getMaxX(), y(value)));
  }

  /** A line through points in pixels, none of it outside of the area. */
  void line(Graphics2D g, double[][] points, Color color, BasicStroke stroke) {
    Shape clip = g.getClip();
    g.clip(area);
    g.setColor(color);
    g.setStroke(stroke);
    g.draw(path(points));
    g.setClip(clip);
  }

  /** Points as {x, y}; a point with NaN interrupts the line. */
  static Path2D path(double[]... points) {
    Path2D path = new Path2D.Double();
    boolean drawing = false;
    for (double[] p : points) {
      boolean gap = Double.isNaN(p[0]) || Double.isNaN(p[1]);
      if (!gap && drawing) {
        path.lineTo(p[0], p[1]);
      } else if (!gap) {
        path.moveTo(p[0], p[1]);
      }
      drawing = !gap;
    }
    return path;
  }
}
