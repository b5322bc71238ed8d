// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Two obstacles that a falling circle hits at one time, found in either order. */
class TieUnderGravityTest {

  private static final int X = 14;

  private static final int Y = 1;

  /**
   * A point peg at the start of a line: lines come before pegs. A peg that is added is searched
   * first, and the exact time of both may be later than the time to which it rounds.
   */
  @Test
  void theLineComesBeforeThePegThatIsFoundFirst() {
    int ties = 0;
    for (int seed = 0; seed < 1000; seed++) {
      Random random = new Random(seed);
      SceneBuilder scene = Scene.builder().gravity(0.25, -1).line(X, Y, 3, 14);
      for (int i = 0; i < 30; i++) { // so many that there is a grid
        double x = 40 * random.nextDouble() - 10;
        double y = -20 - 20 * random.nextDouble();
        scene.line(x, y, x + 1, y + random.nextDouble());
      }
      double x = X + 2 * random.nextDouble() - 0.2;
      double y = Y + 4 + 4 * random.nextDouble();
      double radius = 0.5 + random.nextDouble();
      scene.circle(x, y, radius, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1);
      World world = new World(scene.build());
      world.step(0);
      world.addPeg(X, Y, 0, Traits.DEFAULT);
      if (world.advanceToImpact(5) && world.impacts().get(0).point().equals(new Vec2(X, Y))) {
        assertThat(world.impacts().kind(0)).as("seed %s", seed).isEqualTo(Kind.LINE);
        ties++;
      }
    }
    assertThat(ties).isGreaterThan(10);
  }
}
