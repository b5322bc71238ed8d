// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;

/**
 * The things that are inert for a jammed circle: not there, until it gets away or something comes
 * from further off. Immutable; null stands for none.
 */
final class Jam {

  private final int[] codes;

  private Jam(int[] codes) {
    this.codes = codes;
  }

  /** A jam, or none yet, with one more thing. */
  static Jam with(Jam jam, int code) {
    if (jam == null) {
      return new Jam(new int[] {code});
    }
    if (jam.makesInert(code)) {
      return jam;
    }
    int[] more = Arrays.copyOf(jam.codes, jam.codes.length + 1);
    more[jam.codes.length] = code;
    return new Jam(more);
  }

  /** What is left of a jam when the codes below the first one of circles are dropped. */
  static Jam ofCircles(Jam jam, int first) {
    if (jam == null) {
      return null;
    }
    int[] left = Arrays.stream(jam.codes).filter(code -> code >= first).toArray();
    return left.length == jam.codes.length ? jam : left.length == 0 ? null : new Jam(left);
  }

  /** What is left of it without one thing, null for nothing. */
  Jam without(int code) {
    int[] left = Arrays.stream(codes).filter(other -> other != code).toArray();
    return left.length == 0 ? null : new Jam(left);
  }

  /** The same with other numbers for circles, whose codes begin at the first one. */
  Jam ofOtherCircles(int first, IntUnaryOperator number) {
    return new Jam(
        Arrays.stream(codes)
            .map(code -> code < first ? code : first + number.applyAsInt(code - first))
            .toArray());
  }

  int[] codes() {
    return codes.clone();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Jam that && Arrays.equals(codes, that.codes);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(codes);
  }

  boolean makesInert(int code) {
    for (int other : codes) {
      if (other == code) {
        return true;
      }
    }
    return false;
  }
}
