// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Bounds;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import org.junit.jupiter.api.Test;

class AmongMovingLinesTest {

  private static final int FRAMES = 600;
  private static final int MOVING = 100;

  /**
   * Moved half-way, and not at all, a coordinate is rounded a few times: 1e-12 is its last place.
   */
  private static final double ROUNDING = 1e-11;

  @Test
  void aHundredLinesMoveInsideTheBoundsOrRestWhereTheyWouldBeHalfWay() throws Exception {
    Scene moving = AmongMovingLines.scene(1, FRAMES, true);
    Scene resting = AmongMovingLines.scene(1, FRAMES, false);
    Bounds bounds = moving.bounds().orElseThrow();
    int others = moving.count(Kind.LINE) - MOVING;
    assertThat(resting.count(Kind.LINE)).isEqualTo(others + MOVING);
    for (int k = 0; k < others; k++) {
      assertThat(moving.velocity(Kind.LINE, k)).isEqualTo(Vec2.ZERO);
      assertThat(resting.shape(Kind.LINE, k)).isEqualTo(moving.shape(Kind.LINE, k));
    }
    for (int k = others; k < others + MOVING; k++) {
      Vec2 u = moving.velocity(Kind.LINE, k);
      assertThat(u.length()).isBetween(1 - ROUNDING, 10 + ROUNDING);
      assertThat(resting.velocity(Kind.LINE, k)).isEqualTo(Vec2.ZERO);
      Line start = (Line) moving.shape(Kind.LINE, k);
      Line rest = (Line) resting.shape(Kind.LINE, k);
      double half = FRAMES / 2.0;
      assertThat(rest.ax()).isCloseTo(start.ax() + half * u.x(), within(ROUNDING));
      assertThat(rest.ay()).isCloseTo(start.ay() + half * u.y(), within(ROUNDING));
      assertThat(rest.bx()).isCloseTo(start.bx() + half * u.x(), within(ROUNDING));
      assertThat(rest.by()).isCloseTo(start.by() + half * u.y(), within(ROUNDING));
      double x = (start.ax() + start.bx()) / 2 + FRAMES * u.x();
      double y = (start.ay() + start.by()) / 2 + FRAMES * u.y();
      assertThat(x).isBetween(bounds.xmin(), bounds.xmax());
      assertThat(y).isBetween(bounds.ymin(), bounds.ymax());
    }
  }
}
