// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A gas of hard disks against its equation of state, Z = P / (rho k T) = (1 + eta^2 / 8) / (1 -
 * eta)^2 (D. Henderson, Molecular Physics 30, 1975), once by the pressure on the walls and once by
 * the rate of collisions, Z - 1 = sqrt(pi) / 4 sigma omega sqrt(m / kT). Density and collisions are
 * counted in the inner quarter of the box, away from the walls, where disks stand closer.
 */
@Tag("long")
class GasTest {

  private static final int SIDE = 30;
  private static final int COUNT = SIDE * SIDE;
  private static final int BLOCKS = 20;
  private static final int FRAMES = 300;

  /** The mean of blocks, and its standard error as it shows in their scatter. */
  private static final class Mean {
    private double sum;
    private double squares;
    private int count;

    void add(double value) {
      sum += value;
      squares += value * value;
      count++;
    }

    double mean() {
      return sum / count;
    }

    double error() {
      double variance = squares / count - mean() * mean();
      return Math.sqrt(variance / (count - 1));
    }
  }

  /** On a square lattice that fills the box, radius 1, with random velocities. */
  private static Scene gas(double length) {
    Random random = new Random(1);
    SceneBuilder builder = Scene.builder().bounds(0, 0, length, length);
    for (int i = 0; i < COUNT; i++) {
      double x = (i % SIDE + 0.5) * length / SIDE;
      int row = i / SIDE;
      double y = (row + 0.5) * length / SIDE;
      builder.circle(x, y, 1, random.nextGaussian(), random.nextGaussian());
    }
    return builder.build();
  }

  private static double leastDistance(World world) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      for (int j = 0; j < i; j++) {
        least = Math.min(least, Math.hypot(world.x(i) - world.x(j), world.y(i) - world.y(j)));
      }
    }
    return least;
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.2, 0.3})
  void hasThePressureAndTheRateOfCollisionsOfHardDisks(double packing) {
    double length = Math.sqrt(COUNT * Math.PI / packing);
    World world = new World(gas(length));
    double energy = Energy.of(world);
    double temperature = energy / COUNT;
    world.advanceTo(20);

    Mean byPressure = new Mean();
    Mean byRate = new Mean();
    Mean density = new Mean();
    double dt = 0.25;
    for (int block = 0; block < BLOCKS; block++) {
      double push = 0;
      double hits = 0;
      double inside = 0;
      for (int frame = 0; frame < FRAMES; frame++) {
        world.step(dt);
        ImpactLog log = world.impacts();
        for (int row = 0; row < log.size(); row++) {
          if (log.kind(row) == Kind.WALL) {
            push += 2 * log.approachSpeed(row);
          } else if (isInside(log.x(row), log.y(row), length)) {
            hits += 2;
          }
        }
        for (int i = 0; i < COUNT; i++) {
          inside += isInside(world.x(i), world.y(i), length) ? 1 : 0;
        }
      }
      double time = FRAMES * dt;
      double rho = inside / FRAMES / (length * length / 4);
      double omega = hits / (inside / FRAMES * time);
      density.add(rho * Math.PI);
      byPressure.add(push / (time * 4 * length) / (rho * temperature));
      byRate.add(1 + Math.sqrt(Math.PI) / 4 * 2 * omega / Math.sqrt(temperature));
    }

    double eta = density.mean();
    double henderson = (1 + eta * eta / 8) / ((1 - eta) * (1 - eta));
    // Henderson's formula is good to 0.2 %; the rest is chance.
    assertThat(byPressure.error()).isLessThan(0.02 * henderson);
    assertThat(byRate.error()).isLessThan(0.01 * henderson);
    assertThat(byPressure.mean())
        .isCloseTo(henderson, within(4 * byPressure.error() + 0.002 * henderson));
    assertThat(byRate.mean()).isCloseTo(henderson, within(4 * byRate.error() + 0.002 * henderson));
    assertThat(Energy.of(world)).isCloseTo(energy, within(1e-12 * energy));
    assertThat(leastDistance(world)).isGreaterThan(2 - 1e-12 * length);
  }

  private static boolean isInside(double x, double y, double length) {
    return Math.abs(x - length / 2) < length / 4 && Math.abs(y - length / 2) < length / 4;
  }
}
