// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.exact.ExactSigns;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.FallReturn;
import dev.carom.internal.sweep.Falls;
import dev.carom.internal.sweep.ParabolaWallSweep;

/**
 * When a circle that falls or slides meets an obstacle: the detector asked for the whole flight.
 */
final class PlainFall {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /**
   * A circle that overlaps a one-way line by no more than this, relative to its place, is on it.
   */
  private static final double TOUCH = 0x1p-49;

  private final ObstacleTable obstacles;

  PlainFall(ObstacleTable obstacles) {
    this.obstacles = obstacles;
  }

  /**
   * The time of the next contact; {@code +infinity} for never.
   *
   * @param sensed when it was last reported, if it is a sensor; 0 for never
   */
  double time(MovingCircle m, int code, double sensed) {
    boolean rests = m.vx == 0 && m.vy == 0 && m.gx == 0 && m.gy == 0;
    boolean finite = Math.abs(m.x) <= Double.MAX_VALUE && Math.abs(m.y) <= Double.MAX_VALUE;
    if (code == m.support || !finite || (rests && !obstacles.areMoving())) {
      return NEVER;
    }
    if (Codes.isWall(code)) {
      return obstacles.walls == null ? NEVER : ofWall(m, code);
    }
    if (obstacles.isSensor(code)) {
      return after(m, code, sensed);
    }
    if (Codes.isLine(code) && obstacles.isOneWay(code)) {
      return ofOneWay(m, code);
    }
    return code == m.last ? again(m, code) : first(m, code);
  }

  private double[] row(MovingCircle m, int code) {
    return obstacles.rowAt(code, m.t, m.tl);
  }

  private double ofWall(MovingCircle m, int code) {
    int inwards = Codes.inwards(code);
    boolean vertical = Codes.isVertical(code);
    double p = vertical ? m.x : m.y;
    double v = vertical ? m.vx : m.vy;
    double g = vertical ? m.gx : m.gy;
    return code == m.last
        ? FallReturn.toWall(v, g, inwards, NEVER)
        : ParabolaWallSweep.time(p, m.radius, v, g, obstacles.walls[code], inwards, NEVER);
  }

  private double first(MovingCircle m, int code) {
    double[] n = row(m, code);
    return Codes.isLine(code)
        ? Falls.timeOfLine(
            m.x, m.y, m.radius, m.vx, m.vy, m.gx, m.gy, n[0], n[1], n[2], n[3], ux(code), uy(code),
            NEVER)
        : disk(m, code, n[0], n[1], n[2]);
  }

  private double disk(MovingCircle m, int code, double x, double y, double radius) {
    return Falls.timeOfDisk(
        m.x, m.y, m.radius, m.vx, m.vy, m.gx, m.gy, x, y, radius, ux(code), uy(code), NEVER);
  }

  private double after(MovingCircle m, int code, double after) {
    double[] n = row(m, code);
    return Codes.isLine(code)
        ? Falls.timeOfLineAfter(
            m.x, m.y, m.radius, m.vx, m.vy, m.gx, m.gy, n[0], n[1], n[2], n[3], ux(code), uy(code),
            after, NEVER)
        : Falls.timeOfDiskAfter(
            m.x, m.y, m.radius, m.vx, m.vy, m.gx, m.gy, n[0], n[1], n[2], ux(code), uy(code), after,
            NEVER);
  }

  /** The return to what was hit last. */
  private double again(MovingCircle m, int code) {
    double[] n = row(m, code);
    if (code == m.landing) {
      return atEnds(m, code, n);
    }
    return Codes.isLine(code)
        ? Falls.returnToLine(
            m.x, m.y, m.radius, m.vx, m.vy, m.gx, m.gy, n[0], n[1], n[2], n[3], ux(code), uy(code),
            NEVER)
        : backToDisk(m, code, n[0], n[1]);
  }

  /**
   * Of a circle that flew off one end of a line: the return to that, or the contact with the other.
   */
  private double atEnds(MovingCircle m, int code, double[] n) {
    boolean isAtStart = Math.hypot(m.x - n[0], m.y - n[1]) < Math.hypot(m.x - n[2], m.y - n[3]);
    int left = isAtStart ? 0 : 2;
    double back = backToDisk(m, code, n[left], n[left + 1]);
    return Math.min(back, disk(m, code, n[2 - left], n[3 - left], 0));
  }

