// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

/** The goal of the published experiment, and what it reached. */
public final class Budget {

  /** The time of one frame at 60 frames per second, in milliseconds. */
  public static final double MILLIS = 1000.0 / 60;

  /** The published run, with 100 circles and 100 lines: Java 6 on a Core 2 Duo E6600, 2010. */
  public static final double PUBLISHED_FPS = 19.2;

  static final double MICROS = 1000 * MILLIS;
  static final double PUBLISHED_MICROS = 1e6 / PUBLISHED_FPS;

  private Budget() {}
}
