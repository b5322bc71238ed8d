// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import java.util.List;
import java.util.Locale;

/** The shares for people: one row a family, and one for all. */
public final class RungTable {

  private RungTable() {}

  /**
   * Renders shares.
   *
   * @param shares one a family
   * @return the table
   */
  public static String render(List<RungShare> shares) {
    StringBuilder text = new StringBuilder();
    text.append(row("", "decided", "by", "", "with a", "rounded", "by"));
    text.append(row("family", "plain", "dbl-dbl", "exact", "time", "dbl-dbl", "exact"));
    shares.forEach(share -> text.append(row(share)));
    text.append(row(shares.stream().reduce(RungShare.none("all"), RungShare::plus)));
    return text.toString();
  }

  private static String row(RungShare s) {
    return row(
        s.family(),
        percent(s.plain(), s.queries()),
        percent(s.doubleDouble(), s.queries()),
        percent(s.exact(), s.queries()),
        percent(s.times(), s.queries()),
        percent(s.doubleDoubleTimes(), s.times()),
        percent(s.exactTimes(), s.times()));
  }

  private static String row(Object... cells) {
    return String.format(Locale.ROOT, "%-24s %9s %9s %9s %9s %9s %9s", cells).stripTrailing()
        + "\n";
  }

  /** A dash for none at all, which a rounded 0.00 need not be. */
  private static String percent(long part, long whole) {
    return part == 0 ? "-" : String.format(Locale.ROOT, "%.2f %%", 100.0 * part / whole);
  }
}
