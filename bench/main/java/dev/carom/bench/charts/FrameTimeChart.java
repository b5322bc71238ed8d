// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.data.xy.DefaultXYDataset;

/**
 * The time of every frame of one replay, none left out, against the budget. Times are on a
 * logarithmic scale, so that a frame of a microsecond and the budget are both to be seen; a time of
 * 0, below the step of the clock, is a triangle at the lower edge; one above the budget a cross.
 */
final class FrameTimeChart {

  private static final int WIDTH = 900;
  private static final int HEIGHT = 420;
  private static final int LABELS = 175;

  private final double[] nanos;
  private final double budget;
  private final double median;
  private final int worst;

  /** Takes times in nanoseconds and the budget in milliseconds. */
  FrameTimeChart(double[] frameNanos, double budgetMillis) {
    check(frameNanos, budgetMillis);
    nanos = frameNanos.clone();
    budget = 1e6 * budgetMillis;
    double[] sorted = nanos.clone();
    Arrays.sort(sorted);
    int n = sorted.length;
    median = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
    worst = indexOf(sorted[n - 1]);
  }

  private static void check(double[] frameNanos, double budgetMillis) {
    if (frameNanos.length == 0) {
      throw new IllegalArgumentException("frameNanos is empty: expected at least one frame");
    }
    for (int i = 0; i < frameNanos.length; i++) {
      if (!(frameNanos[i] >= 0 && frameNanos[i] < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException(
            "frameNanos[" + i + "] is " + frameNanos[i] + ": expected a finite time, at least 0");
      }
    }
    if (!(budgetMillis > 0 && budgetMillis < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "budgetMillis is " + budgetMillis + ": expected a finite time greater than 0");
    }
  }

  private int indexOf(double value) {
    int i = 0;
    while (nanos[i] != value) {
      i++;
    }
    return i;
  }

  Picture picture() {
    return new Picture(WIDTH, HEIGHT, title() + ". " + subtitle(), this::paint);
  }

  /** The conclusion, made by rule. */
  String title() {
    long over = Arrays.stream(nanos).filter(t -> t > budget).count();
    String all = Durations.number(nanos.length, 9);
    String budgetText = "the budget of " + Durations.text(budget, 4);
    if (over == 0) {
      return (nanos.length == 1 ? "The frame is" : "All " + all + " frames are")
          + " within "
          + budgetText;
    }
    return "Above "
        + budgetText
        + ": "
        + Durations.number((double) over, 9)
        + " of "
        + all
        + " frames";
  }

  private String subtitle() {
    long none = Arrays.stream(nanos).filter(t -> t == 0).count();
    String triangles =
        none == 0
            ? ""
            : "; triangles: " + Durations.number((double) none, 9) + " too short for the clock";
    return "Time of each frame of one replay, on a logarithmic scale" + triangles;
  }

  private void paint(Graphics2D g) {
    ChartRenderingInfo info = new ChartRenderingInfo();
    JFreeChart chart = ChartStyle.chart(title(), subtitle(), plot(), LABELS);
    chart.draw(g, new Rectangle2D.Double(0, 0, WIDTH, HEIGHT), info);
    Style.smooth(g);
    XYPlot plot = chart.getXYPlot();
    Rectangle2D area = info.getPlotInfo().getDataArea();
    new LineLabels()
        .add(height(plot, area, budget), budgetLabel(), budgetDetail(), Style.VERMILION)
        .add(height(plot, area, nanos[worst]), worstLabel(), worstDetail(), Style.QUIET)
        .add(height(plot, area, median), medianLabel(), medianDetail(), Style.INK)
        .draw(g, area.getMaxX(), area.getMinY(), area.getMaxY());
  }

  private static double height(XYPlot plot, Rectangle2D area, double value) {
    double shown = Math.max(value, plot.getRangeAxis().getLowerBound());
    return plot.getRangeAxis().valueToJava2D(shown, area, plot.getRangeAxisEdge());
  }

  private String budgetLabel() {
    return "budget " + Durations.text(budget, 4);
  }

  private String budgetDetail() {
    return Durations.number(1e9 / budget, 3) + " frames a second";
  }

  private String worstLabel() {
    return "worst " + Durations.text(nanos[worst], 3);
  }

  private String worstDetail() {
    return "of " + Durations.number(nanos.length, 9) + ": frame " + (worst + 1);
  }

  private String medianLabel() {
    return "median " + Durations.text(median, 3);
  }

  private String medianDetail() {
    if (median == 0) {
      return "below the step of the clock";
    }
    return 10 * median < budget
        ? "1/" + Durations.number(budget / median, 2) + " of the budget"
        : Durations.number(100 * median / budget, 2) + " % of the budget";
  }

  private XYPlot plot() {
    NumberAxis frames = new NumberAxis("frame");
    frames.setStandardTickUnits(NumberAxis.createIntegerTickUnits());
    double room = Math.max(0.5, nanos.length / 100.0);
    frames.setRange(1 - room, nanos.length + room);
    DecadeAxis times = DecadeAxis.times(smallest(), Math.max(budget, nanos[worst]));
    XYPlot plot = new XYPlot(dataset(times.getLowerBound()), frames, times, renderer());
    line(plot, budget, Style.VERMILION, Style.dashes(Style.FIRM, 9, 5));
    line(plot, nanos[worst], Style.QUIET, Style.dashes(Style.HAIR, 2, 3));
    line(plot, median, Style.INK, Style.line(Style.FIRM));
    return plot;
  }

  private double smallest() {
    return Arrays.stream(nanos).filter(t -> t > 0).min().orElse(1);
  }

  private static void line(XYPlot plot, double value, Color color, BasicStroke stroke) {
    if (value > 0) {
      plot.addRangeMarker(
          new ValueMarker(value, color, stroke, color, stroke, 1), Layer.FOREGROUND);
    }
  }

  /** Series: within the budget, above it, too short for the clock. */
  private DefaultXYDataset dataset(double floor) {
    DefaultXYDataset data = new DefaultXYDataset();
    data.addSeries("within", series(0, budget, 0));
    data.addSeries("above", series(budget, Double.POSITIVE_INFINITY, 0));
    data.addSeries("too short", series(-1, 0, floor));
    return data;
  }

  /** The frames with a time above one value and up to another, drawn no lower than the floor. */
  private double[][] series(double above, double upTo, double floor) {
    int[] frames =
        IntStream.range(0, nanos.length)
            .filter(i -> nanos[i] > above && nanos[i] <= upTo)
            .toArray();
    double[] x = Arrays.stream(frames).mapToDouble(i -> i + 1).toArray();
    double[] y = Arrays.stream(frames).mapToDouble(i -> Math.max(floor, nanos[i])).toArray();
    return new double[][] {x, y};
  }

  private static XYLineAndShapeRenderer renderer() {
    XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(false, true);
    series(renderer, 0, new Ellipse2D.Double(-1.75, -1.75, 3.5, 3.5), Style.veil(Style.BLUE, 0.6));
    series(renderer, 1, cross(), Style.VERMILION);
    series(renderer, 2, triangle(), Style.BLUE);
    renderer.setDrawOutlines(false);
    return renderer;
  }

  private static void series(XYLineAndShapeRenderer renderer, int i, Shape shape, Color color) {
    renderer.setSeriesShape(i, shape);
    renderer.setSeriesPaint(i, color);
  }

  private static Shape cross() {
    Path2D cross = new Path2D.Double();
    cross.moveTo(-3, -3);
    cross.lineTo(3, 3);
    cross.moveTo(-3, 3);
    cross.lineTo(3, -3);
    return Style.line(Style.THIN).createStrokedShape(cross);
  }

  private static Shape triangle() {
    Path2D triangle = new Path2D.Double();
    triangle.moveTo(0, 0);
    triangle.lineTo(-3.5, -6);
    triangle.lineTo(3.5, -6);
    triangle.closePath();
    return triangle;
  }
}
