// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.LineShape;

/**
 * Circles that slide along one flat side, in closed form: with the part of gravity along it, {@code
 * g - (g.n) / (n.n) n}. From the end of a line they slide on along another one in line with it.
 */
public final class Sliding {

  private final ObstacleTable obstacles;
  private final Gravity gravity;
  private final Impulse impulse = new Impulse();

  // The direction of a side, from its start to its end; its start; its velocity.
  private double wx;
  private double wy;
  private double fromX;
  private double fromY;
  private double ux;
  private double uy;

  Sliding(ObstacleTable obstacles, Gravity gravity) {
    this.obstacles = obstacles;
    this.gravity = gravity;
  }

  /** Lets a circle fall freely. */
  void fall(MovingCircle m) {
    m.fall(gravity.x, gravity.y);
  }

  /** Lets a circle slide along the side or wall that it hit; n is the normal. */
  void slide(MovingCircle m, int code, double normalX, double normalY) {
    double scale = scale(normalX, normalY);
    double nx = normalX / scale;
    double ny = normalY / scale;
    m.fall(0, 0);
    m.support = code;
    m.last = code;
    ux = obstacles.ux(code);
    uy = obstacles.uy(code);
    project(m, nx, ny);
    impulse.of(1, gravity.x, gravity.y, nx, ny);
    m.gx = impulse.less(gravity.x, nx) + 0.0; // 0 for -0
    m.gy = impulse.less(gravity.y, ny) + 0.0;
  }

  /** The same for a circle that hit an end of a line, where its side has the normal n too. */
  void slideFromEnd(MovingCircle m, int code, double nx, double ny) {
    take(m, code);
    double side = Math.signum(wx * ny - wy * nx);
    slide(m, code, -side * wy, side * wx);
  }

  /** Removes the part along a normal from the velocity relative to the side. */
  private void project(MovingCircle m, double normalX, double normalY) {
    double scale = scale(normalX, normalY);
    double nx = normalX / scale;
    double ny = normalY / scale;
    double sx = m.vx - ux;
    double sy = m.vy - uy;
    if (sx * nx + sy * ny != 0) {
      impulse.of(1, sx, sy, nx, ny);
      m.vx = impulse.less(m.vx, nx) + 0.0;
      m.vy = impulse.less(m.vy, ny) + 0.0;
    }
  }

  /** Makes a normal along an axis a unit one: then nothing of a vector along it is left. */
  private static double scale(double nx, double ny) {
    return nx == 0 || ny == 0 ? Math.abs(nx + ny) : 1;
  }

  /** After a blow along n, a sliding circle goes on doing so only if that was along its side. */
  void goOn(MovingCircle m, double nx, double ny) {
    if (m.isCarried()) {
      take(m, m.support);
      double across = wx * ny - wy * nx;
      double size = (Math.abs(wx) + Math.abs(wy)) * (Math.abs(nx) + Math.abs(ny));
      if (Math.abs(across) > ContactLaw.FLAT * size) {
        lift(m);
        fall(m);
      } else {
        project(m, -wy, wx);
      }
    }
  }

  /** Whether a blow along n lifts a circle off the side that it slides on. */
  boolean opensBy(MovingCircle m, double nx, double ny) {
    take(m, m.support);
    double height = wx * (m.y - fromY) - wy * (m.x - fromX);
    return (wx * ny - wy * nx) * height > 0; // n . N > 0 for the normal N of its side
  }

  /** The part of gravity along n. */
  double pull(double nx, double ny) {
    return gravity.x * nx + gravity.y * ny;
  }

  /** Puts a circle off its one-way line, which would not keep one that is inside by rounding. */
  private void lift(MovingCircle m) {
    if (obstacles.isOneWay(m.support)) {
      double up = ContactLaw.ULPS * Math.ulp(size(m)) / Math.sqrt(wx * wx + wy * wy);
      m.x -= up * wy;
      m.y += up * wx;
    }
  }

  /**
   * Lets a circle fly off the end of its line if it is fast: gravity does not keep it at a distance
   * r from the end if {@code v^2 / r > |g.n|}.
   */
  boolean fliesOff(MovingCircle m) {
    int line = m.support;
    take(m, line);
    double length = Math.sqrt(wx * wx + wy * wy);
    double along = (wx * (m.vx - ux) + wy * (m.vy - uy)) / length;
    double pressure = Math.abs(wx * gravity.y - wy * gravity.x) / length;
    boolean flies = along * along > pressure * m.radius;
    if (flies) {
      fall(m);
      m.last = line;
      m.landing = line; // with last: only the ends can be hit
    }
    return flies;
  }

