// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Vec2;
import dev.carom.World;
import java.util.Locale;
import java.util.Optional;

/** The examples by name. */
public enum Examples {
  BREAKOUT("a paddle is a line that moves between frames", 900),
  BILLIARDS("an aiming line that sees balls; friction is a velocity set between frames", 900),
  PI("pi by counting collisions", 345),
  PHOTON("a photon among mirrors, and the digits of its place that are sure", 300),
  LOOP("fixed steps in a Swing timer, with gravity", 100),
  THREADS("a scene split over two threads: each moves half of the circles", 150),
  PADDLE("a paddle that moves as a player wants it, and pushes the ball", 330),
  WHATIF("two futures of one past: the run as it was, and with the wall elsewhere", 240),
  PLINKO("balls fall among pegs, and the slots below count them", 12_000),
  PINBALL("slopes, bumpers and a plunger under gravity", 1_500);

  private final String about;
  private final int frames;

  Examples(String about, int frames) {
    this.about = about;
    this.frames = frames;
  }

  /** Its subject: a phrase. */
  public String about() {
    return about;
  }

  /** When a picture of it tells most: a number of frames. */
  public int frames() {
    return frames;
  }

  /** Starts it, and returns a new one, at its beginning. */
  public Example start() {
    return switch (this) {
      case BREAKOUT -> new Breakout();
      case BILLIARDS -> new Billiards();
      case PI -> new PiCollisions();
      case PHOTON -> new Photon();
      case LOOP -> new GameLoop();
      case THREADS -> new Threads();
      case PADDLE -> new Paddle();
      case WHATIF -> new WhatIf();
      case PLINKO -> new Plinko();
      case PINBALL -> new Pinball();
    };
  }

  /**
   * Starts it and goes on to what a picture shows; at billiards somebody plays the break.
   *
   * @param count how many frames
   * @return it, after those frames
   */
  public Example after(int count) {
    Example example = start();
    if (this == BILLIARDS && count > 0) {
      example.point(new Vec2(0.5, 0.5));
      example.press();
      example.point(new Vec2(0.15, 0.501));
      example.release();
    }
    for (int i = 0; i < count; i++) {
      example.frame();
    }
    if (this == BILLIARDS) {
      example.point(new Vec2(0.765, 0.52)); // at a ball
    }
    return example;
  }

  /** The world of an example of which a film of its things shows all that matters; else empty. */
  public static Optional<World> filmed(Example example) {
    return Optional.ofNullable(
        example instanceof Breakout breakout
            ? breakout.world
            : example instanceof Billiards billiards
                ? billiards.world
                : example instanceof Pinball pinball
                    ? pinball.world
                    : example instanceof Plinko plinko
                        ? plinko.world()
                        : example instanceof Paddle paddle
                            ? paddle.world()
                            : example instanceof GameLoop loop ? loop.world() : null);
  }

  /** Its name in small letters. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
