// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/** Scenes with gravity for tests, and how they are played. */
final class Falling {

  private Falling() {}

  /** A box of 100 by 100 with gravity 10, downwards. */
  static SceneBuilder box() {
    return Scene.builder().bounds(0, 0, 100, 100).gravity(0, -10);
  }

  /** The kinetic and potential energy of a circle of mass 1. */
  static double energy(World world, int id) {
    double vx = world.vx(id);
    double vy = world.vy(id);
    Vec2 g = world.gravity();
    return 0.5 * (vx * vx + vy * vy) - g.x() * world.x(id) - g.y() * world.y(id);
  }

  /** Advances to a time, in as many calls as that takes; returns the number of impacts. */
  static int rows(World world, double until) {
    int rows = 0;
    boolean done;
    do {
      done = world.advanceTo(until, Run.WORK);
      rows += world.impacts().size();
    } while (!done);
    return rows;
  }

  /** How far a circle must go at most to get out of a line, a peg, the bounds or a circle. */
  static double overlap(World world) {
    double most = 0;
    for (int id : world.ids(Kind.CIRCLE)) {
      Circle circle = (Circle) world.shape(Kind.CIRCLE, id);
      for (Kind kind : Kind.values()) {
        for (int other : world.overlapping(kind, circle)) {
          if (kind != Kind.CIRCLE || (other < id && world.scene().collide())) {
            Obstacle shape = world.shape(kind, other);
            most = Math.max(most, circle.separation(shape).length());
          }
        }
      }
    }
    return most;
  }
}
