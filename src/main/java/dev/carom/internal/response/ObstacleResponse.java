// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.Part;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * The velocity of a circle after an impact with an obstacle of velocity u: {@code v -= (1 + e) ((v
 * - u).n) / (n.n) n}. The normal n is that of {@link ContactPoint}, of any length, so that errors
 * do not feed on themselves. A wall turns one component.
 *
 * <p>A {@linkplain StuckRule stuck} circle has restitution 0 with every obstacle, and ignores
 * obstacles that it approaches by no more than rounding; {@link StopRule} decides when it stops.
 * The rule only takes energy away. The TC model of S. Luding and S. McNamara (How to handle the
 * inelastic collapse of a dissipative hard-sphere gas with the TC model, Granular Matter 1, 1998)
 * instead makes impacts elastic that follow each other too fast. That feeds energy back that the
 * scene had taken away, and needs a length of time that a scene does not have.
 */
public final class ObstacleResponse {

  // The results of resolve.

  /** Nothing: a sensor reported it, and the flight goes on. */
  public static final int SENSED = 0;

  /** A new flight. */
  public static final int NEW_FLIGHT = 1;

  /** A new flight of a stuck circle: all its contacts are to be resolved at once. */
  public static final int STUCK = 2;

  private final ObstacleTable obstacles;
  private final Impulse impulse = new Impulse();

  /** The contact of the current impact; {@link #report} fills it. */
  private final ContactPoint point;

  /** The velocity of the circle less that of the obstacle, before the current impact. */
  private double sx;

  private double sy;

  /** How long the flight lasted that ends in it; 0 if too short to advance the clock. */
  private double flown;

  /** Tells of a jammed circle whether something that crushed it is still upon it. */
  private Predicate<MovingCircle> isCrushed;

  public final Settling settling;

  /** The codes of obstacles that a circle may touch, ascending. */
  private final Function<MovingCircle, int[]> near;

  public ObstacleResponse(
      ObstacleTable obstacles, Gravity gravity, Function<MovingCircle, int[]> near) {
    this.near = near;
    this.obstacles = obstacles;
    settling = new Settling(obstacles, gravity, near);
    point = new ContactPoint(obstacles);
    isCrushed = m -> Touch.isCrushed(m, obstacles);
  }

  /** Lets a cluster tell of crushed circles, and of circles that touch: it knows them all. */
  public void ask(ContactCluster cluster) {
    isCrushed = cluster::isCrushed;
    settling.escape.ask(cluster);
  }

  /**
   * The circles that gave way since the last call to one that something pushes, at the start of
   * their new flights.
   */
  public List<MovingCircle> takeYielded() {
    return settling.escape.takeYielded();
  }

  /**
   * Advances a circle to its next impact, changes its velocity, and writes the impact into the log.
   * With a sensor it only writes.
   *
   * @return what follows: SENSED, NEW_FLIGHT or STUCK
   */
  public int resolve(MovingCircle m, ImpactRows log) {
    int code = m.next;
    if (obstacles.isSensor(code)) {
      sense(m, code, log);
      return SENSED;
    }
    boolean falls = m.isFalling();
    point.startAt(m);
    flown = m.advance(m.cleared);
    if (falls && code == m.support) {
      slideOff(m);
      return NEW_FLIGHT;
    }
    double vn = report(m, code, m.t, log);
    if (obstacles.moves(code) && m.jam != null) {
      if (isCrushed.test(m)) {
        passOver(m, code, log);
        return NEW_FLIGHT;
      }
      m.forgetCrushers();
    }
    if (falls) {
      bounce(m, code, vn, log);
      return NEW_FLIGHT;
    }
    double e = m.restitution * obstacles.restitution(code);
    double speed = Math.abs(sx) + Math.abs(sy);
    double approach = vn / (Math.abs(point.nx) + Math.abs(point.ny));
    double speeds = Math.abs(m.vx) + Math.abs(m.vy) + Math.abs(point.ux) + Math.abs(point.uy);
    double pushed = StuckRule.pushedPlace(obstacles.areMoving());
    StuckRule.count(m, flown, speed, speeds, approach, e, StuckRule.ELASTIC, pushed);
    m.pushed |= point.ux * point.nx + point.uy * point.ny > 0;
    boolean stuck = StuckRule.isStuck(m);
    boolean faint = stuck && StuckRule.isFaint(m, approach);
    if (faint) {
      m.jam = IgnoreList.with(m.jam, code);
    } else {
      m.ignoreCirclesOnly();
    }
    if (stuck || e == 0) {
      changeWithoutBounce(m, code, vn, stuck, log);
    } else {
      m.turn = 0;
      change(m, code, vn, e, log);
    }
    m.last = code;
    m.newFlight();
    return stuck && !faint ? STUCK : NEW_FLIGHT;
  }

