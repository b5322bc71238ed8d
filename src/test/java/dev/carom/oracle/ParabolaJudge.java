// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.function.Function;

/** Compares answers about circles with a constant acceleration with the oracle. */
public final class ParabolaJudge {
  private static final double NORMAL_BOUND = 1e-15;

  private final Function<ParabolaQuery, Answer> detector;

  public ParabolaJudge(Function<ParabolaQuery, Answer> detector) {
    this.detector = detector;
  }

  /** Asks for queries of a family and judges the answers; a seed always gives the same queries. */
  public Tally judge(ParabolaFamily family, long seed, int queries) {
    Draw draw = new Draw(seed * 0x9E3779B97F4A7C15L ^ family.name().hashCode());
    Tally tally = new Tally();
    for (int i = 0; i < queries; i++) {
      judge(family.next(draw), tally, family.name() + ", seed " + seed + ", query " + i);
    }
    return tally;
  }

  private void judge(ParabolaQuery query, Tally tally, String source) {
    ParabolaContact truth = query.truth();
    tally.queries++;
    tally.hits += truth.hit() ? 1 : 0;
    try {
      Answer answer = detector.apply(query);
      if (truth.part() != answer.part()) {
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

  private static void judgeHit(
      ParabolaQuery query, ParabolaContact truth, Answer answer, Tally tally, String source) {
    if (truth.time() != answer.time()) {
      double ulps = truth.errorInUlps(answer.time());
      tally.worstUlps = Math.max(tally.worstUlps, ulps);
      tally.notNearest++;
      if (!(ulps <= 1)) {
        tally.beyondOneUlp++;
        tally.note(describe("time beyond 1 ulp", source, query, truth, answer.toString()));
      }
    }
    double error = truth.normal().error(answer.nx(), answer.ny());
    tally.worstNormal = Math.max(tally.worstNormal, error);
    if (!(error <= NORMAL_BOUND)) {
      tally.badNormals++;
      tally.note(describe("normal beyond 1e-15", source, query, truth, answer.toString()));
    }
  }

  private static String describe(
      String what, String source, ParabolaQuery query, ParabolaContact truth, String answer) {
    return String.join(
        "\n  ",
        what + ": " + source,
        query.hex(),
        query.toString(),
        "is   " + truth.part() + " at " + truth.time() + " normal " + truth.normal(),
        "said " + answer);
  }
}
