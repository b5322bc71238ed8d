// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** A question that has an exact answer. */
public interface Question {

  /** The exact answer. */
  Truth truth();

  /** Every number as a hexadecimal double. */
  String hex();
}
