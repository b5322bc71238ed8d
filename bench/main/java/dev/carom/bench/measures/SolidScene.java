// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;

/**
 * The lines and walls of a scene, as what circles can neither reach into nor get through.
 *
 * <p>A circle got through a line if it provably did: its centre is on the other side at the end of
 * a frame, with the line between the two places, and the way round either end is longer than a
 * frame's travel at its greater speed. A legal trip round an end is never counted.
 */
public final class SolidScene {

  /** Factor that covers the rounding of a frame's travel. */
  private static final double MARGIN = 1 + 1e-6;

  private final Scene scene;

  /**
   * Looks at a scene.
   *
   * @param scene its pegs are not looked at
   */
  public SolidScene(Scene scene) {
    this.scene = scene;
  }

  /**
   * How deep a circle reaches into lines and walls.
   *
   * @param x the x coordinate of its centre, any number
   * @param y the y coordinate of its centre, any number
   * @param i its number in the scene
   * @return in radii, 0 if it touches nothing, NaN at no place; a circle outside of the bounds is
   *     no longer held by them
   */
  public double depth(double x, double y, int i) {
    if (Double.isNaN(x + y)) {
      return Double.NaN;
    }
    double room = isInside(x, y) ? roomToWalls(x, y) : Double.POSITIVE_INFINITY;
    Vec2 centre = new Vec2(x, y);
    for (int k = 0; k < scene.count(Kind.LINE); k++) {
      Vec2 closest = ((Line) scene.shape(Kind.LINE, k)).closestPoint(centre);
      room = Math.min(room, Math.hypot(x - closest.x(), y - closest.y()));
    }
    return Math.max(0, 1 - room / ((Circle) scene.shape(Kind.CIRCLE, i)).radius());
  }

  private double roomToWalls(double x, double y) {
    if (scene.bounds().isEmpty()) {
      return Double.POSITIVE_INFINITY;
    }
    Bounds b = scene.bounds().get();
    return Math.min(Math.min(x - b.xmin(), b.xmax() - x), Math.min(y - b.ymin(), b.ymax() - y));
  }

  /**
   * Whether a place is within the bounds.
   *
   * @param x its x coordinate, any number
   * @param y its y coordinate, any number
   * @return also if the scene has no bounds; false for NaN
   */
  public boolean isInside(double x, double y) {
    return roomToWalls(x, y) >= 0;
  }

  /**
   * Whether a circle got through a line.
   *
   * @param x0 the x coordinate of its centre before the frame
   * @param y0 the y coordinate of its centre before the frame
   * @param x1 the x coordinate of its centre after the frame
   * @param y1 the y coordinate of its centre after the frame
   * @param speed the greater one of those before and after the frame
   * @return whether it provably did
   */
  public boolean passes(double x0, double y0, double x1, double y1, double speed) {
    double travel = MARGIN * speed;
    for (int k = 0; k < scene.count(Kind.LINE); k++) {
      Line line = (Line) scene.shape(Kind.LINE, k);
      if (isBetween(line, x0, y0, x1, y1)
          && Math.hypot(x0 - line.ax(), y0 - line.ay()) + Math.hypot(x1 - line.ax(), y1 - line.ay())
              > travel
          && Math.hypot(x0 - line.bx(), y0 - line.by()) + Math.hypot(x1 - line.bx(), y1 - line.by())
              > travel) {
        return true;
      }
    }
    return false;
  }

  /** Whether two places are strictly on two sides of a line, with the line between. */
  private static boolean isBetween(Line line, double x0, double y0, double x1, double y1) {
    double wx = line.bx() - line.ax();
    double wy = line.by() - line.ay();
    double px = x0 - line.ax();
    double py = y0 - line.ay();
    double vx = x1 - x0;
    double vy = y1 - y0;
    double before = wx * py - wy * px;
    double after = before + wx * vy - wy * vx;
    double share = before / (before - after);
    double along = wx * (px + share * vx) + wy * (py + share * vy);
    return before * after < 0 && along > 0 && along < wx * wx + wy * wy;
  }
}
