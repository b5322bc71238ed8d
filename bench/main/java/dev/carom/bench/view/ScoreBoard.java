// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.bench.charts.Style;
import dev.carom.bench.duel.Duel;
import dev.carom.bench.duel.ScoreLine;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** Draws the score of one side of a duel; failures are red. */
final class ScoreBoard {

  /** Pixels that a score takes. */
  static final int HEIGHT = 22 + Duel.LINES * 15 + 10;

  private static final double TITLE = 14;
  private static final double TEXT = 12;
  private static final int ROW = 15;
  private static final int INSET = 26;

  private ScoreBoard() {}

  static void draw(
      Graphics2D g, Rectangle2D area, String title, List<ScoreLine> lines, Style.Scheme scheme) {
    Style.smooth(g);
    float x = (float) area.getX() + INSET;
    float y = (float) area.getY() + 16;
    g.setFont(Style.bold(TITLE));
    g.setColor(scheme.ink());
    g.drawString(title, x, y);
    y += ROW + 4;
    for (ScoreLine line : lines) {
      g.setFont(line.bad() ? Style.bold(TEXT) : Style.font(TEXT));
      g.setColor(line.bad() ? Style.VERMILION : scheme.ink());
      g.drawString(fitting(g, line.text(), area.getWidth() - 2 * INSET), x, y);
      y += ROW;
    }
  }

  /** A text, cut if it is longer than there is room for. */
  private static String fitting(Graphics2D g, String text, double width) {
    FontMetrics metrics = g.getFontMetrics();
    String fit = text;
    while (metrics.stringWidth(fit) > width && fit.length() > 2) {
      fit = fit.substring(0, fit.length() - 2) + "…";
    }
    return fit;
  }
}
