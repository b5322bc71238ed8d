// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.bench.charts.Style;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.RoundRectangle2D;
import java.util.List;

/** Lines of text on a panel of their own, over a scene. */
final class Notes {

  private static final double TEXT = 12;
  private static final int PAD = 7;

  private Notes() {}

  /** Draws them with the upper left corner at a place, but inside of the area. */
  static void draw(
      Graphics2D g, List<String> lines, double x, double y, Rectangle area, Style.Scheme scheme) {
    if (lines.isEmpty()) {
      return;
    }
    g.setFont(Style.font(TEXT));
    FontMetrics metrics = g.getFontMetrics();
    int width = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0) + 2 * PAD;
    int height = lines.size() * metrics.getHeight() + 2 * PAD;
    double left = Math.max(area.x, Math.min(x, area.x + area.width - width));
    double top = Math.max(area.y, Math.min(y, area.y + area.height - height));
    g.setColor(Style.veil(scheme.paper(), 0.88));
    g.fill(new RoundRectangle2D.Double(left, top, width, height, 10, 10));
    g.setColor(scheme.grid());
    g.setStroke(Style.line(Style.HAIR));
    g.draw(new RoundRectangle2D.Double(left, top, width, height, 10, 10));
    g.setColor(scheme.ink());
    double base = top + PAD + metrics.getAscent();
    for (String line : lines) {
      g.drawString(line, (float) (left + PAD), (float) base);
      base += metrics.getHeight();
    }
  }
}
