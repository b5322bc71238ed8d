// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.state.CircleTable;
import dev.carom.internal.util.Index;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The calendar gives the same order as a sorted set, whatever is set, moved and taken. */
class CalendarQueueTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private record Event(double time, double tail, long rank, int circle) {
    static final Comparator<Event> ORDER =
        Comparator.comparingDouble(Event::time)
            .thenComparingDouble(Event::tail)
            .thenComparingLong(Event::rank)
            .thenComparingInt(Event::circle);
  }

  /** The queue, and beside it what it must agree with. */
  private static final class Twin {

    final CalendarQueue queue;
    final TreeSet<Event> sorted = new TreeSet<>(Event.ORDER);
    final Event[] events;

    Twin(int count) {
      events = new Event[count];
      queue = new CalendarQueue(count, (i, j) -> Event.ORDER.compare(events[i], events[j]) < 0);
    }

    void set(int circle, double time, double tail, long rank) {
      if (events[circle] != null) {
        sorted.remove(events[circle]);
      }
      queue.clear(circle);
      events[circle] = new Event(time, tail, rank, circle);
      if (time < NEVER) {
        sorted.add(events[circle]);
      }
      queue.set(circle, time);
    }

    /** Takes the first event, as a world does before it sets another one. */
    void poll(int first) {
      sorted.remove(events[first]);
      assertThat(queue.poll(Math.nextDown(events[first].time()))).isEqualTo(Index.NONE);
      assertThat(queue.poll(events[first].time())).isEqualTo(first);
      assertThat(queue.polledTime()).isEqualTo(events[first].time());
      events[first] = null;
      assertThat(queue.time(first)).isEqualTo(NEVER);
    }

    int first() {
      int first = queue.first();
      assertThat(first).isEqualTo(sorted.isEmpty() ? Index.NONE : sorted.first().circle());
      return first;
    }
  }

  /** Takes events and sets others in their place, as a world does: never before the last taken. */
  private static void play(int count, long seed, DoubleUnaryOperator next) {
    Random random = new Random(seed);
    Twin twin = new Twin(count);
    for (int i = 0; i < count; i++) {
      twin.set(i, next.applyAsDouble(0), random.nextInt(3), rank(random, i));
    }
    for (int step = 0; step < 30_000; step++) {
      int first = twin.first();
      if (first == Index.NONE) {
        return;
      }
      double now = twin.events[first].time();
      if (random.nextBoolean()) {
        twin.poll(first);
      }
      twin.set(first, next.applyAsDouble(now), random.nextInt(3), rank(random, first));
      for (int k = random.nextInt(3); k > 0; k--) {
        int i = random.nextInt(count);
        twin.set(i, next.applyAsDouble(now), random.nextInt(3), rank(random, i));
      }
    }
  }

  /** Ranks differ between circles, as those of a world do. */
  private static long rank(Random random, int circle) {
    return (long) random.nextInt(50) << 31 | circle;
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 10, 100, 1000})
  void timesSpreadAsThoseOfImpacts(int count) {
    Random random = new Random(count);
    play(count, 1, now -> now - Math.log(1 - random.nextDouble()));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 3, 10, 100, 1000})
  void manyAtOneTime(int count) {
    Random random = new Random(count);
    play(count, 2, now -> now + random.nextInt(3));
    play(count, 3, now -> Math.rint(now + random.nextDouble()));
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 30, 300})
  void soonFarAndNever(int count) {
    Random random = new Random(count);
    play(
        count,
        4,
        now ->
            switch (random.nextInt(8)) {
              case 0 -> NEVER;
              case 1 -> now + 1e300 * random.nextDouble();
              case 2 -> now;
              case 3 -> now + 1e-300;
              case 4 -> now + 1e9 * random.nextDouble();
              default -> now + random.nextDouble();
            });
  }

  /** The bucket width at the start of a round is soon far too long, and then far too short. */
  @ParameterizedTest
  @ValueSource(ints = {1, 40, 300, 3000})
  void timesThatGrowShortAndLongAgain(int count) {
    Random random = new Random(count);
    int[] set = new int[1];
    play(
        count,
        8,
        now -> {
          double unit = Math.scalb(1.0, 20 * ((set[0]++ >> 13) % 3));
          return now - Math.log(1 - random.nextDouble()) / unit;
        });
  }

  @ParameterizedTest
  @ValueSource(doubles = {0x1p-1074, 1e-300, 1e300, Double.MAX_VALUE / 4})
  void timesOfAnySize(double unit) {
    Random random = new Random(7);
    play(100, 5, now -> Math.max(now, unit * (1 + random.nextInt(3))));
    play(100, 6, now -> Math.min(Double.MAX_VALUE, now + unit * random.nextInt(2)));
  }

  @Test
  void isEmptyAtFirstAndAgain() {
    Twin twin = new Twin(3);
    twin.first();
    twin.set(1, 5, 0, 1);
    twin.set(0, NEVER, 0, 0);
    assertThat(twin.first()).isEqualTo(1);
    twin.set(1, NEVER, 0, 1);
    assertThat(twin.first()).isEqualTo(Index.NONE);
    twin.set(2, 1, 0, 2);
    twin.set(1, 1, -1, 2);
    assertThat(twin.first()).isEqualTo(1);
    assertThat(twin.queue.time(2)).isEqualTo(1);
  }

  private static CalendarQueue telling(List<Integer> told, int count) {
    return new CalendarQueue(
        count,
        (i, j) -> i < j,
        (calendar, circles, size) -> Arrays.stream(circles, 0, size).forEach(told::add),
        new int[CircleTable.collidingCodesAt(count)]);
  }

  /** With nothing set in between, every event that is taken was told of before, and once. */
  @ParameterizedTest
  @ValueSource(ints = {1, 40, 3000})
  void tellsWhatComesNext(int count) {
    List<Integer> told = new ArrayList<>();
    CalendarQueue queue = telling(told, count);
    Random random = new Random(count);
    for (int i = 0; i < count; i++) {
      queue.set(i, random.nextInt(count / 2 + 1));
    }
    for (int taken = 0; taken < count; taken++) {
      int first = queue.first();
      assertThat(told).contains(first);
      assertThat(told.size() - taken).isLessThanOrEqualTo(count - taken);
      queue.clear(first);
    }
    assertThat(told).doesNotHaveDuplicates();
  }

  /**
   * Events at one moment are prefetched up to a limit: the loads that a core can wait for at once.
   */
  @Test
  void tellsNoMoreThanThereIsRoomFor() {
    int count = 3 * CalendarQueue.MOST_PREFETCHED;
    List<Integer> told = new ArrayList<>();
    CalendarQueue queue = telling(told, count);
    for (int i = 0; i < count; i++) {
      queue.set(i, 1);
    }
    assertThat(queue.first()).isZero();
    assertThat(told).hasSize(CalendarQueue.MOST_PREFETCHED).doesNotHaveDuplicates();
  }

  /** Whether it waits for its turn or is among the next. */
  @Test
  void anEventIsSetInPlaceOfTheOneThatACircleHad() {
    CalendarQueue queue = new CalendarQueue(3, (i, j) -> i < j);
    assertThat(queue.time(2)).isEqualTo(NEVER);
    queue.set(0, 1);
    queue.set(1, 1.5);
    queue.set(2, 9);
    assertThat(queue.first()).isZero();
    queue.set(0, 2);
    queue.set(2, 1.75);
    for (int i : new int[] {1, 2, 0}) {
      assertThat(queue.first()).isEqualTo(i);
      assertThat(queue.poll(9)).isEqualTo(i);
    }
    assertThat(queue.first()).isEqualTo(Index.NONE);
  }

  @Test
  void isMadeForNoneToo() {
    assertThat(new CalendarQueue(0, (i, j) -> false).first()).isEqualTo(Index.NONE);
  }

  /**
   * An event put off and set to its old time again, with a later rank: what stood in the heap for
   * it before must not pass for it.
   */
  @Test
  void anEventPutOffAndBackStandsWhereItsNewRankPutsIt() {
    Twin twin = new Twin(2);
    twin.set(0, 1, 0, 1);
    twin.set(1, 1, 0, 5);
    twin.first();
    twin.set(0, 1e9, 0, 1);
    twin.set(0, 1, 0, 10);
    assertThat(twin.first()).isEqualTo(1);
  }

  /**
   * Where time hardly goes on, events far ahead are set again and again: stale ones must not stay.
   */
  @Test
  void theListsStayShortWhereTimeHardlyGoesOn() {
    Twin twin = new Twin(30);
    for (int i = 0; i < 30; i++) {
      twin.set(i, i == 0 ? 0 : 1 + i, 0, i);
    }
    int longest = 0;
    for (int step = 1; step <= 20_000; step++) {
      twin.poll(twin.first());
      twin.set(0, step * 1e-12, 0, 0);
      int other = 1 + step % 29;
      twin.set(other, 1e3 + step, 0, other);
      longest = Math.max(longest, twin.queue.overflow());
    }
    assertThat(longest).isLessThan(300);
  }
}
