// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/** A way to find, in doubles, when a moving circle touches a line; it counts its work. */
public abstract class LineDetector {

  static final double NEVER = Double.POSITIVE_INFINITY;

  int squareRoots;
  long pairTests;

  LineDetector() {}

  /** Whether it counts its square roots. */
  boolean countsRoots() {
    return true;
  }

  /**
   * A moving circle against a line.
   *
   * @param px the x coordinate of the centre
   * @param py the y coordinate of the centre
   * @param r the radius
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @param ax the x coordinate of the line's start
   * @param ay the y coordinate of the line's start
   * @param bx the x coordinate of the line's end
   * @param by the y coordinate of the line's end
   * @param end the end of the window
   * @return the time of impact, infinite for a miss
   */
  public abstract double time(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double ax,
      double ay,
      double bx,
      double by,
      double end);
}
