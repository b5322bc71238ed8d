// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class MovingCircleTest {

  private static BigDecimal exact(double x) {
    return new BigDecimal(x);
  }

  private static MovingCircle body(double t, double tl) {
    MovingCircle m = new MovingCircle();
    m.start(0, 1, 2, 1, 1, 3, 1);
    m.t = t;
    m.tl = tl;
    return m;
  }

  /** A thousand flights of a tenth, each a little off a tenth, from a late time on. */
  @Test
  void theClockKeepsTwiceTheDigits() {
    MovingCircle m = body(1e6, 0);
    BigDecimal time = exact(m.t);
    for (int i = 0; i < 1000; i++) {
      double dt = 0.1 + i * 1e-9;
      assertThat(m.after(dt)).isEqualTo(exact(m.t).add(exact(m.tl)).add(exact(dt)).doubleValue());
      m.advance(dt);
      time = time.add(exact(dt));
      assertThat(m.t).isEqualTo(time.doubleValue());
      BigDecimal error = exact(m.t).add(exact(m.tl)).subtract(time).abs();
      assertThat(error).isLessThan(exact(1e6 * 0x1p-96));
    }
    assertThat(m.tl).isNotZero();
  }

  @Test
  void anEditBeginsWhereItIsByThen() {
    MovingCircle m = body(0x1p53, -0.5);
    m.restart(0x1p53 + 2, 0, ObstacleTable.empty(null));
    assertThat(m.x).isEqualTo(3.5);
    assertThat(m.y).isEqualTo(9.5);
    assertThat(m.t).isEqualTo(0x1p53 + 2);
    assertThat(m.tl).isZero();
    m.restart(0x1p53 + 2, 0.75, ObstacleTable.empty(null));
    assertThat(m.x).isEqualTo(4.25);
    assertThat(m.tl).isEqualTo(0.75);
  }

  /** Not before the flight begins: it has just come from elsewhere. */
  @Test
  void aFlightThatBeginsAfterATimeWithTheSameHeadIsAtItsStart() {
    assertThat(MovingCircle.since(1, 0x1p-60, 1)).isZero();
    assertThat(MovingCircle.since(1, -0x1p-60, 1)).isEqualTo(0x1p-60);
    assertThat(MovingCircle.since(1, 0x1p-60, 2)).isEqualTo(1);
  }

  @Test
  void aRoundedPlaceLacksWhatIsLeft() {
    assertThat(MovingCircle.lack(1, 1e20, 1, 1e20)).isOne();
    assertThat(MovingCircle.lack(1, 0x1p-60, 3, 1)).isEqualTo(0x1.8p-59);
  }

  /** Half an ulp and a bit: to the nearest of all that, not of its parts. */
  @Test
  void timesAreRoundedOnce() {
    assertThat(MovingCircle.sum(1.25, 0x1p-58, 0x1.8000000000004p-3))
        .isEqualTo(0x1.7000000000001p0);
    assertThat(MovingCircle.sum(1.25, -0x1p-58, 0x1.8000000000004p-3)).isEqualTo(0x1.7p0);
  }

  /** Late in a long flight, early in one, and where many lengths of time are told alike. */
  @Test
  void theLatestTimeByNowIsTheLastThatTheClockTellsSo() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 10_000; i++) {
      double t = random.nextDouble() * Math.scalb(1.0, random.nextInt(-30, 30));
      double tl = (random.nextDouble() - 0.5) * Math.ulp(t);
      double now = t + random.nextDouble() * Math.scalb(1.0, random.nextInt(-80, 30));
      MovingCircle m = body(t, tl);
      double latest = m.latestBy(now);
      assertThat(latest).isNotNegative();
      assertThat(m.after(latest)).isLessThanOrEqualTo(now);
      assertThat(m.after(Math.nextUp(latest))).isGreaterThan(now);
    }
  }
}
