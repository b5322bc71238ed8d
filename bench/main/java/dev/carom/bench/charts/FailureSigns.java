// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** How a class of cells looks: a colour, and a sign for those who read in grey. */
final class FailureSigns {

  /** The number of the class that has no sign. */
  static final int RIGHT = 0;

  /** The number of the class that has no colour. */
  static final int NO_ANSWER = 5;

  private static final int DRIFTED = 1;

  /** The diameter of its sign, in pixels. */
  private static final double DOT = 2.6;

  /** Half the size of a sign, and the size of a corner, as a share of a cell. */
  private static final double SIZE = 0.22;

  private static final double CORNER = 0.42;

  /** Right, drifted, far off, lost speed, escaped, no answer. */
  private static final List<Color> COLORS =
      List.of(Style.SKY, Style.YELLOW, Style.ORANGE, Style.PURPLE, Style.VERMILION, Style.FLOOR);

  /** Signs stay dark on a dark page, too, where these colours are brighter still. */
  private static final Color SIGN = new Color(0x11151A);

  private FailureSigns() {}

  static void fill(Graphics2D g, Shape area, int number) {
    g.setColor(COLORS.get(number));
    g.fill(area);
  }

  /** Draws the sign of a class in some cells. */
  static void sign(Graphics2D g, List<Rectangle2D> cells, int number) {
    Path2D signs = new Path2D.Double();
    for (Rectangle2D cell : cells) {
      double s = Math.min(cell.getWidth(), cell.getHeight()) * SIZE;
      signs.append(sign(number, cell.getCenterX(), cell.getCenterY(), s), false);
    }
    if (number != RIGHT && !cells.isEmpty()) {
      g.setColor(ink(number));
      g.setStroke(Style.line(number == DRIFTED ? DOT : Style.THIN));
      g.draw(signs);
    }
  }

  private static Color ink(int number) {
    return number == NO_ANSWER ? Style.QUIET : SIGN;
  }

  /** Nothing; a dot; a cross; a bar; an arrow out of the cell; a slash. */
  private static Path2D sign(int number, double x, double y, double s) {
    double[][] points =
        switch (number) {
          case DRIFTED -> new double[][] {{x, y}, {x, y}};
          case 2 ->
              new double[][] {
                {x - s, y - s}, {x + s, y + s}, gap(), {x - s, y + s}, {x + s, y - s}
              };
          case 3 -> new double[][] {{x - 1.3 * s, y}, {x + 1.3 * s, y}};
          case 4 ->
              new double[][] {
                {x, y + 1.4 * s},
                {x, y - 1.3 * s},
                gap(),
                {x - s, y - 0.2 * s},
                {x, y - 1.4 * s},
                {x + s, y - 0.2 * s}
              };
          case NO_ANSWER -> new double[][] {{x - s, y + s}, {x + s, y - s}};
          default -> new double[0][];
        };
    return Axes.path(points);
  }

  private static double[] gap() {
    return new double[] {Double.NaN, Double.NaN};
  }

  /** Darkens a corner of some cells of a class. */
  static void corner(Graphics2D g, List<Rectangle2D> cells, int number) {
    Path2D corners = new Path2D.Double();
    for (Rectangle2D cell : cells) {
      double s = Math.min(cell.getWidth(), cell.getHeight()) * CORNER;
      corners.moveTo(cell.getMaxX() - s, cell.getMinY());
      corners.lineTo(cell.getMaxX(), cell.getMinY());
      corners.lineTo(cell.getMaxX(), cell.getMinY() + s);
      corners.closePath();
    }
    if (!cells.isEmpty()) {
      g.setColor(ink(number));
      g.fill(corners);
    }
  }
}
