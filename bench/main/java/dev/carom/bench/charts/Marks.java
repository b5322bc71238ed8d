// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;

/** The colour and the shape of each method, the same in all charts of one report. */
public final class Marks {

  /** The method that has blue circles for itself. */
  static final String OURS = "carom";

  private static final double RADIUS = 5;

  /** Ours is found first. */
  private static final double OUR_RADIUS = 7;

  /** The outer radius of a ring. */
  static final double RING = 10;

  private static final double RING_WIDTH = 2.5;

  private static final List<Color> COLORS =
      List.of(Style.ORANGE, Style.GREEN, Style.VERMILION, Style.SKY, Style.PURPLE, Style.INK);

  /** Corners, and how far the first one is turned from straight up; a star has its notches. */
  private static final List<Shape> SHAPES =
      List.of(
          polygon(4, Math.PI / 4, 1),
          polygon(3, 0, 1),
          polygon(4, 0, 1),
          polygon(3, Math.PI, 1),
          polygon(5, 0, 1),
          polygon(10, 0, 0.45),
          polygon(6, 0, 1));

  /**
   * How a method is drawn.
   *
   * @param color of its lines and dots
   * @param shape of its dots, around the origin
   * @param dashed whether its lines are
   */
  record Mark(Color color, Shape shape, boolean dashed) {

    /** How its lines are drawn. */
    BasicStroke stroke() {
      return dashed ? Style.dashes(Style.FIRM, 6, 3) : Style.line(Style.FIRM);
    }
  }

  private final Map<String, Mark> marks = new LinkedHashMap<>();
  private final UnaryOperator<String> names;

  /**
   * Hands out marks. Twenty and more methods have different ones.
   *
   * @param methods their labels, in an order that says which mark
   * @param names the words for a label where people read
   */
  public Marks(Collection<String> methods, UnaryOperator<String> names) {
    this.names = names;
    int next = 0;
    for (String method : methods) {
      if (isOurs(method)) {
        marks.put(method, new Mark(Style.BLUE, circle(0, 0, OUR_RADIUS), false));
      } else {
        // 6 and 7 have no common divisor: 42 pairs.
        Color color = COLORS.get(next % COLORS.size());
        Shape shape = SHAPES.get(next % SHAPES.size());
        marks.put(method, new Mark(color, shape, next % 2 == 1));
        next++;
      }
    }
  }

  static boolean isOurs(String method) {
    return method.equals(OURS);
  }

  /** How a method is called where people read. */
  String name(String method) {
    return names.apply(method);
  }

  Mark of(String method) {
    return marks.getOrDefault(method, new Mark(Style.QUIET, circle(0, 0, RADIUS), true));
  }

  /** The colour of a method. */
  public Color color(String method) {
    return of(method).color;
  }

  /** Draws a dot, with a rim that sets it apart from one below it. */
  void draw(Graphics2D g, String method, double x, double y) {
    Mark mark = of(method);
    Shape dot = AffineTransform.getTranslateInstance(x, y).createTransformedShape(mark.shape);
    g.setColor(Style.FLOOR);
    g.setStroke(Style.line(Style.FIRM));
    g.draw(dot);
    g.setColor(mark.color);
    g.fill(dot);
  }

  /** Draws a dot as a ring, around what lies at its place. */
  void drawRing(Graphics2D g, String method, double x, double y) {
    Shape ring = circle(x, y, RING - RING_WIDTH / 2);
    g.setColor(Style.FLOOR);
    g.setStroke(Style.line(RING_WIDTH + 2));
    g.draw(ring);
    g.setColor(of(method).color);
    g.setStroke(Style.line(RING_WIDTH));
    g.draw(ring);
  }

  /** Draws the sign of a failure: a ring with a cross in it. */
  void drawFailure(Graphics2D g, String method, double x, double y) {
    double r = RADIUS + 1.5;
    g.setColor(Style.FLOOR);
    g.fill(circle(x, y, r));
    g.setColor(of(method).color);
    g.setStroke(Style.line(Style.FIRM));
    g.draw(circle(x, y, r));
    double d = r / Math.sqrt(2);
    Path2D cross = new Path2D.Double();
    cross.moveTo(x - d, y - d);
    cross.lineTo(x + d, y + d);
    cross.moveTo(x - d, y + d);
    cross.lineTo(x + d, y - d);
    g.draw(cross);
  }

  private static Shape circle(double x, double y, double r) {
    return new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r);
  }

  private static Shape polygon(int corners, double turn, double notch) {
    Path2D path = new Path2D.Double();
    double size = RADIUS * (corners == 3 || notch < 1 ? 1.35 : 1.15);
    for (int i = 0; i < corners; i++) {
      double radius = i % 2 == 0 ? size : notch * size;
      double angle = turn + 2 * Math.PI * i / corners;
      double x = radius * Math.sin(angle);
      double y = -radius * Math.cos(angle);
      if (i == 0) {
        path.moveTo(x, y);
      } else {
        path.lineTo(x, y);
      }
    }
    path.closePath();
    return path;
  }
}
