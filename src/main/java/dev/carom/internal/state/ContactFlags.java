// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * The flags of an obstacle or a circle, in a byte: its response, whether it is a one-way line, and
 * where a side of a solid polygon is outside.
 */
public final class ContactFlags {

  // The responses: the ordinals of Response.
  public static final int BOUNCE = 0;
  public static final int HALT = 1;
  public static final int SENSOR = 2;

  private static final int RESPONSE = 3;
  private static final int ONE_WAY = 4;

  /** A side of a solid polygon, whose outside is to its left; to its right. */
  private static final int OUTSIDE_LEFT = 8;

  private static final int OUTSIDE_RIGHT = 16;
  private static final int OUTSIDE = OUTSIDE_LEFT | OUTSIDE_RIGHT;

  /** All flags that a wall, a peg or a circle can have. */
  public static final int MOST = RESPONSE;

  /** All flags that a line can have. */
  public static final int MOST_OF_LINES = RESPONSE | ONE_WAY | OUTSIDE;

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

  /** The flags of a side of a solid polygon: 1 for one that is outside to its left, -1 right. */
  static int withOutside(int traits, int outside) {
    int flag = outside == 0 ? 0 : outside > 0 ? OUTSIDE_LEFT : OUTSIDE_RIGHT;
    return (traits & ~OUTSIDE) | flag;
  }

  /** Where the outside of a solid polygon is from its side: 1 left, -1 right; 0 of other things. */
  static int outside(int traits) {
    return (traits & OUTSIDE_LEFT) != 0 ? 1 : (traits & OUTSIDE_RIGHT) != 0 ? -1 : 0;
  }

  /** Whether flags can be those of an obstacle. */
  public static boolean areKnown(int traits, int most) {
    return (traits & ~most) == 0
        && response(traits) != RESPONSE
        && (traits & OUTSIDE) != OUTSIDE
        && !(isOneWay(traits) && outside(traits) != 0);
  }

  public static boolean isOneWay(int traits) {
    return (traits & ONE_WAY) != 0;
  }
}
