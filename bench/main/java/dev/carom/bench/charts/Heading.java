// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;

/** The title of a picture and the line below it, broken where they are longer than it is wide. */
final class Heading {

  private static final int LEFT = 16;
  private static final int TOP = 14;

  private Heading() {}

  /** Draws them and tells the height below which the picture begins. */
  static double draw(Graphics2D g, int width, String title, String subtitle) {
    double y = TOP;
    y = lines(g, width, y, title, Style.bold(17), Style.INK);
    y = lines(g, width, y + 2, subtitle, Style.font(13), Style.QUIET);
    return y + 8;
  }

  private static double lines(
      Graphics2D g, int width, double top, String text, Font font, Color color) {
    g.setFont(font);
    g.setColor(color);
    FontMetrics metrics = g.getFontMetrics();
    double y = top;
    StringBuilder line = new StringBuilder();
    for (String word : text.split(" ", -1)) {
      String longer = line.isEmpty() ? word : line + " " + word;
      if (!line.isEmpty() && metrics.stringWidth(longer) > width - 2 * LEFT) {
        y = line(g, y, line.toString(), metrics);
        line.setLength(0);
        line.append(word);
      } else {
        line.setLength(0);
        line.append(longer);
      }
    }
    return line.isEmpty() ? y : line(g, y, line.toString(), metrics);
  }

  private static double line(Graphics2D g, double top, String text, FontMetrics metrics) {
    g.drawString(text, (float) LEFT, (float) (top + metrics.getAscent()));
    return top + metrics.getHeight();
  }
}
