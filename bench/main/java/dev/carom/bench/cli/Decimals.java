// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import com.fasterxml.jackson.core.io.schubfach.DoubleToDecimal;
import java.math.BigDecimal;

/**
 * Numbers as text. {@link Double#toString(double)} writes more digits than needed before JDK 19
 * (JDK-4511638), so the same run would give different files on different machines.
 */
final class Decimals {

  private Decimals() {}

  /** The shortest decimal that reads back as the same double, in Java's notation. */
  static String shortest(double value) {
    return DoubleToDecimal.toString(value);
  }

  /** The same digits without exponent and without zeros at the end, for a finite value. */
  static String plain(double value) {
    return new BigDecimal(shortest(value)).stripTrailingZeros().toPlainString();
  }
}
