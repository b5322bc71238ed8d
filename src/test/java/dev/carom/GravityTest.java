// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Circles under gravity: laws of falling, bouncing, sliding and coming to rest. */
class GravityTest {

  private static SceneBuilder box() {
    return Scene.builder().bounds(0, 0, 100, 100).gravity(0, -10);
  }

  private static double energy(World world, int id) {
    double vx = world.vx(id);
    double vy = world.vy(id);
    Vec2 g = world.gravity();
    return 0.5 * (vx * vx + vy * vy) - g.x() * world.x(id) - g.y() * world.y(id);
  }

  private static int rows(World world, double until) {
    int rows = 0;
    boolean done;
    do {
      done = world.advanceTo(until);
      rows += world.impacts().size();
    } while (!done);
    return rows;
  }

  @Test
  void aCircleInTheOpenFliesAParabola() {
    World world = new World(Scene.builder().gravity(1, -2).circle(3, 4, 1, 5, 6).build());
    assertThat(world.step(2.5)).isTrue();
    assertThat(world.x(0)).isEqualTo(3 + 5 * 2.5 + 0.5 * 2.5 * 2.5);
    assertThat(world.y(0)).isEqualTo(4 + 6 * 2.5 - 2.5 * 2.5);
    assertThat(world.vx(0)).isEqualTo(7.5);
    assertThat(world.vy(0)).isEqualTo(1);
  }

