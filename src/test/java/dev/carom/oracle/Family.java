// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.function.Function;

/**
 * A kind of question.
 *
 * @param name as in tables and in the files of cases
 * @param generator makes one
 */
public record Family<Q extends Question>(String name, Function<Draw, Q> generator) {

  /** The next question that makes sense. */
  public Q next(Draw d) {
    Q question = generator.apply(d);
    while (!question.isFair()) {
      question = generator.apply(d);
    }
    return question;
  }

  /**
   * A family of queries that are mirrored at random, so that no direction is preferred. The end of
   * the window sometimes is infinite.
   */
  static Family<Query> mirrored(String name, Function<Draw, Query> generator) {
    Family<Query> plain = new Family<>(name, generator);
    return new Family<>(name, d -> mirrored(d, plain.next(d), !name.endsWith("window_end")));
  }

  private static Query mirrored(Draw d, Query query, boolean anyWindow) {
    double[] n = query.numbers();
    if (anyWindow) {
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
