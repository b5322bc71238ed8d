// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import org.junit.jupiter.api.Test;

class CircleRegistryTest {

  /** The list of live slots does not grow with the circles that were ever there. */
  @Test
  void whoIsGoneIsNotAmongWhomToAsk() {
    CircleRegistry registry =
        new CircleRegistry(Internals.data(Scene.builder().circle(0, 0, 1, 0, 0).build()), 1);
    for (int i = 0; i < 1000; i++) {
      registry.remove(registry.add());
      assertThat(registry.count()).isEqualTo(1);
      assertThat(registry.present().size()).isLessThanOrEqualTo(2);
    }
    CircleRegistry copy = registry.copy();
    int added = copy.add();
    assertThat(copy.present().stream(id -> !copy.contains(id))).containsExactly(0, added);
    assertThat(registry.present().stream(id -> !registry.contains(id))).containsExactly(0);
  }

  /** Circles 0 to 9, of masses 1 to 10, of which those are gone whose ids are given. */
  private static CircleRegistry without(int... gone) {
    SceneBuilder scene = Scene.builder().collide(false);
    for (int i = 0; i < 10; i++) {
      scene.circle(9 * i, 0, 1, 0, 0).mass(i + 1);
    }
    CircleRegistry registry = new CircleRegistry(Internals.data(scene.build()), 1);
    for (int id : gone) {
      registry.remove(registry.slot(id));
    }
    return registry;
  }

  @Test
  void whatIsDenseNamesItsCirclesAsBefore() {
    CircleRegistry registry = without(0, 3, 4, 9);
    registry.setTraits(7, ContactFlags.with(0, ContactFlags.SENSOR));
    CircleRegistry sparse = without(0, 3, 4, 9);
    sparse.setTraits(7, ContactFlags.with(0, ContactFlags.SENSOR));
    registry.set(registry);
    assertThat(registry.slots()).containsExactly(0, 1, 2, 3, 4, 5);
    assertThat(registry.ids()).containsExactly(1, 2, 5, 6, 7, 8).isEqualTo(sparse.ids());
    for (int id : new int[] {8, 1, 2, 7, 5, 6, 6, 8}) {
      int slot = registry.slot(id);
      assertThat(registry.id(slot)).isEqualTo(id);
      assertThat(registry.mass(slot)).isEqualTo(id + 1);
      assertThat(registry.isSensor(slot)).isEqualTo(id == 7);
    }
    for (int id : new int[] {-1, 0, 3, 4, 9, 10, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
      assertThat(registry.slot(id)).isNegative();
      assertThat(sparse.slot(id)).isNegative();
    }
    assertThat(registry).isEqualTo(sparse).hasSameHashCodeAs(sparse);
    assertThat(sparse).isEqualTo(registry);
    registry.setMass(registry.slot(8), 3);
    assertThat(registry).isNotEqualTo(sparse);
  }

  @Test
  void aFewThatAreGoneAreNoBurden() {
    CircleRegistry registry = without();
    int gone = 0;
    while (!registry.isSparse()) {
      registry.remove(registry.add());
      gone++;
    }
    assertThat(gone).isEqualTo(10 + 1024 + 1);
    registry.set(registry);
    assertThat(registry.isSparse()).isFalse();
  }

  private static MovingCircle knowing(int last, IgnoreList jam) {
    MovingCircle m = new MovingCircle();
    m.start(0, 0, 0, 1, 0, 0, 1);
    m.last = last;
    m.jam = jam;
    return m;
  }

  /** By their slots within, by their ids in a snapshot; lines and pegs are what they are. */
  @Test
  void whatACircleKnowsOfOthersIsTranslated() {
    CircleRegistry registry = without(0, 3, 4);
    registry.set(registry); // 1, 2, 5, 6, ...
    int circles = Codes.circle(0);
    IgnoreList jam =
        IgnoreList.with(
            IgnoreList.with(IgnoreList.with(null, circles + 2), Codes.line(0)), circles);
    MovingCircle m = knowing(circles + 3, jam);
    registry.toIds(m);
    assertThat(m.last).isEqualTo(circles + 6);
    assertThat(m.jam.entries()).containsExactly(circles + 5, Codes.line(0), circles + 1);
    registry.toSlots(m);
    assertThat(m.last).isEqualTo(circles + 3);
    assertThat(m.jam).isEqualTo(jam);
    registry.remove(3);
    registry.toIds(m);
    assertThat(m.last).isEqualTo(MovingCircle.NOTHING);
    MovingCircle other = knowing(Codes.peg(7), null);
    registry.toIds(other);
    registry.toSlots(other);
    assertThat(other.last).isEqualTo(Codes.peg(7));
    assertThat(other.jam).isNull();
  }
}
