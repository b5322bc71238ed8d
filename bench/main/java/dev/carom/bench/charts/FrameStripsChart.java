// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import org.jfree.chart.axis.NumberAxis;

/**
 * The time of every frame of one replay of each method, none left out, against the budget: a strip
 * for each method, its frames from top to bottom, and lines at the median and the worst.
 */
public final class FrameStripsChart {

  /**
   * One strip.
   *
   * @param method its label
   * @param knob its setting; may be empty
   * @param nanos the time of each frame; 0 is drawn at the left edge
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

  private static final double ROW = 25;
  private static final double FOOT = 44;
  private static final double NAMES = 138;

  /** Room for the first tick, as a share of the axis. */
  private static final double EDGE = 0.08;

  private final String description;
  private final Marks marks;
  private final List<Strip> strips;
  private final double budget;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param marks how methods are drawn
   * @param strips at least one
   * @param budget in nanoseconds
   */
  public FrameStripsChart(String description, Marks marks, List<Strip> strips, double budget) {
    this.description = description;
    this.marks = marks;
    this.strips = List.copyOf(strips);
    this.budget = budget;
  }

  /** Draws it. */
  public Picture picture() {
    int height = (int) Math.ceil(ROW * strips.size() + FOOT);
    return new Picture(Picture.PANEL, height, description, g -> paint(g, height));
  }

  private void paint(Graphics2D g, int height) {
    DecadeAxis times =
        DecadeAxis.covering(
            DoubleStream.concat(
                strips.stream().flatMapToDouble(s -> Arrays.stream(s.nanos())),
                DoubleStream.of(budget)),
            nanos -> Durations.text(nanos, 1));
    times.setLabel("time of a frame, logarithmic");
    times.withGutters(EDGE, 0);
    NumberAxis rows = new NumberAxis(null);
    rows.setRange(0, strips.size());
    rows.setInverted(true);
    rows.setTickLabelsVisible(false);
    rows.setTickMarksVisible(false);
    Rectangle2D where =
        new Rectangle2D.Double(NAMES - 6, 0, Picture.PANEL - NAMES + 4, height - 2.0);
    Axes axes = Axes.draw(g, where, times, rows);
    for (int i = 0; i < strips.size(); i++) {
      Strip strip = strips.get(i);
      double top = axes.y(i);
      double bottom = axes.y(i + 1);
      Hover.over(g, text(strip), () -> strip(g, axes, strip, top, bottom));
      name(g, strip, (top + bottom) / 2);
    }
    double x = axes.x(budget);
    g.setColor(Style.QUIET);
    g.setStroke(Style.dashes(Style.FIRM, 9, 5));
    g.draw(new Line2D.Double(x, axes.area().getMinY(), x, axes.area().getMaxY()));
  }

  private String text(Strip strip) {
    return "%s: median %s, 95 %% %s, worst of %d %s"
        .formatted(
            (marks.name(strip.method) + " " + strip.knob).strip(),
            Durations.text(strip.rank(0.5), 3),
            Durations.text(strip.rank(0.95), 3),
            strip.nanos.length,
            Durations.text(strip.rank(1), 3));
  }

  private void strip(Graphics2D g, Axes axes, Strip strip, double top, double bottom) {
    g.setColor(Style.GRID);
    g.setStroke(Style.line(Style.HAIR));
    g.draw(new Line2D.Double(axes.area().getMinX(), bottom, axes.area().getMaxX(), bottom));
    Path2D dots = new Path2D.Double();
    double step = (bottom - top - 6) / strip.nanos.length;
    Set<Point2D> drawn = new HashSet<>();
    for (int i = 0; i < strip.nanos.length; i++) {
      double x = Math.rint(axes.x(strip.nanos[i]));
      double y = Math.rint(top + 3 + step * (i + 0.5));
      if (drawn.add(new Point2D.Double(x, y))) { // many frames share a pixel
        dots.moveTo(x, y);
        dots.lineTo(x, y);
      }
    }
    g.setColor(Style.veil(marks.of(strip.method()).color(), 0.6));
    g.setStroke(Style.line(2));
    g.draw(dots);
    level(g, axes.x(strip.rank(0.5)), top, bottom, 2 * Style.THIN);
    level(g, axes.x(strip.rank(1)), top, bottom, Style.THIN);
  }

  private static void level(Graphics2D g, double x, double top, double bottom, double width) {
    g.setColor(Style.INK);
    g.setStroke(Style.line(width));
    g.draw(new Line2D.Double(x, top + 3, x, bottom - 3));
  }

  private void name(Graphics2D g, Strip strip, double y) {
    marks.draw(g, strip.method, 10, y);
    g.setColor(Style.INK);
    g.setFont(Style.bold(11));
    String name = marks.name(strip.method);
    g.drawString(name, 22f, (float) y + 4);
    double right = 22 + g.getFontMetrics().stringWidth(name + " ");
    g.setFont(Style.font(11));
    if (right + g.getFontMetrics().stringWidth(strip.knob) < NAMES) {
      g.setColor(Style.QUIET);
      g.drawString(strip.knob, (float) right, (float) y + 4);
    }
  }
}
