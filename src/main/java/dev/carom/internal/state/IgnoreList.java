// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.function.IntUnaryOperator;

/**
 * The obstacles and circles that a jammed circle ignores, until it gets away or something
 * approaches from further off. Immutable; null stands for an empty list.
 */
public final class IgnoreList {

  /**
   * The {@link Codes} of the things that are ignored; ~code for a moving obstacle or an infinite
   * mass that crushed the circle.
   */
  private final int[] entries;

  private IgnoreList(int[] entries) {
    this.entries = entries;
  }

  /** The list of these entries, codes or their complements, each once; null if there is none. */
  public static IgnoreList of(int... entries) {
    return entries.length == 0 ? null : new IgnoreList(entries);
  }

  /** The code in an entry. */
  public static int code(int entry) {
    return entry < 0 ? ~entry : entry;
  }

  /** Whether an entry is that of something that crushed the circle. */
  public static boolean crushes(int entry) {
    return entry < 0;
  }

  /** Whether anything in the list crushed the circle. */
  boolean hasCrushers() {
    for (int entry : entries) {
      if (crushes(entry)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Adds a moving obstacle or an infinite mass that crushed the circle. The circle ignores it while
   * it passes over the circle.
   */
  public static IgnoreList crushedBy(IgnoreList jam, int code) {
    return with(jam, ~code);
  }

  /** Adds an entry, such as a code, to a list, which may be null. */
  public static IgnoreList with(IgnoreList jam, int entry) {
    if (jam != null && jam.contains(entry)) {
      return jam;
    }
    int size = jam == null ? 0 : jam.entries.length;
    int[] more = jam == null ? new int[1] : Arrays.copyOf(jam.entries, size + 1);
    more[size] = entry;
    return new IgnoreList(more);
  }

  /** Without all obstacles but those that crushed the circle; null if nothing is left. */
  IgnoreList ofCircles() {
    return only(entry -> crushes(entry) || isOfCircle(entry));
  }

  private IgnoreList only(IntPredicate stays) {
    int[] left = Arrays.stream(entries).filter(stays).toArray();
    return left.length == entries.length ? this : of(left);
  }

  /** Without all that crushed the circle; null if nothing is left. */
  IgnoreList withoutCrushers() {
    return only(entry -> !crushes(entry));
  }

  private static boolean isOfCircle(int entry) {
    return Codes.isCircle(code(entry));
  }

  /** Removes one code; null if nothing is left. */
  public IgnoreList without(int code) {
    return only(entry -> code(entry) != code);
  }

  /** The same with other slots or ids for circles. */
  IgnoreList ofOtherCircles(IntUnaryOperator number) {
    return new IgnoreList(Arrays.stream(entries).map(entry -> other(entry, number)).toArray());
  }

  private static int other(int entry, IntUnaryOperator number) {
    if (!isOfCircle(entry)) {
      return entry;
    }
    int other = Codes.circle(number.applyAsInt(Codes.slot(code(entry))));
    return crushes(entry) ? ~other : other;
  }

  /** One entry for each thing: {@link #code} and {@link #crushes} say what it means. */
  public int[] entries() {
    return entries.clone();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof IgnoreList that && Arrays.equals(entries, that.entries);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(entries);
  }

  public boolean makesInert(int code) {
    return contains(code);
  }

  public boolean isCrushedBy(int code) {
    return contains(~code);
  }

  /** Whether the circle ignores a code, or was crushed by it. */
  public boolean concerns(int code) {
    return contains(code) || contains(~code);
  }

  private boolean contains(int entry) {
    for (int other : entries) {
      if (other == entry) {
        return true;
      }
    }
    return false;
  }
}
