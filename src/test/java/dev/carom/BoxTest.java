// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * One circle of radius 10 in a box of 800 x 600, from (400, 300), in 14 speeds from 13 to 20,000
 * px/s at 60 frames a second and 15 directions from 1 to 89 degrees: each coordinate is a triangle
 * wave, here computed exactly. After each of 600 frames the circle must be within 1e-9 radii of it.
 */
@Tag("long")
class BoxTest {

  private static final int SPEEDS = 14;
  private static final int ANGLES = 15;
  private static final int FRAMES = 600;
  private static final double RADIUS = 10;

  private static SceneBuilder lines() {
    SceneBuilder builder = Scene.builder().line(0, 0, 800, 0).line(800, 0, 800, 600);
    return builder.line(800, 600, 0, 600).line(0, 600, 0, 0);
  }

  @Test
  void fourLinesFollowTheTriangleWave() {
    double worst = worst(i -> lines());
    System.out.printf("box of lines: worst %.2g radii from the triangle wave%n", worst);
    assertThat(worst).isLessThan(1e-9);
  }

  @Test
  void boundsFollowTheTriangleWave() {
    double worst = worst(i -> Scene.builder().bounds(0, 0, 800, 600));
    System.out.printf("box of bounds: worst %.2g radii from the triangle wave%n", worst);
    assertThat(worst).isLessThan(1e-9);
  }

  private static double worst(IntFunction<SceneBuilder> box) {
    double worst = 0;
    for (int i = 0; i < SPEEDS; i++) {
      double speed = 13 * Math.pow(20_000 / 13.0, i / (SPEEDS - 1.0)) / 60;
      for (int k = 0; k < ANGLES; k++) {
        double angle = Math.toRadians(1 + 88.0 * k / (ANGLES - 1));
        double vx = speed * Math.cos(angle);
        double vy = speed * Math.sin(angle);
        Scene scene = box.apply(i).circle(400, 300, RADIUS, vx, vy).build();
        worst = Math.max(worst, follow(scene, vx, vy));
      }
    }
    return worst;
  }

  /** The largest distance from the wave over all frames, in radii. */
  private static double follow(Scene scene, double vx, double vy) {
    World world = new World(scene);
    double worst = 0;
    for (int frame = 1; frame <= FRAMES; frame++) {
      world.step(1);
      double dx = error(world.x(0), 400, vx, frame, 800);
      double dy = error(world.y(0), 300, vy, frame, 600);
      worst = Math.max(worst, Math.hypot(dx, dy) / RADIUS);
    }
    return worst;
  }

  /** x less the wave at a frame: start + v frame, folded into the room that the centre has. */
  private static double error(double x, double start, double v, int frame, double size) {
    BigDecimal room = new BigDecimal(size - 2 * RADIUS);
    BigDecimal way =
        new BigDecimal(v).multiply(BigDecimal.valueOf(frame)).add(new BigDecimal(start - RADIUS));
    BigDecimal[] crossings = way.divideAndRemainder(room);
    boolean back = crossings[0].toBigInteger().testBit(0);
    BigDecimal place = back ? room.subtract(crossings[1]) : crossings[1];
    return new BigDecimal(x).subtract(new BigDecimal(RADIUS)).subtract(place).doubleValue();
  }
}
