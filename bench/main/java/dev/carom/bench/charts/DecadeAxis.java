// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.stream.DoubleStream;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberTick;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.TextAnchor;

/**
 * A logarithmic axis in whole decades, at the left or at the bottom, with room for gutters beyond
 * its ends, where stands what is on no scale. Its labels are plain text, where those of LogAxis
 * become outlines in an SVG.
 */
final class DecadeAxis extends LogAxis {

  private static final long serialVersionUID = 1;

  /** So many times, at least, a value is from the ends. */
  static final double ROOM = 1.25;

  private static final int MOST_TICKS = 15;

  /** The way from 0 to the first decade, as a share of the length of all decades. */
  private static final double ZERO_GUTTER = 0.12;

  private final int lowest;
  private final int highest;
  private boolean zero;
  private double brokenAbove = Double.NaN;
  private String beyond;
  private final transient DoubleFunction<String> text;
  private transient DoubleFunction<String> unit = value -> Durations.number(value, 3);

  private DecadeAxis(int lowest, int highest, DoubleFunction<String> text) {
    super(null);
    this.lowest = lowest;
    this.highest = highest;
    this.text = text;
    setRange(Math.pow(10, lowest), Math.pow(10, highest));
    setMinorTickMarksVisible(false);
  }

  /**
   * An axis on which the smallest and the largest of some values stand off the edges. Those that
   * are not finite or not above 0 are passed over.
   */
  static DecadeAxis covering(DoubleStream values, DoubleFunction<String> text) {
    DoubleSummaryStatistics shown =
        values.filter(v -> v > 0 && v < Double.POSITIVE_INFINITY).summaryStatistics();
    double smallest = shown.getCount() == 0 ? 1 : shown.getMin();
    double largest = shown.getCount() == 0 ? 1 : shown.getMax();
    int lowest = (int) Math.floor(Math.log10(smallest / ROOM));
    int highest = (int) Math.ceil(Math.log10(largest * ROOM));
    return new DecadeAxis(lowest, highest, text);
  }

  /** How a value between ticks is written. */
  DecadeAxis withTexts(DoubleFunction<String> exact) {
    unit = exact;
    return this;
  }

  /** Leaves room, as shares of the decades' length, before the first and after the last decade. */
  DecadeAxis withGutters(double before, double after) {
    double decades = highest - lowest;
    setRange(Math.pow(10, lowest - before * decades), Math.pow(10, highest + after * decades));
    return this;
  }

  /**
   * Breaks the axis below its first decade, and gives it a tick named 0 there: no logarithm ends at
   * 0, and a value of 0 drawn at the first decade would read as that decade.
   */
  DecadeAxis withZero() {
    return withZero(ZERO_GUTTER, 0);
  }

  /** The same with another way from 0 to the first decade, and with a gutter after the last one. */
  DecadeAxis withZero(double before, double after) {
    zero = true;
    return withGutters(before, after);
  }

  /**
   * Breaks the axis above its last decade, and gives the room beyond a tick of its own: what lies
   * there is greater, and not drawn to scale.
   *
   * @param name of the tick
   * @param room beyond the last decade, as a share of the decades' length
   * @param breakAt where the break is, as a share of this room
   */
  DecadeAxis withBeyond(String name, double room, double breakAt) {
    double length = room * (highest - lowest);
    setRange(getLowerBound(), Math.pow(10, highest + length));
    brokenAbove = Math.pow(10, highest + breakAt * length);
    beyond = name;
    return this;
  }

  /** Where the axis is broken above its last decade; NaN for an axis that ends there. */
  double breakAbove() {
    return brokenAbove;
  }

  /** Where the axis is broken, between 0 and the first decade; NaN for an axis without a 0. */
  double breakAt() {
    return zero ? Math.cbrt(getLowerBound() * least() * least()) : Double.NaN;
  }

  /** A value with three digits, as its ticks are written. */
  String text(double value) {
    return unit.apply(value);
  }

  /** Half of the width of the last tick's text, and a little more. */
  double halfLast(Graphics2D g) {
    return g.getFontMetrics(getTickLabelFont()).stringWidth(text.apply(most())) / 2.0 + 3;
  }

  /** The end of the scale, where the gutter before it begins. */
  double least() {
    return Math.pow(10, lowest);
  }

  /** The end of the scale, where the gutter after it begins. */
  double most() {
    return Math.pow(10, highest);
  }

  /** A value beyond an end lies there; 0 lies off it, so that a mark covers no text of the axis. */
  @Override
  public double valueToJava2D(double value, Rectangle2D area, RectangleEdge edge) {
    double end = getLowerBound();
    double shown =
        zero && value == 0
            ? Math.cbrt(end * end * least())
            : Math.max(end, Math.min(getUpperBound(), value));
    return super.valueToJava2D(shown, area, edge);
  }

  @Override
  public List<NumberTick> refreshTicks(
      Graphics2D g, AxisState state, Rectangle2D area, RectangleEdge edge) {
    boolean left = RectangleEdge.isLeftOrRight(edge);
    TextAnchor anchor = left ? TextAnchor.CENTER_RIGHT : TextAnchor.TOP_CENTER;
    double room = left ? area.getHeight() / 18 : area.getWidth() / 52;
    int step = 1 + (int) ((highest - lowest) / Math.min(MOST_TICKS, room));
    List<NumberTick> ticks = new ArrayList<>();
    for (int i = lowest; i <= highest; i += step) {
      double value = Math.pow(10, i);
      ticks.add(new NumberTick(value, text.apply(value), anchor, TextAnchor.CENTER, 0));
    }
    if (zero) {
      ticks.add(new NumberTick(0, "0", anchor, TextAnchor.CENTER, 0));
    }
    if (beyond != null) {
      double middle = Math.sqrt(brokenAbove * getUpperBound());
      ticks.add(new NumberTick(middle, beyond, anchor, TextAnchor.CENTER, 0));
    }
    return ticks;
  }
}
