// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.DoubleDouble;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Coordinates;

/**
 * One circle in flight: {@code FlightSearch} predicts its next impact, and {@code ObstacleResponse}
 * resolves it. A world loads a circle from its arrays into one such object, advances it, and stores
 * it again.
 *
 * <p>Times are kept as head and tail: the nearest double and the remainder, about 106 bits in all.
 * So an impact is placed as accurately after a million frames as after one, and a sum of times does
 * not depend on how the steps were cut.
 */
public final class MovingCircle {

  /** Impacts at one place are counted up to this number. */
  public static final int STUCK_LIMIT = 1 << 24;

  /** No obstacle or circle: nothing was hit yet, or nothing since the last edit. */
  public static final int NOTHING = -1;

  /** No other circle: a sensor reported no contact with one. */
  public static final int NOT_SENSED = -2;

  // The modes of a circle: on its own, or a member of those in contact under gravity, see {@code
  // ContactCore}.
  public static final int ALONE = 0;
  public static final int AWAKE = 1;
  public static final int FROZEN = 2;

  /** Something that moves passes over it. */
  public static final int JAMMED = 3;

  /** The word of a member is this and its mode; it is greater than the code of any support. */
  private static final int WORD_OF_MEMBER = Integer.MAX_VALUE - JAMMED;

  /** The least word of a member. */
  static final int WORD_OF_AWAKE = WORD_OF_MEMBER + AWAKE;

  static final int WORD_OF_FROZEN = WORD_OF_MEMBER + FROZEN;

  /**
   * How far the first search of a flight looks ahead where less is needed, in halves of a cell at
   * the Manhattan speed. Each further search may look twice as far.
   */
  static final int FIRST_LOOKAHEAD = 64;

  /**
   * The same for a flight that an edit began. It is short, as another edit may end the flight soon.
   */
  public static final int EDITED_LOOKAHEAD = 1;

  /** From this on, the lookahead is not doubled any more. */
  private static final int MOST_LOOKAHEAD = 1 << 28;

  /**
   * The flight: the position at its start, its velocity, and the time of its start as head and
   * tail.
   */
  public double x;

  public double y;
  public double vx;
  public double vy;
  public double t;
  public double tl;

  /** The acceleration in this flight; 0 without gravity, and where the circle rests. */
  public double gx;

  public double gy;

  /** The code of the line or wall on which it slides or rests; else NOTHING. */
  public int support = NOTHING;

  /**
   * The code of the side over which contact left it: it slides there soon. If that is what it hit
   * last, it flew off an end of that line. Else NOTHING.
   */
  public int landing = NOTHING;

  /** Whether it is a member of those in contact: ALONE, AWAKE, FROZEN or JAMMED. */
  public int mode;

  /**
   * The momentum by mass of an awake member at the start of its flight, which is the velocity that
   * a world shows, and its rate of change.
   */
  public double px;

  public double py;
  public double ax;
  public double ay;

  /** What contact knows of a member, see {@link ContactRow}; null unless that is saved. */
  public double[] contactRow;

  /** Whether it has settled since its last fast impact. */
  public boolean settled;

  public int id;
  public double radius;
  public double restitution;

  /** Its {@link FilterBits}, which the registry of the circles keeps. */
  public long filter = FilterBits.DEFAULT;

  /** The code of the obstacle or circle hit last, which this flight cannot hit again. */
  public int last;

  /**
   * The obstacles and circles that a jammed circle ignores; null for a circle that is not jammed.
   */
  public IgnoreList jam;

  /** The flight is known to be free of impacts up to this time, counted from its start. */
  public double cleared;

  /**
   * The code of the next impact, at {@link #cleared}; NOTHING if the search ended there without
   * one.
   */
  public int next;

  /** The contact of the next impact, see {@link Contact}; 0 without one. */
  public int contact;

  /**
   * The time of the last contact with another circle in this flight that a sensor reported, as head
   * and tail.
   */
  public double sensedHead;

