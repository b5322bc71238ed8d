// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * What an impact does to the velocity: {@code v -= (1 + e) (v.n) / (n.n) n}, with a normal n of any
 * length and without the radius, so that errors do not feed on themselves.
 *
 * <p>n is the perpendicular of a line for its side, and the offset from the contact point to the
 * centre for an endpoint or a peg; a wall turns one component.
 *
 * <p>Restitution below 1, or clearance below rounding, can make infinitely many impacts in finite
 * time. A circle that makes {@link #patience} impacts without its centre leaving a place of 4 ulps
 * loses its motion along each further normal (e = 0); after as many again it is jammed: what it
 * touches becomes inert if it approaches by no more than rounding, so that it can slide along; else
 * it stops. An impact that approaches by no more than the rounding of the speeds that the circle
 * met at that place has nothing left to take away: it counts as a 32nd of the patience, for a
 * cluster with e = 0 makes thousands of them each time something joins it. Motion is taken away,
 * not given: the TC model of S. Luding and S. McNamara (How to handle the inelastic collapse of a
 * dissipative hard-sphere gas with the TC model, Granular Matter 1, 1998) instead makes impacts
 * elastic that follow each other too fast, which feeds back energy that the scene had taken away,
 * and needs a length of time that a scene does not have.
 */
final class ObstacleResponse {

  /** 4 ulps of a number of size 1..2 are 2^-50; of the size taken here, at most that. */
  private static final double PLACE = 0x1p-51;

  /** Approach, relative to the speed, that is no more than rounding: some ulps of the velocity. */
  private static final double ROUNDING = 0x1p-48;

  /** So much sooner patience ends with impacts that have nothing but rounding to take away. */
  private static final int FAINT = 32;

  /** Range of a normal's components within which products with velocities are safe. */
  private static final double LEAST = 0x1p-300;

  private static final double MOST = 0x1p300;

  private final Obstacles obstacles;
  private int patience;
  private final Impulse impulse = new Impulse();

  // The impact in hand: the contact point and the unnormalized normal.
  private double contactX;
  private double contactY;
  private double nx;
  private double ny;

  ObstacleResponse(Obstacles obstacles, int patience) {
    this.obstacles = obstacles;
    this.patience = patience;
  }

  void setPatience(int impacts) {
    patience = impacts;
  }

  /**
   * Flies a mover to the impact found ahead, changes its velocity, and writes it into the log. At a
   * sensor it only writes.
   *
   * @return whether a new flight begins
   */
  boolean resolve(Mover m, ImpactLog log) {
    int code = m.next;
    if (obstacles.isSensor(code)) {
      sense(m, code, log);
      return false;
    }
    m.fly(m.cleared);
    double vn = report(m, code, m.t, log);
    double speed = Math.abs(m.vx) + Math.abs(m.vy);
    boolean stuck = countStuck(m, m.flown * speed, speed, vn / (Math.abs(nx) + Math.abs(ny)));
    double e = stuck ? 0 : m.restitution * obstacles.restitution(code);
    if (vn < 0) {
      reflect(m, code, e);
    }
    if (isJammed(m)) {
      jam(m, code, -vn / Math.sqrt(nx * nx + ny * ny));
      log.setJammed();
    }
    m.last = code;
    m.newFlight();
    return true;
  }

  /** Writes that a mover meets a sensor; the flight goes on, and is known up to there. */
  private void sense(Mover m, int code, ImpactLog log) {
    double x = m.x;
    double y = m.y;
    m.x = Math.fma(m.vx, m.cleared, x);
    m.y = Math.fma(m.vy, m.cleared, y);
    report(m, code, m.after(m.cleared), log);
    m.x = x;
    m.y = y;
    m.next = Mover.NOTHING;
    m.contact = code;
  }

  /** Writes an impact of a mover that stands where it touches, and returns v.n. */
  private double report(Mover m, int code, double time, ImpactLog log) {
    locate(m, code);
    double vn = dot(m.vx, m.vy, nx, ny);
    log.add(
        time,
        m.id,
        obstacles.kind(code),
        obstacles.index(code),
        obstacles.feature(code, m.contact));
    log.set(contactX, contactY, nx, ny, vn);
    return vn;
  }

  private void reflect(Mover m, int code, double e) {
    if (code >= Obstacles.WALLS) {
      impulse.of(1 + e, m.vx, m.vy, nx, ny);
      m.vx = impulse.change(m.vx, -1, 0, nx);
      m.vy = impulse.change(m.vy, -1, 0, ny);
    } else if (code <= Obstacles.RIGHT) {
      m.vx = -e * m.vx + 0.0; // + 0 turns -0 into 0
    } else {
      m.vy = -e * m.vy + 0.0;
    }
    stopBeyondRange(m);
  }

  /** A circle that an impact would make faster than doubles can tell stops. */
  static void stopBeyondRange(Mover m) {
    if (!(Math.abs(m.vx) <= Double.MAX_VALUE && Math.abs(m.vy) <= Double.MAX_VALUE)) {
      m.vx = 0;
      m.vy = 0;
    }
  }

  /** Finds the contact point and the normal. */
  private void locate(Mover m, int code) {
    if (code < Obstacles.WALLS) {
      locateOnWall(m, code);
    } else if (code < Obstacles.PEGS) {
      locateOnLine(m, obstacles.offset(code));
    } else {
      locateOnPeg(m, obstacles.offset(code));
    }
  }

  private void locateOnWall(Mover m, int code) {
    boolean low = code == Obstacles.LEFT || code == Obstacles.BOTTOM;
    boolean vertical = code <= Obstacles.RIGHT;
    nx = vertical ? (low ? 1 : -1) : 0;
    ny = vertical ? 0 : (low ? 1 : -1);
    Bounds b = obstacles.bounds;
    contactX = vertical ? (low ? b.xmin() : b.xmax()) : m.x;
    contactY = vertical ? m.y : (low ? b.ymin() : b.ymax());
  }

  private void locateOnLine(Mover m, int k) {
    double[] lines = obstacles.lines;
    double ax = lines[k];
    double ay = lines[k + 1];
    double bx = lines[k + 2];
    double by = lines[k + 3];
    switch (m.contact & ~SegmentSweep.NOW) {
      case SegmentSweep.LEFT -> locateOnSide(1, m, ax, ay, bx - ax, by - ay);
      case SegmentSweep.RIGHT -> locateOnSide(-1, m, ax, ay, bx - ax, by - ay);
      case SegmentSweep.START -> locateOnEnd(m, ax, ay, bx - ax, by - ay);
      default -> locateOnEnd(m, bx, by, ax - bx, ay - by);
    }
  }

  /**
   * An end of a line, w pointing from it to the other end. A point particle has no offset from it:
   * its normal is the limit from before, that of the side where it came along that.
   */
  private void locateOnEnd(Mover m, double x, double y, double wx, double wy) {
    locateAt(m, x, y, 0);
    if (m.radius == 0 && m.vx * wx + m.vy * wy < 0) {
      boolean left = wy * m.vx - wx * m.vy > 0;
      normal(left ? -wy : wy, left ? wx : -wx);
    }
  }

  /** n is the left or right perpendicular of w; the contact is its foot, s = (p - a).w / w.w. */
  private void locateOnSide(int side, Mover m, double ax, double ay, double wx, double wy) {
    double s = ((m.x - ax) * wx + (m.y - ay) * wy) / (wx * wx + wy * wy);
    contactX = Math.fma(s, wx, ax);
    contactY = Math.fma(s, wy, ay);
    normal(-side * wy, side * wx);
  }

  private void locateOnPeg(Mover m, int k) {
    locateAt(m, obstacles.pegs[k], obstacles.pegs[k + 1], obstacles.pegs[k + 2]);
  }

  /**
   * n is the offset from (cx, cy) to the centre; that of two points is the limit from before, -v.
   */
  private void locateAt(Mover m, double cx, double cy, double radius) {
    double reach = radius + m.radius;
    double share = reach == 0 ? 0 : radius / reach;
    contactX = Math.fma(share, m.x - cx, cx);
    contactY = Math.fma(share, m.y - cy, cy);
    if (reach == 0) {
      normal(-m.vx, -m.vy);
    } else {
      normal(m.x - cx, m.y - cy);
    }
  }

  /** Keeps a normal, scaled by a power of two where its square would leave the range of doubles. */
  private void normal(double x, double y) {
    double size = Math.max(Math.abs(x), Math.abs(y));
    if (size > LEAST && size < MOST) {
      // + 0 turns -0 into 0.
      nx = x + 0.0;
      ny = y + 0.0;
    } else {
      int exponent = Math.getExponent(size);
      nx = Math.scalb(x, -exponent) + 0.0;
      ny = Math.scalb(y, -exponent) + 0.0;
    }
  }

  /** a.b to within two ulps, whatever cancels (W. Kahan's difference of products). */
  static double dot(double ax, double ay, double bx, double by) {
    double p = ay * by;
    return Math.fma(ax, bx, p) + Math.fma(ay, by, -p);
  }

  /**
   * Counts an impact, and tells whether the circle is stuck: for more impacts than patience allows
   * its clock has not moved; or it has not left its place and what it hit came from no further; or
   * it slid along what it hit, and neither moved against the other by more than rounding. A jammed
   * one that slides on stays so until something approaches it by more than rounding.
   *
   * @param way what the two moved against each other since the circle's last impact
   * @param speed the sum of the components of what moves
   * @param approach along the normal
   */
  boolean countStuck(Mover m, double way, double speed, double approach) {
    double size = Math.max(Math.max(Math.abs(m.anchorX), Math.abs(m.anchorY)), m.radius) * PLACE;
    boolean here = Math.abs(m.x - m.anchorX) <= size && Math.abs(m.y - m.anchorY) <= size;
    int pace = Math.max(m.pace, Math.getExponent(speed));
    boolean faint = Math.abs(approach) <= ROUNDING * Math.scalb(1.0, pace);
    boolean slides = faint && (isJammed(m) || m.flown * Math.abs(approach) <= size);
    if (m.standsStill || (here && way <= size) || slides) {
      m.stuck = Math.min(m.stuck + (faint ? 1 + patience / FAINT : 1), 2 * patience + 1);
      m.pace = pace;
    } else {
      m.stuck = 0;
      m.pace = Math.getExponent(speed);
      m.anchorX = m.x;
      m.anchorY = m.y;
      m.jam = null;
    }
    return m.stuck > patience;
  }

  boolean isJammed(Mover m) {
    return m.stuck > 2 * patience;
  }

  /**
   * Lets the circle slide along what it hit if that is all it does; stops it otherwise, and what it
   * slid along is there for it again.
   */
  private void jam(Mover m, int code, double approach) {
    if (approach <= ROUNDING * (Math.abs(m.vx) + Math.abs(m.vy))) {
      m.jam = Jam.with(m.jam, code);
    } else {
      m.vx = 0;
      m.vy = 0;
      m.jam = Jam.ofCircles(m.jam, Obstacles.CIRCLES);
    }
  }
}
