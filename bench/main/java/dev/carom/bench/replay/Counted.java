// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import java.util.Locale;

/** Numbers with their nouns: 1 circle, 2 circles. */
public final class Counted {

  private Counted() {}

  /**
   * A number with a noun whose plural ends in s.
   *
   * @param noun in the singular
   * @return both, the thousands set apart
   */
  public static String of(long n, String noun) {
    return of(n, noun, noun + "s");
  }

  /**
   * A number with a noun.
   *
   * @param one the noun in the singular
   * @param many in the plural
   * @return both, the thousands set apart
   */
  public static String of(long n, String one, String many) {
    return String.format(Locale.ROOT, "%,d %s", n, n == 1 ? one : many);
  }
}
