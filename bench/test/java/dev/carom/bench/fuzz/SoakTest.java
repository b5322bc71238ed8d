// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.Scene;
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
    SoakTimes times = Soak.run(Crosses.canonical(1).scene(), 5_000, rounds::add);
    assertThat(times.impacts()).isBetween(5_000L, 6_000L);
    assertThat(rounds).hasSize(Soak.ROUNDS);
    assertThat(times.nanosAtStart()).isBetween(times.leastNanos(), times.mostNanos());
    assertThat(times.heapAtEnd()).isPositive();
  }

  @Test
  void aGasHolds() throws Exception {
    SoakTimes times = Soak.run(new Gas(50, 0.2, 1, false, 1).scene(), 5_000, round -> {});
    assertThat(times.impacts()).isGreaterThanOrEqualTo(5_000);
  }

  @ParameterizedTest
  @EnumSource(EndScene.Layout.class)
  void scenesOfTheEndRuleHold(EndScene.Layout kind) throws FindingException {
    assertThat(Soak.run(kind, 1, 2_000, round -> {}).impacts()).isGreaterThanOrEqualTo(2_000);
  }

  @Test
  void aSceneWithoutImpactsIsRefused() {
    Scene scene = Scene.builder().circle(0, 0, 1, 1, 0).build();
    assertThatThrownBy(() -> Soak.run(scene, 100, round -> {}))
        .hasMessageContaining("no impact in a step");
  }
}
