// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

/** The parts of an obstacle that can be hit, by the ordinals of the public features. */
public final class Part {

  public static final int SIDE = 0;
  public static final int START = 1;
  public static final int END = 2;
  public static final int CIRCLE = 3;

  private Part() {}
}
