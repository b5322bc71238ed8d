// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.util.KindNumber;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The rows of any kind of obstacle. */
class ObstacleRowsTest {

  private static final int SENSOR = ContactFlags.with(0, ContactFlags.SENSOR);

  private static final long FILTER = FilterBits.DEFAULT ^ 1;

  private static double[] numbers(int kind, double first) {
    double[] numbers = new double[ObstacleTable.shape(kind).restitution];
    Arrays.setAll(numbers, i -> first + i);
    return numbers;
  }

  private static ObstacleRows rows(int kind, int count) {
    ObstacleRows rows = new ObstacleRows(kind, ObstacleTable.shape(kind));
    for (int i = 0; i < count; i++) {
      rows.add(numbers(kind, 10 * i));
    }
    return rows;
  }

  /** Each change takes the arrays that it changes from nobody else. */
  @ParameterizedTest
  @ValueSource(ints = {KindNumber.LINE, KindNumber.PEG})
  void aCopyStaysAsItIsWhateverIsChanged(int kind) {
    int code = rows(kind, 0).first() + 1;
    double[] motion = ObstacleMotions.motion(code, 1, 2, 0);
    ObstacleMotions motions = ObstacleMotions.of(new int[] {code}, motion);
    List<Consumer<ObstacleRows>> changes =
        List.of(
            rows -> rows.add(numbers(kind, 7)),
            rows -> rows.move(code, numbers(kind, 7)),
            rows -> rows.advance(code, motions, 3),
            rows -> rows.setRestitution(code, 0.5),
            rows -> rows.setTraits(code, SENSOR),
            rows -> rows.setFilter(code, FILTER),
            rows -> rows.remove(code),
            ObstacleRows::joinLast,
            rows -> rows.join(2));
    for (Consumer<ObstacleRows> change : changes) {
      ObstacleRows rows = rows(kind, 3);
      rows.join(1);
      ObstacleRows fresh = rows(kind, 3);
      fresh.join(1);
      ObstacleRows copy = rows.copy();
      change.accept(rows);
      assertThat(copy).isEqualTo(fresh).hasSameHashCodeAs(fresh).isNotEqualTo(rows);
      copy.set(rows);
      assertThat(copy).isEqualTo(rows).hasSameHashCodeAs(rows);
      assertThat(copy.obstacles()).isEqualTo(rows.obstacles());
      assertThat(copy.sensors()).isEqualTo(rows.sensors());
    }
  }

  @Test
  void aRowMovesAndIsRemovedWithAllThatItHas() {
    ObstacleRows rows = rows(KindNumber.LINE, 2);
    int code = rows.first() + 1;
    double[] motion = ObstacleMotions.motion(code, 1, -2, 0);
    rows.advance(code, ObstacleMotions.of(new int[] {code}, motion), 3);
    assertThat(rows.numbers(code)).containsExactly(13, 5, 15, 7);
    assertThat(rows.row(code)).containsExactly(13, 5, 15, 7, 1);
    assertThat(rows.hashCode()).isNotEqualTo(rows(KindNumber.LINE, 2).hashCode());
    assertThat(rows.filters()).isNull();
    rows.setFilter(code, FILTER);
    assertThat(rows.filters()).containsExactly(FilterBits.DEFAULT, FILTER);
    rows.remove(code);
    assertThat(rows.filter(code)).isEqualTo(FilterBits.DEFAULT);
    assertThat(rows.isGone(code)).isTrue();
    assertThat(rows.obstacles()).isOne();
  }

  /** Sides 0 1 2 | 3 | 4 5: an obstacle counts until its last side is removed. */
  @Test
  void joinedRowsAreOneObstacle() {
    ObstacleRows rows = rows(KindNumber.LINE, 3);
    int first = rows.first();
    assertThat(rows.areJoined()).isFalse();
    rows.join(1, 2);
    rows.add(numbers(KindNumber.LINE, 30));
    rows.add(numbers(KindNumber.LINE, 40));
    rows.add(numbers(KindNumber.LINE, 44));
    rows.joinLast();
    assertThat(rows.areJoined()).isTrue();
    assertThat(rows.joined()).containsExactly(1, 2, 5);
    assertThat(rows.obstacles()).isEqualTo(3);
    assertThat(rows.idLimit()).isEqualTo(3);
    assertThat(rows.id(first + 5)).isEqualTo(2);
    assertThat(rows.firstOf(first + 2)).isEqualTo(first);
    assertThat(rows.endOf(first + 1)).isEqualTo(first + 3);
    assertThat(rows.isJoined(first + 2)).isTrue();
    assertThat(rows.isJoined(first + 3)).isFalse();
    for (int code = first; code < first + 3; code++) {
      rows.remove(code);
    }
    assertThat(rows.obstacles()).isEqualTo(2);
    rows.remove(first + 3);
    assertThat(rows.obstacles()).isOne();
    ObstacleRows then = rows(KindNumber.LINE, 4);
    then.joinAs(rows);
    assertThat(then.joined()).containsExactly(1, 2);
    assertThat(then.obstacles()).isEqualTo(2);
    rows.join(1, 2, 5);
    assertThat(rows.obstacles()).as("removed sides count neither way").isOne();
  }

  /** Of (0, 1, 2, 3) and the like: one begins at (2, 3), one at (2, 0), one at (0, 3). */
  @Test
  void sidesMeetInBothCoordinates() {
    ObstacleRows rows = rows(KindNumber.LINE, 1);
    int one = rows.first();
    assertThat(rows.meet(one, rows.add(2, 3, 9, 9))).isTrue();
    assertThat(rows.meet(one, rows.add(2, 0, 2, 3))).isFalse();
    assertThat(rows.meet(one, rows.add(0, 3, 2, 3))).isFalse();
  }
}
