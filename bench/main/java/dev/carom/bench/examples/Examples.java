// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import java.util.Locale;

/** The examples by name. */
public enum Examples {
  /** See {@link Breakout}. */
  BREAKOUT("a paddle is a line that moves between frames", 900),
  /** See {@link Billiards}. */
  BILLIARDS("a break; friction is a velocity set between frames", 90),
  /** See {@link Relaxation}. */
  GAS("speeds relax to those of Maxwell and Boltzmann", 200),
  /** See {@link AimingLine}. */
  AIM("the way that a shot would take, bounces included", 0),
  /** See {@link GameLoop}. */
  LOOP("fixed steps in a Swing timer, with gravity", 100),
  /** See {@link Threads}. */
  THREADS("a scene split over two threads", 150);

  private final String about;
  private final int frames;

  Examples(String about, int frames) {
    this.about = about;
    this.frames = frames;
  }

  /**
   * What it shows.
   *
   * @return a phrase
   */
  public String about() {
    return about;
  }

  /**
   * When a picture of it tells most.
   *
   * @return a number of frames
   */
  public int frames() {
    return frames;
  }

  /**
   * Starts it.
   *
   * @return a new one, at its beginning
   */
  public Example start() {
    return switch (this) {
      case BREAKOUT -> new Breakout();
      case BILLIARDS -> new Billiards();
      case GAS -> new Relaxation();
      case AIM -> new AimingLine();
      case LOOP -> new GameLoop();
      case THREADS -> new Threads();
    };
  }

  /** Its name in small letters. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
