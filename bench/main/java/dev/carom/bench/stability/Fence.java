// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

/** Where the centre of a circle cannot be unless it went through something. */
@FunctionalInterface
interface Fence {

  /** For scenes that nothing encloses. */
  Fence NONE = (x, y) -> false;

  /** Whether a place is beyond the fence. */
  boolean isBeyond(double x, double y);
}
