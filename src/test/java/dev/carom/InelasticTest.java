// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Circles that lose energy at each collision gather in clusters and chains, which make infinitely
 * many collisions in finite time (S. McNamara, W. R. Young, Inelastic collapse in two dimensions,
 * Physical Review E 50, 1994; S. Luding, S. McNamara, Granular Matter 1, 1998): time goes on.
 */
class InelasticTest {

  /** Impacts that a circle of the gas may make, on average; measured, 584. */
  private static final int IMPACTS = 1_000;

  /** Budgets that a frame may take: measured, each takes one. */
  private static final int CALLS = 1;

  /** The counts at the end of a run. */
  private record End(int impacts, int jammed) {}

  private static End play(World world, int frames) {
    int impacts = 0;
    int jammed = 0;
    for (int frame = 1; frame <= frames; frame++) {
      boolean complete;
      int calls = 0;
      do {
        complete = world.advanceTo(frame, Run.WORK);
        assertThat(++calls).as("calls for a frame").isLessThanOrEqualTo(CALLS);
        for (Impact row : Run.rows(world.impacts())) {
          impacts++;
          jammed += row.outcome() == Outcome.JAMMED ? 1 : 0;
        }
      } while (!complete);
    }
    return new End(impacts, jammed);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.3})
  void aGasThatCoolsGoesOn(double restitution) {
    Random random = new Random(1);
    SceneBuilder builder = Scene.builder().bounds(0, 0, 24, 24);
    for (int i = 0; i < 100; i++) {
      double x = 1.01 + 2.4 * (i % 10) + 0.38 * random.nextDouble();
      int row = i / 10;
      double y = 1.01 + 2.4 * row + 0.38 * random.nextDouble();
      builder
          .circle(x, y, 1, random.nextGaussian(), random.nextGaussian())
          .restitution(restitution);
    }
    World world = new World(builder.build());
    double energy = Energy.of(world);
    End end = play(world, 100);
    assertThat(end.impacts()).isBetween(200, 100 * IMPACTS);
    assertThat(Energy.of(world)).isLessThan(energy);
    for (int i = 0; i < 100; i++) {
      assertThat(world.x(i)).isBetween(1 - 1e-9, 23 + 1e-9);
      assertThat(world.y(i)).isBetween(1 - 1e-9, 23 + 1e-9);
    }
  }

  /** A heavy circle gathers a row of light ones; in one piece they reach the far wall. */
  @Tag("long")
  @ParameterizedTest
  @CsvSource({"0, 8", "0.5, 8", "0, 20"})
  void aRowPushedByAHeavyOneJamsAndGoesOn(double restitution, int count) {
    SceneBuilder builder = Scene.builder().bounds(0, -10, 20 + 3 * count, 10);
    for (int i = 0; i < count; i++) {
      builder.circle(10 + 2.5 * i, 0, 1, 0, 0).restitution(restitution);
    }
    builder.circle(2, 0, 1, 1, 0).mass(100).restitution(restitution);
    World world = new World(builder.build());
    End end = play(world, 100);
    assertThat(end.jammed()).isPositive();
    // Each circle that joins is hit 17 times at most until all act at once, a row of the log each.
    assertThat(end.impacts()).isLessThan(3 * 17 * count * count);
    assertThat(Energy.of(world)).isLessThan(50);
    for (int i = 0; i <= count; i++) {
      assertThat(world.x(i)).isBetween(1 - 1e-9, 19 + 3 * count + 1e-9);
    }
    for (int i = 1; i < count; i++) {
      assertThat(world.x(i) - world.x(i - 1)).as("pressed into itself").isGreaterThan(2 - 1e-12);
    }
  }

  /** Pairs keep momentum, jammed or not: nothing else is there to take it. */
  @Tag("long")
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5})
  void aClusterKeepsMomentum(double restitution) {
    Random random = new Random(2);
    SceneBuilder builder = Scene.builder();
    double px = 0;
    double py = 0;
    for (int i = 0; i < 25; i++) {
      double x = 3 * (i % 5 - 2);
      int row = i / 5 - 2;
      double y = 3 * row;
      double vx = 3 - x / 4 + random.nextGaussian() / 8;
      double vy = -y / 4 + random.nextGaussian() / 8;
      builder.circle(x, y, 1, vx, vy).restitution(restitution);
      px += vx;
      py += vy;
    }
    World world = new World(builder.build());
    End end = play(world, 30);
    assertThat(end.impacts()).isGreaterThan(50);
    double qx = 0;
    double qy = 0;
    for (int i = 0; i < 25; i++) {
      qx += world.vx(i);
      qy += world.vy(i);
    }
    assertThat(qx).isCloseTo(px, within(1e-12 * 75));
    assertThat(qy).isCloseTo(py, within(1e-12 * 75));
  }
}
