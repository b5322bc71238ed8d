// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Filter;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.LineShape;
import java.util.function.Function;

/**
 * How bounces under gravity end. A ball that bounces with a restitution below 1 makes infinitely
 * many impacts in finite time. So, after an impact that has changed the velocity:
 *
 * <ul>
 *   <li><b>Side or wall.</b> A circle whose next hop would be lower than rounding can show slides
 *       along it from now on, with the part of gravity along it. On level ground it rests or rolls
 *       on for ever.
 *   <li><b>Corner.</b> A sliding circle that hits something else, and hops from neither, rests if
 *       the two normals hold gravity between them; else it slides on along what it hit. Between
 *       things that move unlike each other it hops as from what is round.
 *   <li><b>Round.</b> Sliding over an end of a line, a peg or a circle has no closed form. A circle
 *       pressed against one leaves it fast enough for a hop of 2^-12 of the combined radius R. If
 *       all its motion could lift it by no more than 2^-10 R, and something within 2^-9 R holds it
 *       together with what it hit, it rests.
 * </ul>
 */
public final class Settling {

  /** The least hop from what is round, in combined radii. */
  public static final double LEAST_HOP = 0x1p-12;

  /** A circle whose motion could lift it by no more than so many least hops may rest. */
  private static final double CALM_HOPS = 4;

  /** What holds such a circle is no further away, in combined radii. */
  private static final double HOLD = 8 * LEAST_HOP;

  /** Nor in radii of the circle: the cells of the grid list what is within 2^-8 of a radius. */
  private static final double MOST_HOLD = 0x1p-8 - 0x1p-18;

  /** A contact of two circles is slow if they approach by no more than so many least speeds. */
  private static final double SLOW_APPROACH = 3;

  /** A circle whose motion could lift it by no more than so many least hops may lie in a heap. */
  private static final double SLOW_HOPS = 64;

  /** What holds a circle in a heap is no further away, in combined radii. */
  private static final double HEAP_HOLD = 32 * LEAST_HOP;

  /**
   * The sine of the least angle between two things that move unlike each other and carry a circle.
   * Along one of them it leaves the other by the least speed, so at that over the sine.
   */
  private static final double LEAST_SINE = 0x1p-10;

  /** A hop that is no higher than so many ulps of the coordinates is none. */
  private static final double ULPS = 2;

  /** The largest ulp of a number, in proportion. */
  private static final double ULP = 0x1p-52;

  /** At a joint, gaps and hops of so many ulps are none. */
  private static final double JOINT_ULPS = 8;

  /** In units of the speed: far more than the rounding of its part along a normal. */
  static final double ROUNDING = 0x1p-40;

  private final ObstacleTable obstacles;
  private final Gravity gravity;
  private final Impulse impulse = new Impulse();
  final Escape escape;

  /** The unit normal of what the circle hit, and of what carries it. */
  private double nx;

  private double ny;
  private double carrierX;
  private double carrierY;

  /** The codes of obstacles that a circle may touch, ascending. */
  private final Function<MovingCircle, int[]> near;

  public Settling(ObstacleTable obstacles, Gravity gravity, Function<MovingCircle, int[]> near) {
    this.obstacles = obstacles;
    this.gravity = gravity;
    this.near = near;
    escape = new Escape(obstacles, this, near);
  }

  /**
   * Decides how a circle goes on after an impact.
   *
   * @param m the circle, with its new velocity
   * @param point where it touches
   * @param reach the distance of its centre from what is round; 0 for a side or a wall
   * @param e the restitution
   */
  void settle(
      MovingCircle m, int code, ContactPoint point, double reach, double e, ImpactRows log) {
    if (!m.isSupported() && isFast(m, point, reach)) {
      m.fall(gravity.x, gravity.y);
      return;
    }
    double length = StrictMath.hypot(point.nx, point.ny);
    nx = point.nx / length;
    ny = point.ny / length;
    double bounce = (m.vx - point.ux) * nx + (m.vy - point.uy) * ny;
    boolean carried = m.isCarried() && m.support != code && staysOn(m);
    if (!carried) {
      m.fall(gravity.x, gravity.y);
    }
    double sx = m.vx - point.ux;
    double sy = m.vy - point.uy;
    double out = sx * nx + sy * ny;
    double along = sy * nx - sx * ny;
    if (bounce > 0 && out < -ROUNDING * Math.abs(along)) {
      m.last = MovingCircle.NOTHING; // what carries it leads it there again
    }
    double pressure = -(m.gx * nx + m.gy * ny);
    if (reach > 0 && !carried) {
      hop(m, out, pressure - along * along / reach, reach, e);
      if (e < 1 && isCalm(m, reach) && isHeld(m, code)) {
        pin(m);
        log.setOutcome(ImpactRows.SETTLED);
      }
    } else if (pressure > 0 && !isHop(m, out, pressure)) {
      boolean isHeld = carried && holdsBetween();
      if (isHeld && restsBetween(m, code, point, reach)) {
        log.setOutcome(ImpactRows.SETTLED);
      } else if (!(isHeld && hopsBetween(m, point, out, pressure, reach))) {
        log.setOutcome(ImpactRows.SETTLED);
        if (reach == 0) {
          slide(m, code, point);
        } else {
          m.fall(gravity.x, gravity.y);
        }
      }
    }
  }

