// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import org.junit.jupiter.api.Test;

class CircleRegistryTest {

  @Test
  void aMassIsThatOfOneWorldOnly() {
    Scene scene = Scene.builder().circle(0, 0, 1, 0, 0).circle(9, 0, 1, 0, 0).build();
    CircleRegistry roster = new CircleRegistry(scene.data, 1);
    CircleRegistry other = new CircleRegistry(scene.data, 1);
    roster.setMass(1, 5);
    roster.setMass(0, 3);
    assertThat(roster.mass(0)).isEqualTo(3);
    assertThat(roster.mass(1)).isEqualTo(5);
    assertThat(other.mass(0)).isOne();
    assertThat(scene.mass(0)).isOne();
    assertThat(scene.mass(1)).isOne();
  }

  /** What asks each circle would else take longer with all that ever were there. */
  @Test
  void whoIsGoneIsNotAmongWhomToAsk() {
    CircleRegistry roster =
        new CircleRegistry(Scene.builder().circle(0, 0, 1, 0, 0).build().data, 1);
    for (int i = 0; i < 1000; i++) {
      roster.remove(roster.add());
      assertThat(roster.count()).isEqualTo(1);
      assertThat(roster.present().size()).isLessThanOrEqualTo(2);
    }
    CircleRegistry copy = roster.copy();
    int added = copy.add();
    assertThat(copy.present().stream(id -> !copy.contains(id))).containsExactly(0, added);
    assertThat(roster.present().stream(id -> !roster.contains(id))).containsExactly(0);
  }

  /** Circles 0 to 9, of masses 1 to 10, of which those are gone whose ids are given. */
  private static CircleRegistry without(int... gone) {
    SceneBuilder scene = Scene.builder();
    for (int i = 0; i < 10; i++) {
      scene.circle(9 * i, 0, 1, 0, 0).mass(i + 1);
    }
    CircleRegistry roster = new CircleRegistry(scene.build().data, 1);
    for (int id : gone) {
      roster.remove(roster.slot(id));
    }
    return roster;
  }

  @Test
  void whatIsDenseNamesItsCirclesAsBefore() {
    CircleRegistry roster = without(0, 3, 4, 9);
    roster.setTraits(7, ContactFlags.with(0, ContactFlags.SENSOR));
    CircleRegistry sparse = without(0, 3, 4, 9);
    sparse.setTraits(7, ContactFlags.with(0, ContactFlags.SENSOR));
    roster.set(roster);
    assertThat(roster.slots()).containsExactly(0, 1, 2, 3, 4, 5);
    assertThat(roster.ids()).containsExactly(1, 2, 5, 6, 7, 8).isEqualTo(sparse.ids());
    for (int id : new int[] {8, 1, 2, 7, 5, 6, 6, 8}) {
      int slot = roster.slot(id);
      assertThat(roster.id(slot)).isEqualTo(id);
      assertThat(roster.mass(slot)).isEqualTo(id + 1);
      assertThat(roster.isSensor(slot)).isEqualTo(id == 7);
    }
    for (int id : new int[] {-1, 0, 3, 4, 9, 10, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
      assertThat(roster.slot(id)).isNegative();
      assertThat(sparse.slot(id)).isNegative();
    }
    assertThat(roster).isEqualTo(sparse).hasSameHashCodeAs(sparse);
    assertThat(sparse).isEqualTo(roster);
    roster.setMass(roster.slot(8), 3);
    assertThat(roster).isNotEqualTo(sparse);
  }

  @Test
  void theNextOneGetsTheNextId() {
    CircleRegistry roster = without(2, 9);
    roster.set(roster);
    for (int id = 10; id < 40; id++) {
      int slot = roster.add();
      assertThat(slot).isEqualTo(id - 2);
      assertThat(roster.id(slot)).isEqualTo(id);
      assertThat(roster.slot(id)).isEqualTo(slot);
      assertThat(roster.idLimit()).isEqualTo(id + 1);
    }
    roster.remove(roster.slot(12));
    assertThat(roster.slot(12)).isNegative();
    assertThat(roster.slot(13)).isEqualTo(11);
  }

  @Test
  void oneThatHasLostItsLastOneKnowsWhichIdIsNext() {
    CircleRegistry roster = without(9);
    roster.set(roster);
    assertThat(roster.slot(9)).isNegative();
    assertThat(roster.id(roster.add())).isEqualTo(10);
  }

  @Test
  void aFewThatAreGoneAreNoBurden() {
    CircleRegistry roster = without();
    int gone = 0;
    while (!roster.isSparse()) {
      roster.remove(roster.add());
      gone++;
    }
    assertThat(gone).isEqualTo(10 + 1024 + 1);
    roster.set(roster);
    assertThat(roster.isSparse()).isFalse();
  }

  @Test
  void theLastOneThatIsThereUpToASlot() {
    CircleRegistry roster = without(0, 1, 4);
    assertThat(roster.lastId(-1)).isNegative();
    assertThat(roster.lastId(1)).isNegative();
    assertThat(roster.lastId(2)).isEqualTo(2);
    assertThat(roster.lastId(4)).isEqualTo(3);
    roster.set(roster);
    assertThat(roster.lastId(2)).isEqualTo(5);
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
    CircleRegistry roster = without(0, 3, 4);
    roster.set(roster); // 1, 2, 5, 6, ...
    int circles = ObstacleTable.CIRCLES;
    IgnoreList jam =
        IgnoreList.with(
            IgnoreList.with(IgnoreList.with(null, circles + 2), ObstacleTable.WALLS), circles);
    MovingCircle m = knowing(circles + 3, jam);
    roster.toIds(m);
    assertThat(m.last).isEqualTo(circles + 6);
    assertThat(m.jam.codes()).containsExactly(circles + 5, ObstacleTable.WALLS, circles + 1);
    roster.toSlots(m);
    assertThat(m.last).isEqualTo(circles + 3);
    assertThat(m.jam).isEqualTo(jam);
    roster.remove(3);
    roster.toIds(m);
    assertThat(m.last).isEqualTo(MovingCircle.NOTHING);
    MovingCircle other = knowing(ObstacleTable.PEGS + 7, null);
    roster.toIds(other);
    roster.toSlots(other);
    assertThat(other.last).isEqualTo(ObstacleTable.PEGS + 7);
    assertThat(other.jam).isNull();
  }
}
