// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** A world passes over lines without asking the detector: never over one that is hit. */
class PassedLinesTest {

  private static final double END = 100;

  private final SplittableRandom random = new SplittableRandom(1);

  @Test
  void noLineThatIsHitIsPassedOver() {
    int hits = 0;
    int touching = 0;
    for (int i = 0; i < 100_000; i++) {
      double vx = place(2);
      double vy = place(2);
      double r = 1 + random.nextInt(3);
      double[] p = {place(6), place(6)};
      // Ends on a lattice are often exactly beside the start, or where the circle touches.
      Line line = new Line(place(6), place(6), place(6), place(6));
      double t =
          new SweptCircle(p[0], p[1], r, vx, vy)
              .timeToLine(line.ax(), line.ay(), line.bx(), line.by(), END);
      SceneBuilder scene = Scene.builder().line(line.ax(), line.ay(), line.bx(), line.by());
      World world = new World(scene.circle(p[0], p[1], r, vx, vy).build());
      world.step(END);
      boolean hit = t <= END;
      assertThat(world.impacts().size() > 0)
          .as("%s at %s, %s, radius %s, velocity %s, %s", line, p[0], p[1], r, vx, vy)
          .isEqualTo(hit);
      if (hit) {
        assertThat(world.impacts().time(0)).isEqualTo(t);
        hits++;
        touching += t == 0 ? 1 : 0;
      }
    }
    assertThat(hits).isGreaterThan(20_000);
    assertThat(touching).isGreaterThan(5_000);
  }

  /** A small whole number, every second time moved by an ulp or two. */
  private double place(int size) {
    double x = random.nextInt(-size, size + 1);
    return random.nextBoolean() ? x : x + random.nextInt(-2, 3) * Math.ulp(x + 1);
  }
}
