// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Random;

/**
 * A gas that relaxes: all circles start at the same speed, 1, in random directions. Their
 * collisions spread the speeds, until they follow the law of Maxwell and Boltzmann, which in the
 * plane, with a mean square of 1, is {@code f(v) = 2 v exp(-v v)}. The total energy stays.
 */
public final class Relaxation implements Example {

  private static final int COLUMNS = 30;
  private static final int CIRCLES = COLUMNS * COLUMNS;
  private static final double CELL = 5;
  private static final double MOST = 3;
  private static final int BINS = 24;

  private final World world;
  private final SceneDrawing drawing;

  /**
   * Sets up a lattice.
   *
   * @param seed of the directions, any number
   */
  public Relaxation(long seed) {
    Random random = new Random(seed);
    SceneBuilder scene = Scene.builder().collide(true);
    scene.bounds(0, 0, COLUMNS * CELL, COLUMNS * CELL);
    for (int i = 0; i < CIRCLES; i++) {
      double x = (i % COLUMNS + 0.5) * CELL;
      int row = i / COLUMNS;
      double y = (row + 0.5) * CELL;
      double angle = 2 * StrictMath.PI * random.nextDouble();
      scene.circle(x, y, 1, StrictMath.cos(angle), StrictMath.sin(angle));
    }
    world = new World(scene.build());
    drawing = SceneDrawing.of(world.scene()).withArrowTime(0).withMargin(8);
  }

  /** One of them. */
  public Relaxation() {
    this(1);
  }

  @Override
  public void frame() {
    Example.advance(world, 1, () -> {});
  }

  /** The speeds now. */
  double[] speeds() {
    double[] speeds = new double[CIRCLES];
    for (int i = 0; i < CIRCLES; i++) {
      speeds[i] = Math.sqrt(world.vx(i) * world.vx(i) + world.vy(i) * world.vy(i));
    }
    return speeds;
  }

  /** The share of the circles that the law gives speeds up to a limit. */
  static double law(double v) {
    return -Math.expm1(-v * v);
  }

  /** All speeds become 1 again; the directions stay. */
  @Override
  public void press() {
    double[] speeds = speeds();
    for (int i = 0; i < CIRCLES; i++) {
      world.setVelocity(i, world.vx(i) / speeds[i], world.vy(i) / speeds[i]);
    }
  }

  @Override
  public String hint() {
    return "Watch the speeds, from blue to red, take the curve; click to make all of them 1 again.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    double left = 0.64 * area.getWidth();
    double[] speeds = speeds();
    Rectangle2D square = new Rectangle2D.Double(area.getX(), area.getY(), left, area.getHeight());
    drawing.draw(g, square, Still.of(world).colored(i -> color(speeds[i])));
    double right = area.getWidth() - left;
    histogram(
        g,
        new Rectangle2D.Double(area.getX() + left + 10, area.getCenterY() - 140, right - 30, 280));
  }

  /** From blue for what rests over yellow for the mean to red. */
  private static Color color(double v) {
    return v < 1
        ? Style.mix(Style.BLUE, Style.YELLOW, v)
        : Style.mix(Style.YELLOW, Style.VERMILION, Math.min(1, v - 1));
  }

  /** Bars for what is, a curve for the law; both as densities. */
  private void histogram(Graphics2D g, Rectangle2D box) {
    int[] counts = new int[BINS];
    for (double v : speeds()) {
      counts[(int) Math.min(BINS - 1, v / MOST * BINS)]++;
    }
    double tallest = 1.2;
    double width = box.getWidth() / BINS;
    g.setColor(Style.SKY);
    for (int i = 0; i < BINS; i++) {
      double density = counts[i] / (CIRCLES * MOST / BINS);
      double height = Math.min(1, density / tallest) * box.getHeight();
      g.fill(
          new Rectangle2D.Double(
              box.getX() + i * width + 0.5, box.getMaxY() - height, width - 1, height));
    }
    Path2D law = new Path2D.Double();
    law.moveTo(box.getX(), box.getMaxY());
    for (int i = 1; i <= 100; i++) {
      double v = MOST * i / 100;
      double height = 2 * v * Math.exp(-v * v) / tallest * box.getHeight();
      law.lineTo(box.getX() + v / MOST * box.getWidth(), box.getMaxY() - height);
    }
    g.setColor(Style.VERMILION);
    g.setStroke(Style.line(Style.FIRM));
    g.draw(law);
    g.setColor(Style.INK);
    g.setFont(Style.font(12));
    float base = (float) box.getMaxY() + 16;
    for (int v = 0; v <= MOST; v++) {
      g.drawString(String.valueOf(v), (float) (box.getX() + v / MOST * box.getWidth()) - 3, base);
    }
    g.drawString("speed, at time " + Math.round(world.now()), (float) box.getX(), base + 14);
    g.drawString("curve: Maxwell and Boltzmann", (float) box.getX(), (float) box.getY() - 6);
  }
}
