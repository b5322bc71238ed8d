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
 * it stops, and the circles that are jammed to it with it. Two jammed circles that approach each
 * other by more than rounding go on as one {@link Piece}. An impact that approaches by no more than
 * the rounding of the speeds that the circle met at that place has nothing left to take away: it
 * counts as a 32nd of the patience, for a cluster with e = 0 makes thousands of them each time
 * something joins it. Motion is taken away, not given: the TC model of S. Luding and S. McNamara
 * (How to handle the inelastic collapse of a dissipative hard-sphere gas with the TC model,
 * Granular Matter 1, 1998) instead makes impacts elastic that follow each other too fast, which
 * feeds back energy that the scene had taken away, and needs a length of time that a scene does not
 * have.
 */
final class ObstacleResponse {

  /** 4 ulps of a number of size 1..2 are 2^-50; of the size taken here, at most that. */
  private static final double PLACE = 0x1p-51;

  /** Approach, relative to the speed, that is no more than rounding: some ulps of the velocity. */
  private static final double ROUNDING = 0x1p-48;

  /** So much sooner patience ends with impacts that have nothing but rounding to take away. */
  private static final int FAINT = 32;

  /** Range of a normal's size, and of a speed, within which their products are safe. */
  private static final double LEAST = 0x1p-300;

  private static final double MOST = 0x1p300;

  /**
   * An offset that is smaller than so much of a coordinate, or of one where the flight started, may
   * be mere rounding: 2^10 ulps.
   */
  private static final double SMALL = 0x1p-43;

  /** A normal is so many binary places above 1 for slow motion, whose own places may be few. */
  private static final int SLOW = 60;

  private final Obstacles obstacles;
  private int patience;
  private final Impulse impulse = new Impulse();

  /** Whether the last impact jammed what then has to go on as one piece. */
  private boolean seizes;

  /** Where the flight started that ends in the impact in hand. */
  private double startX;

