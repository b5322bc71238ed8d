// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Outline;
import dev.carom.Scene;
import dev.carom.Trajectory;
import dev.carom.Vec2;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.math.BigDecimal;
import java.util.function.IntConsumer;

/**
 * Draws a scene and its circles on anything that Java can draw on: a window, an image, an SVG. What
 * is solid is dark, what moves is blue; an arrow starts at the centre of its circle and ends where
 * the centre would be some time later, were nothing in the way. A circle that glows is orange with
 * a heavier outline; one that was given a colour has that one.
 *
 * <p>Widths are in pixels at any scale, and nothing is so small that it vanishes. Immutable.
 */
public final class SceneDrawing {

  /** Nothing is drawn with a smaller radius, in pixels. */
  /** As far as a drawing of bounds goes, in units of the scene: an open side is beyond all. */
  private static final double FAR = 1e6;

  private static final double LEAST_RADIUS = 1;

  /** The longest arrow, as a part of the scene's diagonal, at the most. */
  private static final double LONGEST_ARROW = 0.04;

  /** Room around the scene, in pixels: an arrow that points through a wall still ends in it. */
  private static final double MARGIN = 20;

  private static final double ARROWHEAD = 5;

  /** Pieces of a flight, which gravity bends. */
  private static final int PIECES = 24;

  private final Scene scene;
  private final Rectangle2D extent;
  private final double arrowTime;
  private final double margin;
  private final Style.Scheme scheme;

  private SceneDrawing(
      Scene scene, Rectangle2D extent, double arrowTime, double margin, Style.Scheme scheme) {
    this.scene = scene;
    this.extent = extent;
    this.arrowTime = arrowTime;
    this.margin = margin;
    this.scheme = scheme;
  }

  /**
   * Starts with arrows whose time suits the speeds at time 0: 1, 2, 3 or 5 times a power of ten.
   *
   * @param scene what to draw; if it has no bounds, what is there at time 0 must fit
   */
  public static SceneDrawing of(Scene scene) {
    Rectangle2D extent = SceneExtent.of(scene);
    double longest = LONGEST_ARROW * Math.hypot(extent.getWidth(), extent.getHeight());
    double time = roundDown(longest / fastest(scene));
    return new SceneDrawing(scene, extent, time, MARGIN, Style.Scheme.LIGHT);
  }

  /**
   * The same view of another scene: the same things later, say.
   *
   * @param other what to draw instead
   * @return the drawing, to the same scale
   */
  public SceneDrawing withScene(Scene other) {
    return new SceneDrawing(other, extent, arrowTime, margin, scheme);
  }

  /**
   * The same with other arrows.
   *
   * @param time the time of motion that an arrow shows, at least 0; at 0 there are no arrows
   */
  public SceneDrawing withArrowTime(double time) {
    return new SceneDrawing(scene, extent, time, margin, scheme);
  }

  /**
   * The same with another margin.
   *
   * @param pixels the room around the scene, at least 0
   */
  public SceneDrawing withMargin(double pixels) {
    return new SceneDrawing(scene, extent, arrowTime, pixels, scheme);
  }

  /**
   * The same in other colours.
   *
   * @param other for light or dark
   */
  public SceneDrawing withScheme(Style.Scheme other) {
    return new SceneDrawing(scene, extent, arrowTime, margin, other);
  }

  /** The time of motion that an arrow shows: at least 0. */
  public double arrowTime() {
    return arrowTime;
  }

  /**
   * The size of an area that the scene and its margin fill.
   *
   * @param width in pixels, not to be exceeded
   * @param height in pixels, not to be exceeded
   * @return the largest such size
   */
  public Dimension size(int width, int height) {
    double scale = scale(width, height);
    int across = (int) Math.round(scale * extent.getWidth() + 2 * margin);
    int up = (int) Math.round(scale * extent.getHeight() + 2 * margin);
    return new Dimension(Math.min(across, width), Math.min(up, height));
  }

  /**
   * Where things come to lie: as large as possible in the middle of an area, y upwards.
   *
   * @param area in pixels, y downwards
   * @return the map from the scene to pixels
   */
  public AffineTransform transform(Rectangle2D area) {
    double scale = scale(area.getWidth(), area.getHeight());
    double x = area.getCenterX() - scale * extent.getCenterX();
    double y = area.getCenterY() + scale * extent.getCenterY();
    return new AffineTransform(scale, 0, 0, -scale, x, y);
  }

