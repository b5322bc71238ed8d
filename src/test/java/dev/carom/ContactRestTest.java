// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.EverydayScenes.Shape;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Heaps at rest stand still to the bit and cost nothing, also where something carries them. */
class ContactRestTest {

  /** So many frames would be more than a call's budget if each took a tick. */
  private static final double LONG = 1e8;

  private static World atRest(EverydayScenes scenes) {
    ContactRun run = new ContactRun(new World(scenes.scene()));
    while (run.world.now() < 6_000 && run.resting() < run.world.count(Kind.CIRCLE)) {
      run.play(run.world.now() + 1);
    }
    assertThat(run.faults()).isEmpty();
    assertThat(run.resting()).as("%s: rest", scenes).isEqualTo(run.world.count(Kind.CIRCLE));
    return run.world;
  }

  /** Nothing moves by a bit in 1e8 frames, there are no rows, and next to nothing is allocated. */
  @ParameterizedTest
  @CsvSource({"BOX, 30, 0.5", "BOX, 30, 0", "V, 30, 0.5", "BINS, 10, 0", "SHAFT, 10, 0.5"})
  void aHeapAtRestStandsStillAndCostsNothing(Shape shape, int balls, double e)
      throws ReflectiveOperationException {
    World world = atRest(EverydayScenes.of(shape, balls).restitution(e));
    double[] state = new ContactRun(world).state();
    Meter meter = new Meter();
    long bytes = meter.bytes();
    world.advanceTo(world.now() + LONG);
    assertThat(meter.bytes() - bytes).isLessThan(100_000);
    assertThat(world.impacts().size()).isZero();
    assertThat(new ContactRun(world).state()).isEqualTo(state);
    for (int i = 0; i < balls; i++) {
      assertThat(Math.hypot(world.vx(i), world.vy(i))).as("speed of %s", i).isZero();
    }
  }

  /** A ball that lands on one heap does not wake the other one. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5})
  void aLandingBallWakesOnlyTheHeapItLandsOn(double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -0.05).bounds(0, 0, 500, 900);
    Random random = new Random(2);
    scene.line(249, 0, 249, 400).line(251, 0, 251, 400);
    for (int i = 0; i < 80; i++) {
      double left = i % 2 == 0 ? 15 : 266;
      double x = left + 23 * (i / 2 % 10) + random.nextDouble();
      scene.circle(x, 40 + 23 * (i / 20) + random.nextDouble(), 10, 0, 0).restitution(e);
    }
    ContactRun run = new ContactRun(new World(scene.build()));
    while (run.world.now() < 1_000 && run.resting() < 80) {
      run.play(run.world.now() + 1);
    }
    assertThat(run.resting()).isEqualTo(80);
    World world = run.world;
    double[] before = run.state();
    int id = world.addCircle(120, 600, 10, 0, -3, Traits.DEFAULT);
    world.setTraits(Kind.CIRCLE, id, world.traits(Kind.CIRCLE, id).withRestitution(e));
    int moved = 0;
    for (int k = 0; k < 600; k++) {
      world.step(1);
      for (int i = 0; i < 80; i++) {
        boolean isLeft = world.x(i) < 250;
        moved += isLeft && !world.isResting(i) ? 1 : 0;
        assertThat(isLeft || world.isResting(i)).as("ball %s rests", i).isTrue();
      }
    }
    assertThat(moved).as("in the heap that was hit").isPositive();
    for (int i = 0; i < 80; i++) {
      if (world.x(i) > 250) {
        assertThat(world.x(i)).isEqualTo(before[4 * i]);
        assertThat(world.y(i)).isEqualTo(before[4 * i + 1]);
      }
    }
  }

  /** A lift and a box carry a heap: at constant velocity it stays where it is in them. */
  @ParameterizedTest
  @CsvSource({"0, 1, 0", "0, -1, 0.5", "1, 0, 0.5", "0.7, 0.3, 0", "0, 0.01, 0"})
  void aHeapThatIsCarriedCostsNothing(double vx, double vy, double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -0.05);
    scene.line(0, 0, 127, 0).line(0, 0, 0, 200).line(127, 0, 127, 200);
    Random random = new Random(4);
    for (int i = 0; i < 20; i++) {
      double x = 14 + 22.5 * (i % 5) + random.nextDouble();
      scene.circle(x, 30 + 24 * (i / 5), 10, 0, 0).restitution(e);
    }
    ContactRun run = new ContactRun(new World(scene.build())).withMovers().play(600);
    for (int line = 0; line < 3; line++) {
      run.world.setVelocity(Kind.LINE, line, vx, vy);
    }
    while (run.world.now() < 4_000 && run.resting() < 20) {
      run.play(run.world.now() + 1);
    }
    assertThat(run.faults()).isEmpty();
    assertThat(run.jammed).isEmpty();
    assertThat(run.resting()).isEqualTo(20);
    World world = run.world;
    double[] before = run.state();
    double start = world.now();
    double span = 1e5;
    world.advanceTo(start + span);
    assertThat(world.impacts().size()).isZero();
    for (int i = 0; i < 20; i++) {
      assertThat(world.x(i)).isCloseTo(before[4 * i] + span * vx, within(1e-6));
      assertThat(world.y(i)).isCloseTo(before[4 * i + 1] + span * vy, within(1e-6));
      assertThat(world.vx(i)).isEqualTo(vx);
      assertThat(world.vy(i)).isEqualTo(vy);
    }
    assertThat(run.play(world.now() + 10).faults()).isEmpty();
  }

  /** Level ground and gravity push nothing sideways: a heap falls apart, its momentum stays. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void aHeapOnOpenGroundKeepsItsMomentumAlongIt(double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -0.05);
    scene.line(-50_000, 0, 50_000, 0);
    Random random = new Random(6);
    double right = 0;
    for (int i = 0; i < 30; i++) {
      double vx = random.nextDouble() - 0.3;
      double mass = 1 + random.nextInt(3);
      right += mass * vx;
      double x = 22 * (i % 6) + random.nextDouble();
      scene.circle(x, 30 + 23 * (i / 6), 10, vx, 0).mass(mass).restitution(e);
    }
    ContactRun run = new ContactRun(new World(scene.build()));
    for (int t = 100; t <= 1_000; t += 100) {
      run.play(t);
      double momentum = 0;
      for (int i = 0; i < 30; i++) {
        momentum += run.world.traits(Kind.CIRCLE, i).mass() * run.world.vx(i);
      }
      assertThat(momentum).as("at %s", t).isCloseTo(right, within(1e-11));
    }
    assertThat(run.faults()).isEmpty();
  }

  /** A member that loses its support falls, one that keeps it stays. */
  @Test
  void whatLosesItsSupportFalls() {
    World world = atRest(EverydayScenes.of(Shape.BOX, 30).restitution(0.3));
    int lowest = 0;
    for (int i = 0; i < 30; i++) {
      lowest = world.y(i) < world.y(lowest) ? i : lowest;
    }
    double before = new ContactRun(world).energy();
    world.remove(Kind.CIRCLE, lowest);
    int woken = 0;
    for (int k = 0; k < 600; k++) {
      world.step(1);
      for (int i : world.ids(Kind.CIRCLE)) {
        woken += world.isResting(i) ? 0 : 1;
      }
    }
    assertThat(woken).as("frames and circles").isBetween(30, 12_000);
    double after = 0;
    for (int i : world.ids(Kind.CIRCLE)) {
      after += 0.05 * world.y(i);
    }
    assertThat(after).as("they came down").isLessThan(before - 0.05 * 20);
  }
}