  public double sensedTail;

  /**
   * The other circle in that contact; NOTHING if it was removed, and no smaller one is left; {@link
   * #NOT_SENSED} without such a contact.
   */
  public int sensedPartner = NOT_SENSED;

  /**
   * Without a next impact, the largest code of the sensors that were reported at exactly {@link
   * #cleared}; else 0.
   */
  public int sensedCode;

  /** How far the next search looks ahead where less is needed, see {@link #FIRST_LOOKAHEAD}. */
  public int lookahead;

  /** The number of successive impacts at one place, see {@code ImpactRule}. */
  public int stuck;

  /** Whether one of them was with something infinite that moved towards the circle. */
  public boolean pushed;

  /** Starts the first flight of a circle, at time 0. */
  public void start(
      int id, double x, double y, double radius, double vx, double vy, double restitution) {
    this.id = id;
    this.x = x;
    this.y = y;
    this.radius = radius;
    this.vx = vx;
    this.vy = vy;
    this.restitution = restitution;
    filter = FilterBits.DEFAULT;
    t = 0;
    tl = 0;
    fall(0, 0);
    forget();
    newFlight();
  }

  /**
   * Begins a new flight at a given time, from the position at that time, as an edit does.
   *
   * @param now the head of that time, which is not before the flight that ends
   * @param tail its tail
   * @param obstacles those around it; it does not leave the walls among them
   */
  public void restart(double now, double tail, ObstacleTable obstacles) {
    double dt = (now - t) + (tail - tl);
    double[] walls = obstacles.wallsFor(filter);
    x = Confinement.x(walls, x, xAfter(dt), radius);
    y = Confinement.y(walls, y, yAfter(dt), radius);
    if (dt != 0 && (obstacles.turns(last) || (isFalling() && !staysInContact()))) {
      last = NOTHING;
    }
    accelerate(dt);
    t = now;
    tl = tail;
    newFlight();
    lookahead = EDITED_LOOKAHEAD;
  }

  /**
   * Whether a circle that falls, slides or rests still touches what it hit last. A return to that
   * is computed from a gap of 0 at the start of the flight.
   */
  private boolean staysInContact() {
    return (isCarried() && last == support) || (vx == 0 && vy == 0 && gx == 0 && gy == 0);
  }

  /** Lets the circle fly freely, with a given acceleration. */
  public void fall(double gravityX, double gravityY) {
    gx = gravityX;
    gy = gravityY;
    support = NOTHING;
    landing = NOTHING;
    mode = ALONE;
    contactRow = null;
  }

  /** Flies straight on as a member, until contact says otherwise. */
  public void join(int itsMode) {
    fall(0, 0);
    mode = itsMode;
    leavePlace();
    last = NOTHING;
    settled = false;
  }

  /** How far a search that begins now looks ahead; the next one looks twice as far. */
  public int useLookahead() {
    int now = lookahead;
    lookahead = Math.min(2 * now, MOST_LOOKAHEAD);
    return now;
  }

  /** {@link #support}, {@link #landing} and {@link #mode} in one int; 0 for none. */
  int supportWord() {
    return isMember() ? WORD_OF_MEMBER + mode : landing != NOTHING ? ~landing : support + 1;
  }

  /** The inverse of {@link #supportWord}. */
  void setSupport(int word) {
    mode = word < WORD_OF_AWAKE ? ALONE : word - WORD_OF_MEMBER;
    landing = word < 0 ? ~word : NOTHING;
    support = supportOf(word);
  }

  /** The line or wall in a {@link #supportWord}; NOTHING if it tells anything else. */
  static int supportOf(int word) {
    return word > 0 && word < WORD_OF_AWAKE ? word - 1 : NOTHING;
  }

  /** Whether the circle is a member of those in contact. */
  public boolean isMember() {
    return mode != ALONE;
  }

