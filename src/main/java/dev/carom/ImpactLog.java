// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.ImpactRows;
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

  private static final Outcome[] OUTCOMES = Outcome.values();

  /** Rows that {@link #toString} tells. */
  private static final int ROWS_SHOWN = 10;

  private static final int CIRCLE = ObstacleKind.CIRCLE.ordinal();

  private final ImpactRows rows;

  /** The id of the circle that a row names by its slot. */
  private final IntUnaryOperator ids;

  /** Of circles whose slots are their ids. */
  ImpactLog(ImpactRows rows) {
    this(rows, IntUnaryOperator.identity());
  }

  ImpactLog(ImpactRows rows, IntUnaryOperator ids) {
    this.rows = rows;
    this.ids = ids;
  }

  /**
   * The number of impacts.
   *
   * @return at least 0
   */
  public int size() {
    return rows.size();
  }

  /**
   * When.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the time of impact on the world's clock, the nearest double
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double time(int row) {
    return rows.time(row);
  }

  /**
   * Which circle.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return its id; of two circles that collide, the smaller one
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public int circle(int row) {
    return ids.applyAsInt(rows.circle(row));
  }

  /**
   * The kind of thing it hit.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the kind
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public ObstacleKind kind(int row) {
    return ObstacleKind.of(rows.kind(row));
  }

  /**
   * Which thing of that kind it hit.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the id of the line, peg or other circle; of a wall 0 left, 1 right, 2 bottom, 3 top
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public int id(int row) {
    int obstacle = rows.obstacle(row);
    return rows.kind(row) == CIRCLE ? ids.applyAsInt(obstacle) : obstacle;
  }

  /**
   * The part of the obstacle that was hit.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the feature
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public Feature feature(int row) {
    return Feature.of(rows.feature(row));
  }

  /**
   * The x coordinate of the contact point, see {@link Impact#point}.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the coordinate
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double x(int row) {
    return rows.x(row);
  }

  /**
   * The y coordinate of the contact point, see {@link Impact#point}.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the coordinate
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double y(int row) {
    return rows.y(row);
  }

  /**
   * The x component of the unit normal, which points from the obstacle to the circle.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double nx(int row) {
    return rows.nx(row);
  }

  /**
   * The y component of the unit normal, which points from the obstacle to the circle.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double ny(int row) {
    return rows.ny(row);
  }

  /**
   * The speed at which the circle approached the obstacle, along the normal.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return at least 0
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double approachSpeed(int row) {
    return rows.approachSpeed(row);
  }

  /**
   * What the impact did.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the outcome
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public Outcome outcome(int row) {
    return OUTCOMES[rows.outcome(row)];
  }

  /**
   * The first rows, for a debugger.
   *
   * @return the number of rows, then up to ten of them, one a line: time, circle, what it hit and
   *     the feature of that, approach speed
   */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("ImpactLog of " + size() + " rows");
    for (int row = 0; row < Math.min(size(), ROWS_SHOWN); row++) {
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
    return text.append(size() > ROWS_SHOWN ? "\nand " + (size() - ROWS_SHOWN) + " more" : "")
        .toString();
  }
}
