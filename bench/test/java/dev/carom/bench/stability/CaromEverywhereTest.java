// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.methods.Methods;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every map at a third of its width and height. */
class CaromEverywhereTest {

  static List<FailureMap> maps() {
    return FailureMap.all(true);
  }

  @ParameterizedTest
  @MethodSource("maps")
  void caromIsRightInEveryCellWithinItsLimits(FailureMap map) {
    List<String> wrong = new ArrayList<>();
    int within = 0;
    for (int i = 0; i < map.size(); i++) {
      Cell cell = map.cell(i);
      if (cell.limit() == CellLimit.NONE) {
        within++;
        CellOutcome outcome = CellJudge.of(Methods.CAROM, cell).outcome();
        if (outcome != CellOutcome.RIGHT) {
          wrong.add("cell " + i + ": " + outcome);
        }
      }
    }
    assertThat(wrong).as("map %s", map.name()).isEmpty();
    assertThat(within).isGreaterThan(2 * map.size() / 3);
  }
}