  /** Whether the circle slides or rests on a line or a wall. */
  public boolean isCarried() {
    return support != NOTHING;
  }

  /** Whether something carries the circle: it slides, rests, or is in contact. */
  public boolean isSupported() {
    return isMember() || isCarried();
  }

  /** Whether a massive object that crushed the circle still overlaps it. */
  public boolean isCrushed() {
    return jam != null && jam.hasCrushers();
  }

  /** Whether the circle has an acceleration, slides or rests. */
  public boolean isFalling() {
    return gx != 0 || gy != 0 || isSupported();
  }

  /** Where the centre is after a duration of this flight, on one axis. */
  public double xAfter(double dt) {
    return place(x, vx, gx, dt);
  }

  public double yAfter(double dt) {
    return place(y, vy, gy, dt);
  }

  /** p + v dt + g dt^2 / 2. */
  public static double place(double p, double v, double g, double dt) {
    return fma(g == 0 ? v : fma(0.5 * g, dt, v), dt, p);
  }

  /** The velocity after a duration, on one axis; the largest double where it would be infinite. */
  public static double velocity(double v, double g, double dt) {
    return g == 0 ? v : Coordinates.within(fma(g, dt, v));
  }

  /** Takes the velocity after a duration of this flight. */
  private void accelerate(double dt) {
    vx = velocity(vx, gx, dt);
    vy = velocity(vy, gy, dt);
  }

  /** Forgets what was hit last, so that the next impact may be with anything. */
  public void forget() {
    last = NOTHING;
    settled = false;
    leavePlace();
  }

  /** Resets the count of impacts at one place. */
  public void leavePlace() {
    jam = null;
    stuck = 0;
    pushed = false;
  }

  /** Lets the obstacles that the circle ignores act on it again, but for those that crushed it. */
  public void ignoreCirclesOnly() {
    if (jam != null) {
      jam = jam.ofCircles();
    }
  }

  /** Lets all that crushed the circle act on it again, as none is upon it any more. */
  public void forgetCrushers() {
    if (jam != null) {
      jam = jam.withoutCrushers();
    }
  }

  /**
   * Forgets an obstacle or a circle that is about to change; returns whether the flight referred to
   * it.
   *
   * @param sensedCode used if it is the next impact: of the sensors met at that time, those with a
   *     code up to this one were reported
   */
  public boolean forget(int code, int sensedCode) {
    boolean knew = last == code || next == code || (jam != null && jam.concerns(code));
    if (last == code) {
      last = NOTHING;
      stuck = isFalling() && jam == null ? 0 : stuck; // bounces on one thing are not counted
    }
    if (next == code) {
      clearUpTo(cleared);
      this.sensedCode = sensedCode;
    }
    if (jam != null && jam.concerns(code)) {
      // The rest stays ignored: it would be hit at the start of the flight, before the edit.
      jam = jam.without(code);
      stuck = jam == null ? 0 : stuck;
    }
    return knew;
  }

  /** Forgets the prediction and what was sensed, for a new flight. */
  public void newFlight() {
    forgetPrediction(0, 0);
    forgetSensedCircle();
  }

  private void forgetSensedCircle() {
    sensedHead = 0;
    sensedTail = 0;
    sensedPartner = NOT_SENSED;
  }

  /** Whether anything of it is in a column that not all tables have, see {@link FlightTable}. */
  boolean isRare() {
    return isFalling() || landing != NOTHING || sensedPartner != NOT_SENSED || jam != null;
  }

  /** Takes the values of the columns that a table does not have. */
  void clearRare() {
    fall(0, 0);
    forgetSensedCircle();
    jam = null;
  }

  /**
   * Forgets the prediction, but not the sensors that were reported.
   *
   * @param sensed they were up to this time, from the start of the flight
   * @param code of those met at exactly that time, up to this code
   */
  public void forgetPrediction(double sensed, int code) {
    clearUpTo(sensed);
    sensedCode = code;
    lookahead = FIRST_LOOKAHEAD;
  }

