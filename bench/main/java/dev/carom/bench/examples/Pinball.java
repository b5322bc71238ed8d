// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Timeline;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/**
 * A pinball table: slopes, and bumpers whose restitution is above 1. The plunger is a line that
 * moves; the ball rests on it, goes down with it and is thrown by it. A one-way line keeps the ball
 * out of the plunger's lane, and a sensor under the table reports a lost ball.
 */
public final class Pinball implements Example {

  private static final double WIDTH = 200;
  private static final double HEIGHT = 250;
  private static final double LANE = 182;
  private static final double RADIUS = 5;
  private static final double GRAVITY = -0.06;
  private static final double REST = 30; // the plunger's height
  private static final double PULL = -0.4;
  private static final double THROW = 6;
  private static final int BALL = 0;
  private static final int PLUNGER = 0; // a line
  private static final int DRAIN = 1; // another one
  private static final int TRAIL = 200;
  private static final double[][] BUMPERS = {{55, 175, 13}, {125, 175, 13}, {90, 125, 13}};

  final World world = table();
  private final Timeline past = world.record(1_000);
  private final SceneDrawing drawing =
      SceneDrawing.of(world.scene()).withMargin(8).withArrowTime(0);
  private double lost; // when the last ball was
  int score;
  int balls = 1;
  private boolean held;
  private double goal = REST;

  private static World table() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, WIDTH, HEIGHT).gravity(0, GRAVITY);
    scene.line(LANE, REST, WIDTH, REST);
    scene.line(0, 3, LANE, 3).response(Response.SENSOR);
    scene.line(LANE, 0, LANE, 200);
    scene.line(LANE, 200, LANE, HEIGHT).oneWay(); // its left is the table's side
    scene.line(LANE, HEIGHT, WIDTH, 225).line(0, 225, 30, HEIGHT);
    scene.line(0, 60, 72, 30).line(LANE, 60, 108, 30);
    scene.line(22, 95, 40, 72).restitution(1.9).line(160, 95, 142, 72).restitution(1.9);
    for (double[] b : BUMPERS) {
      scene.peg(b[0], b[1], b[2]).restitution(1.9);
    }
    scene.peg(30, 140, 2).peg(150, 140, 2).peg(90, 215, 2).peg(90, 60, 2);
    scene.circle((LANE + WIDTH) / 2, REST + RADIUS, RADIUS, 0, 0).restitution(0.7);
    return new World(scene.build());
  }

  @Override
  public void frame() {
    boolean waits = world.x(BALL) > LANE && Math.abs(world.vy(BALL)) < 1e-3;
    if (waits && !held && goal == REST && height() == REST) { // deeper or less deep each time
      goal = 8 + 7 * (balls * 0.618 % 1);
    }
    plunge();
    world.step(1);
    readLog();
  }

  /** Sets the velocity that leads to the goal, and no further: down slowly, then up at once. */
  private void plunge() {
    if (height() <= goal && goal < REST && !held) {
      goal = REST;
    }
    double v = Math.max(PULL, Math.min(THROW, goal - height()));
    if (v != world.velocity(Kind.LINE, PLUNGER).y()) {
      world.setVelocity(Kind.LINE, PLUNGER, 0, v);
    }
  }

  private double height() {
    return world.line(PLUNGER).ay();
  }

  private void readLog() {
    ImpactLog log = world.impacts();
    for (int row = 0; row < log.size(); row++) {
      if (log.kind(row) == Kind.LINE && log.id(row) == DRAIN) {
        world.setPosition(BALL, (LANE + WIDTH) / 2, REST + 4 * RADIUS);
        world.setVelocity(BALL, 0, 0);
        lost = world.now();
        balls++;
        return;
      } else if (log.kind(row) == Kind.PEG && log.id(row) < BUMPERS.length) {
        score += 10;
      }
    }
  }

  @Override
  public void press() {
    held = true;
    goal = 6;
  }

  @Override
  public void release() {
    held = false;
    goal = REST;
  }

  @Override
  public String hint() {
    return "Hold the mouse button to pull the plunger down, let go to throw the ball.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    Scene now = WorldScene.of(world);
    drawing.withScene(now).draw(g, area, Still.of(now).colored(i -> Style.ORANGE));
    Path2D way = new Path2D.Double();
    double begin = Math.max(lost, world.now() - TRAIL);
    way.moveTo(past.x(BALL, begin), past.y(BALL, begin));
    for (double t = begin; t <= world.now(); t += 0.25) {
      way.lineTo(past.x(BALL, t), past.y(BALL, t));
    }
    g.setColor(Style.veil(Style.ORANGE, 0.8));
    g.setStroke(Style.line(Style.FIRM));
    g.draw(drawing.transform(area).createTransformedShape(way));
    g.setColor(Style.BLUE);
    for (double[] b : BUMPERS) {
      Ellipse2D disk = new Ellipse2D.Double(b[0] - b[2], b[1] - b[2], 2 * b[2], 2 * b[2]);
      g.fill(drawing.transform(area).createTransformedShape(disk));
    }
    g.setColor(Style.QUIET);
    g.setFont(Style.font(16));
    g.drawString(
        "score " + score + ", ball " + balls, (int) area.getX() + 24, (int) area.getY() + 38);
  }
}
