// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.ObstacleKind;
import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.event.KeyEvent;
import java.awt.geom.Rectangle2D;
import java.util.List;

/**
 * A lift: a line that moves up and down. The ball without bounce rides on it, the others are pushed
 * and bounce.
 */
public final class Lift implements Example {

  /** Up or down, a frame. */
  static final double SPEED = 1.25;

  /** A ball without bounce. */
  static final int RIDER = 0;

  private static final double[] BOUNCE = {0, 0.5, 0.8};
  private static final List<Color> COLORS = List.of(Style.ORANGE, Style.GREEN, Style.PURPLE);
  private static final double WIDTH = 200;
  private static final double HEIGHT = 150;
  private static final double BOTTOM = 15;
  private static final double TOP = 85;
  private static final double GRAVITY = -0.03;
  private static final int PAUSE = 90;
  private static final int LIFT = 0;

  private final World world = shaft();
  private final SceneDrawing drawing =
      SceneDrawing.of(world.scene()).withMargin(8).withArrowTime(0);
  private int frame;

  /** The way that somebody chose: 1 up, -1 down; 0 if the lift goes by itself. */
  private int chosen;

  private static World shaft() {
    var scene = Scene.builder().gravity(0, GRAVITY);
    scene.bounds(0, 0, WIDTH, HEIGHT).line(0, BOTTOM, WIDTH, BOTTOM);
    for (int i = 0; i < BOUNCE.length; i++) {
      scene.circle(50 * (i + 1), BOTTOM + 30, 7 + 2 * i, 0, 0).restitution(BOUNCE[i]);
    }
    return new World(scene.build());
  }

  World world() {
    return world;
  }

  /** Where the lift is. */
  double level() {
    return world.line(LIFT).ay();
  }

  @Override
  public void frame() {
    steer();
    Example.advance(world, 1, () -> {});
    frame++;
  }

  /** Sets the velocity that leads to the next stop, and no further. */
  private void steer() {
    boolean up = chosen == 0 ? frame / PAUSE % 2 == 0 : chosen > 0;
    double way = (up ? TOP : BOTTOM) - level();
    double v = Math.max(-SPEED, Math.min(SPEED, way));
    if (v != world.velocity(ObstacleKind.LINE, LIFT).y()) {
      world.setVelocity(ObstacleKind.LINE, LIFT, 0, v);
    }
  }

  /** Up if it is below, down if it is above. */
  @Override
  public void press() {
    chosen = level() < (BOTTOM + TOP) / 2 ? 1 : -1;
  }

  @Override
  public void key(int code, boolean down) {
    if (code == KeyEvent.VK_UP || code == KeyEvent.VK_DOWN) {
      chosen = code == KeyEvent.VK_UP ? 1 : -1;
    }
  }

  @Override
  public String hint() {
    return "Click, or press up or down, to call the lift; it carries one ball and throws two.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    drawing.withScene(WorldScene.of(world)).draw(g, area, Still.of(world).colored(COLORS::get));
    g.setColor(Style.QUIET);
    g.setFont(Style.font(16));
    String going = world.velocity(ObstacleKind.LINE, LIFT).y() > 0 ? "up" : "down";
    g.drawString("going " + going, (int) area.getX() + 24, (int) area.getY() + 38);
  }
}
