// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.math.BigDecimal;
import java.math.MathContext;

/** The second method for walls: decimal fractions, which are exact for doubles too. */
final class WallCheck {
  private static final MathContext DIGITS = new MathContext(60);

  private WallCheck() {}

  /** The least time of the four walls, to 60 digits; null if none is hit in the window. */
  static BigDecimal time(WallQuery q) {
    BigDecimal[] times = {
      wall(q.px(), q.xmin(), q.r(), q.vx()),
      wall(-q.px(), -q.xmax(), q.r(), -q.vx()),
      wall(q.py(), q.ymin(), q.r(), q.vy()),
      wall(-q.py(), -q.ymax(), q.r(), -q.vy())
    };
    BigDecimal least = null;
    for (BigDecimal time : times) {
      boolean sooner = time != null && (least == null || time.compareTo(least) < 0);
      least = sooner ? time : least;
    }
    return least == null || beyond(least, q.end()) ? null : least;
  }

  /** (p - wall - r) / -v, or 0 if that is negative; null if v does not lead to the wall. */
  private static BigDecimal wall(double p, double wall, double r, double v) {
    if (!(v < 0)) {
      return null;
    }
    BigDecimal gap = new BigDecimal(p).subtract(new BigDecimal(wall)).subtract(new BigDecimal(r));
    return gap.signum() <= 0 ? BigDecimal.ZERO : gap.divide(new BigDecimal(-v), DIGITS);
  }

  private static boolean beyond(BigDecimal time, double end) {
    return end == Double.POSITIVE_INFINITY
        ? Double.isInfinite(time.doubleValue())
        : time.compareTo(new BigDecimal(end)) > 0;
  }
}
