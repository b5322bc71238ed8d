// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * The things between which a circle is stuck. They are gathered while it makes impact after impact
 * without getting anywhere; once it is jammed they are inert: not there for it, until it gets away
 * or something comes from further off. Immutable.
 */
final class Jam {

  private static final Jam EMPTY = new Jam(new int[0], 0);

  private final int[] codes;

  /** The first so many codes are inert. */
  private final int inert;

  private Jam(int[] codes, int inert) {
    this.codes = codes;
    this.inert = inert;
  }

  /** A jam, or none yet, with one more thing. */
  static Jam with(Jam jam, int code) {
    Jam old = jam == null ? EMPTY : jam;
    int n = old.codes.length;
    if (contains(old.codes, n, code)) {
      return old;
    }
    int[] more = Arrays.copyOf(old.codes, n + 1);
    more[n] = code;
    return new Jam(more, old.inert);
  }

  /** The same things, all made inert. */
  Jam made() {
    return inert == codes.length ? this : new Jam(codes, codes.length);
  }

  boolean makesInert(int code) {
    return contains(codes, inert, code);
  }

  private static boolean contains(int[] codes, int first, int code) {
    for (int i = 0; i < first; i++) {
      if (codes[i] == code) {
        return true;
      }
    }
    return false;
  }
}
