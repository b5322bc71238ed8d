// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.ObstacleKind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Locale;
import java.util.Random;

/**
 * A gas under a lid: a line that moves slowly compresses it, and lets it go again. Each circle that
 * meets the lid gains speed, or loses it; the energy E follows the adiabatic law, which in two
 * dimensions is {@code E V = constant}.
 */
public final class Piston implements Example {

  private static final double SIDE = 100;
  private static final double LEAST = 40; // of the volume's length
  private static final double RADIUS = 0.3;
  private static final int ROWS = 20;
  private static final double SPEED = 2; // of each circle, at the start
  private static final double LID_SPEED = 0.05;
  private static final int LID = 0;

  private final World world = gas();
  private final SceneDrawing drawing =
      SceneDrawing.of(world.scene()).withMargin(8).withArrowTime(0);
  private final double energy = energy();
  private final double volume = volume();
  private final Path2D path = new Path2D.Double();

  /** Starts to compress. */
  public Piston() {
    path.moveTo(1, 1);
  }

  private static World gas() {
    SceneBuilder scene = Scene.builder().collide(true).bounds(0, 0, SIDE, SIDE);
    scene.line(SIDE, 0, SIDE, SIDE).velocity(-LID_SPEED, 0);
    Random random = new Random(1);
    for (int i = 0; i < ROWS * ROWS; i++) {
      double angle = 2 * StrictMath.PI * random.nextDouble();
      double x = (i % ROWS + 0.5) * SIDE / ROWS;
      int row = i / ROWS;
      double y = (row + 0.5) * SIDE / ROWS;
      scene.circle(x, y, RADIUS, SPEED * StrictMath.cos(angle), SPEED * StrictMath.sin(angle));
    }
    return new World(scene.build());
  }

  World world() {
    return world;
  }

  @Override
  public void frame() {
    double lid = world.line(LID).ax();
    if (lid <= LEAST || lid >= SIDE) {
      world.setVelocity(ObstacleKind.LINE, LID, lid <= LEAST ? LID_SPEED : -LID_SPEED, 0);
    }
    Example.advance(world, 1, () -> {});
    path.lineTo(volume() / volume, energy() / energy);
  }

  private double energy() {
    double sum = 0;
    for (int id : world.ids(ObstacleKind.CIRCLE)) {
      sum += (world.vx(id) * world.vx(id) + world.vy(id) * world.vy(id)) / 2;
    }
    return sum;
  }

  /** That for the centres, less what the circles keep each other from, after van der Waals. */
  private double volume() {
    double kept = world.circleCount() * 2 * Math.PI * RADIUS * RADIUS;
    return (world.line(LID).ax() - 2 * RADIUS) * (SIDE - 2 * RADIUS) - kept;
  }

  /** E times V, against the start. */
  double invariant() {
    return energy() / energy * (volume() / volume);
  }

  /** The lid turns round. */
  @Override
  public void press() {
    world.setVelocity(ObstacleKind.LINE, LID, -world.velocity(ObstacleKind.LINE, LID).x(), 0);
  }

  @Override
  public String hint() {
    return "Watch the energy follow the curve E = 1 / V; click to turn the lid round.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    double left = 0.68 * area.getWidth();
    Rectangle2D square = new Rectangle2D.Double(area.getX(), area.getY(), left, area.getHeight());
    drawing.withScene(WorldScene.of(world)).draw(g, square, Still.of(world));
    double width = area.getWidth() - left - 40;
    plot(g, new Rectangle2D.Double(square.getMaxX() + 16, area.getCenterY() - 130, width, 260));
  }

  /** The law and what was measured, V to the right and E upwards. */
  private void plot(Graphics2D g, Rectangle2D box) {
    Path2D law = new Path2D.Double();
    law.moveTo(1, 1);
    for (double v = 0.99; v > LEAST / SIDE; v -= 0.01) {
      law.lineTo(v, 1 / v);
    }
    double most = SIDE / LEAST;
    AffineTransform map = AffineTransform.getTranslateInstance(box.getX(), box.getMaxY());
    map.scale(box.getWidth(), -box.getHeight() / (most - 1));
    map.translate(0, -1);
    g.setStroke(Style.line(5));
    g.setColor(Style.veil(Style.ORANGE, 0.6));
    g.draw(map.createTransformedShape(law));
    g.setStroke(Style.line(Style.FIRM));
    g.setColor(Style.BLUE);
    g.draw(map.createTransformedShape(path));
    g.setColor(Style.INK);
    g.setFont(Style.font(14));
    g.drawString("E against V", (float) box.getX(), (float) box.getY() - 20);
    g.drawString("orange: E = 1 / V", (float) box.getX(), (float) box.getMaxY() + 30);
    String product = String.format(Locale.ROOT, "E times V now: %.3f", invariant());
    g.drawString(product, (float) box.getX(), (float) box.getMaxY() + 54);
  }
}
