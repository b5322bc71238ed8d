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

  private static final int PANEL = 290;
  private static final double NAMES = 148;

  private final String description;
  private final Marks marks;
  private final Map<String, List<Curve>> panels;
  private final double goal;
  private final double published;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param marks how methods are drawn
   * @param panels the lines of each panel, by what stands below it
   * @param goal the time of a frame that the experiment aimed at, in nanoseconds
   * @param published the time that it reached
   */
  public SweepChart(
      String description,
      Marks marks,
      Map<String, List<Curve>> panels,
      double goal,
      double published) {
    this.description = description;
    this.marks = marks;
    this.panels = new LinkedHashMap<>(panels);
    this.goal = goal;
    this.published = published;
  }

  /** Draws it. */
  public List<Panel> panels() {
    return panels.entrySet().stream()
        .map(
            panel ->
                new Panel(
                    "Time of a frame against the " + panel.getKey(),
                    new Picture(
                        Picture.PANEL, PANEL, description, g -> paint(g, panel.getValue()))))
        .toList();
  }

  /** All panels have the same heights. */
  private void paint(Graphics2D g, List<Curve> curves) {
    List<Curve> all = panels.values().stream().flatMap(List::stream).toList();
    DecadeAxis times = CurvePanel.heights(all, null, v -> Durations.text(v, 1), goal, published);
    times.withTexts(v -> Durations.text(v, 3));
    Rectangle2D where = new Rectangle2D.Double(2, 0, Picture.PANEL - 4, PANEL - 4);
    Axes axes =
        CurvePanel.draw(g, where, NAMES, CurvePanel.places(curves, null), times, marks, curves);
    level(g, axes, published, Style.INK, "published: " + fps(published));
    level(g, axes, goal, Style.VERMILION, "goal: " + fps(goal));
  }

  private static String fps(double nanos) {
    return Durations.number(1e9 / nanos, 3) + " frames/s";
  }

  private static void level(Graphics2D g, Axes axes, double value, Color color, String text) {
    axes.level(g, value, color, Style.dashes(Style.THIN, 7, 4));
    g.setFont(Style.font(11));
    boolean above = color.equals(Style.INK);
    float y = (float) axes.y(value) + (above ? -5 : 13);
    g.drawString(text, (float) axes.area().getMinX() + 8, y);
  }
}
