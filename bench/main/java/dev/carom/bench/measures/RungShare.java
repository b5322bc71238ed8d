// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.results.Row;
import java.util.List;

/**
 * How many queries each rung of precision answered. A query counts for the highest rung that one of
 * its decisions needed. The rounding of its time is counted apart.
 *
 * @param family the kind of queries
 * @param plain decided by plain doubles
 * @param doubleDouble decided by double-double, or by sums without rounding
 * @param exact decided by exact numbers
 * @param times the queries with an impact after time 0, whose time was to be rounded
 * @param exactTimes of them, those that exact numbers rounded; double-double did the others
 */
public record RungShare(
    String family,
    long queries,
    long plain,
    long doubleDouble,
    long exact,
    long times,
    long exactTimes) {

  /**
   * Nothing asked yet.
   *
   * @param family the kind of queries
   * @return zeros
   */
  static RungShare none(String family) {
    return new RungShare(family, 0, 0, 0, 0, 0, 0);
  }

  /** The times that double-double rounded. */
  public long doubleDoubleTimes() {
    return times - exactTimes;
  }

  /** As rows: the counts, by the names of the rungs. */
  public List<Row> rows() {
    return List.of(
        row("rungs", "asked", queries),
        row("rungs", "double", plain),
        row("rungs", "double-double", doubleDouble),
        row("rungs", "exact", exact),
        row("rungs_of_times", "asked", times),
        row("rungs_of_times", "double-double", doubleDoubleTimes()),
        row("rungs_of_times", "exact", exactTimes));
  }

  private Row row(String metric, String stat, long count) {
    return new Row("query:" + family, "carom", "", metric, stat, (double) count, "1", queries, -1);
  }

  /** The sum of two counts, with the name of this one. */
  public RungShare plus(RungShare other) {
    return new RungShare(
        family,
        queries + other.queries,
        plain + other.plain,
        doubleDouble + other.doubleDouble,
        exact + other.exact,
        times + other.times,
        exactTimes + other.exactTimes);
  }
}
