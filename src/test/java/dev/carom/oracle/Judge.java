// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.function.Function;

/**
 * Compares a detector with the oracle: the decisions (hit or miss, and the feature), the times of
 * impact and the normals.
 */
public final class Judge<Q extends Question> {
  private static final double NORMAL_BOUND = 1e-15;

  private final Function<Q, Answer> detector;

  public Judge(Function<Q, Answer> detector) {
    this.detector = detector;
  }

  /** Asks for queries of a family and judges the answers; a seed always gives the same queries. */
  public Tally judge(Family<Q> family, long seed, int queries) {
    Draw draw = Draw.of(seed, family.name());
    Tally tally = new Tally();
    for (int i = 0; i < queries; i++) {
      judge(family.next(draw), tally, family.name() + ", seed " + seed + ", query " + i);
    }
    return tally;
  }

  /** Judges the answer to one query; the name of its source begins the description of a failure. */
  public void judge(Q query, Tally tally, String source) {
    Truth truth = query.truth();
    tally.queries++;
    tally.hits += truth.hit() ? 1 : 0;
    try {
      Answer answer = detector.apply(query);
      if (!agrees(truth, answer)) {
        tally.wrongDecisions++;
        tally.note(describe("wrong decision", source, query, truth, answer.toString()));
      } else if (truth.hit()) {
        judgeHit(query, truth, answer, tally, source);
      }
    } catch (RuntimeException | AssertionError e) {
      tally.wrongDecisions++;
      tally.note(describe("threw", source, query, truth, e.toString()));
    }
  }

  /** The same feature or miss, and the time of a miss is infinite. */
  private static boolean agrees(Truth truth, Answer answer) {
    return truth.part() == answer.part()
        && (truth.hit() || answer.time() == Double.POSITIVE_INFINITY);
  }

  private static void judgeHit(
      Question query, Truth truth, Answer answer, Tally tally, String source) {
    if (truth.time() != answer.time()) {
      double ulps = Math.abs(truth.errorInUlps(answer.time()));
      tally.worstUlps = Math.max(tally.worstUlps, ulps);
      tally.notNearest++;
      if (!(ulps <= 1)) {
        tally.beyondOneUlp++;
        tally.note(describe("time beyond 1 ulp", source, query, truth, answer.toString()));
      }
    }
    double error = truth.normalError(answer.nx(), answer.ny());
    tally.worstNormal = Math.max(tally.worstNormal, error);
    if (!(error <= NORMAL_BOUND)) {
      tally.badNormals++;
      tally.note(describe("normal beyond 1e-15", source, query, truth, answer.toString()));
    }
  }

  private static String describe(
      String what, String source, Question query, Truth truth, String answer) {
    return String.join(
        "\n  ",
        what + ": " + source,
        query.hex(),
        query.toString(),
        "is   " + truth + " rounded " + Double.toHexString(truth.time()),
        "said " + answer);
  }
}
