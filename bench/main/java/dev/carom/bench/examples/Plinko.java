// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Kind;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Traits;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/**
 * Plinko: balls fall among pegs and lose half of their normal speed at each. A sensor at the bottom
 * of each slot reports a ball that arrives; the ball is counted and removed. The counts come close
 * to the bell curve.
 */
public final class Plinko implements Example {

  /** The slots at the bottom. */
  static final int SLOTS = 17;

  private static final double SPACING = 12;
  private static final int ROWS = 12;
  private static final double LOWEST = 58;
  private static final double WIDTH = SLOTS * SPACING;
  private static final double HEIGHT = LOWEST + ROWS * SPACING - 6;
  private static final double SLOT = 46; // its depth
  private static final double PEG = 1.2;
  private static final double BALL = 2;
  private static final double GRAVITY = -0.03;
  private static final int PAUSE = 4; // frames from ball to ball
  private static final double FULL = 0.86; // of a slot's depth, the longest bar
  private static final List<Color> COLORS = List.of(Style.ORANGE, Style.GREEN, Style.PURPLE);

  private final World world = board();
  private final SceneDrawing drawing =
      SceneDrawing.of(world.scene()).withMargin(8).withArrowTime(0);
  private final Random random = new Random(1);
  private final int[] counts = new int[SLOTS];
  private double from = WIDTH / 2; // where balls are let go
  private Rectangle2D shown = new Rectangle2D.Double(0, 0, 840, 640);
  private int frame;
  private int dropped;

  private static World board() {
    SceneBuilder scene =
        Scene.builder().collide(false).bounds(0, 0, WIDTH, HEIGHT).gravity(0, GRAVITY);
    for (int slot = 0; slot < SLOTS; slot++) { // too short to be touched from the next slot
      double left = slot * SPACING;
      scene.line(left + BALL, 1, left + SPACING - BALL, 1).response(Response.SENSOR);
    }
    for (int slot = 1; slot < SLOTS; slot++) {
      scene.line(slot * SPACING, 0, slot * SPACING, SLOT);
    }
    for (int row = 0; row < ROWS; row++) {
      int pegs = SLOTS - 1 + row % 2;
      for (int i = 0; i < pegs; i++) {
        double x = (i + (row % 2 == 0 ? 1 : 0.5)) * SPACING;
        scene.peg(x, LOWEST + row * (SPACING - 1), PEG);
      }
    }
    return new World(scene.build());
  }

  World world() {
    return world;
  }

  /** How many balls arrived in each slot. */
  int[] counts() {
    return counts.clone();
  }

  int dropped() {
    return dropped;
  }

  @Override
  public void frame() {
    if (frame++ % PAUSE == 0) {
      double x = from + 2 * random.nextDouble() - 1;
      int ball = world.addCircle(x, HEIGHT - BALL - 1, BALL, 0, 0, Traits.DEFAULT);
      world.setTraits(Kind.CIRCLE, ball, world.traits(Kind.CIRCLE, ball).withRestitution(0.5));
      dropped++;
    }
    world.step(1);
    count();
  }

  private void count() {
    for (int row = 0; row < world.impacts().size(); row++) {
      int slot = world.impacts().id(row);
      if (world.impacts().kind(row) == Kind.LINE && slot < SLOTS) {
        counts[slot]++;
        world.remove(Kind.CIRCLE, world.impacts().circle(row));
      }
    }
  }

  @Override
  public void point(Vec2 at) {
    double x = drawing.place(shown, at).x();
    from = Math.max(BALL + 1, Math.min(WIDTH - BALL - 1, x));
  }

  /** Empties the slots. */
  @Override
  public void press() {
    Arrays.fill(counts, 0);
  }

  @Override
  public String hint() {
    return "Move the mouse to choose where balls are let go; click to count anew.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    shown = area;
    int most = Math.max(1, Arrays.stream(counts).max().orElse(1));
    Scene now = WorldScene.of(world);
    int[] ids = world.ids(Kind.CIRCLE);
    drawing.withScene(now).draw(g, area, Still.of(now).colored(i -> COLORS.get(ids[i] % 3)));
    Path2D bars = new Path2D.Double();
    for (int slot = 0; slot < SLOTS; slot++) {
      double height = FULL * SLOT * counts[slot] / most;
      bars.append(new Rectangle2D.Double(slot * SPACING + 1, 0, SPACING - 2, height), false);
    }
    g.setColor(Style.veil(Style.BLUE, 0.6));
    g.fill(drawing.transform(area).createTransformedShape(bars));
    g.setColor(Style.QUIET);
    g.setFont(Style.font(16));
    String text = Arrays.stream(counts).sum() + " balls";
    g.drawString(text, (int) area.getX() + 8, (int) area.getY() + 38);
  }
}
