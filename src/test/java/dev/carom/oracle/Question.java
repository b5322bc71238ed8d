// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** A question that has an exact answer. */
public interface Question {

  /** The exact answer. */
  Truth truth();

  /**
   * Whether it makes sense; as a rule, whether all numbers but the end of the window are finite.
   */
  boolean isFair();

  /** Every number as a hexadecimal double. */
  String hex();
}
