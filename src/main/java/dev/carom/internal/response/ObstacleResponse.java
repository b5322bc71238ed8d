// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.Part;
import java.util.function.Predicate;

/**
 * The velocity of a circle after an impact with an obstacle of velocity u: {@code v -= (1 + e) ((v
 * - u).n) / (n.n) n}. The normal n is that of {@link ContactPoint}, of any length, so that errors
 * do not feed on themselves. A wall turns one component.
 *
 * <p>A circle that is stuck, by the {@link ImpactRule}, has restitution 0 with every obstacle, and
 * all its contacts act at once, see {@link Shock}. That only takes energy away. The TC model of S.
 * Luding and S. McNamara (How to handle the inelastic collapse of a dissipative hard-sphere gas
 * with the TC model, Granular Matter 1, 1998) instead makes impacts elastic that follow each other
 * too fast. That feeds energy back that the scene had taken away, and needs a length of time that a
 * scene does not have.
 */
public final class ObstacleResponse {

  // The results of resolve.

  /** Nothing: a sensor reported it, and the flight goes on. */
  public static final int SENSED = 0;

  /** A new flight. */
  public static final int NEW_FLIGHT = 1;

  /** A new flight of a stuck circle: all its contacts are to be resolved at once. */
  public static final int STUCK = 2;

  /** The circle joins those in contact under gravity, see {@link ContactCore}. */
  public static final int JOIN = 3;

  private final ObstacleTable obstacles;
  private final CircleRegistry registry;
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

  final Sliding sliding;
  final ImpactRule rule;

  private final LoneContact.Nearby nearby;
  private final IntList near = new IntList();

  /**
   * @param registry null for a circle of no world, which has mass 1
   */
  public ObstacleResponse(
      ObstacleTable obstacles,
      CircleRegistry registry,
      Gravity gravity,
      LoneContact.Nearby nearby) {
    this.nearby = nearby;
    this.obstacles = obstacles;
    this.registry = registry;
    sliding = new Sliding(obstacles, gravity);
    rule = new ImpactRule(gravity);
    point = new ContactPoint(obstacles);
  }

  /** Lets contacts of stuck circles tell who is crushed. */
  public void ask(Shock shock) {
    isCrushed = shock::isCrushed;
  }

  /**
   * Advances a circle to its next impact, changes its velocity, and writes the impact into the log.
   * With a sensor it only writes.
   *
   * @return what follows: SENSED, NEW_FLIGHT, STUCK or JOIN
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
      return endSlide(m);
    }
    double vn = report(m, code, m.t, log);
    if (falls) {
      return resolveFalling(m, code, vn, log);
    }
    if (obstacles.moves(code) && m.jam != null) {
      if (isCrushed.test(m)) {
        passOver(m, code, log);
        return NEW_FLIGHT;
      }
      m.forgetCrushers();
    }
    boolean turns = point.rate != 0;
    if (turns && mayJoin(m)) {
      return resolveFalling(m, code, vn, log);
    }
    double e = m.restitution * obstacles.restitution(code);
    boolean pushes = point.ux * point.nx + point.uy * point.ny > 0;
    double way = flown * (Math.abs(sx) + Math.abs(sy));
    ImpactRule.count(m, way, ImpactRule.place(m, e), false, pushes);
    boolean stuck = ImpactRule.isStuck(m, e);
    if (stuck && turns) {
      m.leavePlace(); // once that has left, it bounces again
      passOver(m, code, log);
      return NEW_FLIGHT;
    }
    boolean joins = stuck && mayJoin(m) && isAtTurning(m);
    m.ignoreCirclesOnly();
    change(m, code, vn, stuck ? 0 : e, log);
    if (stuck) {
      log.setOutcome(ImpactRows.JAMMED);
    }
    m.last = code;
    m.newFlight();
    return joins ? JOIN : stuck ? STUCK : NEW_FLIGHT;
  }

  /** Whether contact may hold a circle: nothing moves one of infinite mass. */
  private boolean mayJoin(MovingCircle m) {
    return registry == null || registry.mass(m.id) < Double.POSITIVE_INFINITY;
  }

  /** Whether something that turns may press on a circle that is stuck. */
  private boolean isAtTurning(MovingCircle m) {
    near.clear();
    double reach = ContactLaw.PUSHED * m.radius;
    nearby.obstaclesNear(m, reach, m.t, near);
    boolean is = false;
    for (int k = 0; k < near.size(); k++) {
      is |= obstacles.turns(near.get(k)) && distance(near.get(k), m) <= m.radius + reach;
    }
    return is;
  }

  private double distance(int code, MovingCircle m) {
    return obstacles.of(code).shape.distance(obstacles.rowAt(code, m.t, m.tl), 0, m.x, m.y);
  }

  /**
   * At the end of a side a circle slides on along one in line with it, flies off, or joins, to roll
   * over the end.
   */
  private int endSlide(MovingCircle m) {
    int line = m.support;
    m.jam = null;
    m.newFlight();
    ImpactRule.count(m, flown * (Math.abs(m.vx) + Math.abs(m.vy)), false, false);
    boolean isMany = m.stuck > ContactLaw.IMPACTS;
    near.clear();
    nearby.obstaclesNear(m, Shock.touchOf(m), m.t, near);
    near.sort(0);
    for (int k = 0; k < near.size(); k++) {
      int code = near.get(k);
      if (code != line && !isMany && sliding.slidesOnto(m, code)) {
        return NEW_FLIGHT;
      }
    }
    return sliding.fliesOff(m) ? NEW_FLIGHT : JOIN;
  }

