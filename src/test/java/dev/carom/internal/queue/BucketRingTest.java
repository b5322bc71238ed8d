// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import dev.carom.internal.util.Index;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BucketRingTest {

  private static final int NONE = Index.NONE;

  /** Those of a bucket, the one that was added last first. */
  private static Deque<Integer> all(BucketRing ring, int first) {
    Deque<Integer> all = new ArrayDeque<>();
    for (int i = first; i != NONE; i = ring.next(i)) {
      all.add(i);
    }
    return all;
  }

  /** Beside a map of lists: many turns, each place that of a bucket of every turn. */
  @ParameterizedTest
  @ValueSource(ints = {64, 128, 1024})
  void holdsWhatItWasGivenTurnAfterTurn(int size) {
    int circles = size / 4;
    BucketRing ring = new BucketRing(size, circles);
    Random random = new Random(size);
    TreeMap<Integer, Deque<Integer>> buckets = new TreeMap<>();
    int[] in = new int[circles];
    int current = 0;
    for (int step = 0; step < 20_000; step++) {
      int i = random.nextInt(circles);
      if (in[i] > current) {
        ring.remove(in[i], i);
        buckets.get(in[i]).remove(i);
        assertThat(all(ring, ring.first(in[i]))).containsExactlyElementsOf(buckets.get(in[i]));
        buckets.values().removeIf(Deque::isEmpty);
        in[i] = 0;
      } else {
        int ahead = random.nextInt(4) == 0 ? random.nextInt(size) : random.nextInt(9);
        in[i] = current + 1 + ahead;
        ring.add(in[i], i);
        buckets.computeIfAbsent(in[i], b -> new ArrayDeque<>()).addFirst(i);
      }
      if (random.nextInt(8) == 0) {
        Integer first = buckets.ceilingKey(current + 1);
        assertThat(ring.filledFrom(current + 1))
            .isEqualTo(first == null ? BucketRing.NOWHERE : first);
        if (first != null) {
          current = first;
          assertThat(all(ring, ring.drain(first))).containsExactlyElementsOf(buckets.remove(first));
          assertThat(ring.first(first)).isEqualTo(NONE);
        }
      }
    }
    assertThat(current).isGreaterThan(2 * size);
  }

  /** The last bucket of the turn, and the low bits of the word that is looked at twice. */
  @Test
  void looksOneWholeTurnAhead() {
    BucketRing ring = new BucketRing(128, 1);
    for (int from : new int[] {0, 1, 63, 64, 100, 127, 128, 1000}) {
      assertThat(ring.filledFrom(from)).isEqualTo(BucketRing.NOWHERE);
      for (int ahead : new int[] {0, 1, 27, 28, 63, 64, 126, 127}) {
        ring.add(from + ahead, 0);
        assertThat(ring.filledFrom(from)).isEqualTo(from + ahead);
        assertThat(ring.drain(from + ahead)).isZero();
      }
    }
  }

  @Test
  void aMarkIsReadUntilTheCircleIsInABucket() {
    BucketRing ring = new BucketRing(64, 2);
    assertThat(ring.next(1)).isEqualTo(NONE);
    ring.mark(1, -7);
    assertThat(ring.next(1)).isEqualTo(-7);
    ring.add(3, 1);
    assertThat(ring.next(1)).isEqualTo(NONE);
  }

  /**
   * A lattice in flight crosses all its cells at one time: each must come out at once. That takes
   * milliseconds; to walk the list for each would be 500,000,000,000 steps, more than any machine
   * makes in five minutes.
   */
  @Test
  void oneOfManyInABucketIsTakenOutAtOnce() {
    int count = 1_000_000;
    BucketRing ring = new BucketRing(64, count);
    for (int i = 0; i < count; i++) {
      ring.add(5, i);
    }
    assertTimeoutPreemptively(
        Duration.ofMinutes(5),
        () -> {
          for (int i = 0; i < count; i++) {
            ring.remove(5, i);
          }
        });
    assertThat(ring.first(5)).isEqualTo(NONE);
  }
}
