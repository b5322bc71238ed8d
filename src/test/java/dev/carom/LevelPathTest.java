// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Level paths, of which the broad search knows the speed exactly, and lines that they touch by next
 * to nothing: nothing but what is allowed for rounding keeps these from being passed over.
 */
class LevelPathTest {

  private static final int LINES = 300;

  private final Random random = new Random(3);

  /** Steps on until a circle that flies to the right has passed all of it. */
  private static void assertHit(double px, double py, double r, double vx, Line line) {
    assertThat(
            new SweptCircle(px, py, r, vx, 0)
                .timeToLine(line.ax(), line.ay(), line.bx(), line.by(), 99))
        .isLessThan(99);
    SceneBuilder scene = Scene.builder().line(line.ax(), line.ay(), line.bx(), line.by());
    World world = new World(scene.circle(px, py, r, vx, 0).build());
    world.step(99);
    assertThat(world.impacts().size()).as("%s, %s, %s, %s, %s", px, py, r, vx, line).isPositive();
  }

  /**
   * Sum and difference of what is computed of both ends err by more than the near end is within the
   * radius. The line's places, taken away from the circle's, would leave next to nothing for that.
   */
  @Test
  void aLineIsHitWhoseOtherEndIsFurtherOffThanTheCircle() {
    for (int i = 0; i < LINES; i++) {
      double y = 10 * (1 + random.nextDouble());
      double near = y - 1 - random.nextDouble();
      double r = Math.nextUp(y - near);
      double far = -(y + r * (1 - random.nextDouble() / 100));
      assertHit(0, y, r, 1 + random.nextDouble(), new Line(5, near, 6, far));
    }
  }

  /** And so would the circle's height, taken away from the line's places. */
  @Test
  void aLineIsHitWhoseOtherEndIsAsFarAsTheNearOne() {
    for (int i = 0; i < LINES; i++) {
      double near = 10 * (1 + random.nextDouble());
      double y = near + 1 + random.nextDouble();
      double r = Math.nextUp(y - near);
      assertHit(
          random.nextDouble() / 100, y, r, 1 + random.nextDouble(), new Line(5, near, 6, -near));
    }
  }

  /** The products for either end have but a few bits, of which the last one is rounded. */
  @Test
  void aLineIsHitWhereProductsUnderflow() {
    for (int i = 0; i < LINES; i++) {
      double unit = Math.scalb(1.0, -532 + random.nextInt(5));
      double r = unit * (1 + random.nextDouble());
      double y = -r * (1 - 0x1p-40);
      assertHit(0, 0, r, unit * (1 + random.nextDouble()), new Line(5 * unit, y, 6 * unit, y));
    }
  }

  /** The product for one end is nearly the largest double, and the sum of both is beyond. */
  @Test
  void aLineIsHitWhereSumsOfProductsOverflow() {
    double unit = 0x1p511;
    for (int i = 0; i < LINES; i++) {
      double far = unit * (3.6 + random.nextDouble() / 4);
      double near = unit * (random.nextDouble() + 0.3);
      assertHit(0, 0, 1.4 * unit, unit, new Line(5 * unit, far, 6 * unit, near));
    }
  }
}
