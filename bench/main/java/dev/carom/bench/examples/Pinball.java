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
import java.awt.event.KeyEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/**
 * A pinball table: slopes, bumpers whose restitution is above 1, two {@link Flipper flippers},
 * which play by themselves until the first key, and a {@link Plunger plunger}. A one-way line keeps
 * the ball out of its lane, and a sensor reports a lost ball.
 */
public final class Pinball implements Example {

  private static final double WIDTH = 200;
  private static final double HEIGHT = 250;
  private static final double LANE = 182;
  private static final double RADIUS = 5;
  private static final double GRAVITY = -0.06;
  private static final double REST = 30; // the plunger's height
  private static final int BALL = 0;
  private static final int DRAIN = 1; // a line
  private static final int TRAIL = 200;
  private static final double[][] BUMPERS = {{55, 175, 13}, {125, 175, 13}, {90, 125, 13}};

  final World world = table();
  private final Plunger plunger = new Plunger(world, 0, REST);
  private final Flipper left = new Flipper(world, 2, 1);
  private final Flipper right = new Flipper(world, 3, -1);
  private final Timeline past = world.record(1_000);
  private final SceneDrawing drawing =
      SceneDrawing.of(world.scene()).withMargin(8).withArrowTime(0);
  private double lost; // when the last ball was
  int score;
  int balls = 1;
  private boolean alone = true;

  private static World table() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, WIDTH, HEIGHT).gravity(0, GRAVITY);
    scene.line(LANE, REST, WIDTH, REST);
    scene.line(0, 3, LANE, 3).response(Response.SENSOR);
    Flipper.add(scene, 60, 36, 25, 1);
    Flipper.add(scene, LANE - 60, 36, 25, -1);
    scene.line(LANE, 0, LANE, 200);
    scene.line(LANE, 200, LANE, HEIGHT).oneWay(); // its left is the table's side
    scene.line(LANE, HEIGHT, WIDTH, 225).line(0, 225, 30, HEIGHT);
    scene.line(0, 60, 60, 36).line(LANE, 60, LANE - 60, 36);
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
    if (waits && plunger.isReady()) {
      plunger.pull(8 + 7 * (balls * 0.618 % 1)); // deeper or less deep each time
    }
    plunger.go();
    if (alone) {
      left.hold(left.isNear(BALL));
      right.hold(right.isNear(BALL));
    }
    world.step(1);
    readLog();
  }

  @Override
  public void key(int code, boolean down) {
    if (code == KeyEvent.VK_LEFT || code == KeyEvent.VK_RIGHT) {
      alone = false;
      (code == KeyEvent.VK_LEFT ? left : right).hold(down);
    }
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
    plunger.hold(6);
  }

  @Override
  public void release() {
    plunger.release();
  }

  @Override
  public String hint() {
    return "The left and right keys move the flippers; the mouse button pulls the plunger down.";
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
