// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.util.KindNumber;
import java.util.Arrays;

/**
 * The obstacles of one kind, by their {@link Codes}: for each a row of doubles, laid out by its
 * {@link ObstacleShape}, its {@link ContactFlags} and its {@link FilterBits}. The row of a removed
 * obstacle is NaN, and its code is not used again.
 *
 * <p>Copies share their arrays until one of them is changed.
 */
public final class ObstacleRows {

  private final int kind;
  public final ObstacleShape shape;

  /**
   * The code whose row is at place 0 of the values. It is 0 for lines: rows of NaN stand before
   * theirs for the codes of walls, so that a search finds a line's row by its code alone.
   */
  private final int codeOfRow0;

  /** The number of doubles in a row, and the place of the restitution in it. */
  private final int width;

  private final int restitution;

  /** The rows, by codes. */
  public double[] values;

  /** By numbers within the kind. */
  private TraitColumns traits;

  private JoinedRows joints = new JoinedRows();

  /** The number of live rows that belong to the obstacle of the row before them. */
  private int joined;

  /** The next code to give. */
  public int end;

  private LiveCodes present;

  /** The number of obstacles with traits, and the number of sensors. */
  private int specials;

  private int sensors;

  /** Whether another object uses the same arrays. */
  private boolean shared;

  /** Whether any obstacle may have been removed. */
  private boolean edited;

  /** An empty table. */
  ObstacleRows(int kind, ObstacleShape shape) {
    this.kind = kind;
    this.shape = shape;
    width = shape.row;
    restitution = shape.restitution;
    codeOfRow0 = kind == KindNumber.LINE ? 0 : first();
    end = first();
    values = new double[offset(end)];
    Arrays.fill(values, Double.NaN);
    traits = new TraitColumns();
    present = new LiveCodes(end, 0);
  }

  /** A copy. */
  ObstacleRows copy() {
    ObstacleRows copy = new ObstacleRows(kind, shape);
    copy.set(this);
    return copy;
  }

  /** Copies the obstacles of another table of the same kind. */
  void set(ObstacleRows other) {
    if (!other.shared) {
      other.shared = true; // written only if need be: a scene is used by many threads
    }
    shared = true;
    edited = other.edited;
    values = other.values;
    traits = other.traits;
    joints = other.joints;
    joined = other.joined;
    end = other.end;
    present = other.present;
    specials = other.specials;
    sensors = other.sensors;
  }

  private void countSpecial(int ofOne, int one) {
    specials += ofOne != 0 ? one : 0;
    sensors += ContactFlags.isSensor(ofOne) ? one : 0;
  }

  public int kind() {
    return kind;
  }

  /** The code of the first obstacle. */
  public int first() {
    return Codes.of(kind, 0);
  }

  /** The number of codes given so far. */
  public int count() {
    return end - first();
  }

  // Ids: an obstacle is a row, or, as an outline, several rows that follow each other.

  /** The number of live obstacles. */
  int obstacles() {
    return present.count() - joined;
  }

  /** One more than the largest id. */
  public int idLimit() {
    return joints.idLimit();
  }

  /** The id of the obstacle to which a code belongs. */
  public int id(int code) {
    return joints.id(code - first());
  }

  /** The first code of an id. */
  public int code(int id) {
    return first() + joints.first(id);
  }

  /** The first code of the obstacle to which a code belongs. */
  public int firstOf(int code) {
    return code(id(code));
  }

  /** One more than the last code of the obstacle to which a code belongs. */
  public int endOf(int code) {
    return code(id(code) + 1);
  }

  /** Whether a code belongs to the obstacle of the one before. */
  public boolean isJoined(int code) {
    return joints.isJoined(code - first());
  }

  /** Whether any row belongs to the obstacle of the row before it. */
  boolean areJoined() {
    return joints.areAny();
  }

  /** The numbers, within the kind, of the codes that belong to the obstacle of the one before. */
  public int[] joined() {
    return joints.joined();
  }

  /** Lets the code given last belong to the obstacle of the one before. */
  void joinLast() {
    own();
    joints.join();
    joined++;
  }

  /** Whether the spine of an obstacle begins where that of another one ends. */
  public boolean meet(int one, int next) {
    int end = offset(one) + shape.toEnd;
    int start = offset(next);
    return values[end + ObstacleShape.X] == values[start + ObstacleShape.X]
        && values[end + ObstacleShape.Y] == values[start + ObstacleShape.Y];
  }

  /** Joins as in a later table, in which no id is another one. */
  void joinAs(ObstacleRows later) {
    if (later.areJoined()) {
      join(later.joined());
    }
  }

