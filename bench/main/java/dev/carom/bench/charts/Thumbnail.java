// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Map;
import java.util.TreeMap;

/** A scene as small as a stamp: its lines, its circles, its walls. */
public final class Thumbnail {

  private static final int WIDTH = 112;
  private static final int HEIGHT = 84;
  private static final double MARGIN = 4;

  private Thumbnail() {}

  /**
   * Draws a scene at time 0.
   *
   * @param title what it is, for those who cannot see it
   */
  public static Picture of(Scene scene, String title) {
    return new Picture(WIDTH, HEIGHT, title, g -> draw(g, scene));
  }

  private static void draw(Graphics2D g, Scene scene) {
    Rectangle2D extent = SceneExtent.of(scene);
    double scale =
        Math.min(
            (WIDTH - 2 * MARGIN) / extent.getWidth(), (HEIGHT - 2 * MARGIN) / extent.getHeight());
    double left = (WIDTH - scale * extent.getWidth()) / 2 - scale * extent.getX();
    double top = (HEIGHT + scale * extent.getHeight()) / 2 + scale * extent.getY();
    Map<Double, Path2D> circles = new TreeMap<>();
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      Circle c = (Circle) scene.shape(Kind.CIRCLE, i);
      double width = Math.max(1.5, 2 * scale * c.radius());
      double x = left + scale * c.x();
      double y = top - scale * c.y();
      circles
          .computeIfAbsent(width, none -> new Path2D.Double())
          .append(new Line2D.Double(x, y, x, y), false);
    }
    g.setColor(Style.BLUE);
    circles.forEach(
        (width, path) -> {
          g.setStroke(Style.line(width));
          g.draw(path);
        });
    Path2D lines = new Path2D.Double();
    for (Line l : Sides.of(scene)) {
      lines.append(
          new Line2D.Double(
              left + scale * l.ax(),
              top - scale * l.ay(),
              left + scale * l.bx(),
              top - scale * l.by()),
          false);
    }
    g.setColor(Style.INK);
    g.setStroke(Style.line(Style.THIN));
    g.draw(lines);
    if (scene.bounds().isPresent()) {
      Bounds b = scene.bounds().get();
      g.draw(
          new Rectangle2D.Double(
              left + scale * b.xmin(),
              top - scale * b.ymax(),
              scale * (b.xmax() - b.xmin()),
              scale * (b.ymax() - b.ymin())));
    }
  }
}