  @Test
  void infiniteMassesDoNotFall() {
    World world = new World(box().circle(50, 50, 1, 1, 0).mass(Double.POSITIVE_INFINITY).build());
    assertThat(world.step(2)).isTrue();
    assertThat(world.x(0)).isEqualTo(52);
    assertThat(world.y(0)).isEqualTo(50);
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

  @ParameterizedTest
  @CsvSource({"0.5, 30", "0.9, 200", "0, 2"})
  void aBallComesToRestWhenTheorySays(double e, int most) {
    World world = new World(box().circle(50, 11, 1, 0, 0).restitution(e).build());
    double first = Math.sqrt(2 * 10 / 10.0);
    double rest = first * (1 + e) / (1 - e);
    int rows = rows(world, rest * (1 - 1e-6));
    assertThat(e == 0 ? 1 : Math.abs(world.vy(0))).isGreaterThan(0);
    rows += rows(world, rest * (1 + 1e-6));
    assertThat(world.vy(0)).isZero();
    assertThat(world.y(0)).isCloseTo(1, within(1e-14));
    assertThat(rows).isLessThanOrEqualTo(most);
    assertThat(rows(world, 1e6)).isZero();
    assertThat(world.isResting(0)).isTrue();
    world.setVelocity(0, 0, 3);
    assertThat(world.isResting(0)).isFalse();
  }

  @Test
  void theApexesOfABallFallByTheSquareOfItsRestitution() {
    World world = new World(box().circle(50, 17, 1, 0, 0).restitution(0.8).build());
    double height = 16;
    for (int i = 0; i < 10; i++) {
      assertThat(world.advanceToImpact(1e9)).isEqualTo(StopReason.IMPACT);
      height *= 0.64;
      assertThat(world.vy(0) * world.vy(0) / 20).isCloseTo(height, within(1e-12 * 16));
    }
  }

  @Test
  void aBallSlidesDownASlope() {
    double r = 2;
    // It touches the slope from its left, above.
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 0, 40, 30)
                .circle(32 - 0.6 * r, 24 + 0.8 * r, r, 0, 0)
                .restitution(0)
                .build());
    assertThat(rows(world, 1)).isEqualTo(1);
    assertThat(world.impacts().outcome(0)).isEqualTo(Outcome.SETTLED);
    // The acceleration along it is g sin a = 6: 3 units of length in a second.
    assertThat(world.x(0)).isCloseTo(32 - 0.6 * r - 3 * 0.8, within(1e-13));
    assertThat(world.y(0)).isCloseTo(24 + 0.8 * r - 3 * 0.6, within(1e-13));
    assertThat(Math.hypot(world.vx(0), world.vy(0))).isCloseTo(6, within(1e-13));
  }

  @Test
  void aBallRollsOffATableAndFalls() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 0, 10, 0)
                .circle(5, 1, 1, 4, 0)
                .restitution(0)
                .build());
    assertThat(world.advanceTo(1)).isTrue(); // it leaves the edge at 1.25
    assertThat(world.y(0)).isEqualTo(1);
    // v^2 / r = 16 is more than g = 10: it flies off.
    assertThat(world.advanceTo(2)).isTrue();
    assertThat(world.x(0)).isCloseTo(13, within(1e-13));
    assertThat(world.y(0)).isCloseTo(1 - 5 * 0.75 * 0.75, within(1e-13));
  }

  @Test
  void aBallCrossesTheJointOfTwoLines() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 0, 10, 0)
                .line(10, 0, 20, 0)
                .circle(5, 1, 1, 4, 0)
                .restitution(0.5)
                .build());
    int rows = rows(world, 3);
    assertThat(world.x(0)).isEqualTo(17);
    assertThat(world.y(0)).isCloseTo(1, within(1e-15));
    assertThat(rows).isLessThanOrEqualTo(6);
  }

  @ParameterizedTest
  @CsvSource({"0", "0.5", "0.9"})
  void aBallComesToRestInAWedge(double e) {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(-50, 50, 0, 0)
                .line(0, 0, 60, 40)
                .circle(-10, 30, 1, 3, 0)
                .restitution(e)
                .build());
    int rows = rows(world, 200);
    assertThat(world.vx(0)).isZero();
    assertThat(world.vy(0)).isZero();
    assertThat(rows(world, 1000)).isZero();
    assertThat(rows).isLessThan(2000);
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
  void aSensorReportsABallEachTimeItComes() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 10, 20, 10)
                .response(Response.SENSOR)
                .circle(10, 5, 1, 0, 20)
                .build());
    int rows = rows(world, 100);
    assertThat(rows).isEqualTo(2);
    assertThat(world.impacts().time(0)).isLessThan(0.3);
    // It is up at 2 s, at 25, and comes back to 11 at 2 + sqrt(2.8).
    assertThat(world.impacts().time(1)).isCloseTo(2 + Math.sqrt(2.8), within(1e-12));
  }

  @Test
  void gravityCanBeTurned() {
    World world = new World(box().circle(50, 1, 1, 0, 0).restitution(0).build());
    rows(world, 5);
    assertThat(world.y(0)).isEqualTo(1);
    world.setGravity(0, 10);
    assertThat(world.gravity()).isEqualTo(new Vec2(0, 10));
    rows(world, 6);
    assertThat(world.y(0)).isEqualTo(6);
    world.setGravity(0, 0);
    rows(world, 7);
    assertThat(world.y(0)).isEqualTo(16);
    assertThat(world.vy(0)).isEqualTo(10);
  }

  @Test
  void aSupportThatGoesLetsTheBallFall() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 0, 20, 0)
                .circle(10, 1, 1, 0, 0)
                .restitution(0)
                .build());
    rows(world, 5);
    assertThat(world.y(0)).isEqualTo(1);
    world.remove(ObstacleKind.LINE, 0);
    rows(world, 6);
    assertThat(world.y(0)).isEqualTo(-4);
  }

  @Test
  void aOneWayLineMayNeverBeHit() {
    World world =
        new World(Scene.builder().gravity(0, -10).line(0, 0, 9, 0).circle(5, -3, 1, 0, 0).build());
    world.setOneWay(0, true);
    assertThat(rows(world, 5)).isZero();
  }

  /** The new flight begins in mid-air: the floor that was hit last is not touched there. */
  @Test
  void anObstacleThatAppearsInTheWayOfAHopLeavesTheReturnAsItIs() {
    World world = new World(box().circle(50, 6, 1, 0, 0).build());
    rows(world, 1.25); // it touches the floor at 1
    world.addPeg(50, 8, 1);
    rows(world, 2.75); // it touches the peg at 2, at its apex: a graze
    assertThat(world.y(0)).isLessThan(6);
    assertThat(world.y(0)).isEqualTo(6 - 5 * 0.75 * 0.75);
  }

  @Test
  void aBallThatShrinksInAHopReturnsLater() {
    World world = new World(box().circle(50, 7, 2, 0, 0).build());
    rows(world, 2); // at its apex
    world.setRadius(0, 1);
    rows(world, 3.0625);
    assertThat(world.y(0)).isEqualTo(7 - 5 * 1.0625 * 1.0625);
  }

  /** The ball above bounced from one at rest, which then loses its support. */
  @Test
  void twoBallsOfWhichOneRestedMeetAgainWhenBothFall() {
    Scene scene =
        Scene.builder()
            .gravity(0, -10)
            .collide(true)
            .line(0, 0, 20, 0)
            .restitution(0)
            .circle(10, 1, 1, 0, 0)
            .circle(10, 8, 1, 0, 0)
            .build();
    World world = new World(scene);
    rows(world, 2.5); // it has hit the other one at 1, and is on its way down
    world.remove(ObstacleKind.LINE, 0);
    assertThat(rows(world, 10)).isEqualTo(1);
  }

  @Test
  void collidingBallsBeginToFall() {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 100, 100).collide(true);
    for (int i = 0; i < 9; i++) {
      builder.circle(10 + 9 * i, 40 + 5 * i, 3, i - 4, 0);
    }
    World world = new World(builder.build());
    World other = new World(builder.gravity(0, -10).build());
    world.setGravity(0, -10);
    assertThat(rows(world, 20)).isEqualTo(rows(other, 20));
    assertThat(world.snapshot()).isEqualTo(other.snapshot());
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
    builder.circle(50, 90, 1, 3, 0);
    World world = new World(builder.build());
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
    for (int i = 0; i < world.circleCount(); i++) {
      sum += energy(world, i);
    }
    return sum;
  }

  @Test
  void stepsDoNotMatter() {
    for (int seed = 0; seed < 40; seed++) {
      Scene scene = random(seed);
      World once = new World(scene);
      rows(once, 20);
      World often = new World(scene);
      for (int i = 1; i <= 200; i++) {
        rows(often, i * 0.1);
      }
      often.advanceTo(20);
      for (int i = 0; i < once.circleCount(); i++) {
        assertThat(often.x(i)).as("seed %d circle %d", seed, i).isEqualTo(once.x(i));
        assertThat(often.y(i)).as("seed %d circle %d", seed, i).isEqualTo(once.y(i));
      }
      assertThat(often.snapshot()).as("seed %d", seed).isEqualTo(once.snapshot());
    }
  }

  @Test
  void aRestoredWorldGoesOnAlike() throws Exception {
    for (int seed = 0; seed < 20; seed++) {
      Scene scene = random(seed);
      World world = new World(scene);
      Timeline timeline = world.record(100_000);
      rows(world, 7.3);
      Snapshot saved = world.snapshot();
      java.io.ByteArrayOutputStream out = new java.io.ByteArrayOutputStream();
      saved.write(out);
      Snapshot read = Snapshot.read(new java.io.ByteArrayInputStream(out.toByteArray()));
      assertThat(read).isEqualTo(saved);
      rows(world, 15);
      assertThat(timeline.snapshot(7.3)).as("seed %d", seed).isEqualTo(saved);
      World other = new World(scene);
      other.restore(read);
      rows(other, 15);
      assertThat(other.snapshot()).as("seed %d", seed).isEqualTo(world.snapshot());
    }
  }

  /** Half an angle of 45 degrees: the motions along the two sides do not know of each other. */
  @Test
  void theWedgeBilliardKeepsTheEnergiesAlongItsSides() {
    Scene scene =
        Scene.builder()
            .gravity(0, -10)
            .line(-1000, 1000, 0, 0)
            .line(0, 0, 1000, 1000)
            .circle(3, 40, 1, 2, 1)
            .build();
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
        if (log.kind(row) == ObstacleKind.WALL) {
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
    for (int i = 0; i < world.circleCount(); i++) {
      sum += world.vy(i);
    }
    return sum;
  }

  /** No bit changes where all lengths are doubled, and times stay. */
  @Test
  void powersOfTwoScaleARun() {
    for (int seed = 0; seed < 20; seed++) {
      World world = new World(random(seed));
      World scaled = new World(transformed(random(seed), 4, 4, 0, 0));
      rows(world, 8);
      rows(scaled, 8);
      for (int i = 0; i < world.circleCount(); i++) {
        assertThat(scaled.x(i)).as("seed %d circle %d", seed, i).isEqualTo(4 * world.x(i));
        assertThat(scaled.y(i)).isEqualTo(4 * world.y(i));
        assertThat(scaled.vx(i)).isEqualTo(4 * world.vx(i));
      }
    }
  }

  @Test
  void mirrorsMirrorARun() {
    for (int seed = 0; seed < 20; seed++) {
      World world = new World(random(seed));
      World mirrored = new World(transformed(random(seed), -1, 1, 0, 0));
      World turned = new World(transformed(random(seed), -1, -1, 0, 0));
      assertThat(rows(mirrored, 8)).as("seed %d", seed).isEqualTo(rows(world, 8));
      rows(turned, 8);
      for (int i = 0; i < world.circleCount(); i++) {
        assertThat(mirrored.x(i)).as("seed %d circle %d", seed, i).isEqualTo(-world.x(i));
        assertThat(mirrored.y(i)).isEqualTo(world.y(i));
        assertThat(turned.y(i)).isEqualTo(-world.y(i));
      }
    }
  }

  /** Elastic, they would become faster and faster, without end. */
  @Test
  void twoBallsThatALiftSqueezesAreJammed() {
    World world =
        new World(
            box()
                .collide(true)
                .line(-10, 60, 110, 61)
                .velocity(0, 5)
                .circle(50, 80, 3, 1, 0)
                .circle(51, 90, 4, 0, 0)
                .build());
    assertThat(world.advanceTo(12)).isTrue();
  }

  /** Between a line that moves slowly and a wall: the gap between them closes without end. */
  @Test
  void twoBallsInAWedgeThatClosesAreJammed() {
    World world =
        new World(
            Scene.builder()
                .collide(true)
                .bounds(0, 0, 200, 150)
                .gravity(0, -0.103)
                .line(37.7, 37.2, 93.9, 93.4)
                .velocity(-0.4465043250932107, 0.27527439287918987)
                .circle(20, 135, 5.600229664270529, -0.1067, 0)
                .restitution(0.82)
                .circle(70, 135, 6.364845897878658, -0.1419, 0)
                .restitution(0.83)
                .build());
    for (int i = 1; i <= 250; i++) {
      assertThat(world.advanceTo(i)).as("at %d", i).isTrue();
    }
  }

  /** The scene with x and y multiplied, then moved; gravity and velocities multiplied too. */
  private static Scene transformed(Scene scene, double mx, double my, double dx, double dy) {
    double size = Math.abs(mx);
    SceneBuilder builder = Scene.builder().collide(scene.collide());
    Bounds b = scene.bounds().orElseThrow();
    builder.bounds(
        Math.min(mx * b.xmin(), mx * b.xmax()) + dx,
        Math.min(my * b.ymin(), my * b.ymax()) + dy,
        Math.max(mx * b.xmin(), mx * b.xmax()) + dx,
        Math.max(my * b.ymin(), my * b.ymax()) + dy);
    builder.gravity(mx * scene.gravity().x(), my * scene.gravity().y());
    for (int i = 0; i < scene.lineCount(); i++) {
      Line l = scene.line(i);
      builder.line(mx * l.ax() + dx, my * l.ay() + dy, mx * l.bx() + dx, my * l.by() + dy);
      builder.restitution(scene.restitution(ObstacleKind.LINE, i));
    }
    for (int i = 0; i < scene.pegCount(); i++) {
      Circle c = scene.peg(i);
      builder.peg(mx * c.x() + dx, my * c.y() + dy, size * c.radius());
      builder.restitution(scene.restitution(ObstacleKind.PEG, i));
    }
    for (int i = 0; i < scene.circleCount(); i++) {
      Circle c = scene.circle(i);
      Vec2 v = scene.velocity(i);
      builder.circle(mx * c.x() + dx, my * c.y() + dy, size * c.radius(), mx * v.x(), my * v.y());
      builder.restitution(scene.restitution(ObstacleKind.CIRCLE, i));
    }
    return builder.build();
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

  @Test
  void theEndOfASlideIsNoImpact() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 0, 10, 0)
                .line(5, -20, 40, -20)
                .circle(5, 1, 1, 4, 0)
                .restitution(0)
                .build());
    assertThat(world.advanceToImpact(10)).isEqualTo(StopReason.IMPACT);
    assertThat(world.now()).isZero();
    assertThat(world.advanceToImpact(10)).isEqualTo(StopReason.IMPACT);
    assertThat(world.now()).isCloseTo(1.25 + 2, within(1e-12));
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.advanceToImpact(4)).isEqualTo(StopReason.TIME);
  }

  /** A box with lines, pegs and circles, elastic or not, that collide or not. */
  static Scene random(int seed) {
    Random random = new Random(seed);
    SceneBuilder builder = box().collide(seed % 2 == 0);
    for (int i = 0; i < 12; i++) {
      double x = 5 + 90 * random.nextDouble();
      double y = 5 + 50 * random.nextDouble();
      builder.line(x, y, x + 20 * random.nextDouble(), y + 8 * random.nextGaussian());
      builder.restitution(random.nextInt(3) / 2.0);
      builder.peg(5 + 90 * random.nextDouble(), 5 + 50 * random.nextDouble(), 3);
    }
    for (int i = 0; i < 12; i++) {
      builder.circle(8 + 7 * i, 80 + 3 * (i % 3), 1 + 0.1 * i, 3 * random.nextGaussian(), 0);
      builder.restitution(seed % 4 < 2 ? 1 : random.nextDouble());
    }
    return builder.build();
  }
}