  /**
   * The place in the scene that lies at a point of an area, as of a mouse.
   *
   * @param area in pixels
   * @param share the point, in shares of the width from the left and of the height from the bottom
   */
  public Vec2 place(Rectangle2D area, Vec2 share) {
    double scale = scale(area.getWidth(), area.getHeight());
    double x = extent.getCenterX() + (share.x() - 0.5) * area.getWidth() / scale;
    double y = extent.getCenterY() + (share.y() - 0.5) * area.getHeight() / scale;
    return new Vec2(x, y);
  }

  /**
   * A path to be drawn: straight between impacts, or bent by gravity.
   *
   * @param way of one circle
   * @return the same, in the coordinates of the scene
   */
  public static Path2D path(Trajectory way) {
    Path2D path = new Path2D.Double();
    path.moveTo(way.at(0).x(), way.at(0).y());
    double from = 0;
    for (int i = 0; i <= way.impacts().size(); i++) {
      double to = i < way.impacts().size() ? way.impacts().get(i).time() : way.duration();
      for (int k = 1; k <= PIECES; k++) {
        double t = k == PIECES ? to : from + (to - from) * k / PIECES;
        path.lineTo(way.at(t).x(), way.at(t).y());
      }
      from = to;
    }
    return path;
  }

  private double scale(double width, double height) {
    double across = Math.max(1, width - 2 * margin) / extent.getWidth();
    double up = Math.max(1, height - 2 * margin) / extent.getHeight();
    return Math.min(across, up);
  }

  /**
   * Draws the scene with its circles at a moment.
   *
   * @param to what to draw on; left as it was, but for the picture
   * @param area where on it, in pixels; nothing is drawn outside
   */
  public void draw(Graphics2D to, Rectangle2D area, Still still) {
    Graphics2D g = (Graphics2D) to.create();
    try {
      Style.smooth(g);
      g.clip(area);
      AffineTransform map = transform(area);
      bounds(g, map);
      obstacles(g, map);
      circles(still, i -> circle(g, map, still, i));
      circles(still, i -> arrow(g, map, still, i));
    } finally {
      g.dispose();
    }
  }

  private void bounds(Graphics2D g, AffineTransform map) {
    if (scene.bounds().isEmpty()) {
      return;
    }
    Bounds b = scene.bounds().get();
    Rectangle2D floor = new Rectangle2D.Double();
    floor.setFrameFromDiagonal(
        point(map, drawn(b.xmin()), drawn(b.ymin())), point(map, drawn(b.xmax()), drawn(b.ymax())));
    g.setColor(scheme.floor());
    g.fill(floor);
    double half = Style.FIRM / 2; // the inner edge of the line is the wall
    floor.setFrameFromDiagonal(
        floor.getMinX() - half,
        floor.getMinY() - half,
        floor.getMaxX() + half,
        floor.getMaxY() + half);
    g.setColor(scheme.ink());
    g.setStroke(Style.line(Style.FIRM));
    g.draw(floor);
  }

  /** An open side is drawn where nobody sees it. */
  private static double drawn(double side) {
    return Math.max(-FAR, Math.min(side, FAR));
  }

