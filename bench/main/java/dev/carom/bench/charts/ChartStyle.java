// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.ui.RectangleInsets;

/** Brings {@link Style} to charts of JFreeChart: paper, quiet axes, a light grid. */
final class ChartStyle {

  private ChartStyle() {}

  /** Makes a chart of a plot without titles or a margin. */
  static JFreeChart bare(XYPlot plot) {
    plot(plot);
    JFreeChart chart = new JFreeChart(null, null, plot, false);
    chart.setBackgroundPaint(Style.PAPER);
    return chart;
  }

  private static void plot(XYPlot plot) {
    plot.setBackgroundPaint(Style.FLOOR);
    plot.setOutlineVisible(false);
    plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
    plot.setDomainGridlinesVisible(false);
    plot.setRangeGridlinePaint(Style.GRID);
    plot.setRangeGridlineStroke(Style.line(Style.HAIR));
    axis(plot.getDomainAxis());
    axis(plot.getRangeAxis());
    plot.getDomainAxis().setTickLabelInsets(new RectangleInsets(5, 4, 2, 4)); // clear of the others
  }

  private static void axis(ValueAxis axis) {
    axis.setLabelFont(Style.font(13));
    axis.setLabelPaint(Style.QUIET);
    axis.setTickLabelFont(Style.font(12));
    axis.setTickLabelPaint(Style.INK);
    axis.setAxisLinePaint(Style.QUIET);
    axis.setAxisLineStroke(Style.line(Style.HAIR));
    axis.setTickMarkPaint(Style.QUIET);
    axis.setTickMarkOutsideLength(4);
  }
}
