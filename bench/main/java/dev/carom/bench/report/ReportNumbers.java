// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Spread;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.DoubleSummaryStatistics;
import java.util.Locale;
import java.util.function.DoubleFunction;
import java.util.stream.DoubleStream;

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
      return rounded(value, 2);
    }
    return String.format(Locale.ROOT, "%.1e", value).replace("e-0", "e-").replace("e+0", "e");
  }

  static String radii(double error) {
    return error(error) + " radii";
  }

  /** A count, its thousands set apart. */
  static String count(double value) {
    return Double.isNaN(value) ? "failed" : String.format(Locale.ROOT, "%,.0f", value);
  }

  /** A share in percent. */
  static String percent(double share) {
    double percent = 100 * share;
    return (percent >= 1000 ? count(percent) : error(percent)) + " %";
  }

  /** A part of a whole, to a tenth of a percent; all and none only if it is. */
  static String share(double part, double whole) {
    if (part == 0 || part == whole) {
      return part == 0 ? "0 %" : "100 %";
    }
    double percent = Math.max(0.1, Math.min(99.9, 100 * part / whole));
    return String.format(Locale.ROOT, "%.1f %%", percent);
  }

  /** A ratio, or a number of a few digits. */
  static String ratio(double value) {
    if (!Double.isFinite(value)) {
      return "none";
    }
    return value >= 1000 ? count(value) : rounded(value, 3);
  }

  /** The ratio of two numbers, in brackets the least and the greatest that the forks allow. */
  static String ratio(Spread a, Spread b) {
    String middle = ratio(a.middle() / b.middle());
    return a.forks() < 2
        ? middle
        : "%s (%s .. %s)".formatted(middle, ratio(a.low() / b.high()), ratio(a.high() / b.low()));
  }

  /** How many times as much: to a tenth below ten. */
  static String times(double value) {
    return value < 9.95 ? ratio(Math.round(10 * value) / 10.0) : count(value);
  }

  /** The least and the greatest of some numbers; one of them if they are told alike. */
  static String range(DoubleStream numbers, DoubleFunction<String> text) {
    DoubleSummaryStatistics all =
        numbers.filter(number -> !Double.isNaN(number)).summaryStatistics();
    if (all.getCount() == 0) {
      return "?";
    }
    String least = text.apply(all.getMin());
    String most = text.apply(all.getMax());
    return least.equals(most) ? least : least + " to " + most;
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

  /** So many digits, without zeros behind them. */
  static String rounded(double value, int digits) {
    return plain(new BigDecimal(value).round(new MathContext(digits)));
  }

  private static String plain(BigDecimal x) {
    return x.signum() == 0 ? "0" : x.stripTrailingZeros().toPlainString();
  }
}
