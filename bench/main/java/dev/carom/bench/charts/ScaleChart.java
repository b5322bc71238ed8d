// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Times against the number of circles, both axes logarithmic, a panel for each kind of time. Where
 * a method has no time, a crossed ring at the limit says that it took longer.
 */
public final class ScaleChart {

  private static final int HEAD = 72;
  private static final int NARROW_HEAD = 110;
  private static final int PANEL = 330;
  private static final int COLUMNS = 2;
  private static final double TITLE = 22;
  private static final double NAMES = 130;

  private final String title;
  private final String subtitle;
  private final Marks marks;
  private final Map<String, List<Curve>> panels;
  private final double limit;

  /**
   * Takes what is drawn.
   *
   * @param title what the reader is to take home
   * @param subtitle what is shown
   * @param marks how methods are drawn
   * @param panels the lines of each panel, by its title; NaN where a frame took too long
   * @param limit the time of a frame that is too long, in nanoseconds
   */
  public ScaleChart(
      String title, String subtitle, Marks marks, Map<String, List<Curve>> panels, double limit) {
    this.title = title;
    this.subtitle = subtitle;
    this.marks = marks;
    this.panels = new LinkedHashMap<>(panels);
    this.limit = limit;
  }

  /**
   * Draws it.
   *
   * @param width {@link Picture#WIDE} or {@link Picture#NARROW}
   * @return the picture
   */
  public Picture picture(int width) {
    int columns = width < Picture.WIDE ? 1 : COLUMNS;
    int rows = (panels.size() + columns - 1) / columns;
    int height = (columns == 1 ? NARROW_HEAD : HEAD) + rows * PANEL;
    return new Picture(width, height, title + ". " + subtitle, g -> paint(g, width, columns));
  }

  private void paint(Graphics2D g, int whole, int columns) {
    double top = Heading.draw(g, whole, title, subtitle);
    double width = (whole - 20.0) / columns;
    int i = 0;
    for (Map.Entry<String, List<Curve>> panel : panels.entrySet()) {
      double x = 10 + i % columns * width;
      int row = i / columns;
      double y = top + row * (PANEL - 4.0);
      g.setFont(Style.bold(13));
      g.setColor(Style.INK);
      g.drawString(panel.getKey(), (float) x + 6, (float) y + 15);
      Rectangle2D where = new Rectangle2D.Double(x, y + TITLE, width - 6, PANEL - TITLE - 12);
      panel(g, where, panel.getValue());
      i++;
    }
  }

  private void panel(Graphics2D g, Rectangle2D where, List<Curve> curves) {
    boolean timeOut = curves.stream().anyMatch(ScaleChart::isCut);
    double[] others = timeOut ? new double[] {limit} : new double[0];
    DecadeAxis circles =
        DecadeAxis.covering(
            curves.stream().flatMapToDouble(c -> Arrays.stream(c.x())), ScaleChart::count);
    DecadeAxis times = CurvePanel.heights(curves, null, v -> Durations.text(v, 1), others);
    Axes axes = CurvePanel.draw(g, where, NAMES, circles, times, marks, curves);
    for (Curve curve : curves) {
      for (int i = 0; i < curve.x().length; i++) {
        if (Double.isNaN(curve.middle()[i])) {
          marks.drawFailure(g, curve.method(), axes.x(curve.x()[i]), axes.y(limit));
        }
      }
    }
  }

  /** Short, for the last one stands at the edge. */
  private static String count(double n) {
    return n < 1e3
        ? Durations.number(n, 1)
        : n < 1e6 ? Durations.number(n / 1e3, 1) + "k" : Durations.number(n / 1e6, 1) + "M";
  }

  private static boolean isCut(Curve curve) {
    return Arrays.stream(curve.middle()).anyMatch(Double::isNaN);
  }
}
