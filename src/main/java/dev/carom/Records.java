// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.Obstacles;

/** The public records of what stands in the rows of {@link Obstacles}. */
final class Records {

  private Records() {}

  /** A line, or a peg, as it is now; of a wall, the bounds. */
  static Obstacle of(Obstacles obstacles, int code) {
    if (code < Obstacles.WALLS) {
      return bounds(obstacles.walls);
    }
    int k = obstacles.offset(code);
    return code < Obstacles.PEGS ? line(obstacles.lines, k) : peg(obstacles.pegs, k);
  }

  /** The bounds with these walls; null for null. */
  static Bounds bounds(double[] walls) {
    return walls == null
        ? null
        : new Bounds(
            walls[Obstacles.LEFT],
            walls[Obstacles.BOTTOM],
            walls[Obstacles.RIGHT],
            walls[Obstacles.TOP]);
  }

  /** What messages say of the bounds with these walls, which may be null. */
  static String told(double[] walls) {
    return walls == null ? "none" : bounds(walls).toString();
  }

  /** Where the walls of bounds stand, by their codes. */
  static double[] walls(Bounds b) {
    return Obstacles.walls(b.xmin(), b.ymin(), b.xmax(), b.ymax());
  }

  /** The line whose row begins at a place in an array. */
  static Line line(double[] rows, int k) {
    return new Line(
        rows[k + Obstacles.AX],
        rows[k + Obstacles.AY],
        rows[k + Obstacles.BX],
        rows[k + Obstacles.BY]);
  }

  /** The peg whose row begins at a place in an array. */
  static Circle peg(double[] rows, int k) {
    return new Circle(rows[k + Obstacles.X], rows[k + Obstacles.Y], rows[k + Obstacles.RADIUS]);
  }
}
