// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Circle;
import dev.carom.Scene;
import dev.carom.Trajectory;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;

/**
 * An aiming line: before the shot the world is asked what way the ball would take, bounces
 * included; nothing moves by that. The mouse aims, a press shoots, and the ball takes that way.
 * With gravity the way is bent.
 */
public final class AimingLine implements Example {

  private static final int BALL = 0;
  private static final double SPEED = 3;
  private static final int BOUNCES = 6;
  private static final double LONG = 300;
  private static final double GRAVITY = -0.02;

  private final Scene scene =
      Scene.builder()
          .bounds(0, 0, 400, 300)
          .line(120, 60, 170, 190)
          .line(250, 250, 340, 190)
          .line(230, 120, 330, 70)
          .peg(210, 180, 18)
          .peg(300, 140, 10)
          .circle(60, 150, 9, 0, 0)
          .build();
  private final World world = new World(scene);
  private final SceneDrawing drawing = SceneDrawing.of(scene).withMargin(8).withArrowTime(0);
  private Rectangle2D shown = new Rectangle(size());
  private Vec2 aim = new Vec2(SPEED * 0.8, SPEED * 0.6);

  /**
   * The way that a shot would take: from the ball to its seventh impact, or as far as it comes in
   * 300 frames.
   */
  public Trajectory line() {
    Circle ball = new Circle(world.x(BALL), world.y(BALL), world.radius(BALL));
    return world.trace(ball, aim, 1, LONG, BOUNCES);
  }

  @Override
  public void press() {
    world.setVelocity(BALL, aim.x(), aim.y());
  }

  @Override
  public void frame() {
    Example.advance(world, 1, () -> {});
  }

  @Override
  public void point(Vec2 at) {
    Vec2 to = drawing.place(shown, at);
    double dx = to.x() - world.x(BALL);
    double dy = to.y() - world.y(BALL);
    double distance = Math.sqrt(dx * dx + dy * dy);
    if (distance > 0) {
      aim = new Vec2(SPEED * dx / distance, SPEED * dy / distance);
    }
  }

  /** The world, to look at: the ball and what is in its way. */
  public World world() {
    return world;
  }

  /** The G key switches gravity on and off. */
  @Override
  public void key(int code, boolean down) {
    if (code == KeyEvent.VK_G && down) {
      world.setGravity(0, world.gravity().y() == 0 ? GRAVITY : 0);
    }
  }

  @Override
  public String hint() {
    return "Move the mouse to aim, click to shoot; the G key lets the ball fall, or not.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    shown = area;
    AffineTransform map = drawing.transform(area);
    drawing.draw(g, area, Still.of(world).colored(i -> Style.ORANGE));
    Trajectory line = line();
    g.setColor(Style.VERMILION);
    g.setStroke(Style.dashes(Style.FIRM, 6, 5));
    g.draw(map.createTransformedShape(SceneDrawing.path(line)));
    g.setStroke(Style.line(Style.THIN));
    double r = world.radius(BALL);
    for (var impact : line.impacts()) {
      Vec2 p = line.at(impact.time());
      g.draw(map.createTransformedShape(new Ellipse2D.Double(p.x() - r, p.y() - r, 2 * r, 2 * r)));
    }
  }
}