  private double backToDisk(MovingCircle m, int code, double x, double y) {
    return Falls.returnToDisk(m.x, m.y, m.vx, m.vy, m.gx, m.gy, x, y, ux(code), uy(code), NEVER);
  }

  /** A one-way line counts when the circle comes to touch it, its centre left of the line. */
  private double ofOneWay(MovingCircle m, int code) {
    double[] n = row(m, code);
    if (code == m.last) {
      double t = again(m, code);
      if (t == NEVER || isLeft(m, code, n, t)) {
        return t;
      }
    } else if (standsOn(m, n) && first(m, code) == 0) {
      return 0;
    }
    double t = after(m, code, -1);
    while (t < NEVER && !isLeft(m, code, n, t)) {
      t = after(m, code, t);
    }
    return t;
  }

  private boolean isLeft(MovingCircle m, int code, double[] n, double t) {
    if (t == 0) {
      return ExactSigns.NUMBERS.cross(n[2], n[3], n[0], n[1], m.x, m.y, n[0], n[1]) > 0;
    }
    double x = (m.x - n[0]) + ((m.vx - ux(code)) + 0.5 * m.gx * t) * t;
    double y = (m.y - n[1]) + ((m.vy - uy(code)) + 0.5 * m.gy * t) * t;
    return (n[2] - n[0]) * y - (n[3] - n[1]) * x > 0;
  }

  private static boolean standsOn(MovingCircle m, double[] n) {
    double wx = n[2] - n[0];
    double wy = n[3] - n[1];
    double height = wx * (m.y - n[1]) - wy * (m.x - n[0]);
    double size = Math.abs(m.x) + Math.abs(m.y) + m.radius;
    return height > 0 && height >= (m.radius - TOUCH * size) * Math.sqrt(wx * wx + wy * wy);
  }

  /** Which part of a line is touched at the time of its contact; 0 for others. */
  int contact(MovingCircle m, int code, double t) {
    if (!Codes.isLine(code) || code == m.support) {
      return 0;
    }
    double[] n = row(m, code);
    boolean isReturn =
        code == m.last
            && !obstacles.isSensor(code)
            && (!obstacles.isOneWay(code) || again(m, code) == t);
    return isReturn
        ? Falls.contactOfReturn(
            m.x, m.y, m.radius, m.vx, m.vy, m.gx, m.gy, n[0], n[1], n[2], n[3], ux(code), uy(code),
            t)
        : Falls.contact(
            m.x, m.y, m.radius, m.vx, m.vy, m.gx, m.gy, n[0], n[1], n[2], n[3], ux(code), uy(code),
            t);
  }

  /** When a circle that slides along a line comes to one of its ends. */
  double endOfSlide(MovingCircle m) {
    int code = m.support;
    if (code < 0 || !Codes.isLine(code) || Codes.isWall(code)) {
      return NEVER;
    }
    boolean rests = m.vx == 0 && m.vy == 0 && m.gx == 0 && m.gy == 0;
    if (rests && !obstacles.areMoving()) {
      return NEVER;
    }
    double[] n = row(m, code);
    double wx = n[2] - n[0];
    double wy = n[3] - n[1];
    double v = wx * (m.vx - ux(code)) + wy * (m.vy - uy(code));
    double g = wx * m.gx + wy * m.gy;
    return Math.min(
        reaches(wx * (m.x - n[2]) + wy * (m.y - n[3]), v, g),
        reaches(wx * (n[0] - m.x) + wy * (n[1] - m.y), -v, -g));
  }

  /** When c + v t + g t^2 / 2 first rises above 0. */
  private static double reaches(double c, double v, double g) {
    if (c >= 0) {
      if (v > 0 || (v == 0 && g > 0)) {
        return 0;
      }
      return g > 0 ? -2 * v / g : NEVER;
    }
    double root = Math.sqrt(v * v - 2 * g * c);
    if (v < 0) {
      return g > 0 ? (root - v) / g : NEVER;
    }
    return v + root > 0 ? -2 * c / (v + root) : NEVER;
  }

  private double ux(int code) {
    return obstacles.ux(code);
  }

  private double uy(int code) {
    return obstacles.uy(code);
  }
}
