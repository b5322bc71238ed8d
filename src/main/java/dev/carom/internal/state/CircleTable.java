// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The flights of all circles in flat arrays. A row holds the start of a flight and the prediction
 * of its next impact with a static obstacle. A circle is loaded into the one {@link MovingCircle},
 * advanced, and stored.
 */
public final class CircleTable {

  // Columns of a circle in state, after those of its flight.
  public static final int CLEARED = FlightRow.SIZE;
  static final int RESTITUTION = 8;
  static final int STATE = 9;

  // Further columns of a circle that collides: its next predicted collision, see
  // CollisionPredictor, and its cell; how long after the start of its flight it came into its cells
  // (under gravity only), and leaves the first of them.
  public static final int MEETING = 9;
  public static final int MEETING_TAIL = 10;
  public static final int TAU = 11;
  public static final int COLUMN = 12;
  public static final int ROW = 13;
  public static final int ENTERED = 14;
  public static final int LEAVING = 15;
  private static final int COLLIDING_STATE = 16;

  /**
   * Doubles before the first circle. In a large array each group of 8 doubles then fills one cache
   * line.
   */
  private static final int ALIGNMENT = 6;

  /** Ints before the first circle, for the same reason. */
  private static final int CODES_ALIGNMENT = 12;

  // Columns of a circle in codes.
  public static final int LAST = 0;
  public static final int NEXT = 1;

  /** See {@link ContactWord}. */
  static final int CONTACT = 2;

  static final int LOOKAHEAD = 3;
  public static final int STUCK = 4;
  static final int CODES = 5;

  // Further columns of a circle that collides: its partner in the predicted collision, the
  // partner's change count at that time, and its own change count; the next circle in its cell's
  // list; its event's position in the heap, and kind; the index of its cell.
  public static final int PARTNER = 5;
  public static final int PARTNER_COUNT = 6;
  public static final int COUNT = 7;
  public static final int FOLLOWER = 8;
  public static final int HEAP_INDEX = 9;
  public static final int KIND = 10;
  public static final int CELL = 11;

  /** The way in which it next leaves a cell, see {@code CellExit}. */
  public static final int WAY = 12;

  /** The ints of a circle that collides fill one cache line; 13 of them are used. */
  private static final int COLLIDING_CODES = 16;

  public int count;

  // The collision loop copies these two references into locals and passes them on. Read as fields
  // they would be reloaded, and their ranges checked again, after every call that is not inlined.
  // They change only when a circle is added.
  public double[] state;
  public int[] codes;

  private final int first;
  private final int stride;
  private final int firstCode;
  private final int codeStride;

  /**
   * The next event time of each circle: its next impact, or the end of its prediction. Used only by
   * circles that ignore each other.
   */
  public final DueTimes due;

  /** The walls, as {@link ObstacleTable#walls}. Filters may let some circles pass. */
  private double[] walls;

  // These have the filters. Null in a table without an engine, where each filter is the default.
  private CircleRegistry registry;
  private ObstacleTable obstacles;

  /** The ignore list of each jammed circle; null until there is one. */
  public IgnoreList[] jams;

  /** Acceleration and support of each circle; null until there is gravity. */
  private Accelerations accelerations;

  public final MovingCircle body = new MovingCircle();

  /** A table of circles that ignore each other. */
  public CircleTable(int count) {
    this(count, false);
  }

  private CircleTable(int count, boolean collide) {
    this.count = count;
    first = collide ? ALIGNMENT : 0;
    stride = collide ? COLLIDING_STATE : STATE;
    firstCode = collide ? CODES_ALIGNMENT : 0;
    codeStride = collide ? COLLIDING_CODES : CODES;
    state = new double[at(count)];
    codes = new int[codesAt(count)];
    due = new DueTimes(collide ? 0 : count);
  }

  /** A table of circles that collide. A queue holds their event times. */
  public static CircleTable colliding(int count) {
    return new CircleTable(count, true);
  }

  /** Lets the table know the filters of its circles and of the walls. */
  public void setFilters(CircleRegistry ofCircles, ObstacleTable ofWalls) {
    registry = ofCircles;
    obstacles = ofWalls;
    walls = ofWalls.walls;
  }

  private long filter(int i) {
    return registry == null ? Filter.DEFAULT : registry.filter(i);
  }

  /** The walls that circle i does not leave, as {@link ObstacleTable#walls}; null for none. */
  public double[] wallsOf(int i) {
    return obstacles == null ? null : obstacles.wallsFor(filter(i));
  }

  /** Makes room for accelerations, all 0. */
  public void allowGravity() {
    if (accelerations == null) {
      accelerations = new Accelerations(capacity());
    }
  }

  /** Whether circles may have accelerations. */
  public boolean allowsGravity() {
    return accelerations != null;
  }

