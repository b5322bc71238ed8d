// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Timeline;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/**
 * Two futures of one past. The left half shows a recorded run. On the right, another world goes
 * back to a moment of it, gets the wall at another place, and goes on. Up to that moment both are
 * the same, to the bit.
 */
public final class WhatIf implements Example {

  /** The end of both futures, in frames. */
  static final double END = 360;

  private static final int WALL = 0;
  private static final double HALF = 30;
  private static final double BACK = 10;
  private static final int TRAIL = 90;
  private static final List<Color> COLORS =
      List.of(Style.BLUE, Style.ORANGE, Style.GREEN, Style.PURPLE, Style.VERMILION);

  private final World was;
  private final Timeline past;
  private final World other;
  private final SceneDrawing drawing;
  private Timeline future;

  /** The moment at which the two futures part, and the one that is shown. */
  double fork;

  double shown;

  private Rectangle2D area = new Rectangle(size());
  private Vec2 mouse = new Vec2(60, 150);

  /** Plays the run to its end, and goes back. */
  public WhatIf() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 200, 300).line(100, 120, 100, 180);
    for (int i = 0; i < COLORS.size(); i++) {
      scene.circle(30 + 35 * i, 40 + 50 * i, 10, 2 - i, i % 2 == 0 ? 1.5 : -2);
    }
    was = new World(scene.build());
    other = new World(was.scene());
    past = was.record(END);
    was.step(END);
    drawing = SceneDrawing.of(was.scene()).withMargin(8).withArrowTime(0);
    shown = 60;
    press();
    shown = 0;
  }

  /** From the moment shown on, the wall is where the mouse is. */
  @Override
  public void press() {
    fork = shown;
    other.restore(past.snapshot(fork));
    future = other.record(END);
    other.setShape(
        Kind.LINE, WALL, new Line(mouse.x(), mouse.y() - HALF, mouse.x(), mouse.y() + HALF));
    other.step(END - fork);
  }

  @Override
  public void point(Vec2 at) {
    double half = at.x() < 0.5 ? 0 : 0.5;
    mouse = drawing.place(side(half), new Vec2(2 * (at.x() - half), at.y()));
  }

  @Override
  public void key(int code, boolean down) {
    if (down && code == KeyEvent.VK_LEFT) {
      shown = Math.max(0, shown - BACK);
    } else if (down && code == KeyEvent.VK_RIGHT) {
      shown = Math.min(END, shown + BACK);
    }
  }

  @Override
  public void frame() {
    shown = Math.min(END, shown + 1);
  }

  /** The recorded run, or the other one, at the moment shown. */
  Scene scene(boolean another) {
    return another && shown >= fork
        ? WorldScene.of(other, future, shown)
        : WorldScene.of(was, past, shown);
  }

  @Override
  public String hint() {
    return "Arrow keys: back in time. Click: put the wall there, in this moment.";
  }

  private Rectangle2D side(double half) {
    double width = area.getWidth() / 2;
    double x = area.getX() + half * area.getWidth();
    return new Rectangle2D.Double(x, area.getY(), width, area.getHeight());
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D whole) {
    area = whole;
    draw(g, side(0), false);
    draw(g, side(0.5), true);
  }

  private void draw(Graphics2D g, Rectangle2D where, boolean another) {
    Scene scene = scene(another);
    drawing.withScene(scene).draw(g, where, Still.of(scene).colored(COLORS::get));
    g.setColor(Style.INK);
    String name = another ? "From frame " + Math.round(fork) + ": wall elsewhere" : "As it was";
    g.drawString(name, (float) where.getX() + 20, (float) where.getY() + 30);
    AffineTransform map = drawing.transform(where);
    g.setStroke(Style.line(Style.THIN));
    for (int id = 0; id < COLORS.size(); id++) {
      Path2D trail = new Path2D.Double();
      for (double t = Math.max(0, shown - TRAIL); t <= shown; t++) {
        Timeline line = another && t >= fork ? future : past;
        double x = line.x(id, t);
        if (trail.getCurrentPoint() == null) {
          trail.moveTo(x, line.y(id, t));
        }
        trail.lineTo(x, line.y(id, t));
      }
      g.setColor(COLORS.get(id));
      g.draw(map.createTransformedShape(trail));
    }
  }
}