  /** At an end of the line on which it slides, a circle goes on along another one, or falls. */
  private void slideOff(MovingCircle m) {
    int line = m.support;
    m.last = line;
    m.newFlight();
    m.ignoreCirclesOnly();
    for (int code : near.apply(m)) {
      if (code != line && settling.slidesOnto(m, code)) {
        return;
      }
    }
    settling.fall(m);
    m.leftLine = line;
  }

  /**
   * Changes the velocity of a circle that falls or slides. Bounces on one thing follow each other
   * without end; {@link Settling} ends them. Other impacts at one place are counted.
   */
  private void bounce(MovingCircle m, int code, double vn, ImpactRows log) {
    double e = m.restitution * obstacles.restitution(code);
    double reach = ObstacleTable.part(code, m.contact) == Part.SIDE ? 0 : reach(m, code);
    if (slidesPast(m, code, vn, reach)) {
      m.newFlight();
      m.jam = IgnoreList.with(m.jam, code); // else rounding would lead it there again and again
      return;
    }
    boolean again = code == m.last && isFaint(vn) && hasHardlyMoved(m);
    if (code == m.last) {
      m.leavePlace();
    } else {
      count(m, vn, e);
    }
    m.last = code;
    m.newFlight();
    m.ignoreCirclesOnly();
    if (StuckRule.isStuck(m)) {
      if (e < 1 && (m.pushed || obstacles.areMoving()) && settling.escape.escapes(log, m)) {
        return;
      }
      boolean pushes = point.ux != 0 || point.uy != 0;
      m.jam = pushes ? IgnoreList.crushedBy(m.jam, code) : m.jam;
      Settling.pin(m);
      log.setOutcome(ImpactRows.JAMMED);
      return;
    }
    change(m, code, vn, e, log);
    settling.settle(m, code, point, reach, e, log);
    if (again && !m.isSupported()) {
      leaveByRounding(m);
    }
  }

  /**
   * Whether a circle passes something at rest as if that were not there. Either it is level with
   * what the circle slides on. Or the circle just slid off the end of a line, and meets another
   * line that ends there.
   */
  private boolean slidesPast(MovingCircle m, int code, double vn, double reach) {
    if (obstacles.moves(code)) {
      return false;
    }
    if (m.isSupported()) {
      return m.support != code
          && !obstacles.moves(m.support)
          && (isLevel(m, vn, reach) || (isFaint(vn) && !isPressed(m)));
    }
    return m.leftLine != MovingCircle.NOTHING
        && m.leftLine != code
        && isFaint(vn)
        && hasHardlyMoved(m)
        && settling.endsHere(m, code);
  }

  /** Whether gravity presses a sliding circle against what it meets. */
  private boolean isPressed(MovingCircle m) {
    double pressure = -ScaledVectors.dot(m.gx, m.gy, point.nx, point.ny);
    double pull = Math.abs(m.gx) + Math.abs(m.gy);
    double scale = Math.abs(point.nx) + Math.abs(point.ny);
    return pressure > 0 && !StuckRule.isFaint(pressure / scale, pull);
  }

  /** Whether a sliding circle would rise by no more than rounding over something round. */
  private boolean isLevel(MovingCircle m, double vn, double reach) {
    // At most sqrt(2) times the speed, so the square of this sine is at least half of that of the
    // turn. The bump is reach (1 - cos) high, half of reach sine^2: no more than what is compared.
    double speed = Math.abs(sx) + Math.abs(sy);
    double sine = vn / (StrictMath.hypot(point.nx, point.ny) * speed);
    return reach > 0 && settling.isLevel(m, sine * sine * reach);
  }

  /** Whether a circle moved by no more than rounding since its last impact. */
  private boolean hasHardlyMoved(MovingCircle m) {
    return flown * (Math.abs(sx) + Math.abs(sy)) <= StuckRule.widthOfPlace(m);
  }

  /**
   * Lets a circle leave by the least that is more than rounding. It met one thing again at once,
   * and approached by so little that no response shows.
   */
  private void leaveByRounding(MovingCircle m) {
    double length = StrictMath.hypot(point.nx, point.ny);
    double least = StuckRule.ROUNDED_SPEED * (Math.abs(sx) + Math.abs(sy));
    m.vx += least * (point.nx / length);
    m.vy += least * (point.ny / length);
  }

  /** Whether an approach is no more than the rounding of the speed; vn is its product with n. */
  private boolean isFaint(double vn) {
    double approach = vn / (Math.abs(point.nx) + Math.abs(point.ny));
    return StuckRule.isFaint(approach, Math.abs(sx) + Math.abs(sy));
  }

