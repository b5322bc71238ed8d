// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Line;

/**
 * Whether a flight comes nearer to a line or a point than a limit. Of a straight flight the answer
 * is exact. A parabola is halved until it leaves its chord by no more than rounding; then the chord
 * decides, exactly.
 */
final class Nearness {

  private final Line line;
  private final double limit;
  private final double slack;

  /**
   * Asks about one thing.
   *
   * @param slack how far a chord may be from its parabola, more than 0
   */
  Nearness(Line line, double limit, double slack) {
    this.line = line;
    this.limit = limit;
    this.slack = slack;
  }

  boolean isReachedBy(Flight f) {
    double turn = turn(f);
    if (turn > f.from() && turn < f.to()) {
      return isReachedByHalf(f.within(f.from(), turn)) || isReachedByHalf(f.within(turn, f.to()));
    }
    return isReachedByHalf(f);
  }

  /** When its velocity is across its acceleration: on either side of it no way leads back. */
  private static double turn(Flight f) {
    double square = f.ax() * f.ax() + f.ay() * f.ay();
    return f.from() - (f.vx() * f.ax() + f.vy() * f.ay()) / square;
  }

  private boolean isReachedByHalf(Flight f) {
    double sag = sag(f);
    if (!isReachedByChord(f, limit + sag)) {
      return false;
    }
    if (sag <= slack) {
      return sag == 0 || isReachedByChord(f, limit - sag);
    }
    double middle = f.from() + (f.to() - f.from()) / 2;
    return middle > f.from()
        && middle < f.to()
        && (isReachedByHalf(f.within(f.from(), middle))
            || isReachedByHalf(f.within(middle, f.to())));
  }

  /** How far it is from its chord at most. */
  private static double sag(Flight f) {
    double dx = f.qx() - f.px();
    double dy = f.qy() - f.py();
    double length = Math.hypot(dx, dy);
    double across =
        length == 0 ? Math.hypot(f.ax(), f.ay()) : Math.abs(f.ax() * dy - f.ay() * dx) / length;
    double dt = f.to() - f.from();
    return across * dt * dt / 8;
  }

  private boolean isReachedByChord(Flight f, double distance) {
    return distance > 0
        && !isApart(f, distance)
        && f.passage().comesNearer(line.ax(), line.ay(), line.bx(), line.by(), distance);
  }

  /** Whether their boxes are so far from each other that no exact answer is needed. */
  private boolean isApart(Flight f, double distance) {
    double room = 1.001 * distance;
    return Math.min(f.px(), f.qx()) - Math.max(line.ax(), line.bx()) > room
        || Math.min(line.ax(), line.bx()) - Math.max(f.px(), f.qx()) > room
        || Math.min(f.py(), f.qy()) - Math.max(line.ay(), line.by()) > room
        || Math.min(line.ay(), line.by()) - Math.max(f.py(), f.qy()) > room;
  }
}
