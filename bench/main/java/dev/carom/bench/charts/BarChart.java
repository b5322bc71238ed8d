// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;

/** Bars from left to right, each with its words above it and its number behind it. */
public final class BarChart {

  /**
   * One bar.
   *
   * @param label what it stands for
   * @param parts what it is made of, from the left; NaN for what was not measured
   * @param text its number
   */
  @SuppressWarnings("ArrayRecordComponent") // compared by nobody
  public record Bar(String label, double[] parts, String text) {

    double whole() {
      return Arrays.stream(parts).filter(Double::isFinite).sum();
    }
  }

  private static final int ROW = 31;
  private static final double BAR = 11;
  private static final double NUMBER = 84;
  private static final double LEGEND = 22;

  /** Colours of the parts of a bar. All but the first stand out, since those parts are narrow. */
  private static final List<Color> COLORS = List.of(Style.SKY, Style.ORANGE, Style.VERMILION);

  private final String description;
  private final List<String> legend;
  private final List<Bar> bars;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param legend the names of the parts, or nothing if bars have but one
   * @param bars from the top
   */
  public BarChart(String description, List<String> legend, List<Bar> bars) {
    this.description = description;
    this.legend = List.copyOf(legend);
    this.bars = List.copyOf(bars);
  }

  /** Draws it. */
  public Picture picture() {
    double head = legend.isEmpty() ? 0 : LEGEND;
    int height = (int) head + ROW * bars.size() + 6;
    return new Picture(Picture.PANEL, height, description, g -> paint(g, head));
  }

  private void paint(Graphics2D g, double head) {
    double x = 2;
    for (int i = 0; i < legend.size(); i++) {
      g.setColor(COLORS.get(i));
      g.fill(new Rectangle2D.Double(x, 4, 11, 11));
      g.setColor(Style.INK);
      g.setFont(Style.font(11));
      g.drawString(legend.get(i), (float) x + 15, 14f);
      x += 15 + g.getFontMetrics().stringWidth(legend.get(i)) + 14;
    }
    double most = bars.stream().mapToDouble(Bar::whole).max().orElse(1);
    double scale = (Picture.PANEL - NUMBER) / (most > 0 ? most : 1);
    for (int i = 0; i < bars.size(); i++) {
      Bar bar = bars.get(i);
      double top = head + i * ROW;
      Hover.over(g, bar.label + ": " + bar.text, () -> bar(g, bar, top, scale));
    }
  }

  private static void bar(Graphics2D g, Bar bar, double top, double scale) {
    g.setColor(Style.INK);
    g.setFont(Style.font(11));
    g.drawString(bar.label, 2f, (float) top + 12);
    double x = 2;
    for (int i = 0; i < bar.parts.length; i++) {
      double width = Double.isFinite(bar.parts[i]) ? scale * bar.parts[i] : 0;
      g.setColor(COLORS.get(i));
      g.fill(new Rectangle2D.Double(x, top + 16, width, BAR));
      x += width;
    }
    g.setColor(Style.INK);
    g.setFont(Style.bold(11));
    g.drawString(bar.text, (float) x + 5, (float) top + 26);
  }
}
