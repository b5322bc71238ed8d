// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.exact.DoubleDouble;
import dev.carom.internal.sweep.Contact;

/**
 * One circle in flight: the state that {@code BroadPhase} looks ahead from and {@link
 * ObstacleResponse} changes. A world loads a circle into its one mover, lets it advance, and stores
 * it again.
 *
 * <p>Times are kept as head and tail, the nearest double and what it leaves: about 106 bits. So an
 * impact is placed as accurately after a million frames as after one, and a sum of times does not
 * depend on how the steps were cut.
 */
public final class MovingCircle {

  /** The sum of weights of impacts at one place beyond which a circle is stuck. */
  public static final int STUCK_LIMIT = 1 << 24;

  /** Nothing hit yet, or since the last edit. */
  public static final int NOTHING = -1;

  /**
   * How far a first search may look ahead, in halves of a cell at the pace, where less is asked
   * for; each further one, twice that.
   */
  static final int FIRST_LOOKAHEAD = 64;

  /** The same for a flight that an edit began: another edit may cut it short. */
  public static final int EDITED_LOOKAHEAD = 1;

  /** The flight: where it started, how it moves, and when it started. */
  public double x;

  public double y;
  public double vx;
  public double vy;
  public double t;
  public double tl;

  public int id;
  public double radius;
  public double restitution;

  /** How long the flight has lasted. */
  public double flown;

  /** Whether the time that the flight lasted is too short for its clock. */
  public boolean standsStill;

  /** What was hit last: it is not there for this flight. */
  public int last;

  /** What is inert for the circle, which is stuck between things; as a rule null. */
  public IgnoreList jam;

  /** Up to where the flight is known to be free, counted from its start. */
  public double cleared;

  /** What is hit at {@link #cleared}, or NOTHING if the search went no further. */
  public int next;

  /**
   * How the detector names that contact, see {@link Contact}; if there is none, the code of the
   * sensor that was met at {@link #cleared}, else 0.
   */
  public int contact;

  /** Cells that the next search may go beyond what is asked for. */
  public int lookahead;

  /** The weight of the successive impacts at one place, see {@code StuckRule}. */
  public int stuck;

  /** The exponent of the largest speed in these impacts. */
  public int speedExponent;

  /** Which way the last of them, of restitution 0, turned the velocity: 1 left, -1 right, or 0. */
  public int turn;

  /** Whether one of them was with an infinite mass that moved towards the circle. */
  public boolean driven;

  /** Whether infinite masses overlap a circle that they crushed; known while they meet. */
  public boolean crushed;

  /** Puts a circle at the start of its first flight, at time 0. */
  public void start(
      int id, double x, double y, double radius, double vx, double vy, double restitution) {
    this.id = id;
    this.x = x;
    this.y = y;
    this.radius = radius;
    this.vx = vx;
    this.vy = vy;
    this.restitution = restitution;
    t = 0;
    tl = 0;
    forget();
    newFlight();
  }

  /**
   * Begins a new flight at a given time, from where the circle is then, as an edit does.
   *
   * @param now the head of that time, which is not before the flight that ends
   * @param tail its tail
   * @param walls which it does not leave, as {@link ObstacleTable#walls}
   */
  public void restart(double now, double tail, double[] walls) {
    double dt = (now - t) + (tail - tl);
    x = Confinement.x(walls, x, Math.fma(vx, dt, x), radius);
    y = Confinement.y(walls, y, Math.fma(vy, dt, y), radius);
    t = now;
    tl = tail;
    newFlight();
    lookahead = EDITED_LOOKAHEAD;
  }

  /** Forgets what was hit: the next impact may be with anything. */
  public void forget() {
    last = NOTHING;
    leavePlace();
    speedExponent = Double.MIN_EXPONENT;
  }

  /** Begins to count impacts anew, at the place where the circle is. */
  public void leavePlace() {
    jam = null;
    stuck = 0;
    turn = 0;
    driven = false;
  }

  /** Whether a number can be the weight of impacts at one place. */
  public static boolean isStuckWeight(int weight) {
    return weight >= 0 && weight <= STUCK_LIMIT + 1;
  }