  /** The number of circles for which there is room. */
  public int capacity() {
    return (codes.length - firstCode) / codeStride;
  }

  /** Removes all circles. */
  public void clear() {
    due.clear();
    jams = null;
    count = 0;
  }

  /**
   * Adds one more circle, whose numbers are to be stored. Replaces the arrays if they are too
   * small.
   */
  public void add() {
    if (count == capacity()) {
      int capacity = 2 * count + 4;
      state = Arrays.copyOf(state, at(capacity));
      codes = Arrays.copyOf(codes, codesAt(capacity));
      if (codeStride == CODES) {
        due.extend(capacity);
      }
      jams = jams == null ? null : Arrays.copyOf(jams, capacity);
      if (accelerations != null) {
        accelerations.resize(capacity);
      }
    }
    count++;
  }

  /** The index of the first double of circle i. */
  public int at(int i) {
    return first + i * stride;
  }

  /** The index of the first int of circle i. */
  public int codesAt(int i) {
    return firstCode + i * codeStride;
  }

  /**
   * The index of the first double of a circle that collides. The stride is a constant for the
   * compiler.
   */
  public static int collidingAt(int i) {
    return ALIGNMENT + i * COLLIDING_STATE;
  }

  /** The index of the first int of a circle that collides. */
  public static int collidingCodesAt(int i) {
    return CODES_ALIGNMENT + i * COLLIDING_CODES;
  }

  /** Starts the first flight of circle i of a scene in {@link #body}, without storing it. */
  public void start(SceneData scene, int i) {
    body.start(
        i, scene.x(i), scene.y(i), scene.radius(i), scene.vx(i), scene.vy(i), scene.restitution(i));
    body.filter = scene.filter(i);
  }

  public double x(int i, double now) {
    int k = at(i);
    double since = MovingCircle.since(state[k + FlightRow.T], state[k + FlightRow.TL], now);
    double g = gx(i);
    double x = MovingCircle.place(state[k + FlightRow.X], state[k + FlightRow.VX], g, since);
    double confined = Confinement.x(walls, state[k + FlightRow.X], x, state[k + FlightRow.RADIUS]);
    return confined == x || wallsOf(i) != null ? confined : x;
  }

  public double y(int i, double now) {
    int k = at(i);
    double since = MovingCircle.since(state[k + FlightRow.T], state[k + FlightRow.TL], now);
    double g = gy(i);
    double y = MovingCircle.place(state[k + FlightRow.Y], state[k + FlightRow.VY], g, since);
    double confined = Confinement.y(walls, state[k + FlightRow.Y], y, state[k + FlightRow.RADIUS]);
    return confined == y || wallsOf(i) != null ? confined : y;
  }

  public double vx(int i, double now) {
    int k = at(i);
    double since = MovingCircle.since(state[k + FlightRow.T], state[k + FlightRow.TL], now);
    return MovingCircle.velocity(state[k + FlightRow.VX], gx(i), since);
  }

  public double vy(int i, double now) {
    int k = at(i);
    double since = MovingCircle.since(state[k + FlightRow.T], state[k + FlightRow.TL], now);
    return MovingCircle.velocity(state[k + FlightRow.VY], gy(i), since);
  }

  /**
   * The time of the impact with an obstacle that ends the flight of a circle that collides;
   * infinite if none is known.
   */
  public double endOfFlight(int i) {
    int next = codes[collidingCodesAt(i) + NEXT];
    if (next < 0 || obstacles.isSensor(next)) {
      return Double.POSITIVE_INFINITY;
    }
    int k = collidingAt(i);
    return MovingCircle.sum(state[k + FlightRow.T], state[k + FlightRow.TL], state[k + CLEARED]);
  }

  /** How long a circle has been on its flight. */
  public double since(int i, double now) {
    int k = at(i);
    return MovingCircle.since(state[k + FlightRow.T], state[k + FlightRow.TL], now);
  }

  /** The acceleration of a circle. */
  public double gx(int i) {
    return accelerations == null ? 0 : accelerations.x(i);
  }

  public double gy(int i) {
    return accelerations == null ? 0 : accelerations.y(i);
  }

  /** The {@link MovingCircle#supportWord} of a circle. */
  private int supportWord(int i) {
    return accelerations == null ? MovingCircle.NOTHING : accelerations.support(i);
  }

  /** Whether a circle slides or rests on something. */
  public boolean isSupported(int i) {
    return supportWord(i) > MovingCircle.NOTHING;
  }

  /** The line or wall on which a circle slides or rests; NOTHING if on none, or on several. */
  public int support(int i) {
    return isSupported(i) && supportWord(i) < MovingCircle.PINNED
        ? supportWord(i)
        : MovingCircle.NOTHING;
  }

  public double radius(int i) {
    return state[at(i) + FlightRow.RADIUS];
  }

