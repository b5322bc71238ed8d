// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The impulses in the log are all that changes the momentum of circles. */
class ImpulseTest {

  private static final int COUNT = 144;
  private static final double LENGTH = 60;

  /** Disks of unlike masses in a square, with lines and moving obstacles among them, or without. */
  private static SceneBuilder gas(double restitution) {
    Random random = new Random(3);
    SceneBuilder scene = Scene.builder().bounds(0, 0, LENGTH, LENGTH);
    for (int i = 0; i < COUNT; i++) {
      double x = 5 * (i % 12) + 2;
      double y = 5 * (i / 12) + 2;
      scene.circle(x, y, 1 + random.nextDouble() / 4, random.nextGaussian(), random.nextGaussian());
      scene.mass(Math.exp(3 * random.nextGaussian())).restitution(restitution);
    }
    return scene;
  }

  private static SceneBuilder withObstacles(SceneBuilder scene) {
    for (int i = 0; i < 5; i++) {
      scene.line(10 * i + 4.5, 4.5, 10 * i + 4.5, 9.5).restitution(0.9);
      scene.peg(10 * i + 4.5, 34.5, 0.25).velocity(0.01 * i, 0.02);
    }
    return scene.line(14.5, 14.5, 34.5, 14.5).velocity(0.05, -0.02);
  }

  private static double[] momenta(World world) {
    double[] p = new double[2 * COUNT];
    for (int i = 0; i < COUNT; i++) {
      p[2 * i] = world.traits(Kind.CIRCLE, i).mass() * world.vx(i);
      p[2 * i + 1] = world.traits(Kind.CIRCLE, i).mass() * world.vy(i);
    }
    return p;
  }

  /** Adds to momenta what the rows of a log say. */
  private static void add(ImpactLog log, double[] p) {
    for (Impact hit : log) {
      push(p, hit.circle(), hit.impulse(), hit);
      if (hit.kind() == Kind.CIRCLE) {
        push(p, hit.id(), -hit.impulse(), hit);
      }
    }
  }

  private static void push(double[] p, int circle, double impulse, Impact hit) {
    p[2 * circle] += impulse * hit.nx();
    p[2 * circle + 1] += impulse * hit.ny();
  }

