// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * The flights of all live circles. A circle is loaded into the one {@link MovingCircle}, advanced,
 * and stored.
 */
public final class CircleTable extends FlightTable {

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

  /**
   * The next event time of each circle: its next impact, or the end of its prediction. Null in a
   * table of circles that collide.
   */
  public final DueTimes due;

  /** The walls, as {@link ObstacleTable#walls}. Filters may let some circles pass. */
  private double[] walls;

  // These have the filters. Null in a table without an engine, where each filter is the default.
  private CircleRegistry registry;
  private ObstacleTable obstacles;

  public final MovingCircle body = new MovingCircle();

  /** A table of circles that ignore each other. */
  public CircleTable(int count) {
    super(count);
    this.count = count;
    due = new DueTimes(count);
  }

  private CircleTable(int count, int doubles, int ints) {
    super(count, ALIGNMENT, doubles, CODES_ALIGNMENT, ints);
    this.count = count;
    due = null;
  }

  /** A table of circles that collide. A queue holds their event times. */
  public static CircleTable colliding(int count) {
    return new CircleTable(count, COLLIDING_STATE, COLLIDING_CODES);
  }

  /** Lets the table know the filters of its circles and of the walls. */
  public void setFilters(CircleRegistry ofCircles, ObstacleTable ofWalls) {
    registry = ofCircles;
    obstacles = ofWalls;
    walls = ofWalls.walls;
  }

  private long filter(int i) {
    return registry == null ? FilterBits.DEFAULT : registry.filter(i);
  }

  /** The walls that circle i does not leave, as {@link ObstacleTable#walls}; null for none. */
  public double[] wallsOf(int i) {
    return obstacles == null ? null : obstacles.wallsFor(filter(i));
  }

  /** Removes all circles. */
  public void clear() {
    if (due != null) {
      due.clear();
    }
    jams = null;
    count = 0;
  }

  /**
   * Adds one more circle, whose numbers are to be stored. Replaces the arrays if they are too
   * small.
   */
  public void add() {
    if (count == capacity()) {
      int room = 2 * count + 4;
      resize(room);
      if (due != null) {
        due.extend(room);
      }
    }
    count++;
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
    body.filter = scene.registry.filter(i);
  }

  public double x(int i, double now) {
    double free = freeX(i, now);
    double confined = confinedX(i, free, radius(i), walls);
    return confined == free || wallsOf(i) != null ? confined : free;
  }

  public double y(int i, double now) {
    double free = freeY(i, now);
    double confined = confinedY(i, free, radius(i), walls);
    return confined == free || wallsOf(i) != null ? confined : free;
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

  public double restitution(int i) {
    return state[at(i) + RESTITUTION];
  }

  public void setRestitution(int i, double e) {
    state[at(i) + RESTITUTION] = e;
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
        || supportWord(i) != 0;
  }

  /** Its circles fall only after {@link #allowGravity}. */
  @Override
  boolean mayBeRare(MovingCircle m) {
    return hasRare || m.jam != null || m.sensedPartner != MovingCircle.NOT_SENSED;
  }

  public void load(int i) {
    load(i, body);
  }

  public void load(int i, MovingCircle m) {
    m.id = i;
    get(i, m);
    m.filter = filter(i);
  }

  /** Loads a circle for a collision, without its prediction, which ends with its flight there. */
  public void loadForMeeting(double[] s, int[] c, int i, MovingCircle m) {
    int k = collidingAt(i);
    m.id = i;
    FlightRow.get(m, s, k);
    m.restitution = s[k + RESTITUTION];
    getPast(m, c, collidingCodesAt(i));
    getRare(i, m);
    m.filter = filter(i);
  }

  public void storeAndSetDue(int i) {
    storeAndSetDue(i, body);
  }

  /** Stores a circle that ignores others, and sets its next event time. */
  public void storeAndSetDue(int i, MovingCircle m) {
    put(i, m);
    due.set(i, m.due());
  }

  /**
   * Stores a circle that collides at the start of a new flight, for which nothing is predicted yet.
   */
  public void storeNewFlight(double[] s, int[] c, int i, MovingCircle m) {
    m.newFlight();
    putFlight(m, s, collidingAt(i), c, collidingCodesAt(i));
    putRare(i, m);
  }
}