  /**
   * Whether a circle passes something where rounding would lead it again and again: it slides level
   * with its side, or flies off where another side ends, too. A sliding circle may slide on along
   * that if its own side ends there.
   */
  private boolean passes(MovingCircle m, int code, double approach) {
    boolean faint = ImpactRule.isFaint(approach, Math.abs(sx) + Math.abs(sy));
    boolean slides = m.isCarried() && sliding.isLevel(m, point.nx, point.ny);
    boolean leaves = flewOff(m) && sliding.leavesEnd(m, code);
    if (!faint || m.stuck > ContactLaw.IMPACTS || !(slides || leaves)) {
      return false;
    }
    m.stuck++;
    m.newFlight();
    if (leaves || !sliding.isAtEnd(m, m.support) || !sliding.slidesOnto(m, code)) {
      m.jam = IgnoreList.with(m.jam, code);
    }
    return true;
  }

  /** Whether a circle flew off an end of the line that it slid on, and has hit nothing since. */
  private static boolean flewOff(MovingCircle m) {
    return m.landing != MovingCircle.NOTHING && m.landing == m.last;
  }

  /**
   * Whether a sliding circle that meets another side leaves its own: then it is on that one only. A
   * slow one joins, since it may come back and back, as between the sides of a V.
   */
  private boolean changesSide(MovingCircle m) {
    double slow = rule.slow(m.radius);
    return sx * sx + sy * sy >= slow * slow && sliding.opensBy(m, point.nx, point.ny);
  }

  /**
   * Resolves an impact of a circle that falls or slides, or with something that turns, by the
   * {@link ImpactRule}.
   */
  private int resolveFalling(MovingCircle m, int code, double vn, ImpactRows log) {
    double e = m.restitution * obstacles.restitution(code);
    double length = Math.sqrt(point.nx * point.nx + point.ny * point.ny);
    double approach = -vn / length;
    double pull = (m.gx * point.nx + m.gy * point.ny) / length;
    boolean turns = point.rate != 0;
    double most = rule.pull(turns ? point.mostBend(m, length) : 0);
    if (turns) {
      pull += point.bend(m, length);
    }
    if (passes(m, code, approach)) {
      log.removeLast();
      return NEW_FLIGHT;
    }
    boolean onSide = ObstacleTable.part(code, m.contact) == Part.SIDE;
    boolean changesSide = onSide && !turns && m.isCarried() && changesSide(m);
    if (changesSide) {
      pull = sliding.pull(point.nx, point.ny) / length;
    }
    boolean onEnd = !onSide && !flewOff(m) && sliding.isSquare(m, code, point.nx, point.ny);
    boolean flat = !turns && (changesSide || (!m.isCarried() && (onSide || onEnd)));
    boolean isSlow = approach < rule.slow(m.radius, most);
    boolean lands = flat && m.landing == code && isSlow;
    boolean pushes = point.ux * point.nx + point.uy * point.ny > 0;
    boolean again = code == m.last;
    double place = ImpactRule.place(m, m.isFalling() ? 1 : e);
    ImpactRule.count(m, flown * (Math.abs(sx) + Math.abs(sy)), place, again, pushes);
    int what = lands ? ImpactRule.SLIDE : rule.of(m, flat, e, approach, pull, most);
    boolean faint = again && ImpactRule.isFaint(approach, Math.abs(sx) + Math.abs(sy));
    if (faint && (turns || (flat && e < 1))) { // it comes back and back, whatever presses it
      what = turns ? ImpactRule.JOIN : ImpactRule.SLIDE;
    }
    m.landing = MovingCircle.NOTHING;
    m.last = code;
    if (m.isFalling()) {
      m.jam = null;
    } else {
      m.ignoreCirclesOnly();
    }
    m.newFlight();
    if (what == ImpactRule.BOUNCE || (what == ImpactRule.JOIN && !isSlow)) {
      change(m, code, vn, e, log);
      sliding.goOn(m, point.nx, point.ny);
    }
    if (what == ImpactRule.BOUNCE) {
      m.settled &= isSlow;
      return NEW_FLIGHT;
    }
    if (what == ImpactRule.SLIDE) {
      setImpulse(m, vn, 0, log);
    }
    ImpactRule.mark(m, isSlow, log);
    if (what == ImpactRule.SLIDE && onSide) {
      sliding.slide(m, code, point.nx, point.ny);
    } else if (what == ImpactRule.SLIDE) {
      sliding.slideFromEnd(m, code, point.nx, point.ny);
    }
    return what == ImpactRule.SLIDE ? NEW_FLIGHT : JOIN;
  }

  /** A moving obstacle passes over a circle that something crushed, and that stands. */
  private static void passOver(MovingCircle m, int code, ImpactRows log) {
    m.vx = 0;
    m.vy = 0;
    m.jam = IgnoreList.crushedBy(m.jam, code);
    m.newFlight();
    log.setOutcome(ImpactRows.JAMMED);
  }

  /** Changes the velocity of a circle that approaches. */
  private void change(MovingCircle m, int code, double vn, double e, ImpactRows log) {
    if (vn < 0) {
      setImpulse(m, vn, e, log);
      reflect(m, code, e);
      if (ImpactRule.stopsBeyondRange(m)) {
        log.setOutcome(ImpactRows.STOPPED);
      } else if (obstacles.halts(code)) {
        log.setOutcome(ImpactRows.HALTED);
      }
    }
  }

  /** Writes the impulse {@code -(1 + e) m (s.n) / (n.n) n} into the row of an impact. */
  private void setImpulse(MovingCircle m, double vn, double e, ImpactRows log) {
    double mass = registry != null && registry.areWeighted() ? registry.mass(m.id) : 1;
    log.setImpulse(-(1 + e) * mass * vn);
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
    log.add(time, m.id, code, ObstacleTable.part(code, m.contact));
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
