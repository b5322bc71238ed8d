// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

/**
 * Thrown when a check fails. Callers of the library see an {@link IllegalArgumentException}. The
 * reader of scene files asks for the name of the property, to point at its place in the file.
 */
public final class RefusedException extends IllegalArgumentException {

  private static final long serialVersionUID = 1;

  private final String property;
  private final String reason;

  RefusedException(String property, Object value, String expected) {
    this(property, property + " is " + value + ": expected " + expected, "", null);
  }

  private RefusedException(String property, String reason, String thing, Throwable cause) {
    super(thing + reason, cause);
    this.property = property;
    this.reason = reason;
  }

  /**
   * Returns the same refusal, with the name of the thing that has the property before the message.
   */
  public RefusedException of(String thing) {
    return new RefusedException(property, reason, thing + ": ", this);
  }

  /** The name of the refused property, as "radius". */
  public String property() {
    return property;
  }

  /** The message without the name of the thing. */
  public String reason() {
    return reason;
  }
}
