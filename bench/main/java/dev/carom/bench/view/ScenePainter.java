// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Scene;
import dev.carom.Timeline;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.NoninvertibleTransformException;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.EnumSet;
import java.util.Set;

/** Draws what a player shows, and beside it what was asked for. */
final class ScenePainter {

  /** What can be shown besides the scene. */
  enum Layer {
    TRAILS,
    NORMALS,
    GRID,
    ARROWS
  }

  /** How far back trails and normals reach, in frames. */
  private static final double FRAMES = 40;

  /** Points of all trails together: what a frame has time for. */
  private static final int POINTS = 40_000;

  private static final int MOST_POINTS = 160;
  private static final double NORMAL = 22;

  private final SceneDrawing drawing;
  private final double arrowTime;
  private final Set<Layer> layers = EnumSet.of(Layer.NORMALS);

  ScenePainter(Scene scene) {
    SceneDrawing fitting = SceneDrawing.of(scene);
    arrowTime = fitting.arrowTime();
    drawing = fitting.withMargin(26);
  }

  void set(Layer layer, boolean visible) {
    if (visible) {
      layers.add(layer);
    } else {
      layers.remove(layer);
    }
  }

  boolean shows(Layer layer) {
    return layers.contains(layer);
  }

  /** The map from the scene to pixels. */
  AffineTransform transform(Rectangle2D area) {
    return drawing.transform(area);
  }

  void draw(Graphics2D g, Rectangle2D area, Player player) {
    Style.smooth(g);
    AffineTransform map = transform(area);
    Scene scene = player.scene();
    double time = shows(Layer.ARROWS) ? arrowTime : 0;
    drawing.withScene(scene).withArrowTime(time).draw(g, area, Still.of(scene));
    if (shows(Layer.GRID)) {
      grid(g, map, area);
    }
    if (shows(Layer.TRAILS)) {
      trails(g, map, player);
    }
    if (shows(Layer.NORMALS)) {
      normals(g, map, player);
    }
  }

  /** Where the circles were, from the recording: a trail turns where the circle did. */
  private static void trails(Graphics2D g, AffineTransform map, Player player) {
    Timeline past = player.past();
    int points = Math.max(2, Math.min(MOST_POINTS, POINTS / Math.max(1, player.circles())));
    double end = player.shown();
    double begin = Math.max(past.start(), end - FRAMES * player.frame());
    g.setColor(Style.veil(Style.BLUE, 0.45));
    g.setStroke(Style.line(Style.THIN));
    for (int id = 0; id < player.circles(); id++) {
      Path2D trail = new Path2D.Double();
      for (int i = 0; i <= points; i++) {
        double t = i == points ? end : begin + (end - begin) * i / points;
        if (past.contains(id, t) && Double.isFinite(past.x(id, t) + past.y(id, t))) {
          append(trail, past.x(id, t), past.y(id, t));
        }
      }
      g.draw(map.createTransformedShape(trail));
    }
  }

  private static void append(Path2D path, double x, double y) {
    if (path.getCurrentPoint() == null) {
      path.moveTo(x, y);
    } else {
      path.lineTo(x, y);
    }
  }

  /** A dot where something was hit, and a line along the normal; older ones fade. */
  private static void normals(Graphics2D g, AffineTransform map, Player player) {
    double reach = FRAMES * player.frame();
    g.setStroke(Style.line(Style.FIRM));
    for (Mark mark : player.marks(reach)) {
      double age = (player.shown() - mark.time()) / reach;
      g.setColor(Style.veil(Style.VERMILION, 1 - 0.8 * age));
      Point2D p = map.transform(new Point2D.Double(mark.x(), mark.y()), null);
      double nx = NORMAL * mark.nx();
      double ny = -NORMAL * mark.ny(); // pixels count downwards
      g.draw(new Line2D.Double(p.getX(), p.getY(), p.getX() + nx, p.getY() + ny));
      g.fill(new Ellipse2D.Double(p.getX() - 3, p.getY() - 3, 6, 6));
    }
  }

  /** Lines of round coordinates, with their numbers. */
  private static void grid(Graphics2D g, AffineTransform map, Rectangle2D area) {
    Rectangle2D plane;
    try {
      plane = map.createInverse().createTransformedShape(area).getBounds2D();
    } catch (NoninvertibleTransformException e) {
      return; // an area of no size
    }
    double step = step(Math.max(plane.getWidth(), plane.getHeight()) / 10);
    g.setFont(Style.font(10));
    g.setStroke(Style.line(Style.HAIR));
    for (double i = Math.ceil(plane.getMinX() / step); i * step < plane.getMaxX(); i++) {
      double x = map.transform(new Point2D.Double(i * step, 0), null).getX();
      g.setColor(Style.veil(Style.QUIET, 0.35));
      g.draw(new Line2D.Double(x, area.getMinY(), x, area.getMaxY()));
      g.setColor(Style.QUIET);
      g.drawString(label(i * step), (float) x + 2, (float) area.getMaxY() - 4);
    }
    for (double i = Math.ceil(plane.getMinY() / step); i * step < plane.getMaxY(); i++) {
      double y = map.transform(new Point2D.Double(0, i * step), null).getY();
      g.setColor(Style.veil(Style.QUIET, 0.35));
      g.draw(new Line2D.Double(area.getMinX(), y, area.getMaxX(), y));
      g.setColor(Style.QUIET);
      g.drawString(label(i * step), (float) area.getMinX() + 2, (float) y - 2);
    }
  }

  /** 1, 2 or 5 times a power of ten, at least x. */
  static double step(double x) {
    double ten = Math.pow(10, Math.floor(Math.log10(x)));
    for (double digit : new double[] {1, 2, 5}) {
      if (digit * ten >= x) {
        return digit * ten;
      }
    }
    return 10 * ten;
  }

  private static String label(double x) {
    return Math.rint(x) == x ? String.valueOf((long) x) : String.valueOf((float) x);
  }
}