  private double startY;

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
    startX = m.x;
    startY = m.y;
    m.fly(m.cleared);
    double vn = report(m, code, m.t, log);
    double speed = Math.abs(m.vx) + Math.abs(m.vy);
    seizes = false;
    boolean stuck = countStuck(m, m.flown * speed, speed, vn / (Math.abs(nx) + Math.abs(ny)));
    double e = stuck ? 0 : m.restitution * obstacles.restitution(code);
    if (vn < 0) {
      reflect(m, code, e);
    }
    if (isJammed(m)) {
      jam(m, code, -vn / Math.sqrt(nx * nx + ny * ny));
      log.setJammed();
    } else {
      m.jam = Jam.ofCircles(m.jam, Obstacles.CIRCLES);
    }
    m.last = code;
    m.newFlight();
    return true;
  }

  /** Writes that a mover meets a sensor; the flight goes on, and is known up to there. */
  private void sense(Mover m, int code, ImpactLog log) {
    startX = m.x;
    startY = m.y;
    m.x = Math.fma(m.vx, m.cleared, m.x);
    m.y = Math.fma(m.vy, m.cleared, m.y);
    report(m, code, m.after(m.cleared), log);
    m.x = startX;
    m.y = startY;
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
      m.vx = impulse.less(m.vx, nx);
      m.vy = impulse.less(m.vy, ny);
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
    double wall = obstacles.walls[code];
    int inwards = 1 - 2 * (code & 1); // the lower wall of an axis has the even code
    if (code <= Obstacles.RIGHT) {
      nx = inwards;
      ny = 0;
      contactX = wall;
      contactY = m.y;
    } else {
      nx = 0;
      ny = inwards;
      contactX = m.x;
      contactY = wall;
    }
  }

  private void locateOnLine(Mover m, int k) {
    double[] lines = obstacles.lines;
    int contact = m.contact & ~SegmentSweep.NOW;
    if (contact >= SegmentSweep.START) {
      // Which end it is, no processor can foretell: its place is computed.
      int end = (contact - SegmentSweep.START) * Scene.END;
      int other = Scene.END - end;
      locateOnEnd(m, lines[k + end], lines[k + end + 1], lines[k + other], lines[k + other + 1]);
      return;
    }
    double ax = lines[k];
    double ay = lines[k + 1];
    double bx = lines[k + 2];
    double by = lines[k + 3];
    if (contact == SegmentSweep.LEFT) {
      locateOnSide(m, ax, ay, bx, by, ay, bx, by, ax);
    } else {
      locateOnSide(m, ax, ay, bx, by, by, ax, ay, bx);
    }
  }

  /**
   * An end of a line, the other one being o. A point particle has no offset from it: its normal is
   * the limit from before, that of the side where it came along that.
   */
  private void locateOnEnd(Mover m, double x, double y, double ox, double oy) {
    locateAt(m, x, y, 0);
    if (m.radius == 0 && Predicates.dot(m.vx, m.vy, 0, 0, ox, oy, x, y) < 0) {
      boolean left = Predicates.cross(m.vx, m.vy, 0, 0, ox, oy, x, y) > 0;
      if (left) {
        normal(m, y, ox, oy, x);
      } else {
        normal(m, oy, x, y, ox);
      }
    }
  }

  /**
   * n is p - q, the perpendicular of w = b - a on the centre's side; the contact is its foot, s =
   * (c - a).w / w.w.
   */
  private void locateOnSide(
      Mover m,
      double ax,
      double ay,
      double bx,
      double by,
      double px,
      double py,
      double qx,
      double qy) {
    double wx = bx - ax;
    double wy = by - ay;
    double size = Math.max(Math.abs(wx), Math.abs(wy));
    double s =
        size > LEAST && size < MOST
            ? ((m.x - ax) * wx + (m.y - ay) * wy) / (wx * wx + wy * wy)
            : Line.fraction(ax, ay, bx, by, Vec2.within(m.x), Vec2.within(m.y));
    contactX = Line.between(s, ax, bx);
    contactY = Line.between(s, ay, by);
    normal(m, px, py, qx, qy);
  }

  private void locateOnPeg(Mover m, int k) {
    locateAt(m, obstacles.pegs[k], obstacles.pegs[k + 1], obstacles.pegs[k + 2]);
  }

  /**
   * n is the offset from (cx, cy) to the centre; that of two points is the limit from before, -v;
   * where the offset is lost in the rounding of the centre, it is the detector's normal.
   */
  private void locateAt(Mover m, double cx, double cy, double radius) {
    double share = share(radius, m.radius);
    contactX = Line.between(share, cx, Vec2.within(m.x));
    contactY = Line.between(share, cy, Vec2.within(m.y));
    double reach = radius + m.radius;
    if (reach == 0) {
      normal(m, 0, 0, m.vx, m.vy);
    } else if (reach < SMALL * Math.max(size(cx, cy), size(startX, startY))) {
      Vec2 n =
          DiskSweep.normal(startX, startY, m.radius, m.vx, m.vy, cx, cy, radius, 0, 0, m.cleared);
      normal(m, n.x(), n.y(), 0, 0);
    } else {
      offset(m, cx, cy);
    }
  }

  private static double size(double x, double y) {
    return Math.max(Math.abs(x), Math.abs(y));
  }

  /**
   * Keeps the offset from (cx, cy) to the true centre: it is smaller than the coordinates, and so
   * has places that the rounded centre lacks. Without them its direction would be wrong by a
   * rounding of the coordinates over the radius, and so would be the new velocity's.
   */
  private void offset(Mover m, double cx, double cy) {
    if (normal(m, m.x, m.y, cx, cy) == 0) {
      nx += Mover.lack(startX, m.vx, m.cleared, m.x);
      ny += Mover.lack(startY, m.vy, m.cleared, m.y);
    }
  }

  /** a / (a + b) for two radii; 0 if both are. */
  static double share(double a, double b) {
    double sum = a + b;
    return sum == 0 ? 0 : sum <= Double.MAX_VALUE ? a / sum : a / 2 / (a / 2 + b / 2);
  }

  /** Keeps the normal p - q; returns by which power of two it was divided. */
  private int normal(Mover m, double px, double py, double qx, double qy) {
    double speed = Math.max(Math.abs(m.vx), Math.abs(m.vy));
    int exponent = exponent(px, py, qx, qy, speed);
    // + 0 turns -0 into 0.
    nx = difference(px, qx, exponent) + 0.0;
    ny = difference(py, qy, exponent) + 0.0;
    return exponent;
  }

  /**
   * By which power of two a normal p - q is to be divided, so that its products with velocities
   * stay within the range of doubles: 0 for ordinary sizes.
   */
  static int exponent(double px, double py, double qx, double qy, double speed) {
    double x = px - qx;
    double y = py - qy;
    double size = Math.max(Math.abs(x), Math.abs(y));
    return size > LEAST && size < MOST && speed > LEAST && speed < MOST
        ? 0
        : Math.getExponent(size) + (speed < 1 ? -SLOW : 3); // n below 1/4: |v.n| < 2 |v| / 4
  }

  /** (p - q) / 2^exponent; of what is beyond the range of doubles, the largest one. */
  static double difference(double p, double q, int exponent) {
    if (exponent == 0) {
      return p - q;
    }
    double a = Vec2.within(p);
    double b = Vec2.within(q);
    double d = a - b;
    return Math.abs(d) <= Double.MAX_VALUE
        ? Math.scalb(d, -exponent)
        : Math.scalb(a, -exponent) - Math.scalb(b, -exponent);
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
    double size = place(m);
    int exponent = exponent(speed);
    boolean slides =
        isFaint(approach, exponent) && (isJammed(m) || m.flown * Math.abs(approach) <= size);
    if (m.standsStill || (isInPlace(m) && way <= size) || slides) {
      int pace = Math.max(m.pace, exponent);
      boolean faint = isFaint(approach, pace);
      m.stuck = Math.min(m.stuck + (faint ? 1 + patience / FAINT : 1), 2 * patience + 1);
      m.pace = pace;
    } else {
      m.stuck = 0;
      m.pace = exponent;
      m.anchorX = m.x;
      m.anchorY = m.y;
      m.jam = null;
    }
    return m.stuck > patience;
  }

  /** Whether a circle's centre is within 4 ulps of where its impacts began to count. */
  static boolean isInPlace(Mover m) {
    double size = place(m);
    return Math.abs(m.x - m.anchorX) <= size && Math.abs(m.y - m.anchorY) <= size;
  }

  private static double place(Mover m) {
    return Math.max(Math.max(Math.abs(m.anchorX), Math.abs(m.anchorY)), m.radius) * PLACE;
  }

  /** The binary exponent of a speed. */
  private static int exponent(double speed) {
    return Math.min(Math.getExponent(speed), Double.MAX_EXPONENT);
  }

  /** 2^k, for the exponent of a double: 0 and subnormal ones have that of 2^-1023. */
  private static double powerOfTwo(int k) {
    return k < Double.MIN_EXPONENT
        ? Double.MIN_NORMAL / 2
        : Double.longBitsToDouble((long) (k + Double.MAX_EXPONENT) << 52);
  }

  /** Whether an approach is no more than rounding of speeds of the binary exponent given. */
  private static boolean isFaint(double approach, int pace) {
    return Math.abs(approach) <= ROUNDING * powerOfTwo(pace);
  }

  /** Whether an approach is no more than rounding of a speed. */
  static boolean isRounding(double approach, double speed) {
    return isFaint(approach, exponent(speed));
  }

  boolean isJammed(Mover m) {
    return m.stuck > 2 * patience;
  }

  /**
   * Lets the circle slide along what it hit if that is all it does; stops it otherwise, and what is
   * jammed to it, and what it slid along is there for it again.
   */
  private void jam(Mover m, int code, double approach) {
    if (approach <= ROUNDING * (Math.abs(m.vx) + Math.abs(m.vy))) {
      m.jam = Jam.with(m.jam, code);
    } else {
      m.vx = 0;
      m.vy = 0;
      m.jam = Jam.ofCircles(m.jam, Obstacles.CIRCLES);
      seizes = true;
    }
  }

  /** Whether the circles that jammed in the last impact have to go on as one {@link Piece}. */
  boolean seizes() {
    return seizes;
  }

  void setSeizes(boolean seizes) {
    this.seizes = seizes;
  }
}
