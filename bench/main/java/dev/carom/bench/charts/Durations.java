// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.math.BigDecimal;
import java.math.MathContext;

/** Times as people read them: few digits, and the unit that needs the fewest. */
final class Durations {

  private Durations() {}

  /** With at most so many significant digits: 612 ns, 1.27 µs, 16.67 ms, 2 s. */
  static String text(double nanos, int digits) {
    BigDecimal rounded = new BigDecimal(nanos).round(new MathContext(digits));
    int unit = 0;
    while (unit < UNITS.length - 1 && rounded.compareTo(THOUSAND) >= 0) {
      rounded = rounded.movePointLeft(3);
      unit++;
    }
    return plain(rounded) + " " + UNITS[unit];
  }

  /** A number with at most so many significant digits, its thousands set apart: 27,000. */
  static String number(double x, int digits) {
    BigDecimal rounded = new BigDecimal(x).round(new MathContext(digits));
    String whole = plain(rounded);
    int point = whole.indexOf('.') < 0 ? whole.length() : whole.indexOf('.');
    StringBuilder text = new StringBuilder(whole);
    for (int i = point - 3; i > 0; i -= 3) {
      text.insert(i, ',');
    }
    return text.toString();
  }

  private static String plain(BigDecimal x) {
    return x.signum() == 0 ? "0" : x.stripTrailingZeros().toPlainString();
  }

  private static final BigDecimal THOUSAND = BigDecimal.valueOf(1000);
  private static final String[] UNITS = {"ns", "µs", "ms", "s"};
}