  /**
   * Sets the numbers, within the kind, of the codes that belong to the obstacle of the one before.
   * Numbers beyond the last code count for nothing.
   */
  public void join(int... rows) {
    joints = new JoinedRows();
    joined = 0;
    for (int code = first(); code < end; code++) {
      joints.add();
      if (Arrays.binarySearch(rows, code - first()) >= 0) {
        joints.join();
        joined += isGone(code) ? 0 : 1;
      }
    }
  }

  /** The codes of the live rows and perhaps of some removed ones, until the next change. */
  public LiveCodes present() {
    return present;
  }

  /** The place of an obstacle's row in the values. */
  public int offset(int code) {
    return (code - codeOfRow0) * width;
  }

  /** A copy of a row. */
  public double[] row(int code) {
    int k = offset(code);
    return Arrays.copyOfRange(values, k, k + shape.row);
  }

  /** A copy of the numbers of a row before the restitution. */
  public double[] numbers(int code) {
    int k = offset(code);
    return Arrays.copyOfRange(values, k, k + shape.restitution);
  }

  /** The name of the kind in scene files. */
  public String name() {
    return shape.name;
  }

  public boolean isGone(int code) {
    return edited && Double.isNaN(values[offset(code)]);
  }

  double restitution(int code) {
    return values[offset(code) + restitution];
  }

  public int traits(int code) {
    return traits.flags(code - first());
  }

  long filter(int code) {
    return traits.filter(code - first());
  }

  /** The filters of all; null if each is the default. */
  public long[] filters() {
    return traits.filters(count());
  }

  /** Whether any may have a filter other than the default. */
  boolean areFiltered() {
    return traits.areFiltered();
  }

  int specials() {
    return specials;
  }

  int sensors() {
    return sensors;
  }

  /** The largest absolute coordinate of an obstacle; 0 for one that was removed. */
  double extent(int code) {
    double extent = 0;
    int k = offset(code);
    for (int i = k; i < k + shape.coordinates && !isGone(code); i++) {
      extent = Math.max(extent, Math.abs(values[i]));
    }
    return extent;
  }

  // Changes.

  /** Prepares a change: copies the arrays if another object shares them. */
  private void own() {
    if (shared) {
      shared = false;
      values = values.clone();
      traits = traits.copy();
      joints = joints.copy();
      present = present.copy();
    }
  }

  /** Frees the room for more obstacles. */
  void trim() {
    values = Arrays.copyOf(values, offset(end));
  }

  /** Adds an elastic obstacle without traits, and returns its code. */
  int add(double... numbers) {
    own();
    int code = end++;
    if (offset(end) > values.length) {
      int room = Math.min(2 * count() + 4, Codes.limit(kind));
      values = Arrays.copyOf(values, offset(first() + room));
    }
    present.add(code);
    joints.add();
    move(code, numbers);
    setRestitution(code, 1);
    return code;
  }

  /** Sets the numbers of an obstacle before its restitution. */
  void move(int code, double... numbers) {
    own();
    System.arraycopy(numbers, 0, values, offset(code), shape.restitution);
  }

  /** Sets the coordinates of an obstacle to those at a time, by its motion. */
  void advance(int code, ObstacleMotions motions, double now) {
    own();
    int k = offset(code);
    motions.place(motions.indexOf(code), now, 0, values, k, values, k, shape.coordinates);
  }

  void setRestitution(int code, double e) {
    own();
    values[offset(code) + restitution] = e;
  }

  void setTraits(int code, int its) {
    own();
    countSpecial(traits(code), -1);
    countSpecial(its, 1);
    traits.setFlags(code - first(), its);
  }

  void setFilter(int code, long filter) {
    own();
    traits.setFilter(code - first(), filter);
  }

  /** Removes a live obstacle: no search finds it any more. */
  void remove(int code) {
    edited = true;
    joined -= isJoined(code) ? 1 : 0;
    setTraits(code, 0);
    setFilter(code, FilterBits.DEFAULT);
    int k = offset(code);
    Arrays.fill(values, k, k + shape.row, Double.NaN);
    present.removed(1, this::isGone);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ObstacleRows that
        && kind == that.kind
        && end == that.end
        && Arrays.equals(values, 0, offset(end), that.values, 0, offset(end))
        && Arrays.equals(joined(), that.joined())
        && hasSameTraits(that);
  }

  private boolean hasSameTraits(ObstacleRows that) {
    for (int code = first(); code < end; code++) {
      if (traits(code) != that.traits(code) || filter(code) != that.filter(code)) {
        return false;
      }
    }
    return true;
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(Arrays.copyOf(values, offset(end)));
  }
}
