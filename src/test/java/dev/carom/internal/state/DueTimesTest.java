// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DueTimesTest {

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 63, 1024, 1025, 5000})
  void eachPassFindsThoseThatAreDueInTheirOrder(int count) {
    SplittableRandom random = new SplittableRandom(count);
    DueTimes agenda = new DueTimes(count);
    double[] due = new double[count];
    Arrays.fill(due, Double.POSITIVE_INFINITY);
    for (int i = 0; i < count; i++) {
      due[i] = set(agenda, i, random.nextDouble(300));
    }
    for (int now = 0; now < 400; now++) {
      int next = agenda.next(0, now);
      for (int i = 0; i < count; i++) {
        if (due[i] <= now) {
          assertThat(next).isEqualTo(i);
          // Blocks fall quiet one after the other.
          boolean quiet = i % 640 < now;
          due[i] = set(agenda, i, quiet ? Double.POSITIVE_INFINITY : now + random.nextDouble(9));
          next = agenda.next(i + 1, now);
        }
      }
      assertThat(next).isEqualTo(agenda.size());
      if (count > 0) {
        // An edit between steps, to an earlier time or a later one.
        int i = random.nextInt(count);
        due[i] = set(agenda, i, now + random.nextDouble(5));
      }
    }
  }

  private static double set(DueTimes agenda, int i, double time) {
    agenda.set(i, time);
    assertThat(agenda.get(i)).isEqualTo(time);
    return time;
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 2000})
  void nothingIsDueAtFirst(int count) {
    assertThat(new DueTimes(count).next(0, Double.MAX_VALUE)).isEqualTo(count);
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 2000})
  void whatIsDueAtTheVeryEndIsFound(int count) {
    DueTimes agenda = new DueTimes(count);
    agenda.set(count - 1, 5);
    assertThat(agenda.next(0, 5)).isEqualTo(count - 1);
    assertThat(agenda.next(0, Math.nextDown(5.0))).isEqualTo(count);
  }

  @Test
  void minusZeroIsZero() {
    DueTimes agenda = new DueTimes(3);
    agenda.set(1, -0.0);
    assertThat(Double.doubleToRawLongBits(agenda.get(1))).isZero();
    assertThat(agenda.next(0, -0.0)).isOne();
  }
}
