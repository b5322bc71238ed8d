// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** Predicted bounds of errors against the true errors, both axes logarithmic: one panel a scene. */
public final class TrustChart {

  private static final int WIDTH = Picture.PANEL;
  private static final int HEIGHT = 340;
  private static final double NAMES = 122;

  private static final String BOUND = "carom";
  private static final String ERROR = "error";

  private static final Marks MARKS =
      new Marks(List.of(BOUND, ERROR), method -> method.equals(BOUND) ? "predicted" : "true error");

  private final String description;
  private final Map<String, Curve> curves;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param curves the bounds against the errors, in radii, by the title of a panel
   */
  public TrustChart(String description, Map<String, Curve> curves) {
    this.description = description;
    this.curves = curves;
  }

  /** Draws it, and returns one panel a scene. */
  public List<Panel> panels() {
    return curves.entrySet().stream()
        .map(
            panel ->
                new Panel(
                    panel.getKey(),
                    new Picture(WIDTH, HEIGHT, description, g -> draw(g, panel.getValue()))))
        .toList();
  }

  private static void draw(Graphics2D g, Curve bounds) {
    double[] x = bounds.x();
    List<Curve> lines = List.of(bounds, new Curve(ERROR, "", x, x, x, x));
    DecadeAxis errors = DecadeAxis.covering(Arrays.stream(x), TrustChart::power);
    errors.setLabel("true error of a place, in radii");
    DecadeAxis heights = CurvePanel.heights(lines, "error, in radii", TrustChart::power);
    Rectangle2D where = new Rectangle2D.Double(2, 0, WIDTH - 4, HEIGHT - 4);
    CurvePanel.draw(g, where, NAMES, errors, heights, MARKS, lines);
  }

  private static String power(double value) {
    return "1e" + Math.round(Math.log10(value));
  }
}
