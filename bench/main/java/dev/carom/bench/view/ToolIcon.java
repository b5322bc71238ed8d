// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.bench.charts.Style;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import javax.swing.Icon;

/** The signs on buttons, as shapes: sharp at any scale, and in the colour of the button's text. */
@SuppressWarnings("ImmutableEnumChecker") // nobody changes the shapes
enum ToolIcon implements Icon {
  RUN(true, path(5, 3, 13, 8, 5, 13)),
  PAUSE(true, box(4, 3, 3, 10), box(9, 3, 3, 10)),
  FRAME(true, path(4, 3, 10, 8, 4, 13), box(11, 3, 2, 10)),
  IMPACT(false, disk(6, 8, 3.5), line(12, 2, 12, 14), line(9.5, 8, 11, 8)),
  RESTART(true, path(12, 3, 6, 8, 12, 13), box(3, 3, 2, 10)),
  FIT(
      false,
      path(2, 6, 2, 3, 5, 3),
      path(11, 3, 14, 3, 14, 6),
      path(14, 10, 14, 13, 11, 13),
      path(5, 13, 2, 13, 2, 10)),
  HAND(true, path(4, 2, 12, 10, 8.4, 10.2, 10.3, 14, 8.8, 14.7, 7, 10.9, 4, 13.2)),
  CIRCLE(false, disk(8, 8, 5.5)),
  LINE(false, line(3, 13, 13, 3)),
  PEG(true, disk(8, 8, 4.5)),
  DELETE(false, line(4, 4, 12, 12), line(12, 4, 4, 12));

  private static final int SIZE = 16;
  private static final double WIDTH = 1.6;

  private final boolean filled;
  private final Shape[] shapes;

  ToolIcon(boolean filled, Shape... shapes) {
    this.filled = filled;
    this.shapes = shapes;
  }

  /** Open: what is filled closes itself. */
  private static Shape path(double... xy) {
    Path2D path = new Path2D.Double();
    path.moveTo(xy[0], xy[1]);
    for (int i = 2; i < xy.length; i += 2) {
      path.lineTo(xy[i], xy[i + 1]);
    }
    return path;
  }

  private static Shape line(double ax, double ay, double bx, double by) {
    return new Line2D.Double(ax, ay, bx, by);
  }

  private static Shape box(double x, double y, double width, double height) {
    return new Rectangle2D.Double(x, y, width, height);
  }

  private static Shape disk(double x, double y, double r) {
    return new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r);
  }

  @Override
  public void paintIcon(Component on, Graphics to, int x, int y) {
    Graphics2D g = (Graphics2D) to.create();
    try {
      Style.smooth(g);
      g.translate(x, y);
      Color color = on.getForeground();
      g.setColor(on.isEnabled() ? color : Style.veil(color, 0.4));
      g.setStroke(Style.line(WIDTH));
      for (Shape shape : shapes) {
        if (filled) {
          g.fill(shape);
        } else {
          g.draw(shape);
        }
      }
    } finally {
      g.dispose();
    }
  }

  @Override
  public int getIconWidth() {
    return SIZE;
  }

  @Override
  public int getIconHeight() {
    return SIZE;
  }
}
