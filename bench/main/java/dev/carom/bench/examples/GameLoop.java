// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Timeline;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.Timer;

/**
 * The loop of a game in Swing. A timer fires when it likes; the game goes on in steps of 1/120 s,
 * as many as fit into the time that passed, so that a run does not depend on the timer. What is
 * shown lies one step back, between the last two steps: the timeline tells where each circle was
 * then, bounces included, where mixing two positions would cut the corner.
 */
public final class GameLoop implements Example {

  /** Nanoseconds of a step. */
  static final long STEP = 1_000_000_000 / 120;

  /** After a longer pause the game goes on where it was, and does not run after the clock. */
  static final long MOST = 20 * STEP;

  private static final List<Color> COLORS = List.of(Style.ORANGE, Style.GREEN, Style.PURPLE);
  private static final double DT = STEP / 1e9;
  private static final double GRAVITY = -600;

  private final World world;
  private final Timeline past;
  private final SceneDrawing drawing;

  /** Time that has passed and is not yet in a step. */
  private long rest;

  /** Sets up a scene. */
  public GameLoop() {
    SceneBuilder setup = Scene.builder().collide(false).gravity(0, GRAVITY);
    setup.bounds(0, 0, 400, 300).restitution(0.9).line(40, 200, 180, 140).line(220, 90, 370, 150);
    setup.peg(200, 220, 12).circle(60, 270, 10, 40, 0).circle(330, 250, 14, -120, 0);
    setup.circle(205, 285, 8, 0, 0);
    Scene scene = setup.build();
    world = new World(scene);
    past = world.record(2 * DT);
    drawing = SceneDrawing.of(scene).withArrowTime(0).withMargin(8);
  }

  /** Goes on by the time that has passed since the last call. */
  void elapse(long nanos) {
    rest = Math.min(rest + nanos, MOST);
    while (rest >= STEP) {
      step();
      rest -= STEP;
    }
  }

  private void step() {
    world.step(DT);
  }

  /** The moment that is shown, at most a step before the world's. */
  double shown() {
    return Math.max(past.start(), world.now() - DT + rest / 1e9);
  }

  World world() {
    return world;
  }

  @Override
  public void frame() {
    elapse(1_000_000_000 / FRAMES);
  }

  /** Throws all balls up. */
  @Override
  public void press() {
    for (int id : world.ids(Kind.CIRCLE)) {
      world.setVelocity(id, world.vx(id), -GRAVITY * 0.6);
    }
  }

  @Override
  public String hint() {
    return "Click to throw the balls up; the game keeps its time whatever the timer does.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    Scene then = WorldScene.of(world, past, shown());
    drawing.withScene(then).draw(g, area, Still.of(then).colored(COLORS::get));
  }

  /** The loop itself: a component that shows the game and keeps it going. */
  public JComponent component() {
    JComponent view =
        new JComponent() {
          private static final long serialVersionUID = 1;

          @Override
          protected void paintComponent(Graphics g) {
            g.setColor(Style.PAPER);
            g.fillRect(0, 0, getWidth(), getHeight());
            draw((Graphics2D) g, getBounds());
          }
        };
    view.setPreferredSize(new Dimension(size()));
    long[] last = {System.nanoTime()};
    Timer timer = new Timer(1000 / FRAMES, event -> tick(view, last));
    timer.start();
    return view;
  }

  private void tick(JComponent view, long[] last) {
    long now = System.nanoTime();
    elapse(now - last[0]);
    last[0] = now;
    view.repaint();
  }
}
