// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.util.List;

/** All pictures of a figure on one sheet, under its title: for files, which have no page around. */
public final class Sheet {

  private static final int COLUMNS = 2;
  private static final int SPACE = 20;
  private static final int TITLE = 24;

  private Sheet() {}

  /**
   * Puts panels side by side, in two columns if there are several.
   *
   * @param title what the reader is to take home
   * @param note what is shown
   * @param panels of one width, at least one
   */
  public static Picture of(String title, String note, List<Panel> panels) {
    int columns = Math.min(COLUMNS, panels.size());
    int each = panels.get(0).picture().width();
    int width = Math.max(Picture.PANEL + 2 * SPACE, columns * (each + SPACE) + SPACE);
    double head = Picture.measured(g -> Heading.draw(g, width, title, note));
    int rows = (panels.size() + columns - 1) / columns;
    double height = head;
    for (int row = 0; row < rows; row++) {
      height += height(panels, row, columns);
    }
    return new Picture(
        width,
        (int) Math.ceil(height + SPACE / 2.0),
        title + ". " + note,
        g -> {
          double top = Heading.draw(g, width, title, note);
          for (int row = 0; row < rows; row++) {
            for (int i = row * columns; i < Math.min(panels.size(), (row + 1) * columns); i++) {
              draw(g, panels.get(i), SPACE + i % columns * (each + SPACE), top);
            }
            top += height(panels, row, columns);
          }
        });
  }

  private static double height(List<Panel> panels, int row, int columns) {
    return panels.stream()
        .skip((long) row * columns)
        .limit(columns)
        .mapToDouble(p -> p.picture().height() + (p.title().isEmpty() ? 0 : TITLE))
        .max()
        .orElse(0);
  }

  private static void draw(Graphics2D g, Panel panel, double left, double top) {
    double below = top;
    if (!panel.title().isEmpty()) {
      g.setFont(Style.bold(13));
      g.setColor(Style.INK);
      g.drawString(panel.title(), (float) left, (float) top + 15);
      below += TITLE;
    }
    AffineTransform before = g.getTransform();
    g.translate(left, below);
    panel.picture().painter().accept(g);
    g.setTransform(before);
  }
}
