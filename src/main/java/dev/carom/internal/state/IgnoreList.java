// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;

/**
 * The things that are inert for a jammed circle: not there, until it gets away or something comes
 * from further off. Immutable; null stands for none.
 */
public final class IgnoreList {

  /** Of what is inert; of an infinite mass that crushed the circle, the complement. */
  private final int[] codes;

  private IgnoreList(int[] codes) {
    this.codes = codes;
  }

  /** A jam, or none yet, with one more thing. */
  public static IgnoreList with(IgnoreList jam, int code) {
    return withEntry(jam, code);
  }

  /** A jam, or none yet, of a circle that an infinite mass crushed, which passes over it. */
  public static IgnoreList crushedBy(IgnoreList jam, int code) {
    return withEntry(jam, ~code);
  }

  private static IgnoreList withEntry(IgnoreList jam, int code) {
    if (jam == null) {
      return new IgnoreList(new int[] {code});
    }
    if (jam.contains(code)) {
      return jam;
    }
    int[] more = Arrays.copyOf(jam.codes, jam.codes.length + 1);
    more[jam.codes.length] = code;
    return new IgnoreList(more);
  }

  /** What is left of a jam when the codes below the first one of circles are dropped. */
  public static IgnoreList ofCircles(IgnoreList jam, int first) {
    if (jam == null) {
      return null;
    }
    int[] left = Arrays.stream(jam.codes).filter(code -> code >= first || code < 0).toArray();
    return left.length == jam.codes.length ? jam : left.length == 0 ? null : new IgnoreList(left);
  }

  /** What is left of it without one thing, null for nothing. */
  public IgnoreList without(int code) {
    int[] left = Arrays.stream(codes).filter(other -> other != code && other != ~code).toArray();
    return left.length == 0 ? null : new IgnoreList(left);
  }

  /** The same with other numbers for circles, whose codes begin at the first one. */
  IgnoreList ofOtherCircles(int first, IntUnaryOperator number) {
    return new IgnoreList(
        Arrays.stream(codes)
            .map(code -> code < 0 ? ~other(~code, first, number) : other(code, first, number))
            .toArray());
  }

  private static int other(int code, int first, IntUnaryOperator number) {
    return code < first ? code : first + number.applyAsInt(code - first);
  }

  /** What is inert; the complements of those infinite masses that crushed the circle. */
  public int[] codes() {
    return codes.clone();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof IgnoreList that && Arrays.equals(codes, that.codes);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(codes);
  }

  public boolean makesInert(int code) {
    return contains(code);
  }

  public boolean isCrushedBy(int code) {
    return contains(~code);
  }

  /** Whether a thing is inert, or crushed the circle. */
  public boolean concerns(int code) {
    return contains(code) || contains(~code);
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
