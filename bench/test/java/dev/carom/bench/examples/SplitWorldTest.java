// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.experiment.Crosses;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SplitWorldTest {

  /** A row of a log; equal if all its bits are. */
  private record Row(
      double time, int circle, Kind kind, int obstacle, Object feature, List<Double> rest) {

    static List<Row> of(ImpactLog log) {
      List<Row> rows = new ArrayList<>();
      for (int i = 0; i < log.size(); i++) {
        List<Double> rest = List.of(log.x(i), log.y(i), log.nx(i), log.ny(i), log.approachSpeed(i));
        rows.add(new Row(log.time(i), log.circle(i), log.kind(i), log.id(i), log.feature(i), rest));
      }
      return rows;
    }
  }

  /** The order of a log. */
  private static final Comparator<Row> ORDER =
      Comparator.comparingDouble(Row::time).thenComparingInt(Row::circle);

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 101})
  void hasTheImpactsOfOneWorldBitForBit(int threads) throws Exception {
    Scene scene = Crosses.canonical(7).scene();
    World one = new World(scene);
    int impacts = 0;
    try (SplitWorld split = new SplitWorld(scene, threads)) {
      for (int frame = 0; frame < 100; frame++) {
        one.step(1);
        split.advanceTo(frame + 1);
        List<Row> merged = new ArrayList<>();
        split.parts().forEach(part -> merged.addAll(Row.of(part.impacts())));
        merged.sort(ORDER);
        assertThat(merged).isEqualTo(Row.of(one.impacts()));
        impacts += merged.size();
      }
      assertThat(impacts).isGreaterThan(100);
      assertThat(positions(split)).isEqualTo(positions(one));
    }
  }

  private static List<Double> positions(World world) {
    List<Double> positions = new ArrayList<>();
    for (int id = 0; id < world.idLimit(Kind.CIRCLE); id++) {
      if (world.contains(Kind.CIRCLE, id)) {
        positions.addAll(List.of(world.x(id), world.y(id), world.vx(id), world.vy(id)));
      }
    }
    return positions;
  }

  /** Parts stand in the order of their circles, so no circle is in two of them or in none. */
  private static List<Double> positions(SplitWorld split) {
    List<Double> positions = new ArrayList<>();
    split.parts().forEach(part -> positions.addAll(positions(part)));
    return positions;
  }

  @Test
  void refusesWhatCannotBeSplit() {
    Scene colliding = Scene.builder().circle(0, 0, 1, 0, 0).circle(9, 0, 1, 0, 0).build();
    assertThatThrownBy(() -> new SplitWorld(colliding, 2))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("the circles of the scene collide");
    assertThatThrownBy(() -> new SplitWorld(Scene.builder().build(), 0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("threads is 0: expected at least 1");
  }
}
