// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/**
 * What an {@link Uncertainty} says of small scenes whose errors are known. The harness holds its
 * bound to true courses of large ones.
 */
class UncertaintyTest {

  private static final double U = 0x1p-53;

  private static SceneBuilder billiard() {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, 100, 100).peg(50, 50, 22);
    return builder.circle(15, 20, 2, 1.3, 2.1).circle(80, 15, 2, -0.7, 2.9);
  }

  /** Steps of 1 until a time. */
  private static void advance(World world, double end) {
    while (world.now() < end) {
      world.step(1);
    }
  }

  @Test
  void refusesWorldsWhoseCirclesCollide() {
    World world = new World(Scene.builder().circle(0, 0, 1, 1, 0).build());
    Uncertainty uncertainty = world.uncertainty(1);
    world.step(1);
    assertThat(uncertainty.bound(0)).isFinite();
    world.addCircle(9, 0, 1, 0, 0, Traits.DEFAULT);
    world.step(1);
    assertThat(uncertainty.bound(0)).isInfinite();
    assertThatThrownBy(() -> world.uncertainty(1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "collide of a world of several circles is true: expected false: circles that ignore each"
                + " other");
  }

  @Test
  void refusesLengthsThatAreNotPositive() {
    World world = new World(billiard().build());
    for (double length : new double[] {0, -1, Double.NaN}) {
      assertThatThrownBy(() -> world.uncertainty(length))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("length is " + length + ": expected more than 0");
    }
  }

  @Test
  void aCircleThatHitNothingIsWrongByTheRoundingOfItsPlace() {
    World world = new World(Scene.builder().circle(15, 20, 2, 1.3, 2.1).build());
    Uncertainty uncertainty = world.uncertainty(1);
    advance(world, 10);
    double rounding = U * (world.x(0) + world.y(0));
    assertThat(uncertainty.bound(0)).isBetween(rounding / 2, 4 * rounding);
    assertThat(uncertainty.lostAt()).isInfinite();
    assertThat(uncertainty.lyapunovExponent(0)).isZero();
  }

  /**
   * A circle flies to and fro between a wall and a peg. With the gap g and the distance R of the
   * centres at contact, the map of a period has the trace {@code 2 + 4 g / R}, and so the larger
   * eigenvalue {@code exp(arcosh(1 + 2 g / R))}.
   */
  @Test
  void theExponentOfAPeriodicPathIsThatOfItsMap() {
    double gap = 8;
    double reach = 12;
    Scene scene =
        Scene.builder().bounds(0, 0, 40, 40).peg(22, 20, 10).circle(5, 20, 2, 4, 0).build();
    World world = new World(scene);
    Uncertainty uncertainty = world.uncertainty(1);
    advance(world, 4000);
    double cosh = 1 + 2 * gap / reach;
    double exponent = Math.log(cosh + Math.sqrt(cosh * cosh - 1)) / (2 * gap / 4);
    assertThat(uncertainty.lyapunovExponent(0)).isCloseTo(exponent, offset(1e-3));
  }

  @Test
  void thePlaceIsLostWhenTheBoundPassesTheLength() {
    World world = new World(billiard().build());
    Uncertainty uncertainty = world.uncertainty(1e-6);
    double last = 0;
    while (uncertainty.lostAt(0) == Double.POSITIVE_INFINITY && world.now() < 10_000) {
      last = uncertainty.bound(0);
      world.step(1);
    }
    assertThat(last).isBetween(1e-12, 1e-6);
    assertThat(uncertainty.bound(0)).isGreaterThan(1e-6);
    assertThat(uncertainty.lostAt(0)).isBetween(world.now() - 1, world.now());
    double lostAt = uncertainty.lostAt(0);
    advance(world, world.now() + 1000);
    assertThat(uncertainty.lostAt(0)).isEqualTo(lostAt);
    assertThat(uncertainty.lostAt()).isLessThanOrEqualTo(lostAt).isPositive();
    assertThat(uncertainty.bound(0)).isInfinite();
    assertThat(uncertainty.lyapunovExponent(0)).isPositive();
  }

  @Test
  void anEditIsUnknownUntilRestart() {
    World world = new World(billiard().build());
    Uncertainty uncertainty = world.uncertainty(1);
    advance(world, 5);
    world.setVelocity(0, 1, 2);
    assertThat(uncertainty.bound(0)).isInfinite();
    assertThat(uncertainty.bound(1)).isFinite();
    uncertainty.restart(0);
    assertThat(uncertainty.bound(0)).isLessThan(1e-13);
    world.setPosition(0, 20, 20);
    advance(world, 60);
    assertThat(uncertainty.bound(0)).isInfinite();
    assertThat(uncertainty.lyapunovExponent(0)).isNaN();
  }

  @Test
  void anAddedCircleIsUnknownUntilRestart() {
    World world = new World(billiard().build());
    Uncertainty uncertainty = world.uncertainty(1);
    int id = world.addCircle(20, 80, 2, 2, 1, Traits.DEFAULT);
    advance(world, 50);
    assertThat(uncertainty.bound(id)).isInfinite();
    assertThat(uncertainty.lostAt(id)).isZero();
    uncertainty.restart(id);
    assertThat(uncertainty.bound(id)).isLessThan(1e-12);
  }

  @Test
  void aRemovedCircleIsNoMore() {
    World world = new World(billiard().build());
    Uncertainty uncertainty = world.uncertainty(1);
    world.advanceTo(60);
    world.remove(Kind.CIRCLE, 0);
    assertThatThrownBy(() -> uncertainty.bound(0)).isInstanceOf(IndexOutOfBoundsException.class);
    assertThat(uncertainty.bound(1)).isFinite();
  }

  /** One long call or many, bounded or from impact to impact: nobody has to tell of them. */
  @Test
  void theImpactsOfEachCallAreTakenIn() {
    List<Consumer<World>> ways =
        List.of(
            world -> world.advanceTo(60),
            world -> Run.finish(world, 60, 1),
            world -> {
              while (world.advanceToImpact(60)) {
                assertThat(world.impacts().size()).isPositive();
              }
            });
    World often = new World(billiard().build());
    Uncertainty byStep = often.uncertainty(1);
    advance(often, 60);
    for (Consumer<World> way : ways) {
      World world = new World(billiard().build());
      Uncertainty uncertainty = world.uncertainty(1);
      way.accept(world);
      for (int i = 0; i < 2; i++) {
        assertThat(uncertainty.bound(i)).isCloseTo(byStep.bound(i), withinPercentage(1));
        assertThat(uncertainty.bound(i)).isPositive();
      }
    }
  }

  /** A world keeps the last one: the one before knows nothing of an impact that comes later. */
  @Test
  void theOneBeforeGivesUpAtTheNextImpact() {
    World world = new World(billiard().build());
    Uncertainty first = world.uncertainty(1);
    world.step(60);
    assertThat(first.bound(0)).isFinite();
    Uncertainty second = world.uncertainty(1);
    assertThat(first.bound(0)).isFinite();
    assertThat(second.bound(0)).isLessThan(first.bound(0));
    world.step(60);
    assertThat(first.bound(0)).isInfinite();
    assertThat(second.bound(0)).isFinite();
  }

  @Test
  void aRestoredWorldIsUnknown() {
    World world = new World(billiard().build());
    Uncertainty uncertainty = world.uncertainty(1);
    Snapshot start = world.snapshot();
    advance(world, 60);
    world.restore(start);
    assertThat(uncertainty.bound(0)).isInfinite();
  }

  @Test
  void movingObstaclesMakeAllUnknown() {
    World world = new World(billiard().build());
    Uncertainty uncertainty = world.uncertainty(1);
    world.setVelocity(Kind.PEG, 0, 0.1, 0);
    assertThat(uncertainty.bound(0)).isInfinite();
    advance(world, 1);
    assertThat(uncertainty.bound(1)).isInfinite();
  }

  @Test
  void anObstacleThatIsToldToStayIsOneAtRest() {
    World world = new World(billiard().build());
    Uncertainty uncertainty = world.uncertainty(1);
    world.setVelocity(Kind.PEG, 0, 0, 0);
    uncertainty.restart(0);
    assertThat(uncertainty.bound(0)).isFinite();
    advance(world, 1);
    assertThat(uncertainty.bound(0)).isFinite();
  }

  @Test
  void aJammedCircleIsUnknown() {
    Scene scene = Scene.builder().bounds(0, 0, 100, 4).circle(50, 2, 2, 1, 0.5).build();
    World world = new World(scene);
    Uncertainty uncertainty = world.uncertainty(1);
    boolean jammed = false;
    for (int i = 0; i < 100 && !jammed; i++) {
      world.step(10);
      ImpactLog log = world.impacts();
      for (int row = 0; row < log.size(); row++) {
        jammed |= log.outcome(row) == Outcome.JAMMED;
      }
    }
    assertThat(jammed).isTrue();
    assertThat(uncertainty.bound(0)).isInfinite();
  }

  @Test
  void aCircleThatRestsIsUnknown() {
    Scene scene =
        Scene.builder().line(-9, 0, 9, 0).response(Response.HALT).circle(0, 5, 2, 0, -1).build();
    World world = new World(scene);
    Uncertainty uncertainty = world.uncertainty(1);
    advance(world, 20);
    assertThat(uncertainty.bound(0)).isInfinite();
    assertThat(uncertainty.lostAt(0)).isEqualTo(3);
  }

  @Test
  void sensorsChangeNothing() {
    World world = new World(billiard().build());
    World sensed = new World(billiard().line(0, 0, 100, 100).response(Response.SENSOR).build());
    Uncertainty uncertainty = world.uncertainty(1);
    Uncertainty ofSensed = sensed.uncertainty(1);
    advance(world, 60);
    advance(sensed, 60);
    assertThat(ofSensed.bound(0)).isEqualTo(uncertainty.bound(0));
  }

  /**
   * A ball bounces on the top of a peg, from a height h above it. A path beside it flies straight
   * across, and each bounce turns it by {@code 2 v / R}: as between a wall and a peg, the map of a
   * period has the trace {@code 2 + 2 v T / R}. Here v T is 4 h.
   */
  @Test
  void theExponentOfABounceOnAPegIsThatOfItsMap() {
    double height = 8;
    double reach = 12;
    SceneBuilder setup = Scene.builder().peg(50, 0, 10);
    Scene scene = setup.circle(50, reach + height, 2, 0, 0).gravity(0, -0.25).build();
    World world = new World(scene);
    Uncertainty uncertainty = world.uncertainty(1);
    advance(world, 4000);
    double cosh = 1 + 4 * height / reach;
    double period = 2 * Math.sqrt(2 * height / 0.25);
    double exponent = Math.log(cosh + Math.sqrt(cosh * cosh - 1)) / period;
    assertThat(uncertainty.lyapunovExponent(0)).isCloseTo(exponent, offset(1e-3));
    assertThat(uncertainty.bound(0)).isInfinite();
  }

  /** Two worlds whose circles start 2^-30 beside each other part as the exponent tells. */
  @Test
  void theExponentTellsHowTwoPathsPartUnderGravity() {
    double step = 0x1p-30;
    World world = new World(plinko(0));
    World other = new World(plinko(step));
    Uncertainty uncertainty = world.uncertainty(1);
    int compared = 0;
    for (int frame = 1; frame <= 200; frame++) {
      world.advanceTo(frame);
      other.advanceTo(frame);
      double off = Math.hypot(other.x(0) - world.x(0), other.y(0) - world.y(0));
      if (off < 1e-4) {
        double predicted = step * Math.exp(uncertainty.lyapunovExponent(0) * frame);
        assertThat(predicted / off).isBetween(0.99, 1.01);
        compared++;
      }
    }
    assertThat(compared).isBetween(50, 199);
  }

  private static Scene plinko(double off) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 100, 200).gravity(0, -0.125);
    builder.line(0, 40, 60, 10);
    builder.line(100, 30, 70, 10);
    for (int i = 0; i < 12; i++) {
      builder.peg(20 + 30 * (i % 3) + 5 * (i / 3 % 2), 60 + 25 * (i / 3), 4);
    }
    return builder.circle(47 + off, 180, 3, 0, -0.5).build();
  }

  @Test
  void aCircleThatSettlesIsUnknown() {
    SceneBuilder setup = Scene.builder().bounds(0, 0, 100, 90).restitution(0.5);
    Scene scene = setup.circle(50, 12, 2, 1, 0).gravity(0, -1).build();
    World world = new World(scene);
    Uncertainty uncertainty = world.uncertainty(1);
    advance(world, 5);
    assertThat(uncertainty.bound(0)).isFinite();
    advance(world, 20);
    assertThat(uncertainty.bound(0)).isInfinite();
    uncertainty.restart(0);
    assertThat(uncertainty.bound(0)).as("it rolls on the floor").isInfinite();
    assertThat(uncertainty.lostAt(0)).isEqualTo(20);
    world.setPosition(0, 50, 50);
    uncertainty.restart(0);
    advance(world, 22);
    assertThat(uncertainty.bound(0)).isBetween(U, 1e-11);
  }

  /** A ball that comes in contact with a peg moves by ticks from then on. */
  @Test
  void contactIsUnknown() {
    SceneBuilder setup = Scene.builder().peg(50, 0, 10).restitution(0.5);
    World world = new World(setup.circle(50.5, 20, 2, 0, 0).gravity(0, -0.25).build());
    Uncertainty uncertainty = world.uncertainty(1);
    boolean settled = false;
    int bounces = 0;
    while (!settled && world.now() < 40) {
      assertThat(uncertainty.bound(0)).isFinite();
      world.step(0x1p-10);
      if (world.impacts().size() > 0) {
        settled = world.impacts().outcome(0) == Outcome.SETTLED;
        bounces++;
      }
    }
    assertThat(settled).isTrue();
    assertThat(bounces).isGreaterThan(1);
    for (int k = 0; k < 100; k++) {
      assertThat(uncertainty.bound(0)).as("at %s", world.now()).isInfinite();
      world.step(0.25);
    }
  }

  @Test
  void anotherGravityIsUnknownUntilRestart() {
    World world = new World(plinko(0));
    Uncertainty uncertainty = world.uncertainty(1);
    advance(world, 5);
    world.setGravity(0, -0.25);
    assertThat(uncertainty.bound(0)).isInfinite();
    uncertainty.restart(0);
    advance(world, 10);
    assertThat(uncertainty.bound(0)).isBetween(U, 1e-10);
    world.setGravity(0, 0);
    world.step(5);
    assertThat(uncertainty.bound(0)).isInfinite();
    uncertainty.restart(0);
    advance(world, 16);
    assertThat(uncertainty.bound(0)).as("straight").isBetween(U, 1e-10);
  }

  @Test
  void aCircleThatNothingMovesIsKnownBesideOnesThatFall() {
    SceneBuilder setup = Scene.builder().collide(false).bounds(0, 0, 100, 90).gravity(0, -1);
    setup.circle(50, 60, 2, 1, 0).mass(Double.POSITIVE_INFINITY).circle(20, 60, 2, 1, 0);
    Scene scene = setup.build();
    World world = new World(scene);
    Uncertainty uncertainty = world.uncertainty(1);
    advance(world, 60);
    assertThat(world.y(0)).isEqualTo(60);
    assertThat(uncertainty.bound(0)).isBetween(U, 1000 * U);
    assertThat(uncertainty.bound(1)).isBetween(U, 1e-9);
  }

  /** Two pegs touched at once: which of them is first depends on roundings. */
  @Test
  void twoPegsAtOnceMakeUnknown() {
    SceneBuilder setup = Scene.builder().bounds(-100, -100, 100, 100).peg(-9.3, 30.1, 10);
    Scene scene = setup.peg(9.3, 30.1, 10).circle(0, -80, 2, 0, 1.7).build();
    World world = new World(scene);
    Uncertainty uncertainty = world.uncertainty(1);
    advance(world, 100);
    assertThat(uncertainty.bound(0)).isInfinite();
  }
}