  /**
   * Whether a circle certainly leaves so fast that nothing ends: it hops from a side, leaves what
   * is round by more than the least speed, and is not calm. So most impacts need no unit normal.
   */
  private boolean isFast(MovingCircle m, ContactPoint point, double reach) {
    double x = (m.vx - point.ux) * point.nx;
    double y = (m.vy - point.uy) * point.ny;
    double size = Math.abs(m.x) + Math.abs(m.y) + m.radius;
    double hop = ULPS * (ULP * size + Double.MIN_NORMAL) + CALM_HOPS * LEAST_HOP * reach;
    double pull = Math.abs(gravity.x) + Math.abs(gravity.y);
    // A hop of this height takes the square of a speed of 2 g times it: twice that is left for
    // rounding. The least normal numbers cover underflow.
    double square = 4 * (pull * hop + Double.MIN_NORMAL);
    return isAbove(square, x, y, point.nx, point.ny);
  }

  /**
   * Whether the square of a speed along a normal n is certainly above another.
   *
   * @param x,y the terms of the product of the velocity and n
   */
  private static boolean isAbove(double square, double x, double y, double nx, double ny) {
    double out = x + y;
    return out > ROUNDING * (Math.abs(x) + Math.abs(y))
        && out * out > square * (nx * nx + ny * ny) + Double.MIN_NORMAL;
  }

  /** Lets a circle go on falling freely. */
  public void fall(MovingCircle m) {
    m.fall(gravity.x, gravity.y);
  }

  /** The speed of the least hop from what is round, for the sum of the radii. */
  double leastSpeed(double reach) {
    return Math.sqrt(2 * gravity.size() * LEAST_HOP * reach);
  }

  /**
   * The least speed at which two circles leave each other.
   *
   * @param out the speed at which they would
   * @param e the restitution
   */
  double leastSpeed(MovingCircle a, MovingCircle b, double out, double e) {
    double least = leastSpeed(a.radius + b.radius);
    return out < least && (e < 1 || !isHop(a, out, gravity.size())) ? least : out;
  }

  /**
   * Whether two circles certainly leave each other by more than their least speed, along a normal
   * of any length. So most collisions need no unit normal.
   *
   * @param x,y the terms of the product of the relative velocity and the normal
   * @param reach the sum of the radii
   */
  boolean isFast(double x, double y, double nx, double ny, double reach) {
    // Four times the square of the least speed: that leaves half of the speed for rounding.
    return isAbove(8 * gravity.size() * LEAST_HOP * reach, x, y, nx, ny);
  }

  /**
   * The least speed at which a circle leaves one that is held: that of a peg.
   *
   * @param kx,ky the unit normal, which points to the circle
   * @param reach the sum of the radii
   * @param out the speed at which it would leave
   */
  double leastSpeed(MovingCircle m, double kx, double ky, double reach, double out, double e) {
    double along = m.vy * kx - m.vx * ky;
    double pressure = -(m.gx * kx + m.gy * ky) - along * along / reach;
    return pressure > 0 && (e < 1 || !isHop(m, out, pressure))
        ? Math.max(out, Math.sqrt(2 * pressure * LEAST_HOP * reach))
        : out;
  }

  /** Whether two circles approach each other by no more than some least speeds. */
  boolean isSlow(MovingCircle a, MovingCircle b, double approach) {
    double hop = LEAST_HOP * (a.radius + b.radius);
    return approach * approach <= SLOW_APPROACH * SLOW_APPROACH * 2 * gravity.size() * hop;
  }

