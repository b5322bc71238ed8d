// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.util.KindNumber;
import dev.carom.internal.util.Part;
import java.util.Arrays;

/**
 * The impacts of a step, one row each, in order of time after {@link #sort}. Circles are named by
 * their slots.
 */
public final class ImpactRows {

  // Outcomes: the ordinals of the public enum.
  public static final int BOUNCED = 0;
  public static final int HALTED = 1;
  public static final int SENSED = 2;
  public static final int PASSED = 3;
  public static final int JAMMED = 4;
  public static final int STOPPED = 5;
  public static final int SETTLED = 6;

  /**
   * Doubles of one row: time, contact x and y, normal n of any length, v.n before the impact, and
   * p.n for the impulse p. The square root that makes n a unit vector is taken only when the normal
   * is read.
   */
  private static final int ROW = 7;

  // Their places in the row.
  private static final int TIME = 0;
  private static final int CONTACT_X = 1;
  private static final int CONTACT_Y = 2;
  private static final int NX = 3;
  private static final int NY = 4;
  private static final int VN = 5;
  private static final int PN = 6;

  /** Ints of one row: circle, obstacle, and three packed ordinals, see {@link #WHAT}. */
  private static final int INTS = 3;

  private static final int OBSTACLE = 1;

  /** The ordinals of the kind, of the feature and of the outcome, a byte each. */
  private static final int WHAT = 2;

  private static final int FEATURE = 8;
  private static final int OUTCOME = 16;
  private static final int ORDINAL = (1 << FEATURE) - 1;

  /** Knows which sides are one outline. */
  private ObstacleTable obstacles = ObstacleTable.empty(null);

  private int size;
  private double[] numbers;
  private int[] ints;

  private final TimeOrder order;

  /** Negative if a row was added that is earlier than its predecessor. Computed branch-free. */
  private long disorder;

  /** The time of the row added last. */
  private double latest;

  /** Creates a log with room for some rows. It grows as needed. */
  public ImpactRows(int rows) {
    numbers = new double[rows * ROW];
    ints = new int[rows * INTS];
    order = new TimeOrder(numbers, ROW);
  }

  /** Sets the obstacles that rows will name. */
  public ImpactRows of(ObstacleTable table) {
    obstacles = table;
    return this;
  }

  public int size() {
    return size;
  }

  // The columns. Row 0 is the earliest one after sort.

  public double time(int row) {
    return numbers[at(row) * ROW + TIME];
  }

  public int circle(int row) {
    return ints[at(row) * INTS];
  }

  public int obstacle(int row) {
    return ints[at(row) * INTS + OBSTACLE];
  }

  /** The code of the obstacle; of a vertex of an outline, that of the side that begins there. */
  public int code(int row) {
    return Codes.of(kind(row), obstacle(row));
  }

  /** The id of the obstacle; of a circle its slot. */
  public int id(int row) {
    return kind(row) == KindNumber.CIRCLE ? obstacle(row) : obstacles.id(code(row));
  }

  /** The side of an outline; 0 of all else. */
  public int side(int row) {
    return kind(row) == KindNumber.LINE ? obstacles.side(code(row)) : 0;
  }

  public int kind(int row) {
    return what(row) & ORDINAL;
  }

  public int feature(int row) {
    return what(row) >> FEATURE & ORDINAL;
  }

  public int outcome(int row) {
    return what(row) >> OUTCOME;
  }

  private int what(int row) {
    return ints[at(row) * INTS + WHAT];
  }

  public double x(int row) {
    return numbers[at(row) * ROW + CONTACT_X];
  }

  public double y(int row) {
    return numbers[at(row) * ROW + CONTACT_Y];
  }

  public double nx(int row) {
    int k = at(row) * ROW;
    return numbers[k + NX] / length(k);
  }

  public double ny(int row) {
    int k = at(row) * ROW;
    return numbers[k + NY] / length(k);
  }

  public double approachSpeed(int row) {
    int k = at(row) * ROW;
    return Math.max(0, -numbers[k + VN] / length(k));
  }

