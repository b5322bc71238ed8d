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

  /**
   * By how much circles overlap lines, pegs, bounds and, if they collide, each other; 0 if none.
   */
  static double overlap(World world) {
    Scene scene = world.scene();
    double most = 0;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      Vec2 p = new Vec2(world.x(i), world.y(i));
      double r = ((Circle) scene.shape(Kind.CIRCLE, i)).radius();
      for (int k = 0; k < scene.count(Kind.LINE); k++) {
        most = Math.max(most, r - distance((Line) scene.shape(Kind.LINE, k), p));
      }
      for (int k = 0; k < scene.count(Kind.PEG); k++) {
        Circle peg = (Circle) scene.shape(Kind.PEG, k);
        most = Math.max(most, r + peg.radius() - Math.hypot(peg.x() - p.x(), peg.y() - p.y()));
      }
      for (int j = 0; j < i && scene.collide(); j++) {
        double distance = Math.hypot(world.x(j) - p.x(), world.y(j) - p.y());
        most = Math.max(most, r + ((Circle) scene.shape(Kind.CIRCLE, j)).radius() - distance);
      }
      most = Math.max(most, scene.bounds().map(b -> beyond(b, p, r)).orElse(0.0));
    }
    return most;
  }

  private static double beyond(Bounds b, Vec2 p, double r) {
    double x = Math.max(b.xmin() + r - p.x(), p.x() + r - b.xmax());
    double y = Math.max(b.ymin() + r - p.y(), p.y() + r - b.ymax());
    return Math.max(x, y);
  }

  private static double distance(Line line, Vec2 p) {
    double wx = line.bx() - line.ax();
    double wy = line.by() - line.ay();
    double s = ((p.x() - line.ax()) * wx + (p.y() - line.ay()) * wy) / (wx * wx + wy * wy);
    double t = Math.max(0, Math.min(1, s));
    return Math.hypot(p.x() - line.ax() - t * wx, p.y() - line.ay() - t * wy);
  }
}
