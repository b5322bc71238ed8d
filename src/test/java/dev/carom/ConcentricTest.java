// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Circles that start on the centre of something, and come back to it before the rounded places
 * differ. Each row of the log has a unit normal and a finite speed.
 */
class ConcentricTest {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private int rows;

  private void step(World world, double dt) {
    world.step(dt);
    ImpactLog log = world.impacts();
    for (int row = 0; row < log.size(); row++, rows++) {
      assertThat(Math.hypot(log.nx(row), log.ny(row))).isCloseTo(1, within(1e-15));
      assertThat(log.approachSpeed(row)).isBetween(0.0, Double.MAX_VALUE);
      assertThat(log.x(row) + log.y(row)).isFinite();
    }
  }

  /** The infinite mass goes ahead, until the other one falls faster: it is still ahead then. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-8, 1e-20, 1e-162, 1e-300, Double.MIN_VALUE})
  void whoFallsFromTheCentreOfAnotherMeetsItWhereItComesBack(double speed) {
    for (int sign : new int[] {1, -1}) {
      SceneBuilder scene = Scene.builder().gravity(0, 2 * sign);
      scene.circle(6, 6, 1, 0, sign * speed).mass(INFINITE).circle(6, 6, 0.5, 0, 0);
      World world = new World(scene.build());
      step(world, 1e-6);
      assertThat(world.impacts().size()).isPositive();
      assertThat(world.impacts().nx(0)).isZero();
      assertThat(world.impacts().ny(0)).isEqualTo(sign);
    }
    assertThat(rows).isPositive();
  }

  /** On a peg or an end of a line, at rest or moving. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-8, 1e-150, 1e-162, 1e-300, Double.MIN_VALUE})
  void whoStartsOnACentreMeetsItWhereItComesBack(double speed) {
    for (boolean collide : new boolean[] {false, true}) {
      for (double place : new double[] {0, 6}) {
        for (boolean moves : new boolean[] {false, true}) {
          SceneBuilder peg = Scene.builder().collide(collide).gravity(0, 2);
          comeBack(peg.peg(place, place, 2), moves, place, speed);
          SceneBuilder line = Scene.builder().collide(collide).gravity(0, 2);
          comeBack(line.line(place, place, place + 1, place), moves, place, speed);
        }
      }
    }
  }

  private void comeBack(SceneBuilder scene, boolean moves, double place, double speed) {
    if (moves) {
      scene.velocity(0, speed);
    }
    World world = new World(scene.circle(place, place, 0.5, 0, moves ? 0 : -speed).build());
    step(world, 1e-6);
    assertThat(world.impacts().size()).isPositive();
    assertThat(world.impacts().ny(0)).isEqualTo(-1);
  }

  /** All on two centres, some set back there between the steps. */
  @Test
  void manyOnOneCentreHaveUnitNormals() {
    for (int seed = 0; seed < 120; seed++) {
      Random random = new Random(seed);
      SceneBuilder scene = Scene.builder().gravity(0, -random.nextInt(3));
      scene.bounds(-10, -10, 30, 30).restitution(0.5);
      for (int i = random.nextInt(3); i > 0; i--) {
        scene.peg(centre(random), 6, random.nextInt(3)).velocity(0, speed(random));
      }
      int count = 2 + random.nextInt(5);
      for (int i = 0; i < count; i++) {
        scene.circle(centre(random), 6, 0.5, speed(random), speed(random));
        scene.restitution(random.nextInt(3) / 2.0);
        scene.mass(random.nextInt(3) == 0 ? INFINITE : 1);
        scene.response(random.nextInt(5) == 0 ? Response.SENSOR : Response.BOUNCE);
      }
      World world = new World(scene.build());
      for (int k = 0; k < 20; k++) {
        step(world, 0.25);
        world.setPosition(random.nextInt(count), centre(random), 6);
        world.setVelocity(random.nextInt(count), speed(random), speed(random));
      }
    }
    assertThat(rows).isGreaterThan(1_000);
  }

  private static double centre(Random random) {
    return 6 * random.nextInt(2);
  }

  private static double speed(Random random) {
    double[] some = {0, 0, 1, -1, 1e-8, -1e-8, 1e-20, -1e-12};
    return some[random.nextInt(some.length)];
  }
}