  /** Whether a circle of finite mass is so slow that it may rest in a heap. */
  boolean mayRest(MovingCircle m) {
    double hop = LEAST_HOP * (2 * m.radius);
    boolean isSlow = m.vx * m.vx + m.vy * m.vy <= 2 * gravity.size() * SLOW_HOPS * hop;
    return isSlow && m.isFalling() && m.jam == null && !StuckRule.isStuck(m);
  }

  /**
   * Decides whether a circle that slid or rested still does after a collision. If that changes its
   * velocity, it may meet its partner again.
   */
  void afterPair(MovingCircle m) {
    if (!m.isFalling() || m.jam != null) {
      return;
    }
    double vx = m.vx;
    double vy = m.vy;
    if (!m.isCarried() || !staysOn(m)) {
      m.fall(gravity.x, gravity.y);
    } else if (m.vx != vx || m.vy != vy) {
      m.last = MovingCircle.NOTHING;
    }
  }

  /** Stops a circle where it is: it rests there, as a jammed one. */
  static void pin(MovingCircle m) {
    StopRule.stop(m);
    m.fall(0, 0);
    m.pinned = true;
  }

  /**
   * Lets a circle rest between what carries it and what it hit, if these move alike. If one of them
   * moves along the other one, which is straight, the circle goes with it, along that.
   *
   * @return whether it does
   */
  private boolean restsBetween(MovingCircle m, int code, ContactPoint point, double reach) {
    int carrier = m.support;
    double ux = obstacles.ux(carrier);
    double uy = obstacles.uy(carrier);
    double x = point.ux - ux;
    double y = point.uy - uy;
    if (x == 0 && y == 0) {
      rest(m, code, ux, uy);
    } else if (x * carrierX + y * carrierY == 0) {
      rest(m, carrier, point.ux, point.uy);
    } else if (reach == 0 && x * nx + y * ny == 0) {
      rest(m, code, ux, uy);
    } else {
      return false;
    }
    return true;
  }

  /**
   * Lets a circle hop between what carries it and what it hit, if these move unlike each other: it
   * leaves what it hit by the least speed, along what carries it. So it follows both.
   *
   * @return whether it does; not if the two are all but parallel, or if that speed is mere rounding
   */
  private boolean hopsBetween(
      MovingCircle m, ContactPoint point, double out, double pressure, double reach) {
    double sine = carrierX * ny - carrierY * nx;
    double hop = LEAST_HOP * (reach > 0 ? reach : m.radius);
    double least = Math.sqrt(2 * pressure * hop);
    double speeds = Math.abs(m.vx) + Math.abs(m.vy) + Math.abs(point.ux) + Math.abs(point.uy);
    if (Math.abs(sine) < LEAST_SINE || least < ROUNDING * speeds) {
      return false;
    }
    double along = (least - out) / sine;
    m.vx -= along * carrierY;
    m.vy += along * carrierX;
    return true;
  }

  private static void rest(MovingCircle m, int support, double vx, double vy) {
    m.fall(0, 0);
    m.vx = vx;
    m.vy = vy;
    m.support = support;
  }

  /** Whether a circle leaves with a speed that makes a hop of more than rounding. */
  private static boolean isHop(MovingCircle m, double out, double pressure) {
    return out * out > 2 * pressure * ULPS * ulp(m);
  }

  /** Whether a height is none at a joint. */
  boolean isLevel(MovingCircle m, double height) {
    return height <= JOINT_ULPS * ulp(m);
  }

  private static double ulp(MovingCircle m) {
    return Math.ulp(Math.max(Math.max(Math.abs(m.x), Math.abs(m.y)), m.radius));
  }

