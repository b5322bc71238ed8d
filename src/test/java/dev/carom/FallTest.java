// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Falling.box;
import static dev.carom.Falling.energy;
import static dev.carom.Falling.rows;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Flights, bounces and conserved quantities under gravity, without loss of energy. */
class FallTest {

  @Test
  void aCircleInTheOpenFliesAParabola() {
    World world = new World(Scene.builder().gravity(1, -2).circle(3, 4, 1, 5, 6).build());
    world.step(2.5);
    assertThat(world.x(0)).isEqualTo(3 + 5 * 2.5 + 0.5 * 2.5 * 2.5);
    assertThat(world.y(0)).isEqualTo(4 + 6 * 2.5 - 2.5 * 2.5);
    assertThat(world.vx(0)).isEqualTo(7.5);
    assertThat(world.vy(0)).isEqualTo(1);
  }

  /** A speed beyond the doubles is the largest one, and a world with it can be saved. */
  @Test
  void speedsStayWithinTheDoubles() throws Exception {
    World world = new World(Scene.builder().circle(0, 0, 1, 0, 0).gravity(0, -1e300).build());
    world.step(1e10);
    assertThat(world.vy(0)).isEqualTo(-Double.MAX_VALUE);
    assertThat(world.velocity(Kind.CIRCLE, 0)).isEqualTo(new Vec2(0, -Double.MAX_VALUE));
    world.setTraits(Kind.CIRCLE, 0, Traits.DEFAULT.withResponse(Response.HALT)); // a new flight
    assertThat(world.y(0)).isEqualTo(Double.NEGATIVE_INFINITY);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    world.snapshot().write(out);
    assertThat(Snapshot.read(new ByteArrayInputStream(out.toByteArray())))
        .isEqualTo(world.snapshot());
  }

  @Test
  void theApexOfAnElasticBallStaysForAMillionBounces() {
    World world =
        new World(
            Scene.builder().bounds(0, 0, 10, 100).gravity(0, -9.81).circle(5, 7, 1, 0, 0).build());
    double before = energy(world, 0);
    double period = 2 * Math.sqrt(2 * 6 / 9.81);
    int rows = 0;
    double worst = 0;
    while (rows < 1_000_000) {
      rows += rows(world, world.now() + 100 * period);
      worst = Math.max(worst, Math.abs(energy(world, 0) / before - 1));
    }
    assertThat(worst).isLessThan(1e-12);
  }