  private static double largest(double[] numbers) {
    double largest = 0;
    for (double number : numbers) {
      largest = Math.max(largest, Math.abs(number));
    }
    return largest;
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 0.9})
  void theyAddUpToTheChangeOfEachMomentum(double restitution) {
    World world = new World(withObstacles(gas(restitution)).build());
    double[] p = momenta(world);
    double[] sum = p.clone();
    int rows = 0;
    for (int frame = 0; frame < 20; frame++) {
      world.step(0.5);
      add(world.impacts(), sum);
      rows += world.impacts().size();
    }
    double[] after = momenta(world);
    for (int k = 0; k < p.length; k++) {
      assertThat(sum[k]).as("component %s", k).isCloseTo(after[k], within(1e-13 * largest(p)));
    }
    assertThat(rows).isGreaterThan(500);
  }

  /**
   * Clausius: the virial {@code sum of m x.v} grows by twice the kinetic energy a second, and by
   * {@code J n.x} with each impulse. All of it stands in the log.
   */
  @Test
  void virialAndPressureOfAGasBalance() {
    World world = new World(gas(1).build());
    double energy = Energy.of(world);
    double before = virial(world);
    double atWalls = 0;
    double ofPairs = 0;
    double duration = 20;
    for (int frame = 0; frame < 40; frame++) {
      world.step(duration / 40);
      for (Impact hit : world.impacts()) {
        double r = world.radius(hit.circle());
        if (hit.kind() == Kind.CIRCLE) {
          ofPairs += hit.impulse() * (r + world.radius(hit.id()));
        } else {
          double x = hit.x() + r * hit.nx();
          double y = hit.y() + r * hit.ny();
          atWalls += hit.impulse() * (hit.nx() * x + hit.ny() * y);
        }
      }
    }
    double scale = 2 * energy * duration;
    double gained = virial(world) - before;
    assertThat((scale + atWalls + ofPairs - gained) / scale).isCloseTo(0, within(1e-13));
    assertThat(ofPairs / scale).isGreaterThan(0.01);
  }

  private static double virial(World world) {
    double virial = 0;
    for (int i = 0; i < COUNT; i++) {
      virial +=
          world.traits(Kind.CIRCLE, i).mass()
              * (world.x(i) * world.vx(i) + world.y(i) * world.vy(i));
    }
    return virial;
  }

  /** A ball that bounces, one that slides, and their weight. */
  @Test
  void underGravityTheWeightIsTheRest() {
    World world =
        new World(
            Scene.builder()
                .collide(false)
                .gravity(0, -10)
                .line(-100, 0, 0, 0)
                .line(0, 0, 100, -75)
                .circle(-50, 4, 1, 0, 0)
                .mass(3)
                .circle(30, 10, 1, 0, 0)
                .mass(2)
                .restitution(0)
                .build());
    double up = 0;
    double onSlope = 0;
    world.step(3);
    for (Impact hit : world.impacts()) {
      if (hit.circle() == 0) {
        up += hit.impulse() * hit.ny();
      } else {
        onSlope += hit.impulse();
      }
    }
    assertThat(up - 3 * 10 * 3).isCloseTo(3 * world.vy(0), within(1e-12));
    double fall = 10 - (1 / 0.8 - 30 * 0.75); // to the slope 3 : 4
    assertThat(onSlope).isCloseTo(2 * Math.sqrt(20 * fall) * 0.8, within(1e-12));
  }

  @Test
  void aSensorAndTwoInfiniteMassesHaveNone() {
    World world =
        new World(
            Scene.builder()
                .circle(0, 0, 1, 1, 0)
                .mass(Double.POSITIVE_INFINITY)
                .circle(5, 0, 1, 0, 0)
                .mass(Double.POSITIVE_INFINITY)
                .line(2.5, -1, 2.5, 1)
                .response(Response.SENSOR)
                .build());
    world.step(10);
    assertThat(world.impacts())
        .extracting(Impact::outcome)
        .containsExactly(Outcome.SENSED, Outcome.PASSED);
    assertThat(world.impacts()).extracting(Impact::impulse).containsExactly(0.0, 0.0);
  }

  @Test
  void anInfiniteMassGivesAndTakesWhatTheOtherOneHas() {
    World world =
        new World(
            Scene.builder()
                .bounds(-100, -100, 100, 100)
                .circle(0, 0, 1, 0, 0)
                .mass(4)
                .circle(5, 0, 1, -3, 0)
                .mass(Double.POSITIVE_INFINITY)
                .build());
    world.step(2);
    Impact hit = world.impacts().get(0);
    assertThat(hit.impulse()).isEqualTo(4 * 2 * 3);
    assertThat(hit.involves(Kind.CIRCLE, 0)).isTrue();
    assertThat(hit.involves(Kind.CIRCLE, 1)).isTrue();
    assertThat(hit.involves(Kind.LINE, 1)).isFalse();
    world.step(100);
    Impact atWall = world.impacts().get(world.impacts().size() - 1);
    assertThat(atWall.kind()).isEqualTo(Kind.WALL);
  }

  /** A stuck ball between two sides gets its last momentum in two parts. */
  @Test
  void aStuckCircleStopsByTheImpulsesOfAllItsContacts() {
    World world =
        new World(
            Scene.builder()
                .line(-1, 10, 0, 0)
                .line(0, 0, 1, 10)
                .circle(0.1, 5, 0.1, 0.3, -1)
                .mass(7)
                .restitution(0)
                .build());
    double[] p = {7 * 0.3, -7};
    world.step(100);
    for (Impact hit : world.impacts()) {
      push(p, 0, hit.impulse(), hit);
    }
    assertThat(world.impacts()).extracting(Impact::outcome).contains(Outcome.JAMMED);
    assertThat(p[0]).isCloseTo(7 * world.vx(0), within(1e-14));
    assertThat(p[1]).isCloseTo(7 * world.vy(0), within(1e-14));
  }

  @Test
  void whatHaltsStopsBoth() {
    World world =
        new World(
            Scene.builder()
                .circle(0, 0, 1, 1, 0)
                .mass(2)
                .response(Response.HALT)
                .circle(5, 0, 1, -3, 0)
                .mass(5)
                .build());
    world.step(5);
    Impact hit = world.impacts().get(0);
    assertThat(hit.outcome()).isEqualTo(Outcome.HALTED);
    assertThat(hit.impulse()).isEqualTo(2);
  }
}
