// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;

/**
 * The impacts of a world's last step, one row each, read without allocation. Valid until the next
 * step of that world, which overwrites it.
 *
 * <p>Rows stand in the order of time, and are numbered from 0. At equal times, where circles ignore
 * each other: by the id of the circle, and those of one circle as they happened; where they
 * collide: in the order in which they were resolved, see {@link ObstacleKind}.
 *
 * <p>A row takes some 70 bytes. A log has room for the longest step that there was, or up to twice
 * that, and keeps it; how many rows a step can have is bounded by its budget of work, see {@link
 * World}.
 */
public final class ImpactLog {

  /**
   * Doubles of one row: time, contact x and y, normal n of any length, and v.n before the impact.
   * The root that makes n a unit vector is taken by who reads it.
   */
  private static final int ROW = 6;

  /** Ints of one row: circle, obstacle, and what is packed, see {@link #WHAT}. */
  private static final int INTS = 3;

  private static final int OBSTACLE = 1;

  /** The ordinals of the kind, of the feature and of the outcome, a byte each. */
  private static final int WHAT = 2;

  private static final int FEATURE = 8;
  private static final int OUTCOME = 16;
  private static final int ORDINAL = (1 << FEATURE) - 1;

  // Ordinals are kept as numbers: storing a reference costs what a garbage collector must know of
  // it.
  private static final ObstacleKind[] KINDS = ObstacleKind.values();
  private static final Feature[] FEATURES = Feature.values();
  private static final Outcome[] OUTCOMES = Outcome.values();

  /** Rows that {@link #toString} tells. */
  private static final int TOLD = 10;

  private static final int CIRCLE = ObstacleKind.CIRCLE.ordinal();

  private int size;
  private double[] numbers;
  private int[] ints;

  private final TimeOrder order;

  /** Below 0 if a row arrived that is earlier than the one before it: told without a branch. */
  private long disorder;

  /** The time of the row that arrived last. */
  private double latest;

  /** What callers call a circle, which is written by its slot. */
  private final IntUnaryOperator ids;

  /** Of circles whose slots are their ids. */
  ImpactLog(int rows) {
    this(rows, IntUnaryOperator.identity());
  }

  /** With room for some rows; it grows as needed. */
  ImpactLog(int rows, IntUnaryOperator ids) {
    this.ids = ids;
    numbers = new double[rows * ROW];
    ints = new int[rows * INTS];
    order = new TimeOrder(numbers, ROW);
  }

  /**
   * The number of impacts.
   *
   * @return at least 0
   */
  public int size() {
    return size;
  }

  /**
   * When.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the time of impact on the world's clock, the nearest double
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double time(int row) {
    return numbers[at(row) * ROW];
  }

  /**
   * Which circle.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return its id; of two circles that collide, the smaller one
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public int circle(int row) {
    return ids.applyAsInt(ints[at(row) * INTS]);
  }

  /**
   * The kind of thing it hit.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the kind
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public ObstacleKind kind(int row) {
    return KINDS[what(row) & ORDINAL];
  }

  /**
   * Which thing of that kind it hit.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the id of the line, peg or other circle; of a wall 0 left, 1 right, 2 bottom, 3 top
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public int id(int row) {
    int k = at(row) * INTS;
    int obstacle = ints[k + OBSTACLE];
    return (ints[k + WHAT] & ORDINAL) == CIRCLE ? ids.applyAsInt(obstacle) : obstacle;
  }

  /**
   * The part of the obstacle that was hit.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the feature
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public Feature feature(int row) {
    return FEATURES[what(row) >> FEATURE & ORDINAL];
  }

  /**
   * The x coordinate of the contact point, see {@link Impact#point}.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the coordinate
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double x(int row) {
    return numbers[at(row) * ROW + 1];
  }

  /**
   * The y coordinate of the contact point, see {@link Impact#point}.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the coordinate
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double y(int row) {
    return numbers[at(row) * ROW + 2];
  }

  /**
   * The x component of the unit normal, which points from the obstacle to the circle.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double nx(int row) {
    int k = at(row) * ROW;
    return numbers[k + 3] / length(k);
  }

  /**
   * The y component of the unit normal, which points from the obstacle to the circle.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double ny(int row) {
    int k = at(row) * ROW;
    return numbers[k + 4] / length(k);
  }

  /**
   * The speed at which the circle approached the obstacle, along the normal.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return at least 0
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double approachSpeed(int row) {
    int k = at(row) * ROW;
    return Math.max(0, -numbers[k + 5] / length(k));
  }

  /**
   * What the impact did.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the outcome
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public Outcome outcome(int row) {
    return OUTCOMES[what(row) >> OUTCOME];
  }

  /**
   * The first rows, for a debugger.
   *
   * @return the number of rows, then up to ten of them, one a line: time, circle, what it hit and
   *     the feature of that, approach speed
   */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("ImpactLog of " + size + " rows");
    for (int row = 0; row < Math.min(size, TOLD); row++) {
      text.append(
          "\n%d: time %s, circle %d, %s %s, approach speed %s%s"
              .formatted(
                  row,
                  time(row),
                  circle(row),
                  kind(row).nameOf(id(row)),
                  feature(row),
                  approachSpeed(row),
                  outcome(row) == Outcome.BOUNCED ? "" : ", " + outcome(row)));
    }
    return text.append(size > TOLD ? "\nand " + (size - TOLD) + " more" : "").toString();
  }

  private int what(int row) {
    return ints[at(row) * INTS + WHAT];
  }

  private double length(int k) {
    double nx = numbers[k + 3];
    double ny = numbers[k + 4];
    return Math.sqrt(nx * nx + ny * ny);
  }

  void clear() {
    size = 0;
    disorder = 0;
    latest = 0;
  }

  /** Adds a row, to be completed by {@link #set}. */
  void add(double time, int circle, ObstacleKind kind, int obstacle, Feature feature) {
    int row = size;
    int k = row * ROW;
    if (k == numbers.length) {
      grow();
    }
    disorder |= Double.doubleToRawLongBits(time - latest);
    latest = time;
    numbers[k] = time;
    int c = row * INTS;
    ints[c] = circle;
    ints[c + WHAT] = kind.ordinal() | feature.ordinal() << FEATURE;
    ints[c + OBSTACLE] = obstacle;
    order.rows[row] = row;
    size = row + 1;
  }

  /** Completes the row added last, with a normal of any length and v.n. */
  void set(double x, double y, double nx, double ny, double vn) {
    int k = (size - 1) * ROW;
    // The first and the last one first: then compilers need not ask whether the rest is in range.
    numbers[k + 1] = Coordinates.within(x);
    numbers[k + 5] = vn;
    numbers[k + 2] = Coordinates.within(y);
    numbers[k + 3] = nx;
    numbers[k + 4] = ny;
  }

  /** Sets the outcome of the row added last, which else is that the circle bounced. */
  void setOutcome(Outcome outcome) {
    int k = (size - 1) * INTS + WHAT;
    ints[k] = (ints[k] & (1 << OUTCOME) - 1) | outcome.ordinal() << OUTCOME;
  }

  /**
   * Puts the rows into the order of time. Stable: rows arrive circle by circle, and those of one
   * circle as they happened.
   */
  void sort() {
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
          "row " + row + " does not exist: the log has " + size + " of them, from 0");
    }
    return order.rows[row];
  }
}
