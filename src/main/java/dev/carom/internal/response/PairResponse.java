// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.sweep.Coordinates;

/**
 * The velocities of two circles after a collision. Let n be the offset {@code x1 - x2}, of any
 * length, and {@code u = v1 - v2}. The part of u along n is reversed, scaled by e, and shared by
 * the masses: {@code v1 -= m2 / (m1 + m2) J n}, {@code v2 += m1 / (m1 + m2) J n} with {@code J = (1
 * + e) (u.n) / (n.n)}.
 *
 * <p>A circle of infinite mass keeps its velocity. Two of them pass through each other, and the log
 * says so. If one of two circles halts, both lose their motion along n.
 */
public final class PairResponse {

  /** Components of velocities below this can be added and subtracted without overflow. */
  private static final double FAST = 0x1p1020;

  /** Masses up to this can be added without overflow. */
  private static final double LARGE = 0x1p1000;

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private final CircleRegistry registry;
  private final Impulse impulse = new Impulse();
  private final Sliding sliding;
  private final ImpactRule rule;

  // The current collision: u / 2^fast, n, and u.n.
  private int fast;
  private double ux;
  private double uy;
  private double nx;
  private double ny;
  private double un;

  public PairResponse(CircleRegistry registry, ObstacleResponse response) {
    this.registry = registry;
    sliding = response.sliding;
    rule = response.rule;
  }

  /** Whether the filters of circles i and j let them meet. */
  public boolean meet(int i, int j) {
    return registry.meet(i, j);
  }

  /** Whether two circles just hit each other and neither changed since, or are jammed together. */
  public boolean skips(CircleTable circles, int i, int j) {
    if (circles.codes[CircleTable.collidingCodesAt(i) + CircleTable.LAST] == Codes.circle(j)
        && circles.codes[CircleTable.collidingCodesAt(j) + CircleTable.LAST] == Codes.circle(i)) {
      return true;
    }
    return areInert(circles, i, j);
  }

  /** Whether two circles are jammed together. */
  public boolean areInert(CircleTable circles, int i, int j) {
    return circles.jams != null && isInert(i, circles.jam(i), j, circles.jam(j));
  }

  /**
   * Whether two circles ignore each other: both are jammed with each other, or one of them has
   * infinite mass and passes over the other, which it crushed.
   */
  public boolean isInert(int i, IgnoreList ofI, int j, IgnoreList ofJ) {
    int codeI = Codes.circle(i);
    int codeJ = Codes.circle(j);
    return (ofI != null && ofI.isCrushedBy(codeJ))
        || (ofJ != null && ofJ.isCrushedBy(codeI))
        || (ofI != null && ofJ != null && ofI.makesInert(codeJ) && ofJ.makesInert(codeI));
  }

  /**
   * Whether a circle on a new flight approaches or leaves one with which it jammed by more than
   * rounding. Then the two no longer ignore each other.
   */
  public static boolean part(MovingCircle m, MovingCircle other) {
    double later = (m.t - other.t) + (m.tl - other.tl);
    double nx = m.x - fma(other.vx, later, other.x);
    double ny = m.y - fma(other.vy, later, other.y);
    double un = (m.vx - other.vx) * nx + (m.vy - other.vy) * ny;
    double approach = un / (Math.abs(nx) + Math.abs(ny));
    return !ImpactRule.isFaint(approach, speeds(m, other));
  }

  private static double speeds(MovingCircle a, MovingCircle b) {
    return Math.abs(a.vx) + Math.abs(a.vy) + Math.abs(b.vx) + Math.abs(b.vy);
  }

  /**
   * The rank of a collision among events of the same time; lower ranks come first. Collisions come
   * after impacts with obstacles, but silent ones before everything, since they change nothing.
   */
  public long rank(int i, int j) {
    long rank = Codes.rank(Codes.circle(i), j);
    return isSilent(i, j) ? rank - Long.MAX_VALUE : rank;
  }

  /** Whether there may be circles whose contacts are only reported. */
  public boolean haveSilent() {
    return registry.hasTraits() || registry.haveInfinite();
  }

  /** Whether a contact of circles i and j is reported and changes nothing. */
  public boolean isSilent(int i, int j) {
    return isSensor(i, j) || pass(i, j);
  }

  /** Whether one of circles i and j is a sensor. */
  public boolean isSensor(int i, int j) {
    return registry.isSensor(i) || registry.isSensor(j);
  }

  /** Whether circles i and j, of infinite mass, pass through each other. */
  boolean pass(int i, int j) {
    return registry.mass(i) == INFINITE && registry.mass(j) == INFINITE;
  }

