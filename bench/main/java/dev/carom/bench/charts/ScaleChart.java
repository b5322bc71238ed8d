// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The time of a frame against the number of circles, both axes logarithmic. Where a method has no
 * time, a crossed ring at the limit says that it took longer.
 */
public final class ScaleChart {

  private static final int PANEL = 300;
  private static final double NAMES = 132;
  private static final double RING = 16;

  /** The time of a frame at 60 frames a second, in nanoseconds. */
  private static final double BUDGET = 1e9 / 60;

  private final String description;
  private final Marks marks;
  private final Map<String, List<Curve>> panels;
  private final double limit;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param marks how methods are drawn
   * @param panels the lines of each panel, by its title; NaN where a frame took too long
   * @param limit the time of a frame that is too long, in nanoseconds: where rings stand
   */
  public ScaleChart(
      String description, Marks marks, Map<String, List<Curve>> panels, double limit) {
    this.description = description;
    this.marks = marks;
    this.panels = new LinkedHashMap<>(panels);
    this.limit = limit;
  }

  /** Draws it. */
  public List<Panel> panels() {
    return panels.entrySet().stream()
        .map(
            panel ->
                new Panel(
                    panel.getKey(),
                    new Picture(
                        Picture.PANEL, PANEL, description, g -> panel(g, panel.getValue()))))
        .toList();
  }

  private void panel(Graphics2D g, List<Curve> curves) {
    boolean timeOut = curves.stream().anyMatch(ScaleChart::isCut);
    double[] others = {BUDGET, timeOut ? limit : BUDGET};
    DecadeAxis circles =
        DecadeAxis.covering(
            curves.stream().flatMapToDouble(c -> Arrays.stream(c.x())), ScaleChart::count);
    circles.setLabel("number of circles");
    DecadeAxis times =
        CurvePanel.heights(curves, "time of a frame", v -> Durations.text(v, 1), others);
    times.withTexts(v -> Durations.text(v, 3));
    Rectangle2D where = new Rectangle2D.Double(2, 0, Picture.PANEL - 4, PANEL - 4);
    Axes axes = CurvePanel.draw(g, where, NAMES, circles, times, marks, curves);
    axes.level(g, BUDGET, Style.QUIET, Style.dashes(Style.THIN, 7, 4));
    g.setFont(Style.font(11));
    g.drawString("60 FPS", (float) axes.area().getMinX() + 6, (float) axes.y(BUDGET) - 4);
    if (timeOut) {
      rings(g, axes, curves);
    }
  }

  /** Those that meet at one place stand above each other. */
  private void rings(Graphics2D g, Axes axes, List<Curve> curves) {
    Map<Double, Integer> taken = new HashMap<>();
    for (Curve curve : curves) {
      for (int i = 0; i < curve.x().length; i++) {
        if (Double.isNaN(curve.middle()[i])) {
          int below = taken.merge(curve.x()[i], 1, Integer::sum) - 1;
          double x = axes.x(curve.x()[i]);
          double y = axes.y(limit) + below * RING;
          String text = marks.name(curve.method()) + ": longer than " + Durations.text(limit, 3);
          Hover.over(g, text, () -> marks.drawFailure(g, curve.method(), x, y));
        }
      }
    }
  }

  /** Short, for the last one stands at the edge. */
  static String count(double n) {
    return n < 1e3
        ? Durations.number(n, 1)
        : n < 1e6 ? Durations.number(n / 1e3, 1) + "k" : Durations.number(n / 1e6, 1) + "M";
  }

  private static boolean isCut(Curve curve) {
    return Arrays.stream(curve.middle()).anyMatch(Double::isNaN);
  }
}