  /**
   * Lets a circle that comes to the end of the line on which it slides go on along another one, if
   * that carries it: it touches its side, and moves along it.
   *
   * @return whether it does
   */
  boolean slidesOnto(MovingCircle m, int code) {
    if (!Codes.isLine(code) || !isSolid(m, code)) {
      return false;
    }
    boolean moves = obstacles.moves(code);
    double[] row = moves ? obstacles.rowAt(code, m.t, m.tl) : obstacles.lines.values;
    int k = moves ? 0 : obstacles.lines.offset(code);
    double wx = row[k + LineShape.BX] - row[k + LineShape.AX];
    double wy = row[k + LineShape.BY] - row[k + LineShape.AY];
    double x = m.x - row[k + LineShape.AX];
    double y = m.y - row[k + LineShape.AY];
    double length = Math.sqrt(wx * wx + wy * wy);
    double height = (wx * y - wy * x) / length;
    double from = (wx * x + wy * y) / length;
    double ux = obstacles.ux(code);
    double uy = obstacles.uy(code);
    double along = (wx * (m.vx - ux) + wy * (m.vy - uy)) / length;
    double side = Math.signum(height);
    double out = side * (wx * (m.vy - uy) - wy * (m.vx - ux)) / length;
    double pressure = -side * (wx * gravity.y - wy * gravity.x) / length;
    double near = JOINT_ULPS * ulp(m);
    double behind = along > 0 ? from : length - from;
    boolean carries =
        Math.abs(side * height - m.radius) <= near
            && behind >= -near
            && length - behind > end(m, length)
            && along != 0
            && pressure > 0
            && out * out <= 2 * pressure * near
            && !(obstacles.isOneWay(code) && side < 0);
    if (carries) {
      project(m, ux, uy, -side * wy, side * wx);
      accelerateAlong(m, -side * wy, side * wx);
      m.support = code;
      m.last = code;
    }
    return carries;
  }

  /** Whether an obstacle at rest is a line of which a circle has come to the end. */
  boolean endsHere(MovingCircle m, int code) {
    if (!Codes.isLine(code)) {
      return false;
    }
    double[] row = obstacles.lines.values;
    int k = obstacles.lines.offset(code);
    double wx = row[k + LineShape.BX] - row[k + LineShape.AX];
    double wy = row[k + LineShape.BY] - row[k + LineShape.AY];
    boolean forward = wx * m.vx + wy * m.vy > 0;
    double x = row[k + (forward ? LineShape.BX : LineShape.AX)] - m.x;
    double y = row[k + (forward ? LineShape.BY : LineShape.AY)] - m.y;
    double length = Math.sqrt(wx * wx + wy * wy);
    double ahead = (forward ? wx * x + wy * y : -wx * x - wy * y) / length;
    return ahead <= end(m, length);
  }

  /**
   * So near to its end a line carries no circle: lines that end in one place, up to rounding, would
   * hand it to each other.
   */
  private static double end(MovingCircle m, double length) {
    return JOINT_ULPS * (ulp(m) + Math.ulp(length + Math.abs(m.x) + Math.abs(m.y)));
  }

  /** Lets a circle that is pressed against something round leave it by the least speed. */
  private void hop(MovingCircle m, double out, double pressure, double reach, double e) {
    if (pressure > 0 && (e < 1 || !isHop(m, out, pressure))) {
      double least = Math.sqrt(2 * pressure * LEAST_HOP * reach);
      if (out < least) {
        m.vx += (least - out) * nx;
        m.vy += (least - out) * ny;
      }
    }
  }

  /** Lets a circle slide along the side or wall that it hit, with the part of gravity along it. */
  private void slide(MovingCircle m, int code, ContactPoint point) {
    project(m, point.ux, point.uy, point.nx, point.ny);
    accelerateAlong(m, point.nx, point.ny);
    m.support = code;
  }

  /** Sets the acceleration to the part of gravity along a side with a given normal. */
  private void accelerateAlong(MovingCircle m, double normalX, double normalY) {
    impulse.of(1, gravity.x, gravity.y, normalX, normalY);
    m.gx = impulse.less(gravity.x, normalX) + 0.0; // 0 for -0
    m.gy = impulse.less(gravity.y, normalY) + 0.0;
  }

  /** Removes the part along a normal from the velocity relative to an obstacle. */
  private void project(MovingCircle m, double ux, double uy, double normalX, double normalY) {
    double sx = m.vx - ux;
    double sy = m.vy - uy;
    if (sx * normalX + sy * normalY != 0) {
      impulse.of(1, sx, sy, normalX, normalY);
      m.vx = impulse.less(m.vx, normalX) + 0.0;
      m.vy = impulse.less(m.vy, normalY) + 0.0;
    }
  }

