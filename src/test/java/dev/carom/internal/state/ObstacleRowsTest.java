// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.util.KindNumber;
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

  @ParameterizedTest
  @ValueSource(ints = {KindNumber.LINE, KindNumber.PEG})
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
}