  /** The distance of the centre of a circle from that of something round that it touches. */
  private double reach(MovingCircle m, int code) {
    return m.radius + obstacles.radius(code);
  }

  /** Counts an impact of a falling circle at one place, which is not wider than rounding. */
  private void count(MovingCircle m, double vn, double e) {
    double speed = Math.abs(sx) + Math.abs(sy);
    double approach = vn / (Math.abs(point.nx) + Math.abs(point.ny));
    double speeds = Math.abs(m.vx) + Math.abs(m.vy) + Math.abs(point.ux) + Math.abs(point.uy);
    double pushed = e < 1 ? StuckRule.FALLING_PLACE : StuckRule.pushedPlace(obstacles.areMoving());
    StuckRule.countFalling(m, flown * speed, speeds, approach, e, pushed);
    m.pushed |= point.ux * point.nx + point.uy * point.ny > 0;
  }

  /**
   * Changes the velocity by an impact of restitution 0, which may stop the circle if the obstacle
   * is at rest.
   */
  private void changeWithoutBounce(
      MovingCircle m, int code, double vn, boolean stuck, ImpactRows log) {
    double approach = vn / (Math.abs(point.nx) + Math.abs(point.ny));
    boolean pushes = point.ux != 0 || point.uy != 0;
    m.turn = pushes ? 0 : m.turn;
    double way = flown * (Math.abs(sx) + Math.abs(sy));
    boolean back = !pushes && StopRule.turnsBack(m, point.nx, point.ny, way, approach);
    change(m, code, vn, 0, log);
    boolean stops = back || (stuck && !pushes && StopRule.isSpent(m));
    if (stops) {
      StopRule.stop(m);
    }
    if (stuck || stops) {
      log.setOutcome(ImpactRows.JAMMED);
    }
  }

  /** A moving obstacle comes to a circle that something crushed: it passes over it, too. */
  private static void passOver(MovingCircle m, int code, ImpactRows log) {
    m.jam = IgnoreList.crushedBy(m.jam, code);
    m.newFlight();
    log.setOutcome(ImpactRows.JAMMED);
  }

  /** Changes the velocity of a circle that approaches. */
  private void change(MovingCircle m, int code, double vn, double e, ImpactRows log) {
    if (vn < 0) {
      reflect(m, code, e);
      if (StopRule.stopsBeyondRange(m)) {
        log.setOutcome(ImpactRows.STOPPED);
      } else if (obstacles.halts(code)) {
        log.setOutcome(ImpactRows.HALTED);
      }
    }
  }

  /** Writes a contact with a sensor. The flight goes on, and is known up to there. */
  private void sense(MovingCircle m, int code, ImpactRows log) {
    double startX = m.x;
    double startY = m.y;
    point.startAt(m);
    double startVx = m.vx;
    double startVy = m.vy;
    m.move(m.cleared);
    report(m, code, m.after(m.cleared), log);
    log.setOutcome(ImpactRows.SENSED);
    m.x = startX;
    m.y = startY;
    m.vx = startVx;
    m.vy = startVy;
    m.clearUpTo(m.cleared);
    m.sensedCode = code;
  }

  /** Writes a contact of a circle with an obstacle. */
  void report(MovingCircle m, Touch touch, ImpactRows log) {
    m.contact = touch.contact();
    point.startAt(m);
    report(m, touch.code(), m.t, log);
    m.contact = 0;
  }

  /**
   * Writes an impact of a circle that stands where it touches, and finds its contact point.
   *
   * @return s.n, for the velocity s relative to the obstacle
   */
  private double report(MovingCircle m, int code, double time, ImpactRows log) {
    point.locate(m, code);
    sx = m.vx - point.ux;
    sy = m.vy - point.uy;
    double vn = ScaledVectors.dot(sx, sy, point.nx, point.ny);
    log.add(time, m.id, Codes.kind(code), Codes.index(code), ObstacleTable.part(code, m.contact));
    log.set(point.x, point.y, point.nx, point.ny, vn);
    return vn;
  }

  private void reflect(MovingCircle m, int code, double e) {
    if (!Codes.isWall(code)) {
      impulse.of(1 + e, sx, sy, point.nx, point.ny);
      m.vx = impulse.less(m.vx, point.nx);
      m.vy = impulse.less(m.vy, point.ny);
    } else if (Codes.isVertical(code)) {
      m.vx = -e * m.vx + 0.0; // + 0 turns -0 into 0
    } else {
      m.vy = -e * m.vy + 0.0;
    }
  }
}
