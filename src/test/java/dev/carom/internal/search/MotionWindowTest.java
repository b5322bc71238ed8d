// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.KindNumber;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Pegs of radius 1 in a row, 10 apart, all of which move to the right. */
class MotionWindowTest {

  private final ObstacleTable obstacles = ObstacleTable.empty(null);

  private final MotionWindow window = new MotionWindow();

  private void addPegs(int count) {
    for (int i = 0; i < count; i++) {
      obstacles.setVelocity(obstacles.add(KindNumber.PEG, 10 * i, 0, 1), 1, 0, 0);
    }
    window.changedAll();
    window.open(0, 2);
  }

  private void setVelocity(int peg, double ux) {
    obstacles.setVelocity(Codes.of(KindNumber.PEG, peg), ux, 0, 0);
    window.changed(obstacles.motions(), Codes.of(KindNumber.PEG, peg));
  }

  /** How many pegs a search finds for a disk that rests at the first of so many. */
  private int foundAtFirst() {
    window.find(obstacles, -1, -1, 1, 1);
    int count = 0;
    for (long word : window.found) {
      count += Long.bitCount(word);
    }
    return count;
  }

  private boolean finds(int peg, double x) {
    window.find(obstacles, x - 1, -1, x + 1, 1);
    return (window.found[peg / Long.SIZE] >>> peg & 1) != 0;
  }

  /** Two more in each search, whether ten move or a thousand: the index stays as it was. */
  @ParameterizedTest
  @ValueSource(ints = {10, 1000})
  void twoEditsAddTwoCandidates(int count) {
    addPegs(count);
    int before = foundAtFirst();

    for (int frame = 0; frame < 100; frame++) {
      setVelocity(count / 2, frame % 2);
      setVelocity(count / 2 + 1, frame % 2);
      assertThat(foundAtFirst()).isEqualTo(before + 2);
    }
    window.open(0, 2);
    assertThat(foundAtFirst()).isEqualTo(before);
  }

  @Test
  void findsAnEditedObstacleWhereItGoesNow() {
    addPegs(10);
    assertThat(finds(1, 80)).isFalse();

    setVelocity(1, 250);

    assertThat(finds(1, 80)).isTrue();
  }

  /** All are indexed anew, once more than 8 and the root of their number are beside the index. */
  @Test
  void makesANewIndexOnceManyWereEdited() {
    addPegs(100);
    int before = foundAtFirst();
    int most = 18;

    for (int peg = 100 - most; peg < 100; peg++) {
      setVelocity(peg, 1);
    }
    assertThat(foundAtFirst()).isEqualTo(before + most);

    setVelocity(100 - most - 1, 1);
    assertThat(foundAtFirst()).isEqualTo(before);
  }

  /** The numbers of the others are less by one then. */
  @Test
  void makesANewIndexOnceAnObstacleIsGone() {
    addPegs(10);
    assertThat(finds(4, 50)).isFalse();

    obstacles.remove(Codes.of(KindNumber.PEG, 0));
    window.changed(obstacles.motions(), Codes.of(KindNumber.PEG, 0));

    assertThat(finds(4, 50)).isTrue();
  }
}
