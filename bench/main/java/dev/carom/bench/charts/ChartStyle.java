// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.HorizontalAlignment;
import org.jfree.chart.ui.RectangleInsets;

/** Brings {@link Style} to charts of JFreeChart: paper, quiet axes, a light grid, one title. */
final class ChartStyle {

  private ChartStyle() {}

  /** Makes a chart of a plot, with room at the right for {@link LineLabels}. */
  static JFreeChart chart(String title, String subtitle, XYPlot plot, double right) {
    plot(plot);
    JFreeChart chart = new JFreeChart(null, null, plot, false);
    chart.setBackgroundPaint(Style.PAPER);
    chart.setPadding(new RectangleInsets(14, 14, 12, right));
    TextTitle first = title(title, 0);
    first.setFont(Style.bold(17));
    first.setPaint(Style.INK);
    chart.setTitle(first);
    TextTitle second = title(subtitle, 8);
    second.setFont(Style.font(13));
    second.setPaint(Style.QUIET);
    chart.addSubtitle(second);
    return chart;
  }

  /** Makes a chart of a plot without titles or a margin. */
  static JFreeChart bare(XYPlot plot) {
    plot(plot);
    JFreeChart chart = new JFreeChart(null, null, plot, false);
    chart.setBackgroundPaint(Style.PAPER);
    return chart;
  }

  private static TextTitle title(String text, double below) {
    TextTitle title = new TextTitle(text);
    title.setHorizontalAlignment(HorizontalAlignment.LEFT);
    title.setTextAlignment(HorizontalAlignment.LEFT);
    title.setPadding(2, 0, below, 0);
    return title;
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
