// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static dev.carom.internal.sweep.LineShape.AX;
import static dev.carom.internal.sweep.LineShape.AY;
import static dev.carom.internal.sweep.LineShape.BX;
import static dev.carom.internal.sweep.LineShape.BY;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.state.MovingCircle;

/**
 * The rule of one-way lines, which stop circles that come from their left, as seen from start to
 * end.
 *
 * <ul>
 *   <li>Straight flights: the line is there, ends included, if the centre is strictly left of it at
 *       the start of the flight, and moves to its right as seen from the line.
 *   <li>Flights with an acceleration: a contact counts if the circle touches the line from outside,
 *       and its centre is then strictly left. A circle that stands on the line, overlapping it by
 *       no more than rounding, touches it from outside, too.
 * </ul>
 *
 * <p>A line is a row k of an array, as it is at the start of the flight, and has the velocity (ux,
 * uy).
 */
final class OneWay {

  /** A circle that overlaps a line by no more than this part of its coordinates touches it. */
  private static final double TOUCH = 0x1p-49;

  private OneWay() {}

  /** Whether a line is there for a straight flight. */
  static boolean stops(MovingCircle m, double[] row, int k, double ux, double uy) {
    return isLeftAtStart(m, row, k)
        && Predicates.cross(row[k + BX], row[k + BY], row[k + AX], row[k + AY], m.vx, m.vy, ux, uy)
            < 0;
  }

  private static boolean isLeftAtStart(MovingCircle m, double[] row, int k) {
    double ax = row[k + AX];
    double ay = row[k + AY];
    return Predicates.cross(row[k + BX], row[k + BY], ax, ay, m.x, m.y, ax, ay) > 0;
  }

  /** Whether the centre is left of a line at a time, by doubles; at 0, exactly. */
  static boolean isLeft(MovingCircle m, double[] row, int k, double ux, double uy, double t) {
    if (t == 0) {
      return isLeftAtStart(m, row, k);
    }
    double ax = row[k + AX];
    double ay = row[k + AY];
    double x = (m.x - ax) + ((m.vx - ux) + 0.5 * m.gx * t) * t;
    double y = (m.y - ay) + ((m.vy - uy) + 0.5 * m.gy * t) * t;
    return (row[k + BX] - ax) * y - (row[k + BY] - ay) * x > 0;
  }

  /** Whether a circle starts left of a line and overlaps it by no more than rounding. */
  static boolean standsOn(MovingCircle m, double[] row, int k) {
    double wx = row[k + BX] - row[k + AX];
    double wy = row[k + BY] - row[k + AY];
    double height = wx * (m.y - row[k + AY]) - wy * (m.x - row[k + AX]);
    double size = Math.abs(m.x) + Math.abs(m.y) + m.radius;
    return height > 0 && height >= (m.radius - TOUCH * size) * Math.sqrt(wx * wx + wy * wy);
  }
}
