// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Elastic impacts keep kinetic energy: rounding moves it at random, and nothing else does. */
@Tag("long")
class EnergyTest {

  private static double energy(World world, int i) {
    return world.vx(i) * world.vx(i) + world.vy(i) * world.vy(i);
  }

  private static double[] energies(World world) {
    double[] energies = new double[world.count(Kind.CIRCLE)];
    for (int i = 0; i < energies.length; i++) {
      energies[i] = energy(world, i);
    }
    return energies;
  }

  /** Each circle's energy relative to before, less 1. */
  private static double[] changes(World world, double[] before) {
    double[] changes = new double[before.length];
    for (int i = 0; i < before.length; i++) {
      changes[i] = (energy(world, i) - before[i]) / before[i];
    }
    return changes;
  }

  private static double worst(double[] changes) {
    double worst = 0;
    for (double change : changes) {
      worst = Math.max(worst, Math.abs(change));
    }
    return worst;
  }

  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "base-2.csv", "base-3.csv", "fast-1.csv", "radii.csv"})
  void everyCircleKeepsItsEnergyOver600Frames(String file) {
    World world = new World(TestScenes.read(file));
    double[] before = energies(world);
    world.advanceTo(600);
    double worst = worst(changes(world, before));
    System.out.printf("%s: worst circle's energy after 600 frames off by %.2g%n", file, worst);
    assertThat(worst).isLessThan(1e-13);
  }

  /**
   * 100 circles with 1e4 impacts each. A trend of 1e-17 an impact would move the mean by 1e-13;
   * chance alone, some 1e-16 an impact, moves it by 1e-15.
   */
  @Test
  void noTrendOverAMillionImpacts() {
    World world = new World(TestScenes.read("base-1.csv"));
    double[] before = energies(world);
    long impacts = 0;
    for (double time = 1000; impacts < 1_000_000; time += 1000) {
      world.advanceTo(time);
      impacts += world.impacts().size();
    }
    double[] changes = changes(world, before);
    double mean = 0;
    double square = 0;
    for (double change : changes) {
      mean += change / changes.length;
      square += change * change / changes.length;
    }
    double sigma = Math.sqrt(square / changes.length);
    System.out.printf(
        "energy after %d impacts: mean change %.2g +- %.2g, worst circle %.2g%n",
        impacts, mean, sigma, worst(changes));
    assertThat(mean).isCloseTo(0, within(4 * sigma));
    assertThat(Math.sqrt(square)).as("a random walk of 1e-16 an impact").isLessThan(1e-13);
  }

  /**
   * In a tilted box a circle meets the same four sides with the same four velocities again and
   * again: an error that a side makes each time, be it 3e-17, adds up. Once the square of its
   * normal was such an error: 2e-12 after 8e4 impacts a circle.
   */
  @Test
  void noTrendInATiltedBox() {
    World world = new World(tiltedBox(0.5));
    double[] before = energies(world);
    long impacts = 0;
    for (double time = 10_000; impacts < 1_000_000; time += 10_000) {
      world.advanceTo(time);
      impacts += world.impacts().size();
    }
    double worst = worst(changes(world, before));
    System.out.printf("tilted box after %d impacts: worst circle %.2g%n", impacts, worst);
    assertThat(worst).isLessThan(1e-13);
  }

  private static Scene tiltedBox(double angle) {
    double c = 300 * Math.cos(angle);
    double s = 300 * Math.sin(angle);
    SceneBuilder builder =
        Scene.builder()
            .collide(false)
            .line(c, s, -s, c)
            .line(-s, c, -c, -s)
            .line(-c, -s, s, -c)
            .line(s, -c, c, s);
    Random random = new Random(1);
    for (int i = 0; i < 20; i++) {
      builder.circle(
          random.nextDouble() * 50,
          random.nextDouble() * 50,
          10,
          random.nextGaussian() * 10,
          random.nextGaussian() * 10);
    }
    return builder.build();
  }
}
