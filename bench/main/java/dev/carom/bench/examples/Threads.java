// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.concurrent.ExecutionException;

/** A scene on two threads: the circles of one are blue, those of the other orange. */
public final class Threads implements Example {

  private static final List<Color> COLORS = List.of(Style.BLUE, Style.ORANGE);
  private static final int CIRCLES = 4_000;

  private final SplitWorld split;
  private int frame;
  private final SceneDrawing drawing;

  /** Starts all circles from one point. */
  public Threads() {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, 400, 300);
    builder.line(60, 40, 150, 120).line(260, 60, 330, 150).line(120, 190, 280, 230);
    builder.peg(60, 240, 15).peg(340, 230, 20);
    for (int i = 0; i < CIRCLES; i++) {
      double angle = 2 * StrictMath.PI * (i + 0.5) / CIRCLES;
      builder.circle(200, 140, 1.5, StrictMath.cos(angle), StrictMath.sin(angle));
    }
    Scene scene = builder.build();
    split = new SplitWorld(scene, COLORS.size());
    drawing = SceneDrawing.of(scene).withMargin(8);
  }

  @Override
  public void frame() {
    try {
      frame++;
      split.advanceTo(frame);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e.getCause());
    }
  }

  @Override
  public String hint() {
    return "4,000 tiny circles from one point: one thread moves the blue half, another one the orange half.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    drawing.draw(g, area, Still.of(Scene.builder().build())); // what stands still
    AffineTransform map = drawing.transform(area);
    for (int k = 0; k < COLORS.size(); k++) {
      g.setColor(Style.veil(COLORS.get(k), 0.6));
      World part = split.parts().get(k);
      for (int id : part.ids(Kind.CIRCLE)) {
        double r = part.radius(id);
        g.fill(
            map.createTransformedShape(
                new Ellipse2D.Double(part.x(id) - r, part.y(id) - r, 2 * r, 2 * r)));
      }
    }
  }
}