  private void obstacles(Graphics2D g, AffineTransform map) {
    g.setColor(scheme.ink());
    g.setStroke(Style.line(Style.FIRM));
    for (int i = 0; i < scene.count(Kind.PEG); i++) {
      Circle peg = (Circle) scene.shape(Kind.PEG, i);
      g.fill(disk(map, peg.x(), peg.y(), peg.radius()));
    }
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      if (scene.shape(Kind.LINE, i) instanceof Outline outline && outline.solid()) {
        g.fill(polygon(map, outline));
      }
    }
    for (Line line : Sides.of(scene)) {
      g.draw(new Line2D.Double(point(map, line.ax(), line.ay()), point(map, line.bx(), line.by())));
    }
  }

  private static Path2D polygon(AffineTransform map, Outline outline) {
    Path2D path = new Path2D.Double();
    for (Vec2 point : outline.points()) {
      Point2D at = point(map, point.x(), point.y());
      if (path.getCurrentPoint() == null) {
        path.moveTo(at.getX(), at.getY());
      } else {
        path.lineTo(at.getX(), at.getY());
      }
    }
    path.closePath();
    return path;
  }

  /** The glowing ones last, on top. */
  private static void circles(Still still, IntConsumer each) {
    for (int i = 0; i < still.count(); i++) {
      if (!still.glows(i)) {
        each.accept(i);
      }
    }
    for (int i = 0; i < still.count(); i++) {
      if (still.glows(i)) {
        each.accept(i);
      }
    }
  }

  private void circle(Graphics2D g, AffineTransform map, Still still, int i) {
    Ellipse2D disk = disk(map, still.x(i), still.y(i), still.radius(i));
    boolean glows = still.glows(i);
    Color own = still.color(i);
    Color rest = own == null ? Style.veil(Style.SKY, 0.4) : own;
    g.setColor(glows ? Style.veil(Style.ORANGE, 0.8) : rest);
    g.fill(disk);
    Color rim = own == null ? scheme.rim() : Style.mix(own, scheme.ink(), 0.35);
    g.setColor(glows ? Style.VERMILION : rim);
    g.setStroke(Style.line(glows ? Style.FIRM : Style.THIN));
    g.draw(disk);
  }

  private void arrow(Graphics2D g, AffineTransform map, Still still, int i) {
    double speed = Math.hypot(still.vx(i), still.vy(i));
    if (speed == 0 || arrowTime == 0) {
      return;
    }
    Point2D from = ahead(map, still, i, 0);
    Point2D to = ahead(map, still, i, arrowTime);
    g.setColor(Style.mix(scheme.rim(), scheme.ink(), 0.5));
    g.setStroke(Style.line(Style.THIN));
    g.draw(new Line2D.Double(from, between(from, to, 1 - Math.min(1, 3 / from.distance(to)))));
    g.fill(head(from, to));
  }

  private static Point2D ahead(AffineTransform map, Still still, int i, double time) {
    double x = still.x(i) + time * still.vx(i);
    double y = still.y(i) + time * still.vy(i);
    return point(map, x, y);
  }

  private static Point2D between(Point2D a, Point2D b, double share) {
    double x = a.getX() + share * (b.getX() - a.getX());
    double y = a.getY() + share * (b.getY() - a.getY());
    return new Point2D.Double(x, y);
  }

  private static Point2D point(AffineTransform map, double x, double y) {
    return map.transform(new Point2D.Double(x, y), null);
  }

  /** A triangle that ends at the end of the arrow, no longer than the arrow. */
  private static Path2D head(Point2D from, Point2D to) {
    double length = from.distance(to);
    double size = Math.min(ARROWHEAD, length);
    double ux = (to.getX() - from.getX()) / length * size;
    double uy = (to.getY() - from.getY()) / length * size;
    Path2D head = new Path2D.Double();
    head.moveTo(to.getX(), to.getY());
    head.lineTo(to.getX() - ux - 0.45 * uy, to.getY() - uy + 0.45 * ux);
    head.lineTo(to.getX() - ux + 0.45 * uy, to.getY() - uy - 0.45 * ux);
    head.closePath();
    return head;
  }

  private static Ellipse2D disk(AffineTransform map, double x, double y, double radius) {
    Point2D center = point(map, x, y);
    double r = Math.max(LEAST_RADIUS, radius * map.getScaleX());
    return new Ellipse2D.Double(center.getX() - r, center.getY() - r, 2 * r, 2 * r);
  }

  /** The speed of the fastest circle at time 0. */
  public static double fastest(Scene scene) {
    double fastest = 0;
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      fastest = Math.max(fastest, scene.velocity(Kind.CIRCLE, i).length());
    }
    return fastest;
  }

  /**
   * The largest of 1, 2, 3 or 5 times a power of ten that is not above a number; 0 for infinity.
   */
  private static double roundDown(double x) {
    if (!(x > 0 && x < Double.POSITIVE_INFINITY)) {
      return 0;
    }
    int exponent = (int) Math.floor(Math.log10(x));
    double lead = x / Math.pow(10, exponent);
    int digit = lead >= 5 ? 5 : lead >= 3 ? 3 : lead >= 2 ? 2 : 1;
    return BigDecimal.valueOf(digit, -exponent).doubleValue(); // 0.3, not 3 times 0.1
  }
}
