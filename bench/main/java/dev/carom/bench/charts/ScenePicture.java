// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.font.FontRenderContext;
import java.awt.geom.Rectangle2D;
import java.math.BigDecimal;

/** A scene at one moment, with a caption under it. */
final class ScenePicture {

  private static final int WIDTH = 840;
  private static final int HEIGHT = 640;
  private static final int CAPTION = 24;
  private static final int MARGIN = 20;
  private static final double TEXT = 14;

  private ScenePicture() {}

  static Picture of(SceneDrawing drawing, Still still, String when, String what) {
    Dimension size = drawing.size(WIDTH, HEIGHT);
    String text = what + arrows(drawing);
    int width = Math.max(size.width, captionWidth(when, text));
    return new Picture(
        width,
        size.height + CAPTION,
        when + ": " + what,
        g -> {
          drawing.draw(g, new Rectangle2D.Double(0, 0, width, size.height), still);
          caption(g, size.height + 8, width, when, text);
        });
  }

  private static int captionWidth(String when, String what) {
    FontRenderContext context = new FontRenderContext(null, true, true);
    double left = Style.bold(TEXT).getStringBounds(when, context).getWidth();
    double right = Style.font(TEXT).getStringBounds(what, context).getWidth();
    return (int) Math.ceil(left + right) + 4 * MARGIN;
  }

  private static void caption(Graphics2D g, int y, int width, String when, String what) {
    g.setColor(Style.INK);
    g.setFont(Style.bold(TEXT));
    g.drawString(when, MARGIN, y);
    g.setColor(Style.QUIET);
    g.setFont(Style.font(TEXT));
    Rectangle2D right = g.getFontMetrics().getStringBounds(what, g);
    g.drawString(what, (float) (width - MARGIN - right.getWidth()), y);
  }

  private static String arrows(SceneDrawing drawing) {
    if (drawing.arrowTime() == 0) {
      return "";
    }
    String time = BigDecimal.valueOf(drawing.arrowTime()).stripTrailingZeros().toPlainString();
    return "; an arrow is the way of " + time + (time.equals("1") ? " frame" : " frames");
  }
}