  /** Whether a circle is where a line ends, up to rounding. */
  boolean isAtEnd(MovingCircle m, int line) {
    return endOf(m, line) != 0;
  }

  /** Whether it is there, and moves away from the line. */
  boolean leavesEnd(MovingCircle m, int line) {
    int end = endOf(m, line);
    return end * (wx * (m.vx - ux) + wy * (m.vy - uy)) > 0;
  }

  /** The end of a line at which a circle is, up to rounding: -1 its start, 1 its end, 0 neither. */
  private int endOf(MovingCircle m, int line) {
    if (!Codes.isLine(line)) {
      return 0;
    }
    take(m, line);
    double square = wx * wx + wy * wy;
    double along = (wx * (m.x - fromX) + wy * (m.y - fromY)) / square;
    double length = Math.sqrt(square);
    double near = end(m, length) / length;
    return along <= near ? -1 : along >= 1 - near ? 1 : 0;
  }

  /**
   * Whether a sliding circle meets something along n where its own side has that normal, too. A
   * step of height d, which is rounding, turns the normal by {@code sqrt(2 d / r)}.
   */
  boolean isLevel(MovingCircle m, double nx, double ny) {
    take(m, m.support);
    double lengths = Math.sqrt(wx * wx + wy * wy) * Math.sqrt(nx * nx + ny * ny);
    double sine = (wx * nx + wy * ny) / lengths;
    return sine * sine <= ImpactRule.turn(m);
  }

  /** Whether a circle that hits an end of a line is where its side ends, with the same normal. */
  boolean isSquare(MovingCircle m, int code, double nx, double ny) {
    if (!Codes.isLine(code)) {
      return false;
    }
    take(m, code);
    double size = (Math.abs(wx) + Math.abs(wy)) * (Math.abs(nx) + Math.abs(ny));
    return size > 0 && Math.abs(wx * nx + wy * ny) <= ContactLaw.FLAT * size; // a point has no side
  }

  /** So near to its end a line carries no circle: others may end in the same place. */
  private static double end(MovingCircle m, double length) {
    return ContactLaw.ULPS * (Math.ulp(size(m)) + Math.ulp(length + size(m)));
  }

  private static double size(MovingCircle m) {
    return Math.max(Math.abs(m.x) + Math.abs(m.y), m.radius);
  }

  private void take(MovingCircle m, int code) {
    ux = obstacles.ux(code);
    uy = obstacles.uy(code);
    if (Codes.isWall(code)) {
      wx = Codes.isVertical(code) ? 0 : 1;
      wy = 1 - wx;
      fromX = wy * obstacles.walls[code];
      fromY = wx * obstacles.walls[code];
      return;
    }
    boolean moves = obstacles.moves(code);
    double[] row = moves ? obstacles.rowAt(code, m.t, m.tl) : obstacles.lines.values;
    int k = moves ? 0 : obstacles.lines.offset(code);
    fromX = row[k + LineShape.AX];
    fromY = row[k + LineShape.AY];
    wx = row[k + LineShape.BX] - fromX;
    wy = row[k + LineShape.BY] - fromY;
  }

  /**
   * Lets a circle slide on along another line, if it touches the side of that and moves along it.
   *
   * @return whether it does
   */
  boolean slidesOnto(MovingCircle m, int code) {
    if (!Codes.isLine(code) || obstacles.isSensor(code)) {
      return false;
    }
    if (obstacles.isGone(code) || !FilterBits.meet(m.filter, obstacles.filter(code))) {
      return false;
    }
    take(m, code);
    double length = Math.sqrt(wx * wx + wy * wy);
    double x = m.x - fromX;
    double y = m.y - fromY;
    double height = (wx * y - wy * x) / length;
    double from = (wx * x + wy * y) / length;
    double side = Math.signum(height);
    double along = (wx * (m.vx - ux) + wy * (m.vy - uy)) / length;
    double out = (wx * (m.vy - uy) - wy * (m.vx - ux)) / length;
    double pressure = -side * (wx * gravity.y - wy * gravity.x) / length;
    double near = ContactLaw.ULPS * Math.ulp(size(m));
    double behind = along > 0 ? from : length - from;
    boolean carries =
        Math.abs(side * height - m.radius) <= near
            && behind >= -near
            && length - behind > end(m, length)
            && along != 0
            && pressure > 0
            && out * out <= 2 * pressure * near
            && !(obstacles.isOneWay(code) && side < 0)
            && obstacles.outside(code) * side >= 0;
    if (carries) {
      slide(m, code, -side * wy, side * wx);
    }
    return carries;
  }
}
