// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import java.util.Locale;
import java.util.function.Supplier;

/** The examples by name. */
public enum Examples {
  /** See {@link Breakout}. */
  BREAKOUT("a paddle is a line that moves between frames", 900, Breakout::new),
  /** See {@link Billiards}. */
  BILLIARDS("a break; friction is a velocity set between frames", 90, Billiards::new),
  /** See {@link Relaxation}. */
  GAS("speeds relax to those of Maxwell and Boltzmann", 200, Relaxation::new),
  /** See {@link AimingLine}. */
  AIM("the way that a shot would take, bounces included", 0, AimingLine::new),
  /** See {@link GameLoop}. */
  LOOP("fixed steps in a Swing timer, with gravity", 100, GameLoop::new),
  /** See {@link Threads}. */
  THREADS("a scene split over two threads", 150, Threads::new);

  private final String about;
  private final int frames;
  private final Supplier<Example> maker;

  Examples(String about, int frames, Supplier<Example> maker) {
    this.about = about;
    this.frames = frames;
    this.maker = maker;
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
    return maker.get();
  }

  /** Its name in small letters. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
