// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Kind;
import dev.carom.World;

/**
 * A level line that goes down slowly, and up at once: a ball rests on it, goes down with it and is
 * thrown by it.
 */
final class Plunger {

  private static final double PULL = -0.4;
  private static final double THROW = 6;

  private final World world;
  private final int id;
  private final double rest;
  private boolean held;
  private double goal;

  /** Steers a line of a world, which is at its height of rest. */
  Plunger(World world, int id, double rest) {
    this.world = world;
    this.id = id;
    this.rest = rest;
    goal = rest;
  }

  /** Whether it rests above. */
  boolean isReady() {
    return !held && goal == rest && height() == rest;
  }

  /** Goes down to a height, and then up. */
  void pull(double height) {
    goal = height;
  }

  /** Goes down to a height, and stays there until it is released. */
  void hold(double height) {
    held = true;
    goal = height;
  }

  void release() {
    held = false;
    goal = rest;
  }

  /** Sets the velocity that leads to the goal, and no further, for the next frame. */
  void go() {
    if (height() <= goal && goal < rest && !held) {
      goal = rest;
    }
    double v = Math.max(PULL, Math.min(THROW, goal - height()));
    if (v != world.velocity(Kind.LINE, id).y()) {
      world.setVelocity(Kind.LINE, id, 0, v);
    }
  }

  private double height() {
    return world.line(id).ay();
  }
}
