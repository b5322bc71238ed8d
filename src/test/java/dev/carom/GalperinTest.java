// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A light circle at rest between a wall and a circle 100^n times as heavy that comes towards it:
 * the impacts count out the digits of pi. Source: G. Galperin, Playing pool with pi, Regular and
 * Chaotic Dynamics 8 (2003).
 */
class GalperinTest {

  @ParameterizedTest
  @CsvSource({"0, 3", "1, 31", "2, 314", "3, 3141", "4, 31415", "5, 314159"})
  void countsTheDigitsOfPi(int n, int impacts) {
    SceneBuilder setup = Scene.builder().line(0, -10, 0, 10).circle(5, 0, 1, 0, 0);
    Scene scene = setup.circle(10, 0, 1, -1, 0).mass(Math.pow(100, n)).collide(true).build();
    World world = new World(scene);
    world.advanceTo(10_000);
    assertThat(world.impacts().size()).isEqualTo(impacts);
    assertThat(world.vx(1)).as("none is left").isGreaterThanOrEqualTo(world.vx(0)).isPositive();
  }
}
