// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.experiment.Gas;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SoakTest {

  @Test
  void theCanonicalSceneHolds() throws Exception {
    List<Integer> rounds = new ArrayList<>();
    SoakResult result = Soak.run(Crosses.canonical(1).scene(), 20_000, rounds::add);

    assertThat(result.holds()).isTrue();
    assertThat(result.times().impacts()).isBetween(20_000L, 22_000L);
    assertThat(rounds).hasSize(Soak.ROUNDS);
    SoakTimes times = result.times();
    assertThat(times.nanosAtStart()).isBetween(times.leastNanos(), times.mostNanos());
    assertThat(times.heapAtEnd()).isPositive();
  }

  @Test
  void aGasHolds() throws Exception {
    assertThat(Soak.run(new Gas(50, 0.2, 1, false, 1).scene(), 20_000, round -> {}).holds())
        .isTrue();
  }

  @ParameterizedTest
  @EnumSource(EndScene.Kind.class)
  void scenesOfTheEndRuleHold(EndScene.Kind kind) throws FindingException {
    assertThat(Soak.run(kind, 1, 2_000, round -> {}).impacts()).isGreaterThanOrEqualTo(2_000);
  }

  /** A bumper: what drifts is told. */
  @Test
  void energyThatIsNotKeptDoesNotHold() {
    Scene scene =
        Scene.builder().bounds(0, 0, 100, 100).restitution(0.99).circle(50, 50, 5, 3, 4).build();
    SoakResult result = Soak.run(scene, 100, round -> {});

    assertThat(result.holds()).isFalse();
    assertThat(result.drift()).isLessThan(-0.5);
    assertThat(result.escapes() + result.crossings() + result.overlaps()).isZero();
  }

  @Test
  void aSceneWithoutImpactsIsRefused() {
    Scene scene = Scene.builder().circle(0, 0, 1, 1, 0).build();
    assertThatThrownBy(() -> Soak.run(scene, 100, round -> {}))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("no impact in 100 frames");
  }

  /** A one-way line lets a circle through from behind: that counts, since nothing else does. */
  @Test
  void aFlightThroughALineIsSeen() {
    SceneBuilder setup = Scene.builder().bounds(0, 0, 100, 100).line(50, 0, 50, 100).oneWay();
    Scene scene = setup.circle(70, 50, 5, -10, 0).build();
    World world = new World(scene);
    Guard guard = new Guard(scene, world);
    world.advanceTo(7);
    guard.watch(world.impacts());

    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(guard.crossings()).isOne();
    assertThat(guard.outside()).isZero();
  }

  @Test
  void circlesOutsideAndInsideOfEachOtherAreSeen() {
    SceneBuilder setup = Scene.builder().bounds(0, 0, 100, 100).collide(true);
    setup.circle(120, 50, 5, 1, 0).circle(50, 50, 5, 0, 0).circle(53, 50, 5, 0, 0);
    Scene scene = setup.build();
    Guard guard = new Guard(scene, new World(scene));

    assertThat(guard.outside()).isOne();
    assertThat(guard.overlaps()).isOne();
  }
}
