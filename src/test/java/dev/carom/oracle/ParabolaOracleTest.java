// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Answers that are known otherwise, and whether the judge can tell a wrong one. */
class ParabolaOracleTest {
  private static final double FOREVER = Double.POSITIVE_INFINITY;

  private static ParabolaContact peg(
      double x, double y, double r, double vx, double vy, double gx, double gy) {
    return new ParabolaQuery(new PairQuery(x, y, r, vx, vy, 0, 0, 0, 0, 0, FOREVER), gx, gy)
        .truth();
  }

  /** A line from (0, 0) to (10, 0). */
  private static ParabolaContact line(
      double x, double y, double r, double vx, double vy, double gx, double gy) {
    SegmentQuery straight = new SegmentQuery(0, 0, 10, 0, x, y, r, vx, vy, FOREVER);
    return new ParabolaQuery(straight, gx, gy).truth();
  }

  @ParameterizedTest(name = "{0}")
  @CsvSource({
    "falls from rest,              0, 9, 1, 0, 0, 0, -4,     2",
    "is thrown up and falls,       0, 1, 1, 0, 2, 0, -1,     4",
    "throws itself up and touches, 0, -9, 1, 0, 8, 0, -4,    Infinity",
    "and a bit more,               0, -9, 1, 0, 10, 0, -4,   1",
    "rests and is supported,       0, 1, 1, 0, 0, 0, -1,     0",
    "rests and is pulled off,      0, 1, 1, 0, 0, 0, 1,      Infinity",
    "rolls too fast,               0, 1, 1, 2, 0, 0, -1,     Infinity",
    "rolls as the circle bends,    0, 1, 1, 1, 0, 0, -1,     Infinity",
    "rolls slowly,                 0, 1, 1, 0.5, 0, 0, -1,   0",
    "turns back inside,            0, 0.5, 1, 0, 0.5, 0, -1, 0.5",
    "leaves and comes back,        0, 0.5, 1, 0, 2, 0, -2,   1.7071067811865475",
    "concentric and at rest,       0, 0, 1, 0, 0, 0, -1,     Infinity"
  })
  void knowsWhenAPegIsHit(
      String name,
      double x,
      double y,
      double r,
      double vx,
      double vy,
      double gx,
      double gy,
      double time) {
    assertThat(peg(x, y, r, vx, vy, gx, gy).time()).isEqualTo(time);
  }

  @ParameterizedTest(name = "{0}")
  @CsvSource({
    "falls on the side,            5, 9, 1, 0, 0, 0, -4,    SIDE, 2",
    "falls beside the end,         -2, 9, 1, 0, 0, 0, -4,   NONE, Infinity",
    "falls exactly on the end,     0, 9, 1, 0, 0, 0, -4,    START, 2",
    "slides over the end,          10, 1, 1, 1, 0, 0, -1,   NONE, Infinity",
    "slides on to the side,        0, 1, 1, 1, 0, 0, -1,    START, 0",
    "passes over a corner,         -1, 0.5, 1, 1, 1, 0, -1, START, 1",
    "a point falls on the end,     10, 2, 0, 0, 0, 0, -1,   END, 2",
    "a point grazes from below,    5, -2, 0, 0, 2, 0, -1,   NONE, Infinity",
    "a point slides into the end,  -2, 0, 0, 0, 0, 1, 0,    START, 2"
  })
  void knowsWhatOfALineIsHit(
      String name,
      double x,
      double y,
      double r,
      double vx,
      double vy,
      double gx,
      double gy,
      Part part,
      double time) {
    ParabolaContact contact = line(x, y, r, vx, vy, gx, gy);
    assertThat(contact.part()).isEqualTo(part);
    assertThat(contact.time()).isEqualTo(time);
  }

  /** A foil that misses all. */
  @Test
  void theJudgeSeesThatNothingIsEverHit() {
    Judge<ParabolaQuery> judge = new Judge<>(query -> Answer.MISS);
    Tally tally = new Tally();
    for (Family<ParabolaQuery> family : ParabolaFamilies.all()) {
      tally = tally.plus(judge.judge(family, 1, 2));
    }
    assertThat(tally.wrongDecisions()).isEqualTo(tally.hits).isGreaterThan(40);
  }

  @Test
  void theJudgeSeesATimeAnUlpOff() {
    Family<ParabolaQuery> uniform = ParabolaFamilies.all().get(0);
    Judge<ParabolaQuery> judge =
        new Judge<>(
            query -> {
              ParabolaContact truth = query.truth();
              Normal n = truth.normal();
              return truth.hit()
                  ? new Answer(Math.nextUp(truth.time()), truth.part(), n.x().near(), n.y().near())
                  : Answer.MISS;
            });
    Tally tally = judge.judge(uniform, 1, 20);
    assertThat(tally.notNearest()).isEqualTo(tally.hits).isPositive();
    assertThat(tally.wrongDecisions()).isZero();
    assertThat(tally.badNormals).isZero();
  }
}
