// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A circle knows the last contact with another one in its flight that a sensor reported. */
class SensedCircleTest {

  private final CircleTable circles = CircleTable.colliding(40);

  private boolean isNew(int i, double head, double tail, int partner) {
    return !circles.isSensed(i, head, tail, partner);
  }

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
    assertThat(isNew(1, head, tail, partner)).isTrue();
    circles.putSensed(1, 5, 1e-20, 3);
    assertThat(isNew(1, head, tail, partner)).isEqualTo(isNew);
    circles.load(1);
    circles.storeNewFlight(circles.state, circles.codes, 1, circles.body);
    assertThat(isNew(1, head, tail, partner)).isTrue();
  }

  @Test
  void toAnyOtherCircleAllIsNew() {
    circles.putSensed(1, 5, 0, 3);
    for (int i = 0; i < 40; i++) {
      assertThat(isNew(i, 0, 0, 0)).isEqualTo(i != 1);
    }
    circles.clear();
    circles.add();
    circles.add();
    circles.body.newFlight();
    circles.put(1, circles.body);
    assertThat(isNew(1, 5, 0, 3)).isTrue();
  }

  @Test
  void soIsAMeetingAtTimeZero() {
    assertThat(isNew(1, 0, 0, 0)).isTrue();
    circles.putSensed(1, 0, 0, 3);
    assertThat(isNew(1, 0, 0, 3)).isFalse();
    assertThat(isNew(1, 0, 0, 4)).isTrue();
  }

  /** Saves circle i as number k, and takes it over as circle k of those that are left. */
  private void pack(CircleRegistry registry, int i, int k) {
    FlightTable saved = new FlightTable(registry.count());
    circles.load(i);
    registry.toIds(circles.body);
    saved.put(k, circles.body);
    registry.set(registry);
    saved.get(k, circles.body);
    registry.toSlots(circles.body);
    circles.put(k, circles.body);
  }

  /** Those of larger ids at the same time are still to be reported, also when it is gone. */
  @Test
  void aPartnerThatIsGoneKeepsItsPlaceInTheOrder() {
    CircleRegistry registry = registry(6);
    circles.putSensed(5, 2, 0, 3);
    registry.remove(2);
    registry.remove(3);
    pack(registry, 5, 3); // circles 0, 1, 4 and 5
    assertThat(isNew(3, 2, 0, 1)).isFalse();
    assertThat(isNew(3, 2, 0, 2)).isTrue();
  }

  @Test
  void aPartnerBeforeWhomNobodyIsLeftIsBeforeAll() {
    CircleRegistry registry = registry(3);
    circles.putSensed(2, 2, 0, 0);
    registry.remove(0);
    pack(registry, 2, 1);
    assertThat(isNew(1, 2, 0, 0)).isTrue();
    assertThat(isNew(1, 1, 0, 0)).isFalse();
  }

  private static CircleRegistry registry(int count) {
    SceneBuilder scene = Scene.builder();
    IntStream.range(0, count).forEach(i -> scene.circle(9 * i, 0, 1, 0, 0));
    return new CircleRegistry(Internals.data(scene.build()), 1);
  }
}
