// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** What is hit: the oracle's own word for the feature, with one for a miss. */
public enum Part {
  SIDE,
  START,
  END,
  CIRCLE,
  NONE
}
