// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.LineShape;

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
 */
final class OneWay {

  /** A circle that overlaps a line by no more than this part of its coordinates touches it. */
  private static final double TOUCH = 0x1p-49;

  private OneWay() {}

  /** Whether a line is there for a straight flight. */
  static boolean stops(Fall f) {
    return isLeftAtStart(f) && Predicates.cross(f.bx, f.by, f.ax, f.ay, f.vx, f.vy, f.ux, f.uy) < 0;
  }

  private static boolean isLeftAtStart(Fall f) {
    return LineShape.side(f.ax, f.ay, f.bx, f.by, f.px, f.py) > 0;
  }

  /** Whether the centre is left of a line at a time, by doubles; at 0, exactly. */
  static boolean isLeft(Fall f, double t) {
    return t == 0 ? isLeftAtStart(f) : f.wx * f.roughY(t) - f.wy * f.roughX(t) > 0;
  }

  /** Whether a circle starts left of a line and overlaps it by no more than rounding. */
  static boolean standsOn(Fall f) {
    double height = f.wx * f.dy - f.wy * f.dx;
    double size = Math.abs(f.px) + Math.abs(f.py) + f.r;
    return height > 0 && height >= (f.r - TOUCH * size) * Math.sqrt(f.wx * f.wx + f.wy * f.wy);
  }
}
