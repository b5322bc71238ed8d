// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** The feature that is hit: the oracle's own enum, with a word for a miss. */
public enum Part {
  SIDE,
  START,
  END,
  CIRCLE,
  NONE
}
