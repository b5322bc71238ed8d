// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * The things between which a circle is stuck. They are gathered while it makes impact after impact
 * without getting anywhere; once it is jammed they are inert: not there, until something else
 * changes its velocity. Immutable.
 */
final class Jam {

  private static final Jam EMPTY = new Jam(new int[0], false);

  private final int[] codes;
  private final boolean inert;

  private Jam(int[] codes, boolean inert) {
    this.codes = codes;
    this.inert = inert;
  }

  /** A jam, or none yet, with one more thing. */
  static Jam with(Jam jam, int code) {
    Jam old = jam == null ? EMPTY : jam;
    if (old.contains(code)) {
      return old;
    }
    int[] more = Arrays.copyOf(old.codes, old.codes.length + 1);
    more[old.codes.length] = code;
    return new Jam(more, false);
  }

  /** The same things, made inert. */
  Jam made() {
    return new Jam(codes, true);
  }

  boolean isInert() {
    return inert;
  }

  boolean makesInert(int code) {
    return inert && contains(code);
  }

  private boolean contains(int code) {
    for (int other : codes) {
      if (other == code) {
        return true;
      }
    }
    return false;
  }
}
