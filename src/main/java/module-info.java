// SPDX-License-Identifier: Apache-2.0

/** Circles that move and bounce: see the one exported package, {@link dev.carom}. */
module dev.carom {
  exports dev.carom;
}