  public double restitution(int i) {
    return state[at(i) + RESTITUTION];
  }

  public void setRestitution(int i, double e) {
    state[at(i) + RESTITUTION] = e;
  }

  public IgnoreList jam(int i) {
    return jams == null ? null : jams[i];
  }

  /**
   * Whether the flight of circle i may depend on an obstacle: false only if it did not hit that
   * last, does not hit it next, ignores nothing, lies on nothing and left no line.
   */
  public boolean mayKnow(int i, int code) {
    int c = codesAt(i);
    return codes[c + LAST] == code
        || codes[c + NEXT] == code
        || jam(i) != null
        || supportWord(i) != MovingCircle.NOTHING;
  }

  public void load(int i) {
    load(i, body);
  }

  public void load(int i, MovingCircle m) {
    m.id = i;
    get(m, state, at(i), codes, codesAt(i));
    m.filter = filter(i);
    m.jam = jam(i);
    getAcceleration(i, m);
  }

  private void getAcceleration(int i, MovingCircle m) {
    if (accelerations != null) {
      accelerations.get(i, m);
    }
  }

  private void putAcceleration(int i, MovingCircle m) {
    if (accelerations != null) {
      accelerations.put(i, m);
    }
  }

  /** Reads a circle from its row of doubles at k and its row of ints at c. */
  static void get(MovingCircle m, double[] state, int k, int[] codes, int c) {
    FlightRow.get(m, state, k);
    m.cleared = state[k + CLEARED];
    m.restitution = state[k + RESTITUTION];
    m.last = codes[c + LAST];
    m.stuck = codes[c + STUCK];
    m.lookahead = codes[c + LOOKAHEAD];
    int word = codes[c + CONTACT];
    ContactWord.recall(word, m);
    // Without a next impact this column holds the code of the sensor that was reported last.
    int next = codes[c + NEXT];
    m.next = Math.max(next, MovingCircle.NOTHING);
    m.contact = ContactWord.contact(word);
    m.sensedCode = next < 0 ? MovingCircle.NOTHING - next : 0;
  }

  /** Writes a circle to its row of doubles at k and its row of ints at c. */
  static void put(MovingCircle m, double[] state, int k, int[] codes, int c) {
    FlightRow.put(m, state, k);
    state[k + CLEARED] = m.cleared;
    state[k + RESTITUTION] = m.restitution;
    // The first and the last column first: then compilers check the range of the others with them.
    codes[c + LAST] = m.last;
    codes[c + STUCK] = m.stuck;
    codes[c + NEXT] = m.next == MovingCircle.NOTHING ? m.next - m.sensedCode : m.next;
    codes[c + CONTACT] = ContactWord.of(m, m.contact);
    codes[c + LOOKAHEAD] = m.lookahead;
  }

  /** Loads a circle for a collision, without its prediction, which ends with its flight there. */
  public void loadForMeeting(double[] s, int[] c, int i, MovingCircle m) {
    int k = collidingAt(i);
    m.id = i;
    FlightRow.get(m, s, k);
    m.restitution = s[k + RESTITUTION];
    int code = collidingCodesAt(i);
    m.stuck = c[code + STUCK];
    ContactWord.recall(c[code + CONTACT], m);
    m.filter = filter(i);
    m.jam = jams == null ? null : jams[i];
    getAcceleration(i, m);
  }

  public void storeAndSetDue(int i) {
    storeAndSetDue(i, body);
  }

  /** Stores a circle that ignores others, and sets its next event time. */
  public void storeAndSetDue(int i, MovingCircle m) {
    store(i, m);
    due.set(i, m.due());
  }

  /** Stores a circle without setting its time in {@link #due}. */
  public void store(int i, MovingCircle m) {
    put(m, state, at(i), codes, codesAt(i));
    setJam(i, m.jam);
    putAcceleration(i, m);
  }

  /**
   * Stores a circle that collides at the start of a new flight, for which nothing is predicted yet.
   */
  public void storeNewFlight(double[] s, int[] c, int i, MovingCircle m) {
    int k = collidingAt(i);
    FlightRow.put(m, s, k);
    s[k + CLEARED] = 0;
    int code = collidingCodesAt(i);
    c[code + LAST] = m.last;
    c[code + STUCK] = m.stuck;
    c[code + NEXT] = MovingCircle.NOTHING;
    c[code + CONTACT] = ContactWord.of(m, 0);
    c[code + LOOKAHEAD] = m.lookahead;
    setJam(i, m.jam);
    putAcceleration(i, m);
  }

  private void setJam(int i, IgnoreList jam) {
    if (jam != null && jams == null) {
      jams = new IgnoreList[capacity()];
    }
    if (jams != null) {
      jams[i] = jam;
    }
  }
}
