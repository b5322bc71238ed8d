// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.ImpactLog;
import dev.carom.ObstacleKind;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.WorldScene;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;

/**
 * A billiards break, in metres and seconds: a cue ball runs into fifteen others that lie as close
 * as they can. The cloth slows them down: friction is a velocity that is set between frames. A
 * pocket is a peg that lets balls through and reports them; they are taken off the table.
 */
public final class Billiards implements Example {

  private static final double LENGTH = 2.54;
  private static final double WIDTH = 1.27;
  private static final double RADIUS = 0.028575;
  private static final int ROWS = 5;

  /** A ball is in when its rim comes to this disk: small, as pockets are seen from the cloth. */
  private static final double POCKET = 0.03;

  private static final double BALLS = 0.95;
  private static final double CUSHION = 0.8;

  /** What rolling takes off the speed: a hundredth of what gravity would. */
  private static final double SLOWING = 0.1;

  private static final double DT = 1.0 / FRAMES;

  private final World world;
  private final SceneDrawing drawing;
  private int pocketed;

  /**
   * Sets up the table.
   *
   * @param speed of the cue ball in metres per second, finite
   * @param aside how far its way lies beside the middle, in metres
   */
  public Billiards(double speed, double aside) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, LENGTH, WIDTH).restitution(CUSHION);
    scene.collide(true);
    for (int i = 0; i < 6; i++) {
      double x = i % 3 * LENGTH / 2;
      scene.peg(x, i < 3 ? 0 : WIDTH, POCKET).response(Response.SENSOR);
    }
    // The product of the two is the restitution of a pair.
    double each = StrictMath.sqrt(BALLS);
    scene.circle(LENGTH / 4, WIDTH / 2 + aside, RADIUS, speed, 0).restitution(each);
    for (int row = 0; row < ROWS; row++) {
      for (int i = 0; i <= row; i++) {
        double x = 0.75 * LENGTH + row * StrictMath.sqrt(3) * RADIUS * 1.0001;
        double y = WIDTH / 2 + (2 * i - row) * RADIUS * 1.0001;
        scene.circle(x, y, RADIUS, 0, 0).restitution(each);
      }
    }
    world = new World(scene.build());
    drawing = SceneDrawing.of(world.scene()).withMargin(10).withArrowTime(0.1);
  }

  /** A break at 8 metres per second, a hair beside the middle. */
  public Billiards() {
    this(8, 0.003);
  }

  @Override
  public void frame() {
    slow();
    world.step(DT);
    ImpactLog impacts = world.impacts();
    for (int row = 0; row < impacts.size(); row++) {
      if (impacts.kind(row) == ObstacleKind.PEG) {
        pocket(impacts.circle(row));
      }
    }
  }

  /** Takes as much off each speed as friction does in a frame; what is slower stops. */
  private void slow() {
    for (int id : world.ids(ObstacleKind.CIRCLE)) {
      if (speed(id) > 0) {
        double left = Math.max(0, 1 - SLOWING * DT / speed(id));
        world.setVelocity(id, left * world.vx(id), left * world.vy(id));
      }
    }
  }

  private double speed(int id) {
    return Math.sqrt(world.vx(id) * world.vx(id) + world.vy(id) * world.vy(id));
  }

  private void pocket(int ball) {
    if (world.contains(ObstacleKind.CIRCLE, ball)) { // else in two pockets in one frame
      world.remove(ObstacleKind.CIRCLE, ball);
      pocketed++;
    }
  }

  /**
   * The world, to look at.
   *
   * @return the table
   */
  public World world() {
    return world;
  }

  /**
   * The balls that are off the table.
   *
   * @return at least 0
   */
  public int pocketed() {
    return pocketed;
  }

  @Override
  public Dimension size() {
    return new Dimension(500, 260);
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    Scene now = WorldScene.of(world);
    drawing.withScene(now).draw(g, area, Still.of(now));
  }
}
