// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

/**
 * What a check refused. Callers see an {@link IllegalArgumentException}; the reader of scene files
 * asks for the name of the property, to point at its place in the file.
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

  /** The same refusal, its message led by the thing that the property belongs to. */
  public RefusedException of(String thing) {
    return new RefusedException(property, reason, thing + ": ", this);
  }

  /** The name of what was refused, as "radius". */
  public String property() {
    return property;
  }

  /** The message without the thing. */
  public String reason() {
    return reason;
  }
}
