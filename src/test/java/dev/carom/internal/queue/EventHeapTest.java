// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.state.CircleTable;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class EventHeapTest {

  /** Events of the same time stand in the order of their circles. */
  @Test
  void theFirstOfThoseThatAreHereIsFirst() {
    int count = 60;
    Random random = new Random(1);
    double[] times = new double[count];
    boolean[] here = new boolean[count];
    EventHeap heap =
        new EventHeap(times, (i, j) -> i < j, new int[CircleTable.collidingCodesAt(count)]);
    for (int step = 0; step < 20_000; step++) {
      int i = random.nextInt(count);
      if (random.nextInt(3) == 0 && !heap.isEmpty()) {
        here[heap.first()] = false;
        heap.removeFirst();
      } else if (here[i]) {
        here[i] = false;
        heap.remove(i);
      } else {
        here[i] = true;
        times[i] = random.nextInt(10);
        heap.add(i);
      }
      assertThat(heap.contains(i)).isEqualTo(here[i]);
      var first = IntStream.range(0, count).filter(j -> here[j]).boxed();
      var expected =
          first.min((a, b) -> times[a] < times[b] || (times[a] == times[b] && a < b) ? -1 : 1);
      assertThat(heap.isEmpty()).isEqualTo(expected.isEmpty());
      if (expected.isPresent()) {
        assertThat(heap.first()).isEqualTo(expected.get());
      }
    }
  }
}
