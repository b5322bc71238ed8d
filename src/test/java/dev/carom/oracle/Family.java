// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.function.Function;

/**
 * A kind of query.
 *
 * @param name as in the files of cases
 * @param generator makes one
 */
public record Family(String name, Function<Draw, Query> generator) {

  /**
   * The next query, mirrored at random, so that no direction is preferred. All numbers are finite,
   * but for the end of the window, which sometimes is not.
   */
  public Query next(Draw d) {
    Query query = generator.apply(d);
    while (!query.isFinite()) {
      query = generator.apply(d);
    }
    double[] n = query.numbers();
    if (!name.endsWith("window_end")) {
      n[n.length - 1] = window(d, n[n.length - 1]);
    }
    return Mirror.any(d, query.with(n));
  }

  /** In one of twenty the window has no end, in one of a hundred it is the moment 0 alone. */
  private static double window(Draw d, double end) {
    double choice = d.in(0, 1);
    return choice < 0.05 ? Double.POSITIVE_INFINITY : choice < 0.06 ? 0 : end;
  }
}
