// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Spread;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;

/** Numbers as the report prints them. */
final class ReportNumbers {

  private static final String[] UNITS = {"ns", "µs", "ms", "s"};

  private ReportNumbers() {}

  /** A time with three digits and its unit. */
  static String time(double nanos) {
    if (!Double.isFinite(nanos)) {
      return "no time";
    }
    BigDecimal rounded = new BigDecimal(nanos).round(new MathContext(3));
    int unit = 0;
    while (unit < UNITS.length - 1 && rounded.compareTo(BigDecimal.valueOf(1000)) >= 0) {
      rounded = rounded.movePointLeft(3);
      unit++;
    }
    return plain(rounded) + " " + UNITS[unit];
  }

  /** An error: plain in the middle, with an exponent far from 1, 0 as it is. */
  static String error(double value) {
    if (Double.isNaN(value)) {
      return "failed";
    }
    if (value == 0 || Double.isInfinite(value)) {
      return value == 0 ? "0" : "infinite";
    }
    double size = Math.abs(value);
    if (size >= 1e-3 && size < 1e6) {
      return plain(new BigDecimal(value).round(new MathContext(2)));
    }
    return String.format(Locale.ROOT, "%.1e", value).replace("e-0", "e-").replace("e+0", "e");
  }

  /** A count, its thousands set apart. */
  static String count(double value) {
    return Double.isNaN(value) ? "failed" : String.format(Locale.ROOT, "%,.0f", value);
  }

  /** A ratio, or a number of a few digits. */
  static String ratio(double value) {
    if (!Double.isFinite(value)) {
      return "none";
    }
    return value >= 1000 ? count(value) : plain(new BigDecimal(value).round(new MathContext(3)));
  }

  /** A median, and in brackets from where to where forks reach. */
  static String spread(Spread spread) {
    if (spread.forks() < 2 || spread.failed()) {
      return time(spread.middle());
    }
    return time(spread.middle()) + " (" + time(spread.low()) + " .. " + time(spread.high()) + ")";
  }

  /**
   * Failures of n: none is told with the bound that it proves at a confidence of 95 %, about 3/n
   * (J. A. Hanley, A. Lippman-Hand, 1983).
   */
  static String failures(double failed, double n) {
    if (failed > 0) {
      return count(failed) + " of " + count(n);
    }
    return "0 of " + count(n) + " (below " + error(300 / n) + " % at 95 %)";
  }

  private static String plain(BigDecimal x) {
    return x.signum() == 0 ? "0" : x.stripTrailingZeros().toPlainString();
  }
}
