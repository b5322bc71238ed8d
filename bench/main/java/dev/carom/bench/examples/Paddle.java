// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.Locale;

/**
 * Squash: before each step the paddle is sent to where the player wants it at the end of the step.
 * So it pushes: a ball that comes with v leaves with {@code -v + 2 u}, and no swing is so fast that
 * the paddle jumps over the ball. The wall at the right takes a fifth of the speed, which a swing
 * gives back. Until somebody plays the paddle plays by itself.
 */
public final class Paddle implements Example {

  private static final double WIDTH = 210;
  private static final double HEIGHT = 160;
  private static final double HALF = 18; // of the paddle
  private static final double HOME = 30;
  private static final double NET = 90; // the paddle stays left of it
  private static final double FASTEST = 6; // of the paddle, a frame
  private static final double SPEED = 3;
  private static final int PADDLE = 0;
  private static final int BALL = 0;

  private final World world = court();
  private final SceneDrawing drawing =
      SceneDrawing.of(world.scene()).withMargin(8).withArrowTime(0);
  private Rectangle2D shown = new Rectangle(size());
  private Vec2 goal;
  private int returned;
  private int lost;

  private static World court() {
    double middle = HEIGHT / 2;
    return new World(
        Scene.builder()
            .bounds(0, 0, WIDTH, HEIGHT)
            .line(HOME, middle - HALF, HOME, middle + HALF)
            .line(WIDTH - 2, 0, WIDTH - 2, HEIGHT)
            .restitution(0.8)
            .circle(120, 60, 4, -SPEED, 1)
            .build());
  }

  World world() {
    return world;
  }

  @Override
  public void frame() {
    swing(goal == null ? follow() : goal);
    world.step(1);
    readLog();
  }

  private void readLog() {
    ImpactLog log = world.impacts();
    for (int row = 0; row < log.size(); row++) {
      if (log.kind(row) == Kind.LINE) {
        returned += log.id(row) == PADDLE ? 1 : 0;
      } else {
        lost += log.nx(row) > 0 ? 1 : 0; // the wall behind the paddle
      }
    }
  }

  /** Sends the paddle to a place in one step, or as far towards it as the paddle can go. */
  private void swing(Vec2 to) {
    Line now = world.line(PADDLE);
    double x = Math.max(5, Math.min(NET, to.x()));
    double y = Math.max(HALF, Math.min(HEIGHT - HALF, to.y()));
    world.moveTo(
        Kind.LINE,
        PADDLE,
        now.ax() + limited(x - now.ax()),
        now.ay() + limited(y - (now.ay() + now.by()) / 2),
        world.now() + 1);
  }

  private static double limited(double v) {
    return Math.max(-FASTEST, Math.min(FASTEST, v));
  }

  /** Follows the ball, and meets it with the swing that sends it back with the first speed. */
  private Vec2 follow() {
    double vx = world.vx(BALL);
    double x = world.line(PADDLE).ax();
    double gap = world.x(BALL) - world.radius(BALL) - x;
    double u = (SPEED + vx) / 2; // -vx + 2 u = SPEED
    boolean near = vx < 0 && gap > 0 && gap < 2 * (u - vx);
    return new Vec2(near ? x + u : HOME, world.y(BALL));
  }

  /** How often the paddle hit the ball. */
  int returned() {
    return returned;
  }

  /** How often the ball hit the wall behind the paddle. */
  int lost() {
    return lost;
  }

  @Override
  public void point(Vec2 at) {
    goal = drawing.place(shown, at);
  }

  @Override
  public String hint() {
    return "Move the paddle with the mouse: swing forwards for a fast ball, back for a drop.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    shown = area;
    drawing.withScene(WorldScene.of(world)).draw(g, area, Still.of(world));
    g.setColor(Style.QUIET);
    g.setFont(Style.font(16));
    String score =
        String.format(Locale.ROOT, "returned %d, lost %d, speed %.1f", returned, lost, speed());
    g.drawString(score, (int) area.getCenterX(), (int) area.getY() + 38);
  }

  private double speed() {
    return Math.hypot(world.vx(BALL), world.vy(BALL));
  }
}
