// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.util.HashMap;
import java.util.Map;
import java.util.TreeSet;

/** The times at which circles were moved by hand: they jumped then, and left no trail. */
final class EditTimes {

  private final Map<Integer, TreeSet<Double>> times = new HashMap<>();

  void add(int circle, double time) {
    times.computeIfAbsent(circle, id -> new TreeSet<>()).add(time);
  }

  /** The last such time up to a moment, minus infinity if there is none. */
  double last(int circle, double upTo) {
    TreeSet<Double> own = times.get(circle);
    Double last = own == null ? null : own.floor(upTo);
    return last == null ? Double.NEGATIVE_INFINITY : last;
  }

  void forgetAfter(double time) {
    times.values().forEach(own -> own.tailSet(time, false).clear());
  }

  void clear() {
    times.clear();
  }
}