  /**
   * Changes the velocities of two circles in contact, and writes the log. If one is a sensor, or
   * both have infinite mass, only the log changes. A {@linkplain MovingCircle#isCrushed crushed}
   * circle acts as one of infinite mass.
   *
   * @param a the one with the lower number
   * @param flownA how long its flight lasted that ends here; 0 if too short to advance the clock
   * @param flownB the same of the other one
   * @param tau how long both flew, since the later one started
   * @param mayFall whether there was gravity at some time
   * @return what follows, as for {@link ObstacleResponse#resolve}
   */
  public int resolve(
      MovingCircle a,
      double flownA,
      MovingCircle b,
      double flownB,
      double tau,
      boolean mayFall,
      ImpactRows log) {
    measure(a, b, tau);
    boolean halt = registry.halts(a.id) || registry.halts(b.id);
    double e = halt ? 0 : a.restitution * b.restitution;
    // The new velocities wait for the impulse. Begun here, it overlaps with writing and counting.
    impulse.of(1 + e, ux, uy, nx, ny);
    write(a, b, log);
    if (haveSilent() && isSilent(a.id, b.id)) {
      log.setOutcome(isSensor(a.id, b.id) ? ImpactRows.SENSED : ImpactRows.PASSED);
      return ObstacleResponse.SENSED;
    }
    double massA = mass(a);
    double massB = mass(b);
    if (massA == INFINITE && massB == INFINITE) {
      passOverCrushed(a, b);
      passOverCrushed(b, a);
      log.setOutcome(ImpactRows.JAMMED);
      return ObstacleResponse.NEW_FLIGHT;
    }
    double speed = scaled(Math.abs(ux) + Math.abs(uy), fast);
    boolean falls = mayFall && (a.isFalling() || b.isFalling());
    double kept = falls ? 1 : e;
    ImpactRule.count(
        a,
        flownA * speed,
        ImpactRule.place(a, kept),
        false,
        massB == INFINITE && b.vx * nx + b.vy * ny > 0);
    ImpactRule.count(
        b,
        flownB * speed,
        ImpactRule.place(b, kept),
        false,
        massA == INFINITE && a.vx * nx + a.vy * ny < 0);
    if (falls) {
      return resolveFalling(a, b, e, halt, log);
    }
    boolean stuck = isStuck(a, e) || isStuck(b, e);
    if (un < 0) {
      if (stuck) {
        impulse.of(1, ux, uy, nx, ny);
      }
      change(a, massA, b, massB, stuck ? 0 : e, halt, log);
    }
    if (stuck) {
      log.setOutcome(ImpactRows.JAMMED);
    }
    beginFlight(a, b);
    beginFlight(b, a);
    return stuck ? ObstacleResponse.STUCK : ObstacleResponse.NEW_FLIGHT;
  }

  /**
   * Resolves an impact of two circles under gravity, by the {@link ImpactRule}. A circle that meets
   * a member joins at any speed.
   */
  private int resolveFalling(
      MovingCircle a, MovingCircle b, double e, boolean halt, ImpactRows log) {
    double length = Math.sqrt(nx * nx + ny * ny);
    double approach = -un / length;
    double pull = ((a.gx - b.gx) * nx + (a.gy - b.gy) * ny) / length;
    a.landing = MovingCircle.NOTHING;
    b.landing = MovingCircle.NOTHING;
    boolean hasMember = a.isMember() || b.isMember();
    boolean joins = hasMember || rule.of(a, b, e, approach, pull) == ImpactRule.JOIN;
    boolean isSlow = approach < rule.slow(Math.min(a.radius, b.radius));
    if (un < 0 && !hasMember && !(joins && isSlow)) {
      change(a, mass(a), b, mass(b), e, halt, log);
      sliding.goOn(a, nx, ny);
      sliding.goOn(b, nx, ny);
    }
    if (joins) {
      boolean known = (a.isMember() || a.settled) && (b.isMember() || b.settled);
      a.settled = isSlow;
      b.settled = isSlow;
      if (isSlow && known) {
        log.removeLast();
      } else if (isSlow) {
        log.setOutcome(ImpactRows.SETTLED);
      }
      return ObstacleResponse.JOIN;
    }
    a.settled = false;
    b.settled = false;
    beginFlight(a, b);
    beginFlight(b, a);
    return ObstacleResponse.NEW_FLIGHT;
  }

  /** Begins a flight after a crushed circle met another infinite mass: they ignore each other. */
  private static void passOverCrushed(MovingCircle m, MovingCircle other) {
    if (m.isCrushed()) {
      m.jam = IgnoreList.crushedBy(m.jam, Codes.circle(other.id));
    }
    beginFlight(m, other);
  }

  /** The mass of a circle in a collision: infinite if it is crushed. */
  double mass(MovingCircle m) {
    return m.isCrushed() ? INFINITE : registry.mass(m.id);
  }

  private static boolean isStuck(MovingCircle m, double e) {
    return !m.isCrushed() && ImpactRule.isStuck(m, e);
  }

