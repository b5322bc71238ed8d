// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jfree.chart.axis.NumberAxis;

/**
 * A run, frame by frame: a panel for each quantity, the median over circles as a line in a band
 * from 5 to 95 %. A value of 0 stands below a break of the axis.
 */
public final class DriftChart {

  private static final int PANEL = 280;
  private static final double NAMES = 138;
  private static final String LIMIT = "off by 1 bit";

  private final String description;
  private final Marks marks;
  private final Map<String, List<Curve>> panels;
  private final double limit;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param marks how methods are drawn
   * @param panels the lines of each quantity, by its name, against frames
   * @param limit the best frame that can be had in doubles, NaN for none: a grey line in every
   *     panel
   */
  public DriftChart(
      String description, Marks marks, Map<String, List<Curve>> panels, double limit) {
    this.description = description;
    this.marks = marks;
    this.panels = new LinkedHashMap<>(panels);
    this.limit = limit;
  }

  /** Draws it, and returns a panel for each quantity. */
  public List<Panel> panels() {
    List<Panel> all = new ArrayList<>();
    Rectangle2D where = new Rectangle2D.Double(2, 0, Picture.PANEL - 4, PANEL - 4);
    panels.forEach(
        (name, curves) ->
            all.add(
                new Panel(
                    name,
                    new Picture(Picture.PANEL, PANEL, description, g -> panel(g, where, curves)))));
    return all;
  }

  private void panel(Graphics2D g, Rectangle2D where, List<Curve> curves) {
    NumberAxis frames = CurvePanel.places(curves, "frame");
    DecadeAxis heights = CurvePanel.heights(curves, null, DriftChart::power);
    Axes axes = CurvePanel.draw(g, where, NAMES, frames, heights, marks, curves);
    if (!Double.isNaN(limit)) {
      horizon(g, axes, limit);
      g.setFont(Style.font(11));
      String text = LIMIT;
      double end = axes.area().getMaxX() - g.getFontMetrics().stringWidth(text) - 4;
      double x = Math.min(axes.x(limit) + 5, end);
      g.drawString(text, (float) x, (float) axes.area().getMaxY() - 42);
    }
  }

  private static void horizon(Graphics2D g, Axes axes, double frame) {
    double x = axes.x(frame);
    if (x >= axes.area().getMinX() && x <= axes.area().getMaxX()) {
      g.setColor(Style.QUIET);
      g.setStroke(Style.dashes(Style.FIRM, 3, 3));
      g.draw(new Line2D.Double(x, axes.area().getMinY(), x, axes.area().getMaxY()));
    }
  }

  private static String power(double value) {
    return Math.abs(Math.log10(value)) < 2.5
        ? Durations.number(value, 1)
        : "1e" + Math.round(Math.log10(value));
  }
}
