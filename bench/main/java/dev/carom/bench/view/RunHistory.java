// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.ImpactLog;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

/**
 * The impacts of a run and the costs of its ticks, by time, to be told of any moment. Its memory is
 * bounded: the oldest impacts and ticks go first, but all impacts are counted.
 */
final class RunHistory {

  /** Impacts, or ticks, that are kept. */
  private static final int KEPT = 100_000;

  /** Ticks whose median is told: those of a second. */
  private static final int WINDOW = 60;

  /**
   * A call that moved the world on.
   *
   * @param from the time of the world before
   * @param to its time after
   * @param nanos how long the call took
   */
  private record Tick(double from, double to, long nanos) {}

  private List<Mark> marks = new ArrayList<>();
  private List<Tick> ticks = new ArrayList<>();

  /** Impacts that are no longer kept. */
  private long dropped;

  void add(double from, double to, long nanos, ImpactLog log) {
    for (int row = 0; row < log.size(); row++) {
      marks.add(Mark.of(log, row));
    }
    ticks.add(new Tick(from, to, nanos));
    int before = marks.size();
    marks = bounded(marks);
    dropped += before - marks.size();
    ticks = bounded(ticks);
  }

  /** The newest ones, once there are twice as many as are kept. */
  private static <T> List<T> bounded(List<T> list) {
    int size = list.size();
    return size < 2 * KEPT ? list : new ArrayList<>(list.subList(size - KEPT, size));
  }

  /** Forgets the impacts after a time, and the ticks that began at it or later. */
  void forgetAfter(double time) {
    marks.subList(upTo(marks, Mark::time, time), marks.size()).clear();
    ticks.subList(upTo(ticks, Tick::from, Math.nextDown(time)), ticks.size()).clear();
  }

  /** The impacts up to a time. */
  long impacts(double time) {
    return dropped + upTo(marks, Mark::time, time);
  }

  /** The impacts after a time and up to another one, at most so many of the newest, in order. */
  List<Mark> marks(double after, double upTo, int most) {
    int end = upTo(marks, Mark::time, upTo);
    int begin = Math.max(upTo(marks, Mark::time, after), end - most);
    return List.copyOf(marks.subList(Math.min(begin, end), end));
  }

  /** The time of the first impact after a time, infinity if none is known. */
  double next(double after) {
    int i = upTo(marks, Mark::time, after);
    return i < marks.size() ? marks.get(i).time() : Double.POSITIVE_INFINITY;
  }

  /** What a frame took on the way to a moment: the median of the last second, in nanoseconds. */
  OptionalDouble frameNanos(double time, double frame) {
    int end = Math.min(ticks.size(), upTo(ticks, Tick::from, Math.nextDown(time)));
    double[] nanos =
        ticks.subList(Math.max(0, end - WINDOW), end).stream()
            .filter(tick -> tick.to() > tick.from())
            .mapToDouble(tick -> tick.nanos() * frame / (tick.to() - tick.from()))
            .sorted()
            .toArray();
    return nanos.length == 0 ? OptionalDouble.empty() : OptionalDouble.of(nanos[nanos.length / 2]);
  }

  /** How many of a list, ascending by a key, have at most that key. */
  private static <T> int upTo(List<T> list, ToDoubleFunction<T> key, double most) {
    int low = 0;
    int high = list.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (key.applyAsDouble(list.get(middle)) <= most) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
}
