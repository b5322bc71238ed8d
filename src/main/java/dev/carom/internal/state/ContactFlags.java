// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * The flags of an obstacle or a circle, in a byte: its response, and whether it is a one-way line.
 */
public final class ContactFlags {

  // The responses: the ordinals of Response.
  public static final int BOUNCE = 0;
  public static final int HALT = 1;
  public static final int SENSOR = 2;

  private static final int RESPONSE = 3;
  private static final int ONE_WAY = 4;

  /** All flags that a wall, a peg or a circle can have. */
  public static final int MOST = RESPONSE;

  /** All flags that a line can have. */
  public static final int MOST_OF_LINES = RESPONSE | ONE_WAY;

  private ContactFlags() {}

  public static int with(int traits, int response) {
    return (traits & ~RESPONSE) | response;
  }

  public static int withOneWay(int traits, boolean oneWay) {
    return oneWay ? traits | ONE_WAY : traits & ~ONE_WAY;
  }

  public static int response(int traits) {
    return traits & RESPONSE;
  }

  public static boolean isSensor(int traits) {
    return (traits & RESPONSE) == SENSOR;
  }

  static boolean halts(int traits) {
    return (traits & RESPONSE) == HALT;
  }

  public static boolean isOneWay(int traits) {
    return (traits & ONE_WAY) != 0;
  }
}
