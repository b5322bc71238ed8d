// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/**
 * Wrong answers to yes/no questions: a row for each method, a column for each class of queries,
 * misses and false hits in exact counts. The more of its answers are wrong, the darker a cell.
 */
public final class DecisionTable {

  /**
   * One cell.
   *
   * @param missed hits that were not reported; NaN if it was not measured
   * @param invented hits that were reported and are none
   * @param total all queries
   */
  public record Cell(double missed, double invented, double total) {

    boolean measured() {
      return !Double.isNaN(missed + invented + total);
    }

    double wrong() {
      return missed + invented;
    }
  }

  private static final double TOP = 76;
  private static final double NARROW_TOP = 190;
  private static final double ROW = 34;
  private static final double HEAD = 48;
  private static final int MOST_COLUMNS = 8;
  private static final int NARROW_COLUMNS = 3;
  private static final double NAMES = 178;

  private final String title;
  private final String subtitle;
  private final List<String> methods;
  private final List<String> classes;
  private final Cell[][] cells;

  /**
   * Takes what is drawn.
   *
   * @param title what the reader is to take home
   * @param subtitle what is shown
   * @param methods the rows
   * @param classes the columns
   * @param cells by row and column
   */
  public DecisionTable(
      String title, String subtitle, List<String> methods, List<String> classes, Cell[][] cells) {
    this.title = title;
    this.subtitle = subtitle;
    this.methods = List.copyOf(methods);
    this.classes = List.copyOf(classes);
    this.cells = cells;
  }

  /**
   * Draws it, in as many blocks as its columns need.
   *
   * @param width {@link Picture#WIDE} or {@link Picture#NARROW}
   * @return the picture
   */
  public Picture picture(int width) {
    boolean narrow = width < Picture.WIDE;
    int most = narrow ? NARROW_COLUMNS : MOST_COLUMNS;
    int blocks = (classes.size() + most - 1) / most;
    double block = HEAD + ROW * methods.size() + 12;
    int height = (int) Math.ceil((narrow ? NARROW_TOP : TOP) + blocks * block);
    return new Picture(
        width,
        height,
        title + ". " + subtitle,
        g -> {
          double y = Heading.draw(g, width, title, subtitle);
          int columns = (classes.size() + blocks - 1) / blocks;
          for (int from = 0; from < classes.size(); from += columns) {
            block(g, width, y, from, columns);
            y += block;
          }
        });
  }

  private void block(Graphics2D g, int whole, double top, int from, int columns) {
    int to = Math.min(classes.size(), from + columns);
    double names = Math.min(NAMES, 0.32 * whole);
    double width = (whole - 32 - names) / columns;
    for (int k = from; k < to; k++) {
      double x = 16 + names + (k - from) * width;
      head(g, x, top, width, k);
      for (int i = 0; i < methods.size(); i++) {
        cell(g, new Rectangle2D.Double(x, top + HEAD + i * ROW, width, ROW), cells[i][k]);
      }
    }
    for (int i = 0; i < methods.size(); i++) {
      g.setColor(Style.INK);
      g.setFont(Style.bold(12));
      shrink(g, methods.get(i), names - 10);
      g.drawString(methods.get(i), 16, (float) (top + HEAD + i * ROW + 21));
    }
  }

  /** The class, on two lines if need be, and how many queries. */
  private void head(Graphics2D g, double x, double top, double width, int k) {
    g.setFont(Style.bold(11));
    g.setColor(Style.INK);
    String name = classes.get(k);
    int space = name.indexOf(' ', name.length() / 3);
    boolean broken = space > 0 && g.getFontMetrics().stringWidth(name) > width - 6;
    String first = broken ? name.substring(0, space) : "";
    String second = broken ? name.substring(space + 1) : name;
    shrink(g, first.length() > second.length() ? first : second, width - 6);
    centred(g, first, x + width / 2, top + 12);
    centred(g, second, x + width / 2, top + 26);
    double most = 0;
    for (Cell[] row : cells) {
      most = Math.max(most, row[k].measured() ? row[k].total : 0);
    }
    g.setFont(Style.font(10.5));
    g.setColor(Style.QUIET);
    centred(g, "of " + Durations.number(most, 12), x + width / 2, top + 41);
  }

  private static void cell(Graphics2D g, Rectangle2D where, Cell cell) {
    Rectangle2D inner =
        new Rectangle2D.Double(
            where.getX() + 1, where.getY() + 1, where.getWidth() - 2, where.getHeight() - 2);
    g.setColor(paint(cell));
    g.fill(inner);
    g.setColor(cell.measured() ? Style.INK : Style.QUIET);
    if (cell.measured() && cell.wrong() == 0) {
      none(g, inner, cell.total);
      return;
    }
    g.setFont(cell.measured() ? Style.bold(12) : Style.font(12));
    String text =
        cell.measured()
            ? Durations.number(cell.missed, 12) + " | " + Durations.number(cell.invented, 12)
            : "not asked";
    shrink(g, text, inner.getWidth() - 4);
    centred(g, text, inner.getCenterX(), inner.getCenterY() + 4.5);
  }

  /** None of n: the share of wrong answers is then below 3/n, at a confidence of 95 %. */
  private static void none(Graphics2D g, Rectangle2D inner, double total) {
    g.setFont(Style.font(12));
    centred(g, "0", inner.getCenterX(), inner.getCenterY() + 1);
    g.setFont(Style.font(9.5));
    g.setColor(Style.QUIET);
    String bound = "below " + Durations.number(300 / total, 1) + " %";
    shrink(g, bound, inner.getWidth() - 4);
    centred(g, bound, inner.getCenterX(), inner.getCenterY() + 13);
  }

  /** By decades, so that one wrong answer in a million can be told from none. */
  private static Color paint(Cell cell) {
    if (!cell.measured()) {
      return Style.PAPER;
    }
    if (cell.wrong() == 0) {
      return Style.FLOOR;
    }
    double decades = Math.log10(cell.total / cell.wrong());
    return Style.veil(Style.VERMILION, Math.max(0.14, 0.62 - 0.08 * decades));
  }

  private static void shrink(Graphics2D g, String text, double width) {
    double wanted = g.getFontMetrics().stringWidth(text);
    if (wanted > width) {
      g.setFont(g.getFont().deriveFont((float) (g.getFont().getSize2D() * width / wanted)));
    }
  }

  private static void centred(Graphics2D g, String text, double x, double y) {
    g.drawString(text, (float) (x - g.getFontMetrics().stringWidth(text) / 2.0), (float) y);
  }
}