  /** Whether a circle that slides or rests goes on doing so after an impact with something else. */
  private boolean staysOn(MovingCircle m) {
    int code = m.support;
    double wx = 0;
    double wy = 0;
    if (Codes.isWall(code)) {
      wx = Codes.isVertical(code) ? Codes.inwards(code) : 0;
      wy = Codes.isVertical(code) ? 0 : Codes.inwards(code);
    } else if (Codes.isLine(code)) {
      boolean moves = obstacles.moves(code);
      double[] row = moves ? obstacles.rowAt(code, m.t, m.tl) : obstacles.lines.values;
      int k = moves ? 0 : obstacles.lines.offset(code);
      wx = row[k + LineShape.AY] - row[k + LineShape.BY];
      wy = row[k + LineShape.BX] - row[k + LineShape.AX];
      double side = wx * (m.x - row[k + LineShape.AX]) + wy * (m.y - row[k + LineShape.AY]);
      wx = side < 0 ? -wx : wx;
      wy = side < 0 ? -wy : wy;
    }
    double length = Math.sqrt(wx * wx + wy * wy);
    if (!(length > 0)) {
      return false;
    }
    carrierX = wx / length;
    carrierY = wy / length;
    double ux = obstacles.ux(code);
    double uy = obstacles.uy(code);
    double out = (m.vx - ux) * carrierX + (m.vy - uy) * carrierY;
    double pressure = -(gravity.x * carrierX + gravity.y * carrierY);
    if (!(pressure > 0) || isHop(m, out, pressure)) {
      return false;
    }
    project(m, ux, uy, wx, wy);
    accelerateAlong(m, wx, wy);
    return true;
  }

  /** Whether all the motion of a circle could lift it by no more than some least hops. */
  private boolean isCalm(MovingCircle m, double reach) {
    return m.vx * m.vx + m.vy * m.vy <= 2 * gravity.size() * CALM_HOPS * LEAST_HOP * reach;
  }

  /** Whether what a circle hit holds it against gravity, alone or with another thing at rest. */
  private boolean isHeld(MovingCircle m, int code) {
    if (!obstacles.isAtRest(code)) {
      return false;
    }
    if (nx * gravity.y == ny * gravity.x) {
      return nx * gravity.x + ny * gravity.y < 0; // it stands on the top, or hangs under it
    }
    for (int other : near.apply(m)) {
      if (other != code && isSolid(m, other) && obstacles.isAtRest(other)) {
        Touch touch = touch(m, other);
        if (touch != null) {
          carrierX = touch.nx();
          carrierY = touch.ny();
          if (holdsBetween()) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /**
   * Whether a circle bounces off an obstacle: that is not removed, the filters let them meet, it is
   * no sensor, and the circle does not ignore it.
   */
  boolean isSolid(MovingCircle m, int code) {
    return Filter.meet(m.filter, obstacles.filter(code))
        && (Codes.isWall(code)
            ? obstacles.walls != null
            : !obstacles.isGone(code) && !obstacles.isSensor(code))
        && (m.jam == null || !m.jam.concerns(code));
  }

  /** The contact with an obstacle that may hold a circle; null if it is too far away. */
  private Touch touch(MovingCircle m, int code) {
    return touch(m, code, HOLD);
  }

  private Touch touch(MovingCircle m, int code, double hold) {
    double radius = Codes.isWall(code) ? 0 : obstacles.radius(code);
    double distance = Math.min(hold * (m.radius + radius), MOST_HOLD * m.radius);
    return Touch.of(m, obstacles, code, distance);
  }

  /** The contact with an obstacle at rest that may hold a circle in a heap; null for none. */
  Touch touchInHeap(MovingCircle m, int code) {
    return isSolid(m, code) && obstacles.isAtRest(code) ? touch(m, code, HEAP_HOLD) : null;
  }

  /** The contact of two circles in a heap; null if they are too far from each other. */
  static Touch touchInHeap(MovingCircle a, MovingCircle b) {
    return Touch.of(a, b, HEAP_HOLD * (a.radius + b.radius));
  }

  /** Whether an obstacle may hold a circle at its place. */
  public boolean touches(MovingCircle m, int code) {
    return touch(m, code, HEAP_HOLD) != null;
  }

  /**
   * Whether the normals of what the circle hit and of what carries it hold gravity between them.
   */
  private boolean holdsBetween() {
    double cross = carrierX * ny - carrierY * nx;
    double ofCarrier = nx * gravity.y - ny * gravity.x;
    double ofHit = gravity.x * carrierY - gravity.y * carrierX;
    return cross > 0 ? ofCarrier >= 0 && ofHit >= 0 : cross < 0 && ofCarrier <= 0 && ofHit <= 0;
  }
}
