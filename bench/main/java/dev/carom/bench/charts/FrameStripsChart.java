// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import org.jfree.chart.axis.NumberAxis;

/**
 * The time of every frame of one replay of each method, none left out, against the budget: a strip
 * for each method, its frames from left to right, and lines at its quantiles.
 */
public final class FrameStripsChart {

  /**
   * One strip.
   *
   * @param method its label
   * @param knob its setting; may be empty
   * @param nanos the time of each frame; 0 is drawn at the lower edge
   */
  @SuppressWarnings("ArrayRecordComponent") // compared by nobody
  public record Strip(String method, String knob, double[] nanos) {

    /** The least value that a share of all does not exceed. */
    double rank(double share) {
      double[] sorted = nanos.clone();
      Arrays.sort(sorted);
      return sorted[Math.max(0, (int) Math.ceil(share * sorted.length) - 1)];
    }
  }

  private static final int HEIGHT = 580;
  private static final int NARROW_STRIPS = 4;
  private static final int NARROW_HEAD = 130;
  private static final int NARROW_ROW = 330;
  private static final int NOTES = 116;
  private static final double LEFT = 26;
  private static final int NAME_LINES = 2;
  private static final double FIRST_NUMBER = 50;
  private static final double SMALLEST = 7;

  private final String title;
  private final String subtitle;
  private final Marks marks;
  private final List<Strip> strips;
  private final double budget;

  /**
   * Takes what is drawn.
   *
   * @param title what the reader is to take home
   * @param subtitle what is shown
   * @param marks how methods are drawn
   * @param strips at least one
   * @param budget in nanoseconds
   */
  public FrameStripsChart(
      String title, String subtitle, Marks marks, List<Strip> strips, double budget) {
    this.title = title;
    this.subtitle = subtitle;
    this.marks = marks;
    this.strips = List.copyOf(strips);
    this.budget = budget;
  }

  /**
   * Draws it.
   *
   * @param width {@link Picture#WIDE} or {@link Picture#NARROW}
   * @return the picture
   */
  public Picture picture(int width) {
    boolean narrow = width < Picture.WIDE;
    int most = narrow ? NARROW_STRIPS : strips.size();
    int rows = (strips.size() + most - 1) / most;
    int height = narrow ? NARROW_HEAD + rows * NARROW_ROW : HEIGHT;
    return new Picture(width, height, title + ". " + subtitle, g -> paint(g, width, height, rows));
  }

  private void paint(Graphics2D g, int width, int height, int rows) {
    double top = Heading.draw(g, width, title, subtitle);
    double each = (height - top) / rows;
    int most = (strips.size() + rows - 1) / rows;
    for (int row = 0; row < rows; row++) {
      List<Strip> shown = strips.subList(row * most, Math.min(strips.size(), (row + 1) * most));
      row(g, new Rectangle2D.Double(LEFT, top, width - 14 - LEFT, each - NOTES), shown);
      top += each;
    }
  }

  /** All rows have the same axis of times. */
  private void row(Graphics2D g, Rectangle2D where, List<Strip> shown) {
    DecadeAxis times =
        DecadeAxis.covering(
            DoubleStream.concat(
                strips.stream().flatMapToDouble(s -> Arrays.stream(s.nanos())),
                DoubleStream.of(budget)),
            nanos -> Durations.text(nanos, 1));
    NumberAxis places = new NumberAxis(null);
    places.setRange(0, shown.size());
    places.setTickLabelsVisible(false);
    places.setTickMarksVisible(false);
    Axes axes = Axes.draw(g, where, places, times);
    for (int i = 0; i < shown.size(); i++) {
      strip(g, axes, shown.get(i), axes.x(i), axes.x(i + 1));
    }
    axes.level(g, budget, Style.VERMILION, Style.dashes(Style.FIRM, 9, 5));
    budget(g, axes.area().getMinX() + 8, axes.y(budget) - 6);
    legend(g, axes);
  }

  /** On a plate of its own, since frames may be there. */
  private void budget(Graphics2D g, double x, double y) {
    String text = "budget " + Durations.text(budget, 4);
    g.setFont(Style.bold(12));
    double width = g.getFontMetrics().stringWidth(text);
    g.setColor(Style.veil(Style.FLOOR, 0.85));
    g.fill(new Rectangle2D.Double(x - 3, y - 12, width + 6, 15));
    g.setColor(Style.VERMILION);
    g.drawString(text, (float) x, (float) y);
  }

