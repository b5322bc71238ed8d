// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RosterTest {

  @Test
  void aMassIsThatOfOneWorldOnly() {
    Scene scene = Scene.builder().circle(0, 0, 1, 0, 0).circle(9, 0, 1, 0, 0).build();
    Roster roster = new Roster(scene);
    Roster other = new Roster(scene);
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
    Roster roster = new Roster(Scene.builder().circle(0, 0, 1, 0, 0).build());
    for (int i = 0; i < 1000; i++) {
      roster.remove(roster.add());
      assertThat(roster.count()).isEqualTo(1);
      assertThat(roster.present().size()).isLessThanOrEqualTo(2);
    }
    Roster copy = roster.copy();
    int added = copy.add();
    assertThat(copy.present().stream(id -> !copy.contains(id))).containsExactly(0, added);
    assertThat(roster.present().stream(id -> !roster.contains(id))).containsExactly(0);
  }
}
