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
    ObstacleRows rows = ObstacleTable.rows(kind, new double[0], null, null);
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
  void whatIsReadIsWhatWasKept(int kind) {
    ObstacleRows kept = rows(kind, 5);
    kept.setTraits(kept.first() + 2, SENSOR);
    kept.remove(kept.first() + 1);
    double[] values =
        Arrays.copyOfRange(kept.values, kept.offset(kept.first()), kept.offset(kept.end));
    ObstacleRows read =
        ObstacleTable.rows(kind, values, new byte[] {0, 0, (byte) SENSOR, 0, 0}, null);
    assertThat(read).isEqualTo(kept);
    assertThat(read.sensors()).isEqualTo(1);
    assertThat(read.isGone(read.first() + 1)).isTrue();
    assertThat(read.present().count()).isEqualTo(4);
    assertThat(read.extent(read.first() + 1)).isZero();
  }
}
