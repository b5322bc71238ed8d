// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** Bars from left to right, each with its words above it and its number behind it. */
public final class BarChart {

  /**
   * One bar.
   *
   * @param label what it stands for; ours is written in bold
   * @param color that of its method, or {@link Style#BLUE} where all bars are ours
   * @param value its length; one that is not finite has none
   * @param text its number
   */
  public record Bar(String label, Color color, double value, String text) {}

  private static final int ROW = 31;
  private static final double BAR = 11;
  private static final double NUMBER = 84;

  private final String description;
  private final List<Bar> bars;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param bars from the top
   */
  public BarChart(String description, List<Bar> bars) {
    this.description = description;
    this.bars = List.copyOf(bars);
  }

  /** Draws it. */
  public Picture picture() {
    return new Picture(Picture.PANEL, ROW * bars.size() + 6, description, this::paint);
  }

  private void paint(Graphics2D g) {
    double most = bars.stream().mapToDouble(Bar::value).filter(Double::isFinite).max().orElse(1);
    double scale = (Picture.PANEL - NUMBER) / (most > 0 ? most : 1);
    for (int i = 0; i < bars.size(); i++) {
      Bar bar = bars.get(i);
      double top = i * ROW;
      Hover.over(g, bar.label + ": " + bar.text, () -> bar(g, bar, top, scale));
    }
  }

  private static void bar(Graphics2D g, Bar bar, double top, double scale) {
    g.setColor(Style.INK);
    g.setFont(bar.label.equals("Carom") ? Style.bold(11) : Style.font(11));
    g.drawString(bar.label, 2f, (float) top + 12);
    double width = Double.isFinite(bar.value) ? Math.max(1.5, scale * bar.value) : 0;
    g.setColor(bar.color);
    g.fill(new Rectangle2D.Double(2, top + 16, width, BAR));
    g.setColor(Style.INK);
    g.setFont(Style.bold(11));
    g.drawString(bar.text, (float) (2 + width) + 5, (float) top + 26);
  }
}
