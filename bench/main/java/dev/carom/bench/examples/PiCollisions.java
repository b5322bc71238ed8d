// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/**
 * Pi by counting collisions, after Galperin: a heavy circle flies at a light one that rests before
 * a wall. Where its mass is 100 to the power k the impacts, wall included, are the first k + 1
 * digits of pi: 3, 31, 314, 3141, 31415. Each one must be found, for a single one too few shows.
 */
public final class PiCollisions implements Example {

  /** Lanes, one for each number of digits. */
  static final int LANES = 5;

  private static final double LENGTH = 420;
  private static final double HALF = 30;
  private static final double WALL = 10;
  private static final double LIGHT = 8;
  private static final double SPEED = 1.5;

  private final List<World> lanes = new ArrayList<>();
  private final int[] counts = new int[LANES];
  private final SceneDrawing drawing;

  /** Sets up all lanes. */
  public PiCollisions() {
    Rectangle2D lane = new Rectangle2D.Double(0, -HALF, LENGTH, 2 * HALF);
    drawing =
        SceneDrawing.of(
                Scene.builder()
                    .line(lane.getMinX(), lane.getMinY(), lane.getMaxX(), lane.getMinY())
                    .line(lane.getMinX(), lane.getMaxY(), lane.getMaxX(), lane.getMaxY())
                    .build())
            .withArrowTime(0)
            .withMargin(10);
    press();
  }

  /** Begins again. */
  @Override
  public void press() {
    lanes.clear();
    double mass = 1;
    for (int k = 0; k < LANES; k++) {
      double radius = LIGHT + 4 * k;
      SceneBuilder setup = Scene.builder().line(WALL, -HALF, WALL, HALF);
      setup.circle(60, 0, LIGHT, 0, 0).circle(300, 0, radius, -SPEED, 0).mass(mass);
      Scene scene = setup.build();
      lanes.add(new World(scene));
      counts[k] = 0;
      mass *= 100;
    }
  }

  @Override
  public void frame() {
    for (int k = 0; k < LANES; k++) {
      int lane = k;
      World world = lanes.get(lane);
      world.step(1);
      counts[lane] += world.impacts().size();
    }
  }

  /**
   * The impacts so far.
   *
   * @param k the lane: its heavy circle has the mass 100 to the power k
   * @return at least 0
   */
  public int count(int k) {
    return counts[k];
  }

  @Override
  public String hint() {
    return "Watch the counts become the digits of pi; click to begin again.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    double height = area.getHeight() / LANES;
    for (int k = 0; k < LANES; k++) {
      double y = area.getY() + k * height;
      double width = 0.76 * area.getWidth();
      Rectangle2D lane = new Rectangle2D.Double(area.getX(), y, width, height);
      World world = lanes.get(k);
      drawing
          .withScene(world.scene())
          .draw(
              g,
              lane,
              Still.of(world).colored(i -> Style.veil(i == 0 ? Style.ORANGE : Style.BLUE, 0.75)));
      g.setColor(Style.INK);
      g.setFont(Style.bold(34));
      float x = (float) (area.getX() + width + 12);
      g.drawString(String.valueOf(counts[k]), x, (float) (y + height / 2 + 8));
      g.setColor(Style.QUIET);
      g.setFont(Style.font(13));
      String mass = k == 0 ? "equal masses" : "mass 1 to 1" + "00".repeat(k);
      g.drawString(mass, x, (float) (y + height / 2 + 30));
    }
  }
}
