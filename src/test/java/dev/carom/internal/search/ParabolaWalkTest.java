// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.state.ObstacleTable;
import java.util.Random;
import org.junit.jupiter.api.Test;

class ParabolaWalkTest {
  private static final double CELL = 4;

  /** The box of the pegs is from 0 to 40, so that the grid is from -5 to 45, or farther. */
  private static Grid grid() {
    SceneBuilder scene = Scene.builder();
    for (int i = 0; i <= 10; i++) {
      for (int j = 0; j <= 10; j++) {
        scene.peg(4 * i, 4 * j, 0);
      }
    }
    return new Grid(ObstacleTable.of(Internals.data(scene.build())), 1, CELL);
  }

  /** The lists that the walk names are those of the cells in which the centre is. */
  private static void assertFollows(
      Grid grid, double px, double py, double vx, double vy, double gx, double gy, double end) {
    ParabolaWalk walk = new ParabolaWalk();
    assertThat(walk.start(grid, px, py, vx, vy, gx, gy, 0)).isTrue();
    int compared = 0;
    for (double t = 0; t < end; t += end / 4096) {
      while (walk.to < t) {
        assertThat(walk.advance()).isTrue();
      }
      double x = grid.columns(px + (vx + 0.5 * gx * t) * t);
      double y = grid.rows(py + (vy + 0.5 * gy * t) * t);
      boolean isNearBorder =
          Math.abs(x - Math.rint(x)) < 0x1p-9 || Math.abs(y - Math.rint(y)) < 0x1p-9;
      boolean isInside = x > 0 && x < grid.columns && y > 0 && y < grid.rows;
      if (!isNearBorder) {
        long list = isInside ? grid.lists[grid.number((int) x, (int) y)] : CellList.OUTSIDE;
        assertThat(walk.list()).isEqualTo(list);
        compared++;
      }
    }
    assertThat(compared).isGreaterThan(1000);
  }

  @Test
  void itFollowsRandomPaths() {
    Grid grid = grid();
    Random random = new Random(1);
    for (int i = 0; i < 200; i++) {
      double gx = random.nextInt(3) == 0 ? 0 : random.nextGaussian();
      double gy = random.nextInt(3) == 0 ? 0 : random.nextGaussian();
      double vx = random.nextInt(5) == 0 ? 0 : 5 * random.nextGaussian();
      double vy = random.nextInt(5) == 0 ? 0 : 5 * random.nextGaussian();
      double px = 40 * random.nextDouble();
      double py = 40 * random.nextDouble();
      assertFollows(grid, px, py, vx, vy, gx, gy, 20);
    }
  }

  /** All borders, also those of the grid: it comes back from each at which it just turns. */
  @Test
  void itFollowsPathsThatTurnAtABorder() {
    Grid grid = grid();
    double edge = -grid.rows(0) * CELL;
    for (int border = 1; border <= grid.rows; border++) {
      double height = edge + border * CELL - 21;
      double g = height > 0 ? -2 : 2;
      double v = -g * Math.sqrt(2 * height / -g);
      assertFollows(grid, 21.5, 21, 0.01, v, 0, g, 20);
      assertFollows(grid, 21, 21.5, v, 0.01, g, 0, 20);
    }
  }

  /** It begins just after a turn at a border, which rounding puts on either side. */
  @Test
  void itGoesOnAfterATurnAtABorder() {
    Grid grid = grid();
    ParabolaWalk walk = new ParabolaWalk();
    double edge = -grid.rows(0) * CELL;
    Random random = new Random(2);
    for (int i = 0; i < 200_000; i++) {
      double g = -1 - 9 * random.nextDouble();
      double v = 5 * random.nextDouble();
      double turn = -v / g;
      double border = edge + (3 + random.nextInt(7)) * CELL;
      double py = border - 0.5 * v * turn + (random.nextInt(9) - 4) * 0x1p-50;
      double from = turn + random.nextInt(9) * 1e-9;
      assertThat(walk.start(grid, 21, py, 0.01, v, 0, g, from)).isTrue();
      double later = turn + Math.sqrt(3 * CELL / -g); // a cell and a half below
      while (walk.to < later) {
        assertThat(walk.advance()).isTrue();
      }
      double x = grid.columns(21 + 0.01 * later);
      double y = grid.rows(py + (v + 0.5 * g * later) * later);
      assertThat(walk.list()).isEqualTo(grid.lists[grid.number((int) x, (int) y)]);
    }
  }
}
