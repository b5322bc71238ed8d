// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.SavedFlights;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SensorPairsTest {

  private final SensorPairs pairs = new SensorPairs();

  /** Circle 1 met circle 3 at 5 + 1e-20. */
  @ParameterizedTest
  @CsvSource({
    "5, 1e-20, 3, false",
    "5, 1e-20, 2, false",
    "5, 1e-20, 4, true",
    "5, 0, 9, false",
    "5, 2e-20, 0, true",
    "4, 9e-20, 9, false",
    "6, 0, 0, true"
  })
  void whatComesLaterIsNew(double head, double tail, int partner, boolean isNew) {
    assertThat(pairs.isNew(1, head, tail, partner)).isTrue();
    pairs.report(1, 5, 1e-20, 3);
    assertThat(pairs.isNew(1, head, tail, partner)).isEqualTo(isNew);
    pairs.forget(1);
    assertThat(pairs.isNew(1, head, tail, partner)).isTrue();
  }

  @Test
  void toAnyOtherCircleAllIsNew() {
    pairs.report(1, 5, 0, 3);
    for (int i = 0; i < 40; i++) {
      assertThat(pairs.isNew(i, 0, 0, 0)).isEqualTo(i != 1);
      if (i != 1) {
        pairs.forget(i);
      }
    }
    pairs.clear();
    assertThat(pairs.isNew(1, 5, 0, 3)).isTrue();
    pairs.forget(1);
  }

  @Test
  void whatIsSavedIsRestored() {
    SavedFlights states = new SavedFlights(IntStream.range(0, 40).toArray());
    pairs.report(1, 5, 1e-20, 3);
    SensorPairs others = new SensorPairs();
    CircleRegistry registry = registry(40);
    for (int i = 0; i < 40; i++) {
      pairs.save(i, registry, i, states);
      others.restore(i, registry, states);
      assertThat(others.isNew(i, 5, 1e-20, 3)).isEqualTo(i != 1);
      assertThat(others.isNew(i, 5, 1e-20, 4)).isTrue();
    }
  }

  @Test
  void soIsAMeetingAtTimeZero() {
    SavedFlights states = new SavedFlights(new int[] {0, 1});
    pairs.report(1, 0, 0, 3);
    CircleRegistry registry = registry(4);
    pairs.save(1, registry, 1, states);
    SensorPairs others = new SensorPairs();
    others.restore(1, registry, states);
    assertThat(others.isNew(1, 0, 0, 3)).isFalse();
    assertThat(others.isNew(1, 0, 0, 4)).isTrue();
  }

  /** Those of larger ids at the same time are still to be reported, also when it is gone. */
  @Test
  void aPartnerThatIsGoneKeepsItsPlaceInTheOrder() {
    CircleRegistry registry = registry(6);
    pairs.report(5, 2, 0, 3);
    registry.remove(2);
    registry.remove(3);
    SavedFlights states = new SavedFlights(registry.ids());
    pairs.save(5, registry, 3, states);
    assertThat(states.sensedPartner(3)).isEqualTo(1);
    registry.set(registry); // circles 0, 1, 4 and 5
    SensorPairs others = new SensorPairs();
    others.restore(3, registry, states);
    assertThat(others.isNew(3, 2, 0, 1)).isFalse();
    assertThat(others.isNew(3, 2, 0, 2)).isTrue();
  }

  @Test
  void aPartnerBeforeWhomNobodyIsLeftIsBeforeAll() {
    CircleRegistry registry = registry(3);
    pairs.report(2, 2, 0, 0);
    registry.remove(0);
    SavedFlights states = new SavedFlights(registry.ids());
    pairs.save(2, registry, 1, states);
    registry.set(registry);
    SensorPairs others = new SensorPairs();
    others.restore(1, registry, states);
    assertThat(others.isNew(1, 2, 0, 0)).isTrue();
    assertThat(others.isNew(1, 1, 0, 0)).isFalse();
  }

  private static CircleRegistry registry(int count) {
    SceneBuilder scene = Scene.builder();
    IntStream.range(0, count).forEach(i -> scene.circle(9 * i, 0, 1, 0, 0));
    return new CircleRegistry(Internals.data(scene.build()), 1);
  }
}
