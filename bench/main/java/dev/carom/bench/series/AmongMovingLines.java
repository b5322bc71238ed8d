// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.Bounds;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.SceneCopy;
import dev.carom.bench.experiment.Tiles;
import java.util.SplittableRandom;

/**
 * A hundred canonical scenes side by side, with their 10,000 lines and one in ten of their circles;
 * and 100 more lines, which move, or rest where they would be half-way: so both have about as many
 * impacts.
 */
final class AmongMovingLines {

  private static final int SIDE = 10;
  private static final int EACH = 10;
  private static final int MOVING = 100;
  private static final double HALF = 10;
  private static final double SLOWEST = 1;
  private static final double FASTEST = 10;

  private final Scene tiles;
  private final Bounds bounds;
  private final double frames;
  private final boolean moves;
  private final SceneBuilder builder;

  private AmongMovingLines(long seed, int frames, boolean moves) throws CannotPlaceException {
    tiles = new Tiles(SIDE, true, seed).scene();
    bounds = tiles.bounds().orElseThrow();
    builder = SceneCopy.obstacles(tiles);
    this.frames = frames;
    this.moves = moves;
  }

  /**
   * Makes the scene.
   *
   * @param frames for which the moving lines stay inside the bounds
   * @param moves whether they move
   */
  static Scene scene(long seed, int frames, boolean moves) throws CannotPlaceException {
    return new AmongMovingLines(seed, frames, moves).build(seed);
  }

  private Scene build(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int added = 0;
    while (added < MOVING) {
      added += add(random) ? 1 : 0;
    }
    for (int i = 0; i < tiles.count(Kind.CIRCLE); i += EACH) {
      SceneCopy.circle(builder, tiles, i);
    }
    return builder.build();
  }

  /** Draws a line, which is added if it stays inside. */
  private boolean add(SplittableRandom random) {
    double x = random.nextDouble() * bounds.xmax();
    double y = random.nextDouble() * bounds.ymax();
    Vec2 u = vector(random, SLOWEST + (FASTEST - SLOWEST) * random.nextDouble());
    Vec2 half = vector(random, HALF);
    boolean stays = isInside(x + frames * u.x(), y + frames * u.y());
    if (stays && moves) {
      line(x, y, half).velocity(u.x(), u.y());
    } else if (stays) {
      line(x + frames / 2 * u.x(), y + frames / 2 * u.y(), half);
    }
    return stays;
  }

  private SceneBuilder line(double x, double y, Vec2 half) {
    return builder.line(x - half.x(), y - half.y(), x + half.x(), y + half.y());
  }

  private boolean isInside(double x, double y) {
    return x > bounds.xmin() && x < bounds.xmax() && y > bounds.ymin() && y < bounds.ymax();
  }

  private static Vec2 vector(SplittableRandom random, double length) {
    double angle = 2 * StrictMath.PI * random.nextDouble();
    return new Vec2(length * StrictMath.cos(angle), length * StrictMath.sin(angle));
  }
}