  private void strip(Graphics2D g, Axes axes, Strip strip, double left, double right) {
    double room = (right - left) * 0.07;
    g.setColor(Style.GRID);
    g.setStroke(Style.line(Style.HAIR));
    g.draw(new Line2D.Double(right, axes.area().getMinY(), right, axes.area().getMaxY()));
    Path2D dots = new Path2D.Double();
    double step = (right - left - 2 * room) / strip.nanos.length;
    for (int i = 0; i < strip.nanos.length; i++) {
      double x = left + room + step * (i + 0.5);
      double y = axes.y(strip.nanos[i]);
      dots.moveTo(x, y);
      dots.lineTo(x, y);
    }
    g.setColor(Style.veil(marks.of(strip.method).color(), 0.6));
    g.setStroke(Style.line(3));
    g.draw(dots);
    level(g, axes.y(strip.rank(0.5)), left, right, 2 * Style.THIN);
    level(g, axes.y(strip.rank(0.95)), left, right, Style.THIN);
    notes(g, axes, strip, left, right);
  }

  private static void level(Graphics2D g, double y, double left, double right, double width) {
    g.setColor(Style.INK);
    g.setStroke(Style.line(width));
    g.draw(new Line2D.Double(left + 3, y, right - 3, y));
  }

  /** Under the strip: its shape and name, then numbers, a line each. */
  private void notes(Graphics2D g, Axes axes, Strip strip, double left, double right) {
    double middle = (left + right) / 2;
    double y = axes.area().getMaxY() + 14;
    String name = strip.knob.isEmpty() ? strip.method : strip.method + " " + strip.knob;
    marks.draw(g, strip.method, middle, y, false);
    g.setColor(Style.INK);
    List<String> lines = wrap(g, name, right - left - 4);
    for (int i = 0; i < lines.size(); i++) {
      centred(g, lines.get(i), middle, y + 19 + 13 * (i + 0.5 * (NAME_LINES - lines.size())));
    }
    g.setFont(Style.font(11));
    centred(g, Durations.text(strip.rank(0.5), 3), middle, y + FIRST_NUMBER);
    centred(g, Durations.text(strip.rank(0.95), 3), middle, y + FIRST_NUMBER + 16);
    centred(g, Durations.text(strip.rank(1), 3), middle, y + FIRST_NUMBER + 32);
  }

  /** On as few lines as fit, broken at blanks and after hyphens; smaller if there are too many. */
  private static List<String> wrap(Graphics2D g, String name, double width) {
    for (double size = 12; ; size--) {
      g.setFont(Style.bold(size));
      List<String> lines = new ArrayList<>();
      for (String word : name.split("(?<=[- ])", -1)) {
        int last = lines.size() - 1;
        boolean joins =
            last >= 0 && g.getFontMetrics().stringWidth(lines.get(last) + word) <= width;
        if (joins) {
          lines.set(last, lines.get(last) + word);
        } else {
          lines.add(word);
        }
      }
      boolean fits =
          lines.stream().allMatch(line -> g.getFontMetrics().stringWidth(line.strip()) <= width);
      if (size <= SMALLEST || (fits && lines.size() <= NAME_LINES)) {
        return lines;
      }
    }
  }

  private void legend(Graphics2D g, Axes axes) {
    g.setFont(Style.font(11));
    g.setColor(Style.QUIET);
    double x = axes.area().getMinX() - 6;
    double y = axes.area().getMaxY() + 14;
    int frames = strips.stream().mapToInt(s -> s.nanos.length).max().orElse(0);
    right(g, "median", x, y + FIRST_NUMBER);
    right(g, "95 %", x, y + FIRST_NUMBER + 16);
    right(g, "worst of " + frames, x, y + FIRST_NUMBER + 32);
  }

  private static void right(Graphics2D g, String text, double x, double y) {
    g.drawString(text, (float) (x - g.getFontMetrics().stringWidth(text)), (float) y);
  }

  private static void centred(Graphics2D g, String text, double x, double y) {
    g.drawString(text, (float) (x - g.getFontMetrics().stringWidth(text) / 2.0), (float) y);
  }
}
