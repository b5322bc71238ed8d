// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.KindNumber;
import org.junit.jupiter.api.Test;

/** When the index of questions is made, which radii share a grid, and what is loose beside it. */
class ObstacleIndexTest {

  /** So many questions that test each obstacle cost as much as the index. */
  private static final int COST = 16;

  private static final int MANY = 100;

  private static ObstacleIndex index(int pegs) {
    SceneBuilder scene = Scene.builder();
    for (int i = 0; i < pegs; i++) {
      scene.peg(10 * (i % 10), 10 * (i / 10), 1);
    }
    return new ObstacleIndex(ObstacleTable.of(Internals.data(scene.build())));
  }

  private static ObstacleIndex made() {
    ObstacleIndex index = index(MANY);
    index.expect(COST + 1);
    return index;
  }

  @Test
  void itIsMadeOnceItPays() {
    ObstacleIndex index = index(MANY);
    for (int i = 0; i < COST; i++) {
      index.expect(1);
      assertThat(index.tree(KindNumber.PEG)).isNull();
      assertThat(index.grid(0)).isNull();
    }
    index.expect(1);
    assertThat(index.tree(KindNumber.PEG).size()).isEqualTo(MANY);
    assertThat(index.tree(KindNumber.LINE).size()).isZero();
    assertThat(index.grid(0)).isNotNull();
  }

  @Test
  void aFewPegsNeedNone() {
    ObstacleIndex index = index(8);
    index.expect(1000);
    assertThat(index.grid(0)).isNull();
    assertThat(index.tree(KindNumber.PEG)).isNull();
  }

  @Test
  void radiiOfAnOctaveShareAGrid() {
    ObstacleIndex index = made();
    assertThat(index.grid(2)).isSameAs(index.grid(3.9)).isNotSameAs(index.grid(4));
    assertThat(index.grid(3).radius).isEqualTo(4);
    assertThat(index.grid(0)).isSameAs(index.grid(Double.MIN_VALUE)).isNotSameAs(index.grid(1));
    assertThat(index.grid(1000)).as("as large as the scene").isNull();
  }

  @Test
  void changesAreLooseUntilTheyAreMany() {
    ObstacleIndex index = made();
    int most = 8 + 10; // and the root of the number of pegs
    for (int i = 0; i < most; i++) {
      index.changed(Codes.peg(i));
      index.changed(Codes.peg(i));
    }
    assertThat(index.loose().size).isEqualTo(most);
    assertThat(index.tree(KindNumber.PEG)).isNotNull();
    index.changed(Codes.peg(most));
    assertThat(index.loose().size).isZero();
    assertThat(index.tree(KindNumber.PEG)).isNull();
  }

  /** Loose obstacles cost each question something, which adds up to the cost of an index. */
  @Test
  void itIsMadeAnewOnceThatPays() {
    ObstacleIndex index = made();
    BoxTree before = index.tree(KindNumber.PEG);
    index.expect(1_000_000);
    assertThat(index.tree(KindNumber.PEG)).isSameAs(before);
    index.changed(Codes.peg(3));
    index.expect(COST * MANY);
    assertThat(index.tree(KindNumber.PEG)).isSameAs(before);
    index.expect(1);
    assertThat(index.tree(KindNumber.PEG)).isNotSameAs(before);
    assertThat(index.loose().size).isZero();
  }

  /** A small box among 100 pegs finds those that it touches. */
  @Test
  void aTreeFindsWhatIsInABox() {
    IntList found = new IntList();
    made().tree(KindNumber.PEG).find(new BoxTree.Outside().set(18, -5, 31, 9), found);
    assertThat(found.filtered(code -> true))
        .containsExactly(Codes.peg(2), Codes.peg(3), Codes.peg(12), Codes.peg(13));
  }
}