  /** Predicts the next impact, a duration after the start of the flight. */
  public void predict(double duration, int code, int itsContact) {
    cleared = duration;
    next = code;
    contact = itsContact;
    sensedCode = 0;
  }

  /** Predicts that no impact comes until a duration after the start of the flight. */
  public void clearUpTo(double duration) {
    predict(duration, NOTHING, 0);
  }

  /**
   * The time since the start of a flight. At least 0: a flight may start later than the head of its
   * time.
   */
  public static double since(double t, double tl, double now) {
    return Math.max(0, now - t - tl);
  }

  /** The time of the next impact or tick, or at which the prediction ends. */
  public double due() {
    return contactRow == null ? known() : Math.min(known(), nextTick());
  }

  /** The time of the next impact, or at which the prediction ends, whatever ticks come before. */
  public double known() {
    return cleared == Double.POSITIVE_INFINITY ? cleared : after(cleared);
  }

  /** The next tick of a member whose contact stands in its row. */
  private double nextTick() {
    return mode == FROZEN ? Double.POSITIVE_INFINITY : contactRow[ContactRow.END];
  }

  /** Whether a tick is what comes next. */
  public boolean ticksNext() {
    return contactRow != null && due() == nextTick();
  }

  /** The first double that is not before a time, given as head and tail. */
  public static double firstNotBefore(double head, double tail) {
    return tail > 0 ? Math.nextUp(head) : head;
  }

  /** The head of the time that is dt after the start of the flight. */
  public double after(double dt) {
    return sum(t, tl, dt);
  }

  /**
   * The longest duration, at least 0, after which the rounded time is not later than {@code now}.
   */
  public double latestBy(double now) {
    double since = since(t, tl, now);
    double error = 2 * Math.ulp(now);
    // The bits of doubles that are at least 0 have the same order as the doubles.
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

  /** from + v dt - to, for to = fl(from + v dt): the rounding error of a position. */
  public static double lack(double from, double v, double dt, double to) {
    double d = from - to;
    return fma(v, dt, d) + DoubleDouble.differenceTail(from, to, d);
  }

  /** Whether the flight started at exactly that time of the clock. */
  public boolean isAt(double head, double tail) {
    return head == t && tail == tl;
  }

  /**
   * Advances by one duration and then another, to the start of a new flight at a known time.
   *
   * @param standsStill whether the second duration is too short to advance the clock
   * @param obstacles with the walls that it does not leave
   * @return how long the flight lasted that ends here; 0 if too short to advance the clock
   */
  public double advance(
      double first,
      double second,
      double head,
      double tail,
      boolean standsStill,
      ObstacleTable obstacles) {
    double startX = x;
    double startY = y;
    move(first);
    move(second);
    if (!Confinement.isInside(obstacles.walls, x, y, radius)) {
      double[] walls = obstacles.wallsFor(filter);
      x = Confinement.x(walls, startX, x, radius);
      y = Confinement.y(walls, startY, y, radius);
    }
    t = head;
    tl = tail;
    double flown = first + second;
    return standsStill && flown == second ? 0 : flown;
  }

  /**
   * Advances by dt, to the start of a new flight.
   *
   * @return dt; 0 if too short to advance the clock
   */
  public double advance(double dt) {
    move(dt);
    double head = after(dt);
    double tail = afterTail(dt, head);
    boolean standsStill = isAt(head, tail);
    t = head;
    tl = tail;
    return standsStill ? 0 : dt;
  }

  /** Moves the centre, and takes the velocity, to those after a duration; time stays. */
  public void move(double dt) {
    if (gx == 0 && gy == 0) {
      x = fma(vx, dt, x);
      y = fma(vy, dt, y);
    } else {
      x = xAfter(dt);
      y = yAfter(dt);
      accelerate(dt);
    }
  }
}
