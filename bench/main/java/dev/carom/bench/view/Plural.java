// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.util.Locale;

/** Counted things. */
final class Plural {

  private Plural() {}

  /** The number and the thing, as many of which as it says. */
  static String of(long n, String thing) {
    return String.format(Locale.ROOT, "%,d %s%s", n, thing, n == 1 ? "" : "s");
  }
}
