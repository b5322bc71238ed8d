// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

/**
 * The exceptions of {@link Check}: plain {@link IllegalArgumentException}s with a message such as
 * "radius is -1.0: expected a finite number, at least 0". The name of the thing that has the
 * property may stand before it, as "circle 3: radius is -1.0: ...".
 */
public final class Refusal {

  private static final String IS = " is ";

  private Refusal() {}

  static IllegalArgumentException of(String property, Object value, String expected) {
    return new IllegalArgumentException(property + IS + value + ": expected " + expected);
  }

  /** The same refusal, with the name of the thing before its message. */
  public static IllegalArgumentException of(String thing, IllegalArgumentException refusal) {
    return new IllegalArgumentException(thing + ": " + refusal.getMessage(), refusal);
  }

  /** The message without the name of the thing. */
  public static String reason(IllegalArgumentException refusal) {
    return refusal.getCause() instanceof IllegalArgumentException unnamed
        ? reason(unnamed)
        : refusal.getMessage();
  }

  /** The name of the property, as "radius". */
  public static String property(IllegalArgumentException refusal) {
    String reason = reason(refusal);
    return reason.substring(0, reason.indexOf(IS));
  }
}
