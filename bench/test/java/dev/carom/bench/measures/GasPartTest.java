// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.results.Row;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class GasPartTest {

  private static Map<String, Double> measure(Contender contender, Scene scene, int frames) {
    List<Row> rows = GasPart.measure(new Trial("gas", contender), scene, frames);
    return rows.stream().collect(Collectors.toMap(Row::metric, Row::value));
  }

  @Test
  void eventsKeepEnergyAndDistance() {
    Map<String, Double> carom = measure(Methods.CAROM, Subjects.scene(Subjects.GAS), 100);
    Map<String, Double> overlap = measure(Methods.OVERLAP, Subjects.scene(Subjects.GAS), 100);

    assertThat(carom.get(GasPart.ENERGY)).isLessThan(1e-12);
    assertThat(carom.get(GasPart.OVERLAP)).isLessThan(1e-12);
    assertThat(carom.get(GasPart.LOST)).isZero();
    assertThat(overlap.get(GasPart.OVERLAP)).isGreaterThan(1e-3);
  }

  /** 3 of 10 units over are 0.6 radii; one circle is still on its way from outside. */
  @Test
  void overlapEnergyAndLostCirclesAreThoseOfTheWorstFrame() {
    SceneBuilder setup =
        Scene.builder().collide(false).bounds(0, 0, 100, 100).circle(20, 50, 5, 0, 1);
    Scene scene = setup.circle(27, 50, 5, 0, 1).circle(120, 50, 1, -1, 0).build();

    Map<String, Double> found = measure(Methods.TEXTBOOK_DOUBLE, scene, 5);

    assertThat(found.get(GasPart.OVERLAP)).isEqualTo(0.6);
    assertThat(found.get(GasPart.ENERGY)).isZero();
    assertThat(found.get(GasPart.LOST)).isEqualTo(1);
  }
}
