// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.ExactBudget;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Each edit of an obstacle asks whether the flight of a circle, if it never ended, meets that. */
class EndlessFallTest {
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final int QUESTIONS = 1_000;

  private final Random random = new Random(7);

  private Fall pegOrLine(boolean isPeg) {
    double vx = random.nextDouble() - 0.5;
    double vy = random.nextDouble() - 0.5;
    Fall fall = Fall.ofThread().flight(0, 0, 1, vx, vy, 0, -0.1 * random.nextDouble());
    double x = 40 * random.nextDouble() - 20;
    double y = 40 * random.nextDouble() - 20;
    return isPeg
        ? fall.disk(x, y, 1, 0, 0)
        : fall.line(x, y, x + random.nextDouble(), y + random.nextDouble(), 0, 0);
  }

  /** They answer 983 and 974; 40 and 31 if the filter is given no finite end. */
  @Test
  void plainDoublesAnswerNearlyAllQuestionsWithoutAnEnd() {
    for (boolean isPeg : new boolean[] {true, false}) {
      int answered = 0;
      for (int i = 0; i < QUESTIONS; i++) {
        Fall fall = pegOrLine(isPeg);
        long before = ExactBudget.ofThread().bits();
        double time = FallSweep.time(fall, NEVER);
        answered += ExactBudget.ofThread().bits() == before ? 1 : 0;
        assertThat(time).isEqualTo(FallSweep.exact(fall).time(NEVER));
      }
      assertThat(answered).isGreaterThan(QUESTIONS * 95 / 100);
    }
  }
}
