// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.ImpactLog;
import java.util.ArrayList;
import java.util.List;

/**
 * The impacts of a run, to be told of any moment. Its memory is bounded: the oldest impacts go
 * first, but all are counted.
 */
final class RunHistory {

  /** Impacts that are kept. */
  private static final int KEPT = 100_000;

  private List<Mark> marks = new ArrayList<>();

  /** Impacts that are no longer kept. */
  private long dropped;

  void add(ImpactLog log) {
    for (int row = 0; row < log.size(); row++) {
      marks.add(Mark.of(log, row));
    }
    int size = marks.size();
    if (size >= 2 * KEPT) {
      marks = new ArrayList<>(marks.subList(size - KEPT, size));
      dropped += size - KEPT;
    }
  }

  /** Forgets the impacts after a time. */
  void forgetAfter(double time) {
    marks.subList(upTo(time), marks.size()).clear();
  }

  /** The impacts up to a time. */
  long impacts(double time) {
    return dropped + upTo(time);
  }

  /** The impacts after a time and up to another one, at most so many of the newest, in order. */
  List<Mark> marks(double after, double upTo, int most) {
    int end = upTo(upTo);
    int begin = Math.max(upTo(after), end - most);
    return List.copyOf(marks.subList(Math.min(begin, end), end));
  }

  /** The time of the first impact after a time, infinity if none is known. */
  double next(double after) {
    int i = upTo(after);
    return i < marks.size() ? marks.get(i).time() : Double.POSITIVE_INFINITY;
  }

  /** How many impacts there are up to a time, of those that are kept. */
  private int upTo(double time) {
    int low = 0;
    int high = marks.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (marks.get(middle).time() <= time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
}
