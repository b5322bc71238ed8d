// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;

/** Errors of a quantity that should not change, against bounces, both axes logarithmic. */
public final class BounceChart {

  private static final int HEIGHT = 360;
  private static final double NAMES = 110;

  private final String description;
  private final Marks marks;
  private final List<Curve> curves;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param marks how methods are drawn
   * @param curves a line for each setting
   */
  public BounceChart(String description, Marks marks, List<Curve> curves) {
    this.description = description;
    this.marks = marks;
    this.curves = List.copyOf(curves);
  }

  /** Draws it. */
  public Picture picture() {
    return new Picture(Picture.PANEL, HEIGHT, description, this::draw);
  }

  private void draw(Graphics2D g) {
    DecadeAxis bounces =
        DecadeAxis.covering(
            curves.stream().flatMapToDouble(c -> Arrays.stream(c.x()).map(n -> Math.max(n, 1.25))),
            ScaleChart::count);
    bounces.setLabel("number of bounces");
    DecadeAxis errors = CurvePanel.heights(curves, "error of the energy", BounceChart::percent);
    Rectangle2D where = new Rectangle2D.Double(2, 0, Picture.PANEL - 4, HEIGHT - 4);
    CurvePanel.draw(g, where, NAMES, bounces, errors, marks, curves);
  }

  private static String percent(double share) {
    return Durations.number(100 * share, 2) + " %";
  }
}
