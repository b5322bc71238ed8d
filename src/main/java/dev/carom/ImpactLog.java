// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.ImpactRows;
import java.util.Iterator;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;

/**
 * An {@code ImpactLog} lists the impacts of a world's last step, one row each. The next step of
 * that world overwrites it.
 *
 * <pre>{@code
 * Scene scene = Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 5, 30, 0).build();
 * World world = new World(scene);
 * world.advanceTo(2);
 * for (Impact hit : world.impacts()) {
 *   System.out.println(hit.time() + ": " + hit.kind() + " " + hit.id()); // 1.5: WALL 1
 * }
 * }</pre>
 *
 * <p>An {@link Impact} is a copy that stays. The columns, {@code log.time(row)} and so on, hold the
 * same numbers, and reading them allocates nothing.
 *
 * <p>Rows are numbered from 0, in the order of time. At equal times the order depends on the world.
 * Where circles ignore each other, it is by the id of the circle, and the impacts of one circle
 * stand as they happened. Where circles collide, it is the order in which the impacts were
 * resolved, see {@link Kind}.
 *
 * <p>Under {@linkplain SceneBuilder#gravity gravity}, a circle that bounces lower and lower ends in
 * a row with the outcome {@link Outcome#SETTLED}. To slide or to rest makes no further rows. In a
 * heap that comes down, neighbours free a circle again and again: it settles many times.
 *
 * <p>A row takes some 80 bytes. A log keeps room for the longest step so far, or up to twice that.
 * The <a href="doc-files/rules.html#unfinished">budget of work</a> bounds the rows of a step.
 */
public final class ImpactLog implements Iterable<Impact> {

  private static final Outcome[] OUTCOMES = Outcome.values();

  /** The number of rows that {@link #toString} prints. */
  private static final int ROWS_SHOWN = 10;

  private static final int CIRCLE = Kind.CIRCLE.ordinal();

  private final ImpactRows rows;

  /** Maps the slot of a circle, by which a row names it, to its id. */
  private final IntUnaryOperator ids;

  /** Makes a log for circles whose slots are their ids. */
  ImpactLog(ImpactRows rows) {
    this(rows, IntUnaryOperator.identity());
  }

  ImpactLog(ImpactRows rows, IntUnaryOperator ids) {
    this.rows = rows;
    this.ids = ids;
  }

  /**
   * Returns the number of impacts.
   *
   * @return at least 0
   */
  public int size() {
    return rows.size();
  }

  /**
   * Returns a row as a record, which stays when the next step overwrites the log.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the impact
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public Impact get(int row) {
    return new Impact(
        time(row),
        circle(row),
        kind(row),
        id(row),
        part(row),
        feature(row),
        x(row),
        y(row),
        nx(row),
        ny(row),
        approachSpeed(row),
        impulse(row),
        outcome(row));
  }

  /**
   * Returns the rows that there are now, as records, in their order.
   *
   * @return an iterator, to be used before the next step; it removes nothing
   */
  @Override
  public Iterator<Impact> iterator() {
    return IntStream.range(0, size()).mapToObj(this::get).iterator();
  }

  /**
   * Returns the time of an impact.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the time of impact on the world's clock, the nearest double
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double time(int row) {
    return rows.time(row);
  }

  /**
   * Returns the id of the circle; of two circles that collide, the smaller id, whichever moves.
   *
   * <p>So a program that looks for the impacts of one circle tests both sides of a row: {@code
   * log.circle(row) == PUCK || log.kind(row) == Kind.CIRCLE && log.id(row) == PUCK}.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return its id; the larger id of two circles is that of {@link #id}
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public int circle(int row) {
    return ids.applyAsInt(rows.circle(row));
  }

  /**
   * Returns the kind of thing that the circle hit.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the kind
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public Kind kind(int row) {
    return Kind.of(rows.kind(row));
  }

  /**
   * Returns the id of the thing that the circle hit.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the id of the line, peg or other circle; of a wall 0 left, 1 right, 2 bottom, 3 top
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public int id(int row) {
    int id = rows.id(row);
    return rows.kind(row) == CIRCLE ? ids.applyAsInt(id) : id;
  }

  /**
   * Returns the part of the thing that was hit.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the side of an {@link Outline}, from 0 on, see {@link Impact#part}; 0 of all else
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public int part(int row) {
    return rows.side(row);
  }

  /**
   * Returns the feature of the thing that was hit.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the feature
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public Feature feature(int row) {
    return Feature.of(rows.feature(row));
  }

  /**
   * Returns the x coordinate of the contact point, see {@link Impact#point}.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the coordinate
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double x(int row) {
    return rows.x(row);
  }

  /**
   * Returns the y coordinate of the contact point, see {@link Impact#point}.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the coordinate
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double y(int row) {
    return rows.y(row);
  }

  /**
   * Returns the x component of the unit normal, which points from the obstacle to the circle.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double nx(int row) {
    return rows.nx(row);
  }

  /**
   * Returns the y component of the unit normal, which points from the obstacle to the circle.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the component
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double ny(int row) {
    return rows.ny(row);
  }

  /**
   * Returns the speed along the normal at which the circle approached the obstacle.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return at least 0
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double approachSpeed(int row) {
    return rows.approachSpeed(row);
  }

  /**
   * Returns the impulse that the circle received, along the normal. What it hit received the
   * opposite one.
   *
   * <p>So a circle of mass m has changed its velocity by {@code impulse / m} along the normal. With
   * the outcome {@link Outcome#HALTED} both of two circles stop along the normal: then the other
   * one received another impulse. Circles in contact under {@linkplain SceneBuilder#gravity
   * gravity} carry each other without rows, and the row with which a circle joins them has impulse
   * 0.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return mass times speed. 0 if the impact changed nothing, as with {@link Outcome#SENSED} and
   *     {@link Outcome#PASSED}, or if the circle stopped because something that moves squeezes it.
   *     Infinite if it is beyond the range of doubles, and of a circle of infinite mass that meets
   *     an obstacle
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public double impulse(int row) {
    return rows.impulse(row);
  }

  /**
   * Returns the outcome: what the impact did.
   *
   * @param row a row, 0..{@link #size()} - 1
   * @return the outcome
   * @throws IndexOutOfBoundsException if there is no such row
   */
  public Outcome outcome(int row) {
    return OUTCOMES[rows.outcome(row)];
  }

  /**
   * Describes the first rows for a debugger.
   *
   * @return the number of rows, then up to ten of them, one a line: time, circle, what it hit and
   *     the feature of that, approach speed
   */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("ImpactLog of " + size() + " rows");
    for (int row = 0; row < Math.min(size(), ROWS_SHOWN); row++) {
      text.append(
          "\n%s: time %s, circle %s, %s %s, approach speed %s%s"
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
