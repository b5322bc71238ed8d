// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Comparator;
import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class TimeOrderTest {

  private static final int STRIDE = 6;

  private final SplittableRandom random = new SplittableRandom(1);

  @Test
  void timesThatAreSpreadEvenly() {
    check(() -> 17 + random.nextDouble());
  }

  @Test
  void equalTimesKeepTheirOrder() {
    check(() -> random.nextInt(5));
  }

  @Test
  void manyTimesInOneHeap() {
    check(() -> random.nextInt(100) == 0 ? 1e9 * random.nextDouble() : 3 + random.nextDouble());
  }

  @Test
  void timesOfTwoHeapsFarApart() {
    check(() -> (random.nextBoolean() ? 1 : 1e300) * random.nextDouble());
  }

  @Test
  void extremeTimes() {
    check(() -> random.nextBoolean() ? Double.MAX_VALUE : Double.MIN_VALUE * random.nextInt(3));
    check(() -> Double.MIN_VALUE * random.nextInt(3));
    check(() -> Double.MAX_VALUE);
  }

  @Test
  void timesInDescendingOrder() {
    double[] next = {1e6};
    check(() -> next[0]--);
  }

  private void check(DoubleSupplier time) {
    for (int size : new int[] {1, 2, 5, 16, 17, 33, 100, 1000, 4097}) {
      double[] numbers = new double[(size + 3) * STRIDE];
      for (int row = 0; row < size; row++) {
        numbers[row * STRIDE] = time.getAsDouble();
        Arrays.fill(numbers, row * STRIDE + 1, (row + 1) * STRIDE, -row);
      }
      TimeOrder order = new TimeOrder(numbers, STRIDE);
      Arrays.setAll(order.rows, row -> row);
      order.sort(size);
      int[] expected =
          IntStream.range(0, size)
              .boxed()
              .sorted(Comparator.comparingDouble(row -> numbers[row * STRIDE]))
              .mapToInt(row -> row)
              .toArray();
      assertThat(Arrays.copyOf(order.rows, size)).as("%d rows", size).isEqualTo(expected);
    }
  }
}