  @Test
  void aBallBouncesOnAOneWayPlatform() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 10, 20, 10)
                .oneWay() // its left is above
                .circle(10, 5, 1, 0, 13)
                .build());
    int rows = 0;
    for (int i = 0; i < 100; i++) {
      rows += rows(world, world.now() + 1);
    }
    assertThat(world.y(0)).isGreaterThan(10);
    assertThat(rows).isGreaterThan(50);
  }

  @Test
  void anElasticBallKeepsItsEnergyAmongPegsAndSlopes() {
    Random random = new Random(5);
    SceneBuilder builder = box();
    for (int i = 0; i < 12; i++) {
      builder.peg(10 + 80 * random.nextDouble(), 10 + 60 * random.nextDouble(), 2);
      double x = 10 + 80 * random.nextDouble();
      double y = 10 + 60 * random.nextDouble();
      builder.line(x, y, x + 8 * random.nextDouble(), y + 4 * random.nextDouble());
    }
    World world = new World(builder.circle(50, 90, 1, 3, 0).build());
    double before = energy(world, 0);
    int rows = 0;
    while (rows < 100_000) {
      rows += rows(world, world.now() + 100);
    }
    assertThat(Math.abs(energy(world, 0) - before) / (10 * 100)).isLessThan(5e-12);
  }

  @Test
  void collidingBallsKeepTheirEnergy() {
    SceneBuilder builder = box().collide(true);
    Random random = new Random(7);
    for (int i = 0; i < 36; i++) {
      builder.circle(10 + 15 * (i % 6), 10 + 15 * (i / 6), 2, random.nextGaussian() * 5, 0);
    }
    World world = new World(builder.build());
    double before = total(world);
    int rows = 0;
    while (rows < 100_000) {
      rows += rows(world, world.now() + 10);
    }
    assertThat(total(world) / before - 1).isCloseTo(0, within(1e-11));
  }

  private static double total(World world) {
    double sum = 0;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      sum += energy(world, i);
    }
    return sum;
  }

  /** Half an angle of 45 degrees: the motions along the two sides do not know of each other. */
  @Test
  void theWedgeBilliardKeepsTheEnergiesAlongItsSides() {
    SceneBuilder setup = Scene.builder().gravity(0, -10).line(-1000, 1000, 0, 0);
    Scene scene = setup.line(0, 0, 1000, 1000).circle(3, 40, 1, 2, 1).build();
    World world = new World(scene);
    double left = alongSide(world, -1);
    double right = alongSide(world, 1);
    int rows = 0;
    while (rows < 20_000) {
      rows += rows(world, world.now() + 50);
      assertThat(alongSide(world, -1)).isCloseTo(left, within(1e-11 * left));
      assertThat(alongSide(world, 1)).isCloseTo(right, within(1e-11 * right));
    }
  }

  /** The energy of the motion along (side, 1). */
  private static double alongSide(World world, int side) {
    double v = side * world.vx(0) + world.vy(0);
    return v * v / 4 + 5 * (side * world.x(0) + world.y(0));
  }

  /** The floor carries the gas: what it gives it, less what the ceiling does, is its weight. */
  @Test
  void theFloorCarriesAnElasticGas() {
    Random random = new Random(9);
    SceneBuilder builder = box().collide(true);
    int count = 49;
    for (int i = 0; i < count; i++) {
      builder.circle(
          10 + 13 * (i % 7),
          10 + 13 * (i / 7),
          1,
          20 * random.nextGaussian(),
          20 * random.nextGaussian());
    }
    World world = new World(builder.build());
    double before = momentum(world);
    double pushed = 0;
    double duration = 200;
    while (world.now() < duration) {
      world.advanceTo(Math.min(duration, world.now() + 1));
      ImpactLog log = world.impacts();
      for (int row = 0; row < log.size(); row++) {
        if (log.kind(row) == Kind.WALL) {
          pushed += 2 * log.approachSpeed(row) * log.ny(row);
        }
      }
    }
    double weight = 10.0 * count;
    assertThat(pushed - weight * duration).isCloseTo(momentum(world) - before, within(1e-7));
    assertThat(pushed / duration).isCloseTo(weight, within(0.05 * weight));
  }

  private static double momentum(World world) {
    double sum = 0;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      sum += world.vy(i);
    }
    return sum;
  }

  /** With all velocities reversed an elastic ball flies back. */
  @Test
  void anElasticBallFliesBack() {
    SceneBuilder builder = box().peg(40, 30, 5).line(10, 10, 60, 20).circle(50, 60, 1, 3, 0);
    World world = new World(builder.build());
    int rows = rows(world, 12);
    world.setVelocity(0, -world.vx(0), -world.vy(0));
    assertThat(rows(world, 24)).isEqualTo(rows).isGreaterThan(2);
    assertThat(world.x(0)).isCloseTo(50, within(1e-6));
    assertThat(world.y(0)).isCloseTo(60, within(1e-6));
    assertThat(world.vx(0)).isCloseTo(-3, within(1e-6));
  }

  /** The square of its length underflows. */
  @Test
  void aLineOfAlmostNoLengthIsHit() {
    SceneBuilder scene = Scene.builder().gravity(0, -1e-3);
    scene.line(30, -5, 30, 5).line(0, 0, 1.5e-162, 0);
    World world = new World(scene.circle(-5, 0.9, 1, 10, 0).build());
    rows(world, 0.5);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.impacts().id(0)).isEqualTo(1);
    assertThat(world.impacts().time(0)).isCloseTo(0.45639, within(1e-5));
  }

  /** It would turn at a time that is no double. */
  @Test
  void aGravityThatIsHardlyAnyLeavesTheCeilingWhereItIs() {
    SceneBuilder scene = Scene.builder().gravity(0, -1e-309).bounds(-100, -100, 100, 100);
    World world = new World(scene.circle(0, 0, 1, 0, 1).build());
    rows(world, 100);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.y(0)).isEqualTo(98);
  }
}