  /** The impulse that the circle received along the normal. */
  public double impulse(int row) {
    int k = at(row) * ROW;
    return numbers[k + PN] / length(k);
  }

  private double length(int k) {
    double nx = numbers[k + NX];
    double ny = numbers[k + NY];
    return Math.sqrt(nx * nx + ny * ny);
  }

  public void clear() {
    size = 0;
    disorder = 0;
    latest = 0;
  }

  /**
   * Adds a row, to be completed by {@link #set}.
   *
   * @param code the code of the obstacle, or of the other circle
   * @param feature the feature of the obstacle
   */
  public void add(double time, int circle, int code, int feature) {
    int named = obstacles.named(code, feature);
    int itsFeature = named == code ? feature : Part.START;
    put(time, circle, Codes.kind(named), Codes.index(named), itsFeature);
  }

  private void put(double time, int circle, int kind, int obstacle, int feature) {
    int row = size;
    int k = row * ROW;
    if (k == numbers.length) {
      grow();
    }
    disorder |= Double.doubleToRawLongBits(time - latest);
    latest = time;
    numbers[k + TIME] = time;
    int c = row * INTS;
    ints[c] = circle;
    ints[c + WHAT] = kind | feature << FEATURE;
    ints[c + OBSTACLE] = obstacle;
    order.rows[row] = row;
    size = row + 1;
  }

  /** Adds a row of two circles, to be completed by {@link #set}. */
  public void addPair(double time, int circle, int other) {
    put(time, circle, KindNumber.CIRCLE, other, Part.CIRCLE);
  }

  /** Completes the row added last, with a normal of any length, v.n and no impulse. */
  public void set(double x, double y, double nx, double ny, double vn) {
    int k = (size - 1) * ROW;
    // The first and the last column first: then compilers need not check the range of the rest.
    numbers[k + CONTACT_X] = Coordinates.within(x);
    numbers[k + PN] = 0;
    numbers[k + VN] = vn;
    numbers[k + CONTACT_Y] = Coordinates.within(y);
    numbers[k + NX] = nx;
    numbers[k + NY] = ny;
  }

  /** Sets the impulse p of the row added last, by p.n for the normal n of the row. */
  public void setImpulse(double pn) {
    numbers[(size - 1) * ROW + PN] = pn;
  }

  /** Adds an impulse along the normal to that of the row added last. */
  public void addImpulse(double p) {
    int k = (size - 1) * ROW;
    numbers[k + PN] += p * length(k);
  }

  /** Sets the outcome of the row added last, which is BOUNCED by default. */
  public void setOutcome(int outcome) {
    int k = (size - 1) * INTS + WHAT;
    ints[k] = (ints[k] & (1 << OUTCOME) - 1) | outcome << OUTCOME;
  }

  /** Appends a contact that jams a circle, at a distance d from its centre, against n. */
  public void addJammed(
      MovingCircle m, int code, int feature, double d, double nx, double ny, double vn) {
    add(m.t, m.id, code, feature);
    set(m.x - d * nx, m.y - d * ny, nx, ny, vn);
    setOutcome(JAMMED);
  }

  /** Removes the row added last. */
  public void removeLast() {
    cut(size - 1);
  }

  /** Keeps only the first so many rows, in the order in which they were added. */
  public void cut(int rows) {
    size = rows;
  }

  /**
   * Sorts the rows by time. The sort is stable: rows arrive circle by circle, and those of one
   * circle as they happened.
   */
  public void sort() {
    if (disorder < 0) {
      order.sort(size);
    }
  }

  private void grow() {
    int capacity = 2 * size;
    numbers = Arrays.copyOf(numbers, capacity * ROW);
    ints = Arrays.copyOf(ints, capacity * INTS);
    order.extend(numbers);
  }

  private int at(int row) {
    if (row < 0 || row >= size) {
      throw new IndexOutOfBoundsException(
          "row is "
              + row
              + ": expected "
              + (size == 0 ? "none, the log is empty" : "0 to " + (size - 1)));
    }
    return order.rows[row];
  }
}
