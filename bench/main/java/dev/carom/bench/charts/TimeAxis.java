// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberTick;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.TextAnchor;

/**
 * A logarithmic axis of nanoseconds at the left, in whole decades, each of which is written with
 * its unit. Its labels are plain text, where those of LogAxis become outlines in an SVG.
 */
final class TimeAxis extends LogAxis {

  private static final long serialVersionUID = 1;

  private final int lowest;
  private final int highest;

  private TimeAxis(int lowest, int highest) {
    super(null);
    this.lowest = lowest;
    this.highest = highest;
    setRange(Math.pow(10, lowest), Math.pow(10, highest));
    setMinorTickMarksVisible(false);
  }

  /** An axis on which a smallest and a largest time, both greater than 0, stand off the edges. */
  static TimeAxis covering(double smallest, double largest) {
    int lowest = (int) Math.floor(Math.log10(smallest / 1.25));
    int highest = (int) Math.ceil(Math.log10(largest * 1.25));
    return new TimeAxis(lowest, highest);
  }

  @Override
  public List<NumberTick> refreshTicks(
      Graphics2D g, AxisState state, Rectangle2D area, RectangleEdge edge) {
    List<NumberTick> ticks = new ArrayList<>();
    int step = 1 + (highest - lowest) / 14;
    for (int i = lowest; i <= highest; i += step) {
      double nanos = Math.pow(10, i);
      String text = Durations.text(nanos, 1);
      ticks.add(new NumberTick(nanos, text, TextAnchor.CENTER_RIGHT, TextAnchor.CENTER, 0));
    }
    return ticks;
  }
}
