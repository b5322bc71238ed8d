// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.util.Kind;
import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The rows of any kind of obstacle. */
class ObstacleRowsTest {

  private static final int SENSOR = ContactFlags.with(0, ContactFlags.SENSOR);

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

  private static double[] row(ObstacleRows rows, int i) {
    return rows.row(rows.first() + i);
  }

  @ParameterizedTest
  @ValueSource(ints = {Kind.LINE, Kind.PEG})
  void whatIsAddedIsElasticAndHasTheNextCode(int kind) {
    ObstacleRows rows = rows(kind, 20);
    for (int i = 0; i < 20; i++) {
      assertThat(row(rows, i)).startsWith(numbers(kind, 10 * i)).endsWith(1);
      assertThat(rows.traits(rows.first() + i)).isZero();
    }
    assertThat(rows.count()).isEqualTo(20);
    assertThat(rows.end).isEqualTo(Codes.of(kind, 20));
  }

  @ParameterizedTest
  @ValueSource(ints = {Kind.LINE, Kind.PEG})
  void aCopyStaysAsItIsWhateverIsChanged(int kind) {
    ObstacleRows rows = rows(kind, 3);
    ObstacleRows copy = rows.copy();
    int code = rows.first() + 1;
    rows.move(code, numbers(kind, 7));
    rows.setRestitution(code, 0.5);
    rows.setTraits(code, SENSOR);
    rows.remove(rows.first());
    assertThat(copy).isEqualTo(rows(kind, 3)).hasSameHashCodeAs(rows(kind, 3)).isNotEqualTo(rows);
    copy.set(rows);
    assertThat(copy).isEqualTo(rows).hasSameHashCodeAs(rows);
    assertThat(copy.restitution(code)).isEqualTo(0.5);
    assertThat(copy.sensors()).isEqualTo(1);
    assertThat(copy.isGone(copy.first())).isTrue();
  }

  @ParameterizedTest
  @ValueSource(ints = {Kind.LINE, Kind.PEG})
  void aRemovedObstacleLeavesNothing(int kind) {
    ObstacleRows rows = rows(kind, 5);
    rows.setTraits(rows.first() + 1, SENSOR);
    rows.setTraits(rows.first() + 2, SENSOR);
    rows.remove(rows.first() + 1);
    assertThat(rows.sensors()).isEqualTo(1);
    assertThat(rows.isGone(rows.first() + 1)).isTrue();
    assertThat(rows.isGone(rows.first() + 2)).isFalse();
    assertThat(rows.present().count()).isEqualTo(4);
    assertThat(rows.extent(rows.first() + 1)).isZero();
    ObstacleRows other = rows(kind, 5);
    other.remove(other.first() + 1);
    assertThat(rows).isNotEqualTo(other);
    other.setTraits(other.first() + 2, SENSOR);
    assertThat(rows).isEqualTo(other);
  }
}
