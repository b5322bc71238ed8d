// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.ImpactLog;
import dev.carom.ObstacleKind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;

/**
 * Breakout: the paddle is a line that moves between frames, a brick is four lines that are removed
 * when the ball hits one of them. Where on the paddle the ball lands decides where it goes: after
 * the step its velocity is set. Without a mouse the paddle follows the ball.
 */
public final class Breakout implements Example {

  private static final double WIDTH = 210;
  private static final double HEIGHT = 160;
  private static final int COLUMNS = 7;
  private static final int ROWS = 5;
  private static final int SIDES = 4;
  private static final double BRICK = WIDTH / COLUMNS;
  private static final double GAP = 2;

  private static final int BALL = 0;
  private static final double RADIUS = 3;
  private static final double SPEED = 150.0 / FRAMES;

  private static final int PADDLE = COLUMNS * ROWS * SIDES;
  private static final double HALF = 18;
  private static final double LEVEL = 10;

  private final World world;
  private final SceneDrawing drawing;
  private double paddle = WIDTH / 2;
  private double mouse = Double.NaN;
  private int bricks = COLUMNS * ROWS;
  private int lost;
  private int returned;

  /** Sets up all bricks. */
  public Breakout() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, WIDTH, HEIGHT);
    for (int i = 0; i < bricks; i++) {
      double x = i % COLUMNS * BRICK + GAP / 2;
      double y = HEIGHT - 20 - (i / COLUMNS + 1) * 10;
      double right = x + BRICK - GAP;
      double top = y + 10 - GAP;
      scene.line(x, y, right, y).line(right, y, right, top);
      scene.line(right, top, x, top).line(x, top, x, y);
    }
    scene.line(paddle - HALF, LEVEL, paddle + HALF, LEVEL);
    scene.circle(WIDTH / 2 + 7, 40, RADIUS, SPEED / 2, -SPEED * StrictMath.sqrt(0.75));
    world = new World(scene.build());
    drawing = SceneDrawing.of(world.scene()).withArrowTime(0).withMargin(8);
  }

  @Override
  public void frame() {
    movePaddle();
    world.step(1);
    ImpactLog impacts = world.impacts();
    for (int row = 0; row < impacts.size(); row++) {
      if (impacts.kind(row) == ObstacleKind.LINE) {
        hit(impacts.id(row));
      } else if (impacts.id(row) == 2) { // the wall at the bottom
        lost++;
      }
    }
  }

  /** A paddle has a speed, too: it does not jump over the ball. */
  private void movePaddle() {
    double goal = Double.isNaN(mouse) ? world.x(BALL) + lean() : mouse * WIDTH;
    double x = Math.max(HALF, Math.min(WIDTH - HALF, goal));
    paddle += Math.max(-2 * SPEED, Math.min(2 * SPEED, x - paddle));
    world.moveLine(PADDLE, paddle - HALF, LEVEL, paddle + HALF, LEVEL);
  }

  /** Where the ball is to land: elsewhere each time, spread by the golden ratio. */
  private double lean() {
    return HALF * (2 * (returned * 0.618 % 1) - 1);
  }

  private void hit(int line) {
    if (line == PADDLE) {
      steer();
      returned++;
    } else if (world.contains(ObstacleKind.LINE, line)) { // else hit twice in one frame
      int brick = line / SIDES;
      for (int side = 0; side < SIDES; side++) {
        world.remove(ObstacleKind.LINE, brick * SIDES + side);
      }
      bricks--;
    }
  }

  /** From straight up in the middle to 60 degrees at the ends. */
  private void steer() {
    double lean = Math.max(-1, Math.min(1, (world.x(BALL) - paddle) / HALF));
    double vx = SPEED * lean * StrictMath.sqrt(0.75);
    if (world.vy(BALL) > 0) {
      world.setVelocity(BALL, vx, StrictMath.sqrt(SPEED * SPEED - vx * vx));
    }
  }

  /**
   * The bricks that still stand.
   *
   * @return at least 0
   */
  public int bricks() {
    return bricks;
  }

  /**
   * How often the ball came to the ground.
   *
   * @return at least 0
   */
  public int lost() {
    return lost;
  }

  @Override
  public void point(Vec2 at) {
    mouse = at.x();
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    drawing.withScene(WorldScene.of(world)).draw(g, area, Still.of(world));
    g.setColor(Style.QUIET);
    g.setFont(Style.font(12));
    g.drawString(bricks + " bricks, lost " + lost, (int) area.getX() + 16, (int) area.getY() + 24);
  }
}