  /**
   * Forgets one thing that is to change, and returns whether it had to do with it.
   *
   * @param sensedCode if it is next: of the sensors at its time, up to which code those were met
   */
  public boolean forget(int code, int sensedCode) {
    boolean knew = last == code || next == code || (jam != null && jam.concerns(code));
    if (last == code) {
      last = NOTHING;
    }
    if (next == code) {
      next = NOTHING;
      contact = sensedCode;
    }
    if (jam != null && jam.concerns(code)) {
      // The rest stays inert: it would be hit where the flight began, before the edit.
      jam = jam.without(code);
      stuck = jam == null ? 0 : stuck;
    }
    return knew;
  }

  /** Forgets what was found ahead. */
  public void newFlight() {
    flown = 0;
    cleared = 0;
    next = NOTHING;
    contact = 0;
    lookahead = FIRST_LOOKAHEAD;
  }

  /** How far a time is into a flight: one that begins at its head may begin after it. */
  public static double since(double t, double tl, double now) {
    return Math.max(0, now - t - tl);
  }

  /** When something is to be done: at the next impact, or where what is known ahead ends. */
  public double due() {
    return cleared == Double.POSITIVE_INFINITY ? cleared : after(cleared);
  }

  /** The first double that is not before a time, given as head and tail. */
  public static double firstNotBefore(double head, double tail) {
    return tail > 0 ? Math.nextUp(head) : head;
  }

  /** The head of the time that is dt after the start of the flight. */
  public double after(double dt) {
    return sum(t, tl, dt);
  }

  /** The latest time from the start of the flight, at least 0, of which the clock tells now. */
  public double latestBy(double now) {
    double since = since(t, tl, now);
    double error = 2 * Math.ulp(now);
    // Of numbers at least 0 the bits are in the same order.
    long by = Double.doubleToRawLongBits(Math.max(0, since - error));
    long later = Double.doubleToRawLongBits(since + error);
    while (later - by > 1) {
      long middle = (by + later) >>> 1;
      if (after(Double.longBitsToDouble(middle)) <= now) {
        by = middle;
      } else {
        later = middle;
      }
    }
    return Double.longBitsToDouble(by);
  }

  /** The tail of {@link #after}. */
  public double afterTail(double dt, double head) {
    return sumTail(t, tl, dt, head);
  }

  /** The head of the time that is dt after t + tl. */
  public static double sum(double t, double tl, double dt) {
    double s = t + dt;
    return s + (DoubleDouble.sumTail(t, dt, s) + tl);
  }

  /** The tail of {@link #sum}. */
  public static double sumTail(double t, double tl, double dt, double head) {
    double s = t + dt;
    double l = DoubleDouble.sumTail(t, dt, s) + tl;
    return DoubleDouble.sumTail(s, l, head);
  }

  /** from + v dt - to, for to = fl(from + v dt): what the rounded place lacks. */
  public static double lack(double from, double v, double dt, double to) {
    double d = from - to;
    return Math.fma(v, dt, d) + DoubleDouble.differenceTail(from, to, d);
  }

  /** Whether the flight started at that time, by its clock. */
  public boolean isAt(double head, double tail) {
    return head == t && tail == tl;
  }

  /**
   * Flies on for one length of time and then another, to a new start of a flight whose time is
   * known.
   *
   * @param standsStill whether the second is too short for the clock
   * @param walls which it does not leave, as {@link ObstacleTable#walls}
   */
  public void advance(
      double first, double second, double head, double tail, boolean standsStill, double[] walls) {
    x = Confinement.x(walls, x, Math.fma(vx, second, Math.fma(vx, first, x)), radius);
    y = Confinement.y(walls, y, Math.fma(vy, second, Math.fma(vy, first, y)), radius);
    t = head;
    tl = tail;
    flown = first + second;
    this.standsStill = standsStill && flown == second;
  }

  /** Flies on for dt, to a new start of a flight. */
  public void advance(double dt) {
    x = Math.fma(vx, dt, x);
    y = Math.fma(vy, dt, y);
    double head = after(dt);
    double tail = afterTail(dt, head);
    standsStill = isAt(head, tail);
    t = head;
    tl = tail;
    flown = dt;
  }
}
