// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Timeline;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Locale;

/**
 * A Sinai billiard: a disk in the middle of a square. Two circles start a trillionth apart, and
 * each bounce off the disk multiplies their distance, until they have nothing to do with each
 * other.
 */
public final class SinaiBilliard implements Example {

  /** The distance of the two circles at the start. */
  static final double APART = 1e-12;

  private static final double SIDE = 100;
  private static final double SPEED = 2.5;
  private static final int TRAIL = 100;
  private static final int DECADES = 15;
  private static final Color[] COLORS = {Style.BLUE, Style.VERMILION};

  private SceneDrawing drawing;
  private World world;
  private Timeline past;
  private Rectangle2D shown = new Rectangle(size());
  private Vec2 mouse = new Vec2(60, 95);

  /** Starts both. */
  public SinaiBilliard() {
    press();
  }

  @Override
  public void point(Vec2 at) {
    Rectangle2D square = square(shown);
    double x = at.x() * shown.getWidth() / square.getWidth();
    mouse = drawing.place(square, new Vec2(x, at.y()));
  }

  /** Two orbits begin, towards the mouse. */
  @Override
  public void press() {
    Vec2 way = new Vec2(mouse.x() - 15, mouse.y() - 20);
    double vx = SPEED * way.x() / way.length();
    double vy = SPEED * way.y() / way.length();
    SceneBuilder setup = Scene.builder().bounds(0, 0, SIDE, SIDE).peg(SIDE / 2, SIDE / 2, 22);
    setup.circle(15, 20, 2, vx, vy).circle(15 + APART, 20, 2, vx, vy);
    Scene scene = setup.build();
    world = new World(scene);
    past = world.record(100_000);
    drawing = SceneDrawing.of(scene).withArrowTime(0).withMargin(12);
  }

  @Override
  public void frame() {
    Example.advance(world, 1, () -> {});
  }

  /** How far apart the two were. */
  double distance(double t) {
    return Math.hypot(past.x(0, t) - past.x(1, t), past.y(0, t) - past.y(1, t));
  }

  World world() {
    return world;
  }

  @Override
  public String hint() {
    return "Click where two circles are to fly that start a trillionth of a unit apart.";
  }

  private static Rectangle2D square(Rectangle2D area) {
    double side = Math.min(area.getHeight(), 0.76 * area.getWidth());
    return new Rectangle2D.Double(area.getX(), area.getY(), side, area.getHeight());
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    shown = area;
    Rectangle2D square = square(area);
    drawing.draw(g, square, Still.of(world).colored(i -> Style.veil(COLORS[i], 0.7)));
    AffineTransform map = drawing.transform(square);
    for (int i = 0; i < 2; i++) {
      Path2D trail = new Path2D.Double();
      double begin = Math.max(0, world.now() - TRAIL);
      trail.moveTo(past.x(i, begin), past.y(i, begin));
      for (double t = begin; t <= world.now(); t += 0.25) {
        trail.lineTo(past.x(i, t), past.y(i, t));
      }
      g.setColor(Style.veil(COLORS[i], 0.6));
      g.setStroke(Style.line(Style.FIRM));
      g.draw(map.createTransformedShape(trail));
    }
    double x = square.getMaxX() + 44;
    double width = area.getMaxX() - x - 12;
    plot(g, new Rectangle2D.Double(x, area.getY() + 56, width, area.getHeight() - 130));
  }

  /** The distance, by powers of ten, since the start. */
  private void plot(Graphics2D g, Rectangle2D box) {
    g.setFont(Style.font(12));
    g.setStroke(Style.line(Style.THIN));
    for (int exponent = 3 - DECADES; exponent <= 2; exponent += 2) {
      double y = box.getMaxY() - (exponent + DECADES - 2.0) / DECADES * box.getHeight();
      g.setColor(Style.GRID);
      g.draw(new Line2D.Double(box.getX(), y, box.getMaxX(), y));
      g.setColor(Style.QUIET);
      g.drawString("1e" + exponent, (float) box.getX() - 36, (float) y + 4);
    }
    Path2D curve = new Path2D.Double();
    double span = Math.max(300, world.now());
    curve.moveTo(box.getX(), box.getMaxY() - box.getHeight() / DECADES);
    for (int i = 0; i <= 300; i++) {
      double t = world.now() * i / 300;
      double decades = Math.log10(Math.max(1e-13, distance(t))) + DECADES - 2;
      double x = box.getX() + t / span * box.getWidth();
      curve.lineTo(x, box.getMaxY() - decades / DECADES * box.getHeight());
    }
    g.setColor(Style.INK);
    g.draw(curve);
    g.drawString("how far apart", (float) box.getX() - 36, (float) box.getY() - 26);
    double t = world.now();
    String now = String.format(Locale.ROOT, "%.1e at time %.0f", distance(t), t);
    g.drawString(now, (float) box.getX() - 36, (float) box.getMaxY() + 34);
  }
}
