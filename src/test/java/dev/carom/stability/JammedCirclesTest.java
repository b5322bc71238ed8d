// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Circles that are jammed together go on as one: none is pushed through another, or a wall. */
class JammedCirclesTest {

  /**
   * A jam bears an approach of 2^-48 of the speeds, so a way of 100 units brings 4e-13 at most; and
   * coordinates of 100 have ulps of 1.4e-14. Measured in rows: 4e-14.
   */
  private static final double BORNE = 1e-12;

  /** The gap of the two circles that are nearest to each other. */
  private static double leastGap(World world, double... radii) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < radii.length; i++) {
      for (int j = 0; j < i; j++) {
        double distance = Math.hypot(world.x(i) - world.x(j), world.y(i) - world.y(j));
        least = Math.min(least, distance - radii[i] - radii[j]);
      }
    }
    return least;
  }

  private static void assertApart(World world, double end, int steps, double... radii) {
    int calls = 0;
    for (int k = 1; k <= steps; k++) {
      while (!world.advanceTo(end * k / steps, Run.WORK)) {
        assertThat(++calls).as("calls that did not finish").isLessThan(100);
      }
      assertThat(leastGap(world, radii)).as("gap at %s", world.now()).isGreaterThan(-BORNE);
    }
  }

  /** The first one runs into the row, and the last; with e = 0 they press it from both sides. */
  @ParameterizedTest
  @ValueSource(ints = {3, 5, 8, 20})
  void aRowWithoutBounceIsNotPressedIntoItself(int count) {
    SceneBuilder builder = Scene.builder();
    double[] radii = new double[count];
    for (int i = 0; i < count; i++) {
      builder.circle(3 * i, 0, 1, i == 0 ? 1 : i == count - 1 ? -1 : 0, 0).restitution(0);
      radii[i] = 1;
    }
    assertApart(new World(builder.build()), 100, 200, radii);
  }

  /** Slow or fast, they jam at the same places, and as often: rounding is told by the speeds. */
  @ParameterizedTest
  @ValueSource(ints = {-600, -60, 60, 600})
  void inAnyUnitOfTimeTheSameHappens(int exponent) {
    World world = row(0);
    World other = row(exponent);
    other.advanceTo(Math.scalb(10.0, -exponent));
    world.advanceTo(10);
    assertThat(other.impacts().size()).isEqualTo(world.impacts().size()).isGreaterThan(5);
    for (int i = 0; i < 5; i++) {
      assertThat(other.x(i)).isEqualTo(world.x(i));
      assertThat(other.vx(i)).isEqualTo(Math.scalb(world.vx(i), exponent));
    }
  }

  private static World row(int exponent) {
    double speed = Math.scalb(1.0, exponent);
    SceneBuilder builder = Scene.builder();
    for (int i = 0; i < 5; i++) {
      builder.circle(3 * i, 0, 1, i == 0 ? speed : i == 4 ? -speed : 0, 0).restitution(0);
    }
    return new World(builder.build());
  }

  /** Walls that add a tenth to each bounce drive circles into each other, ever faster. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 2.5, 10})
  void bumpersDriveNoCircleThroughAnother(double end) {
    SceneBuilder builder =
        Scene.builder()
            .bounds(0, 0, 100, 80)
            .restitution(1.1)
            .circle(93.50504846265642, 27.84381529396026, 5.000000000000003, 2000, 0)
            .circle(45, 30.294114675945274, 5, 3, -2.799987593119373)
            .restitution(0.5)
            .circle(60, 55, 3.0156474963818867, 2.345558100010409e-9, -1e-9)
            .restitution(0)
            .circle(84.99999999999996, 55, 3.2234935528701176, -3, -2);
    double[] radii = {5.000000000000003, 5, 3.0156474963818867, 3.2234935528701176};
    assertApart(new World(builder.build()), end, 100, radii);
  }

  /**
   * A heavy circle presses a light one against a wall. No number of impacts stops the heavy one, as
   * the light one gives back the less the lighter it is: the jam has to.
   *
   * <pre>
   *   ( heavy )->(light)|
   * </pre>
   */
  @ParameterizedTest
  @CsvSource({"1e-3, 0, 20", "1e-3, 0, 20.5", "1e-3, 0.5, 20", "1e-9, 0, 20", "0x1p-500, 0.5, 20"})
  void aLightCircleIsNotPressedThroughAWall(double mass, double e, double y) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 40, 40);
    scene.circle(37, 20, 2, 0, 0).mass(mass).circle(20, y, 3, 1, 0).restitution(e);
    World world = new World(scene.build());
    assertApart(world, 100, 200, 2, 3);
    assertThat(world.x(0)).isBetween(2.0, 38 + BORNE);
    assertThat(world.x(1)).isBetween(3.0, 37 + BORNE);
  }

  /**
   * It overlaps the wall, so that all happens in one moment: with restitution above 1 it becomes so
   * fast that the heavy one's approach is rounding beside that, and that it crosses cells in no
   * time.
   */
  @ParameterizedTest
  @ValueSource(doubles = {20, 20.5, 22})
  void aLightCircleThatGathersSpeedInOneMomentIsNotPassedThrough(double y) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 40, 40).restitution(0.9);
    scene.circle(39, 20, 2, 0, 0).mass(0x1p-500).circle(20, y, 3, 1, 0).restitution(1.5);
    World world = new World(scene.build());
    assertApart(world, 100, 200, 2, 3);
    assertThat(world.x(0)).isBetween(2.0, 39 + BORNE);
    assertThat(world.x(1)).isBetween(3.0, 37 + BORNE);
  }
}
