// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.duel.PlayedFrame;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.NoninvertibleTransformException;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.IntFunction;

/** Draws the scene of a player or of a duel, and the chosen layers over it. */
final class ScenePainter {

  /** The layers that can be shown over the scene. */
  enum Layer {
    TRAILS("Trails", "Show where the circles were lately"),
    NORMALS("Normals", "Show the normal of each impact of late"),
    GRID("Grid", "Show coordinates"),
    ARROWS("Arrows", "Show where the circles go");

    private final String label;
    private final String tip;

    Layer(String label, String tip) {
      this.label = label;
      this.tip = tip;
    }

    String label() {
      return label;
    }

    String tip() {
      return tip;
    }
  }

  static final double MARGIN = 26;

  /** How far back trails and normals reach, in frames. */
  static final double FRAMES = 40;

  /** How long a circle glows after an impact, in frames. */
  private static final double GLOW = 5;

  /** More normals at a time hide the scene. */
  private static final int NORMALS = 200;

  private static final double NORMAL = 22;

  private final Set<Layer> layers = EnumSet.of(Layer.TRAILS);
  private final Viewport viewport = new Viewport(MARGIN);
  private SceneDrawing drawing;
  private double arrowTime;
  private Style.Scheme scheme = Style.Scheme.LIGHT;

  ScenePainter(Scene scene) {
    fit(scene);
  }

  /** Shows the whole of a scene. */
  void fit(Scene scene) {
    SceneDrawing fitting = SceneDrawing.of(scene);
    arrowTime = fitting.arrowTime();
    drawing = fitting.withMargin(MARGIN);
    viewport.reset();
  }

  void setScheme(Style.Scheme scheme) {
    this.scheme = scheme;
  }

  Style.Scheme scheme() {
    return scheme;
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

  Viewport viewport() {
    return viewport;
  }

  /** The map from the scene to pixels. */
  AffineTransform transform(Rectangle2D area) {
    return drawing.transform(viewport.area(area));
  }

  void draw(Graphics2D g, Rectangle2D area, Player player) {
    Scene scene = player.scene();
    draw(g, area, scene, player.still(scene, GLOW), Trails.of(player, FRAMES * player.frame()));
    if (shows(Layer.NORMALS)) {
      normals(g, transform(area), player);
    }
  }

  /** One side of a duel: circles that are lost are red. */
  void draw(Graphics2D g, Rectangle2D area, Scene scene, IntFunction<PlayedFrame> side, int frame) {
    PlayedFrame played = side.apply(frame);
    SceneBuilder finite = Scene.builder().collide(false);
    List<Integer> ids = new ArrayList<>();
    for (int i = 0; i < played.circles(); i++) {
      if (Double.isFinite(played.x(i)) && Double.isFinite(played.y(i))) {
        double vx = Double.isFinite(played.vx(i)) ? played.vx(i) : 0;
        double vy = Double.isFinite(played.vy(i)) ? played.vy(i) : 0;
        finite.circle(
            played.x(i), played.y(i), ((Circle) scene.shape(Kind.CIRCLE, i)).radius(), vx, vy);
        ids.add(i);
      }
    }
    Still still =
        Still.of(finite.build())
            .colored(i -> played.isLost(ids.get(i)) ? Style.veil(Style.VERMILION, 0.85) : null);
    draw(g, area, scene, still, Trails.of(side, frame, (int) FRAMES));
  }

  private void draw(Graphics2D g, Rectangle2D area, Scene scene, Still still, Trails trails) {
    Style.smooth(g);
    g.clip(area);
    AffineTransform map = transform(area);
    drawing
        .withScheme(scheme)
        .withScene(scene)
        .withArrowTime(shows(Layer.ARROWS) ? arrowTime : 0)
        .draw(g, viewport.area(area), still);
    if (shows(Layer.GRID)) {
      grid(g, map, area);
    }
    if (shows(Layer.TRAILS)) {
      trails.draw(g, map, scheme.rim());
    }
  }

  /** A dot where something was hit, and a line along the normal; older ones fade. */
  private static void normals(Graphics2D g, AffineTransform map, Player player) {
    double reach = FRAMES * player.frame();
    g.setStroke(Style.line(Style.FIRM));
    for (Mark mark : player.marks(reach, NORMALS)) {
      double age = Math.max(0, (player.shown() - mark.time()) / reach);
      g.setColor(Style.veil(Style.VERMILION, 1 - 0.8 * age));
      Point2D p = map.transform(new Point2D.Double(mark.x(), mark.y()), null);
      double nx = NORMAL * mark.nx();
      double ny = -NORMAL * mark.ny(); // pixels count downwards
      g.draw(new Line2D.Double(p.getX(), p.getY(), p.getX() + nx, p.getY() + ny));
      g.fill(new Ellipse2D.Double(p.getX() - 3, p.getY() - 3, 6, 6));
    }
  }

  /** Lines of round coordinates, with their numbers. */
  private void grid(Graphics2D g, AffineTransform map, Rectangle2D area) {
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
      g.setColor(Style.veil(scheme.quiet(), 0.35));
      g.draw(new Line2D.Double(x, area.getMinY(), x, area.getMaxY()));
      g.setColor(scheme.quiet());
      g.drawString(label(i * step), (float) x + 2, (float) area.getMaxY() - 4);
    }
    for (double i = Math.ceil(plane.getMinY() / step); i * step < plane.getMaxY(); i++) {
      double y = map.transform(new Point2D.Double(0, i * step), null).getY();
      g.setColor(Style.veil(scheme.quiet(), 0.35));
      g.draw(new Line2D.Double(area.getMinX(), y, area.getMaxX(), y));
      g.setColor(scheme.quiet());
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

  /** Draws a thing that is about to be added; for a circle, also the way that it would take. */
  void draft(Graphics2D g, Rectangle2D area, Player player, Draft draft) {
    AffineTransform map = transform(area);
    g.setColor(Style.VERMILION);
    g.setStroke(Style.line(Style.FIRM));
    if (draft.tool() == Tool.LINE) {
      Line l = draft.line();
      g.draw(map.createTransformedShape(new Line2D.Double(l.ax(), l.ay(), l.bx(), l.by())));
      return;
    }
    Circle c = draft.circle();
    double r = c.radius();
    g.draw(map.createTransformedShape(new Ellipse2D.Double(c.x() - r, c.y() - r, 2 * r, 2 * r)));
    if (draft.tool() == Tool.CIRCLE && draft.length() > 0) {
      Path2D way = SceneDrawing.path(draft.way(player));
      g.setStroke(Style.dashes(Style.THIN, 6, 5));
      g.draw(map.createTransformedShape(way));
    }
  }
}
