// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jfree.chart.axis.NumberAxis;

/**
 * What becomes of a run, frame by frame: a panel for each quantity, the median over circles as a
 * line in a band from 5 to 95 %, and in the first panel the frame at which each method has left the
 * true course. A value of 0 is drawn at the lower edge.
 */
public final class DriftChart {

  private static final int HEAD = 72;
  private static final int NARROW_HEAD = 190;
  private static final int PANEL = 250;
  private static final double NAMES = 176;
  private static final double TITLE = 20;
  private static final String LIMIT = "a start 1 ulp away has left the true course";

  private static final String SHORT_LIMIT = "1 ulp away: lost";

  private final String title;
  private final String subtitle;
  private final Marks marks;
  private final Map<String, List<Curve>> panels;
  private final Map<String, Double> horizons;
  private final double limit;

  /**
   * Takes what is drawn.
   *
   * @param title what the reader is to take home
   * @param subtitle what is shown
   * @param marks how methods are drawn
   * @param panels the lines of each quantity, by its name, against frames
   * @param horizons by method, the frame at which half of its circles have left the true course; a
   *     method without a mark of its own is drawn in grey
   * @param limit the best frame that can be had in doubles, NaN for none: a grey line in every
   *     panel
   */
  public DriftChart(
      String title,
      String subtitle,
      Marks marks,
      Map<String, List<Curve>> panels,
      Map<String, Double> horizons,
      double limit) {
    this.title = title;
    this.subtitle = subtitle;
    this.marks = marks;
    this.panels = new LinkedHashMap<>(panels);
    this.horizons = new LinkedHashMap<>(horizons);
    this.limit = limit;
  }

  /**
   * Draws it.
   *
   * @param width {@link Picture#WIDE} or {@link Picture#NARROW}
   * @return the picture
   */
  public Picture picture(int width) {
    int height = (width < Picture.WIDE ? NARROW_HEAD : HEAD) + PANEL * panels.size();
    return new Picture(width, height, title + ". " + subtitle, g -> paint(g, width, height));
  }

  private void paint(Graphics2D g, int width, int height) {
    double top = Heading.draw(g, width, title, subtitle);
    double each = (height - top - 6) / panels.size();
    boolean first = true;
    for (Map.Entry<String, List<Curve>> panel : panels.entrySet()) {
      Rectangle2D where = new Rectangle2D.Double(10, top + TITLE, width - 20, each - TITLE - 4);
      g.setFont(Style.bold(13));
      g.setColor(Style.INK);
      g.drawString(name(g, panel.getKey(), width - 32), 16, (float) (top + 14));
      panel(g, where, panel.getValue(), first);
      top += each;
      first = false;
    }
  }

  /** As much of it as has room: what stands behind a colon or a comma may be left out. */
  private static String name(Graphics2D g, String text, double width) {
    String name = text;
    while (g.getFontMetrics().stringWidth(name) > width && name.matches(".*[:,].*")) {
      name = name.replaceFirst("[:,][^:,]*$", "");
    }
    return name;
  }

  private void panel(Graphics2D g, Rectangle2D where, List<Curve> curves, boolean first) {
    NumberAxis frames = CurvePanel.places(curves, "frame");
    DecadeAxis heights = CurvePanel.heights(curves, null, DriftChart::power);
    double names = Math.min(NAMES, 0.36 * where.getWidth());
    Axes axes = CurvePanel.draw(g, where, names, frames, heights, marks, curves);
    if (!Double.isNaN(limit)) {
      horizon(g, axes, limit, Style.QUIET, axes.area().getMinY());
    }
    if (first && !Double.isNaN(limit)) {
      g.setFont(Style.font(11));
      boolean narrow = where.getWidth() < Picture.WIDE / 2.0;
      String text = narrow ? SHORT_LIMIT : LIMIT;
      double end = axes.area().getMaxX() - g.getFontMetrics().stringWidth(text) - 4;
      double x = Math.min(axes.x(limit) + 5, end);
      g.drawString(text, (float) x, (float) axes.area().getMaxY() - 42);
    }
    if (first) {
      horizons.forEach(
          (method, frame) -> {
            double y = axes.area().getMaxY();
            horizon(g, axes, frame, marks.of(method).color(), y - 22);
            marks.draw(g, method, axes.x(frame), y - 26, false);
          });
    }
  }

  private static void horizon(Graphics2D g, Axes axes, double frame, Color color, double from) {
    double x = axes.x(frame);
    if (x >= axes.area().getMinX() && x <= axes.area().getMaxX()) {
      g.setColor(color);
      g.setStroke(Style.dashes(Style.FIRM, 3, 3));
      g.draw(new Line2D.Double(x, from, x, axes.area().getMaxY()));
    }
  }

  private static String power(double value) {
    return Math.abs(Math.log10(value)) < 2.5
        ? Durations.number(value, 1)
        : "1e" + Math.round(Math.log10(value));
  }
}
