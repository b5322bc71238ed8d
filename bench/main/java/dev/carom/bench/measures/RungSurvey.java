// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.SweptCircle;
import dev.carom.bench.methods.RungCounts;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.Query;
import dev.carom.oracle.SegmentQuery;
import dev.carom.oracle.WallQuery;
import java.util.ArrayList;
import java.util.List;

/** Asks queries of every family and sees which rung answers. */
public final class RungSurvey {

  private RungSurvey() {}

  /** The number of families: how many rows a survey has. */
  public static int families() {
    return Families.all().size();
  }

  /**
   * Asks.
   *
   * @param queries how many of each family
   * @param seed the same seed gives the same queries
   * @param progress called after each family
   * @return one row a family
   * @throws IllegalStateException if the library has been used in this process uncounted
   */
  public static List<RungShare> of(int queries, long seed, Runnable progress) {
    RungCounts.enable();
    List<RungShare> shares = new ArrayList<>();
    for (Family<Query> family : Families.all()) {
      shares.add(of(family, queries, seed));
      progress.run();
    }
    return shares;
  }

  private static RungShare of(Family<Query> family, int queries, long seed) {
    Draw draw = Draw.of(seed, family.name());
    RungShare sum = RungShare.none(family.name());
    for (int i = 0; i < queries; i++) {
      sum = sum.plus(of(family.next(draw)));
    }
    return sum;
  }

  private static RungShare of(Query query) {
    RungCounts before = RungCounts.now();
    double time = time(query);
    RungCounts counts = RungCounts.now().since(before);
    boolean exact = counts.exactDecisions() > 0;
    boolean plain = counts.doubtfulDecisions() == 0;
    boolean timed = time > 0 && time < Double.POSITIVE_INFINITY;
    boolean exactTime = timed && counts.exactTimes() > 0;
    return new RungShare(
        "", 1, one(plain), one(!plain && !exact), one(exact), one(timed), one(exactTime));
  }

  private static long one(boolean counted) {
    return counted ? 1 : 0;
  }

  private static double time(Query query) {
    double[] n = query.numbers();
    if (query instanceof SegmentQuery) {
      return new SweptCircle(n[4], n[5], n[6], n[7], n[8]).timeToLine(n[0], n[1], n[2], n[3], n[9]);
    }
    if (query instanceof WallQuery) {
      return new SweptCircle(n[0], n[1], n[2], n[3], n[4])
          .timeToBounds(n[5], n[6], n[7], n[8], n[9]);
    }
    PairQuery pair = (PairQuery) query;
    return new SweptCircle(n[0], n[1], n[2], n[3], n[4])
        .timeToCircle(new SweptCircle(n[5], n[6], n[7], n[8], n[9]), pair.end());
  }
}
