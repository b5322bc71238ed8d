// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Outcome;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Stuck circles without gravity: all that touches acts at once, and without bounce. */
class ShockTest {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private static World play(SceneBuilder scene) {
    World world = new World(scene.build());
    world.step(1);
    return world;
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 10, 100})
  void aRowThatIsHitGoesOnAsOne(int count) {
    SceneBuilder scene = Scene.builder();
    for (int i = 0; i < count; i++) {
      scene.circle(2 * i, 0, 1, i == 0 ? count : 0, 0).restitution(0);
    }
    World world = play(scene);
    for (int i = 0; i < count; i++) {
      assertThat(world.vx(i)).isCloseTo(1, within(1e-13 * count));
      assertThat(world.vy(i)).isZero();
    }
  }

  /** A column that falls on the floor comes to rest, to the bit. */
  @ParameterizedTest
  @CsvSource({"1, 1", "10, 0.05", "30, 1e-200", "10, 1e150"})
  void aColumnOnTheFloorStops(int count, double speed) {
    SceneBuilder scene = Scene.builder().line(-1, 0, 1, 0);
    for (int i = 0; i < count; i++) {
      scene.circle(0, 1 + 2 * i, 1, 0, -speed).restitution(0);
    }
    World world = play(scene);
    for (int i = 0; i < count; i++) {
      assertThat(world.vy(i)).as("circle %s", i).isZero();
      assertThat(world.y(i)).isEqualTo(1 + 2 * i);
    }
  }

  @Test
  void anInfiniteMassTakesARowAlong() {
    SceneBuilder scene = Scene.builder().circle(0, 0, 1, 3, 0).mass(INFINITE).restitution(0);
    for (int i = 1; i < 4; i++) {
      scene.circle(2 * i, 0, 1, 0, 0).restitution(0);
    }
    World world = play(scene);
    assertThat(world.vx(0)).isEqualTo(3);
    for (int i = 1; i < 4; i++) {
      assertThat(world.vx(i)).isCloseTo(3, within(1e-14));
      assertThat(world.x(i)).isCloseTo(2 * i + 3, within(1e-13));
    }
  }

  @Test
  void betweenTwoInfiniteMassesACircleIsCrushed() {
    SceneBuilder scene = Scene.builder().circle(0, 0, 1, 1, 0).mass(INFINITE);
    World world =
        play(scene.circle(2, 0, 1, 0, 0).restitution(0).circle(4, 0, 1, -1, 0).mass(INFINITE));
    assertThat(world.vx(1)).isZero();
    assertThat(world.x(1)).isEqualTo(2);
    assertThat(world.x(0)).isEqualTo(1);
    assertThat(world.x(2)).isEqualTo(3);
    assertThat(world.impacts().outcome(1)).isEqualTo(Outcome.JAMMED);
  }

  /** Two contacts turn the velocity to and fro; in the end nothing is left of it. */
  @Test
  void whatFliesIntoAWedgeStops() {
    SceneBuilder scene = Scene.builder().line(0, 0, 6, 8).line(0, 0, -6, 8);
    World world = play(scene.circle(0, 5 / 3.0, 1, 0.1, -1).restitution(0));
    assertThat(world.vx(0)).isZero();
    assertThat(world.vy(0)).isZero();
    assertThat(world.y(0)).isEqualTo(5 / 3.0);
  }

  /** Hexagons of circles that touch, without bounce: nothing approaches in the end. */
  @Test
  void inAPatchThatIsThrownTogetherNothingApproaches() {
    Random random = new Random(1);
    for (int run = 0; run < 50; run++) {
      int rows = 2 + random.nextInt(5);
      SceneBuilder scene = Scene.builder();
      double[][] v = new double[rows * rows][2];
      for (int i = 0; i < v.length; i++) {
        v[i] = new double[] {random.nextGaussian(), random.nextGaussian()};
        scene.circle(x(i, rows), y(i, rows), 1, v[i][0], v[i][1]).restitution(0);
      }
      World world = new World(scene.build());
      world.step(0);
      check(world, rows, v);
    }
  }

  private static double x(int i, int rows) {
    int row = i / rows;
    return 2 * (i % rows) + row;
  }

  private static double y(int i, int rows) {
    int row = i / rows;
    return row * Math.sqrt(3);
  }

  private static void check(World world, int rows, double[][] v) {
    double energy = 0;
    double before = 0;
    double px = 0;
    double py = 0;
    for (int i = 0; i < v.length; i++) {
      energy += world.vx(i) * world.vx(i) + world.vy(i) * world.vy(i);
      before += v[i][0] * v[i][0] + v[i][1] * v[i][1];
      px += world.vx(i) - v[i][0];
      py += world.vy(i) - v[i][1];
      for (int j = 0; j < i; j++) {
        double nx = x(i, rows) - x(j, rows);
        double ny = y(i, rows) - y(j, rows);
        boolean touch = Math.hypot(nx, ny) < 2 + 1e-9;
        double opening = (world.vx(i) - world.vx(j)) * nx + (world.vy(i) - world.vy(j)) * ny;
        assertThat(touch && opening < -1e-13).as("circles %s and %s", i, j).isFalse();
      }
    }
    assertThat(energy).isLessThan(before);
    assertThat(px).isCloseTo(0, within(1e-13));
    assertThat(py).isCloseTo(0, within(1e-13));
  }
}
