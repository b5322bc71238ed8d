// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The time of a frame against one number of the scene, a panel for each: mean as a line, from the
 * fastest to the slowest frame as a band; and two times to compare with.
 */
public final class SweepChart {

  private static final int COLUMNS = 2;
  private static final int HEAD = 72;
  private static final int NARROW_HEAD = 150;
  private static final int PANEL = 330;
  private static final double TITLE = 22;
  private static final double NAMES = 120;

  private final String title;
  private final String subtitle;
  private final Marks marks;
  private final Map<String, List<Curve>> panels;
  private final double goal;
  private final double published;

  /**
   * Takes what is drawn.
   *
   * @param title what the reader is to take home
   * @param subtitle what is shown
   * @param marks how methods are drawn
   * @param panels the lines of each panel, by what stands below it
   * @param goal the time of a frame that the experiment aimed at, in nanoseconds
   * @param published the time that it reached
   */
  public SweepChart(
      String title,
      String subtitle,
      Marks marks,
      Map<String, List<Curve>> panels,
      double goal,
      double published) {
    this.title = title;
    this.subtitle = subtitle;
    this.marks = marks;
    this.panels = new LinkedHashMap<>(panels);
    this.goal = goal;
    this.published = published;
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
    return new Picture(
        width, height, title + ". " + subtitle, g -> paint(g, width, columns, height));
  }

  private void paint(Graphics2D g, int whole, int columns, int height) {
    double top = Heading.draw(g, whole, title, subtitle);
    int rows = (panels.size() + columns - 1) / columns;
    double each = (height - top - 8) / rows;
    List<Curve> all = panels.values().stream().flatMap(List::stream).toList();
    double width = (whole - 20.0) / columns;
    int i = 0;
    for (Map.Entry<String, List<Curve>> panel : panels.entrySet()) {
      double x = 10 + i % columns * width;
      int row = i / columns;
      double y = top + row * each;
      g.setFont(Style.bold(13));
      g.setColor(Style.INK);
      g.drawString("against " + panel.getKey(), (float) x + 6, (float) y + 15);
      DecadeAxis times = CurvePanel.heights(all, null, v -> Durations.text(v, 1), goal, published);
      Axes axes =
          CurvePanel.draw(
              g,
              new Rectangle2D.Double(x, y + TITLE, width - 6, each - TITLE - 8),
              NAMES,
              CurvePanel.places(panel.getValue(), null),
              times,
              marks,
              panel.getValue());
      level(g, axes, published, Style.INK, "published: " + fps(published));
      level(g, axes, goal, Style.VERMILION, "goal: " + fps(goal));
      i++;
    }
  }

  private static String fps(double nanos) {
    return Durations.number(1e9 / nanos, 3) + " frames a second";
  }

  private static void level(Graphics2D g, Axes axes, double value, Color color, String text) {
    axes.level(g, value, color, Style.dashes(Style.THIN, 7, 4));
    g.setFont(Style.font(11));
    boolean above = color.equals(Style.INK);
    float y = (float) axes.y(value) + (above ? -5 : 13);
    g.drawString(text, (float) axes.area().getMinX() + 8, y);
  }
}
