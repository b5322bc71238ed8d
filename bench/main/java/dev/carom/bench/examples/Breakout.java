// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Kind;
import dev.carom.Outline;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.event.KeyEvent;
import java.awt.geom.Rectangle2D;

/**
 * Breakout: a brick is a solid rectangle that is removed when the ball hits it, the paddle a line
 * that is sent somewhere in each frame and pushes the ball. Where the ball lands on the paddle
 * decides where it goes. Until somebody plays the paddle follows the ball.
 */
public final class Breakout implements Example {

  private static final double WIDTH = 210;
  private static final double HEIGHT = 160;
  private static final int COLUMNS = 7;
  private static final double BRICK = WIDTH / COLUMNS;
  private static final double GAP = 2;
  private static final Color[] COLORS = {Style.VERMILION, Style.ORANGE, Style.GREEN, Style.BLUE};
  private static final int BRICKS = COLUMNS * COLORS.length;
  private static final int BALL = 0;
  private static final double SPEED = 150.0 / FRAMES;
  private static final int PADDLE = BRICKS;
  private static final double HALF = 18; // of the paddle
  private static final double LEVEL = 10;
  World world = board();
  private final SceneDrawing drawing = SceneDrawing.of(world.scene()).withMargin(8);
  double paddle = WIDTH / 2; // its middle
  private double goal = Double.NaN;
  private double push;
  int bricks = BRICKS;
  private int lost;
  private int returned;

  private static World board() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, WIDTH, HEIGHT);
    for (int i = 0; i < BRICKS; i++) {
      Rectangle2D b = brick(i);
      scene.outline(Outline.rectangle(b.getMinX(), b.getMinY(), b.getMaxX(), b.getMaxY()));
    }
    scene.line(WIDTH / 2 - HALF, LEVEL, WIDTH / 2 + HALF, LEVEL);
    scene.circle(WIDTH / 2 + 7, 40, 3, SPEED / 2, -SPEED * StrictMath.sqrt(0.75));
    return new World(scene.build());
  }

  private static Rectangle2D brick(int i) {
    double y = HEIGHT - 20 - (i / COLUMNS + 1) * 10;
    return new Rectangle2D.Double(i % COLUMNS * BRICK + GAP / 2, y, BRICK - GAP, 10 - GAP);
  }

  @Override
  public void frame() {
    movePaddle();
    world.step(1);
    readLog();
  }

  private void readLog() {
    for (int row = 0; row < world.impacts().size(); row++) {
      if (world.impacts().kind(row) == Kind.LINE) {
        hit(world.impacts().id(row));
      } else if (world.impacts().id(row) == 2) { // the wall at the bottom
        lost++;
      }
    }
  }

  private void movePaddle() {
    double follow = world.x(BALL) + HALF * (2 * (returned * 0.618 % 1) - 1); // elsewhere each time
    goal += push;
    double x = Math.max(HALF, Math.min(WIDTH - HALF, Double.isNaN(goal) ? follow : goal));
    paddle += Math.max(-2 * SPEED, Math.min(2 * SPEED, x - paddle));
    world.moveTo(Kind.LINE, PADDLE, paddle - HALF, LEVEL, world.now() + 1);
  }

  private void hit(int line) {
    if (line == PADDLE && world.vy(BALL) > 0) { // from straight up to 60 degrees at the ends
      double lean = Math.max(-1, Math.min(1, (world.x(BALL) - paddle) / HALF));
      double vx = SPEED * lean * StrictMath.sqrt(0.75);
      world.setVelocity(BALL, vx, StrictMath.sqrt(SPEED * SPEED - vx * vx));
      returned++;
    } else if (line < PADDLE && world.contains(Kind.LINE, line)) { // else hit twice
      world.remove(Kind.LINE, line);
      bricks--;
    }
  }

  int lost() {
    return lost;
  }

  @Override
  public void point(Vec2 at) {
    goal = at.x() * WIDTH;
  }

  @Override
  public void key(int code, boolean down) {
    double side = code == KeyEvent.VK_LEFT ? -1 : code == KeyEvent.VK_RIGHT ? 1 : 0;
    push = down ? 1.5 * SPEED * side : 0;
    goal = paddle;
  }

  @Override
  public void press() {
    if (bricks == 0) {
      world = board();
      bricks = BRICKS;
    }
  }

  @Override
  public String hint() {
    return "Move the paddle with the mouse or the arrow keys; its ends send the ball aside.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    drawing.withScene(WorldScene.of(world)).withArrowTime(0).draw(g, area, Still.of(world));
    for (int i = 0; i < BRICKS; i++) {
      if (world.contains(Kind.LINE, i)) {
        g.setColor(COLORS[i / COLUMNS]);
        g.fill(drawing.transform(area).createTransformedShape(brick(i)));
      }
    }
    g.setColor(Style.QUIET);
    g.setFont(Style.font(16));
    String score = bricks == 0 ? "Cleared! Click for another board" : bricks + " bricks";
    g.drawString(score + ", lost " + lost, (int) area.getX() + 24, (int) area.getY() + 38);
  }
}