  private void change(
      MovingCircle a,
      double massA,
      MovingCircle b,
      double massB,
      double e,
      boolean halt,
      ImpactRows log) {
    if (halt && massA + massB < INFINITE) {
      log.setImpulse(-massA * ScaledVectors.dot(a.vx, a.vy, nx, ny));
      stop(a, nx, ny);
      stop(b, nx, ny);
    } else {
      impulse.scale(fast);
      double ofA = push(a, -1, massB, massA, nx, ny);
      double ofB = push(b, 1, massA, massB, nx, ny);
      log.setImpulse(-(1 + e) * Math.min(ofA, ofB) * un);
    }
    boolean aStops = ImpactRule.stopsBeyondRange(a);
    boolean bStops = ImpactRule.stopsBeyondRange(b);
    if (aStops || bStops) {
      log.setOutcome(ImpactRows.STOPPED);
    } else if (halt) {
      log.setOutcome(ImpactRows.HALTED);
    }
  }

  private static void beginFlight(MovingCircle m, MovingCircle other) {
    m.last = Codes.circle(other.id);
    m.newFlight();
  }

  /** Computes the relative velocity of two circles, their offset, and their approach. */
  private void measure(MovingCircle a, MovingCircle b, double tau) {
    fast = exponent(a, b);
    ux = ScaledVectors.difference(a.vx, b.vx, fast);
    uy = ScaledVectors.difference(a.vy, b.vy, fast);
    int large = ScaledVectors.exponent(a.x, a.y, b.x, b.y, Math.max(Math.abs(ux), Math.abs(uy)));
    nx = ScaledVectors.difference(a.x, b.x, large);
    ny = ScaledVectors.difference(a.y, b.y, large);
    if (nx == 0 && ny == 0) {
      leaveCentre(0.5 * tau * (a.gx - b.gx), 0.5 * tau * (a.gy - b.gy));
    }
    un = scaled(ScaledVectors.dot(ux, uy, nx, ny), fast);
  }

  /**
   * Circles that fall unlike from one centre may turn back before the places of their centres
   * differ: then their offset has the direction of the mean velocity u - g tau / 2.
   */
  private void leaveCentre(double gainX, double gainY) {
    double speed = Math.max(Math.abs(ux), Math.abs(uy));
    int large = ScaledVectors.exponent(ux, uy, gainX, gainY, speed);
    nx = ScaledVectors.difference(ux, gainX, large);
    ny = ScaledVectors.difference(uy, gainY, large);
  }

  private void write(MovingCircle a, MovingCircle b, ImpactRows log) {
    double share = Coordinates.share(b.radius, a.radius);
    log.addPair(a.t, a.id, b.id);
    log.set(Coordinates.between(share, b.x, a.x), Coordinates.between(share, b.y, a.y), nx, ny, un);
  }

  /**
   * The exponent of the power of two by which velocities are divided so that their difference does
   * not overflow; 0 for ordinary speeds.
   */
  private static int exponent(MovingCircle a, MovingCircle b) {
    boolean ordinary =
        Math.abs(a.vx) < FAST
            && Math.abs(a.vy) < FAST
            && Math.abs(b.vx) < FAST
            && Math.abs(b.vy) < FAST;
    return ordinary ? 0 : 2;
  }

  /** x 2^exponent. */
  private static double scaled(double x, int exponent) {
    return exponent == 0 ? x : Math.scalb(x, exponent);
  }

  /** Removes a circle's motion along the normal. */
  private void stop(MovingCircle m, double nx, double ny) {
    m.ignoreCirclesOnly();
    impulse.of(1, m.vx, m.vy, nx, ny);
    m.vx = impulse.less(m.vx, nx);
    m.vy = impulse.less(m.vy, ny);
  }

  /**
   * Gives a circle its share of the impulse: the other's mass over the sum of both. The share is
   * kept as head and tail. As one double it would be rounded alike at each impact of two masses,
   * and the energy would drift. Obstacles that a jammed circle ignored act on it again.
   *
   * @return the share of its own mass: of finite masses the reduced mass of both
   */
  private double push(MovingCircle m, int sign, double other, double own, double nx, double ny) {
    if (own == INFINITE) {
      return INFINITE;
    }
    m.ignoreCirclesOnly();
    double share = 0.5;
    double tail = 0;
    if (own != other || own > LARGE) {
      boolean all = other == INFINITE;
      double sum = other + own;
      share = all ? 1 : other / sum;
      double rest = fma(-share, sum, other) - share * sumTail(other, own, sum);
      tail = all ? 0 : rest / sum;
    }
    m.vx = impulse.change(m.vx, sign * share, sign * tail, nx);
    m.vy = impulse.change(m.vy, sign * share, sign * tail, ny);
    return share * own;
  }
}
