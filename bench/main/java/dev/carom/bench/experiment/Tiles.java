// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;

/**
 * Canonical scenes side by side in one bounds, without walls between them: any number of circles
 * and as many lines, as dense as in the published experiment.
 *
 * @param side how many scenes stand in a row, and how many rows there are; at least 1
 * @param lines whether the lines are there
 * @param seed of the first scene, any number; the others have the numbers after it
 */
public record Tiles(int side, boolean lines, long seed) {

  private static final double WIDTH = 800;
  private static final double HEIGHT = 600;

  /** Checks the numbers. */
  public Tiles {
    if (side < 1) {
      throw new IllegalArgumentException("side is " + side + ": expected at least 1");
    }
  }

  /**
   * Generates the scene.
   *
   * @return the scene, in px and frames, of 100 side^2 circles
   * @throws CannotPlaceException if a cross or a circle finds no place
   */
  public Scene scene() throws CannotPlaceException {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, side * WIDTH, side * HEIGHT);
    for (int row = 0; row < side; row++) {
      for (int column = 0; column < side; column++) {
        Scene tile = Crosses.canonical(seed + (long) row * side + column).scene();
        add(tile, column * WIDTH, row * HEIGHT, builder);
      }
    }
    return builder.build();
  }

  private void add(Scene tile, double x, double y, SceneBuilder builder) {
    for (int i = 0; lines && i < tile.count(Kind.LINE); i++) {
      Line l = (Line) tile.shape(Kind.LINE, i);
      builder.line(l.ax() + x, l.ay() + y, l.bx() + x, l.by() + y);
    }
    for (int i = 0; i < tile.count(Kind.CIRCLE); i++) {
      Circle c = (Circle) tile.shape(Kind.CIRCLE, i);
      Vec2 v = tile.velocity(Kind.CIRCLE, i);
      builder.circle(c.x() + x, c.y() + y, c.radius(), v.x(), v.y());
    }
  }
}
