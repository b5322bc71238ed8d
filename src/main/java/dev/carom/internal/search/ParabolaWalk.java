// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.Codes;

/**
 * The way of a circle with a constant acceleration through the cells of a {@link Grid}, piece after
 * piece: in each the centre stays in one cell, or outside of the grid in line with a row or a
 * column.
 *
 * <p>Each axis crosses the borders between its cells at times of its own: first in the direction of
 * its velocity, then, if the acceleration is against that, back. A time is wrong by rounding only,
 * which the margin of the lists covers.
 */
final class ParabolaWalk {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** So many cells from the start rounding stays far below the margin of the lists. */
  private static final double FARTHEST = 0x1p40;

  /** Faster, squares of velocities could overflow; slower than its inverse, they underflow. */
  private static final double FASTEST = 0x1p300;

  /** In cells: the path is followed with an error far below this. */
  private static final double MARGIN = 0x1p-8;

  private final Axis x = new Axis();
  private final Axis y = new Axis();
  private Grid grid;

  /** The axis on which the next border is crossed. */
  private Axis ahead = x;

  /** The end of the piece. */
  double to;

  /**
   * Takes the walls, by their codes, that count for {@link #isFree}, or null.
   *
   * @param radius of the circle
   */
  void keepOff(Grid grid, double[] walls, double radius) {
    if (walls == null) {
      x.keepBetween(-NEVER, NEVER);
      y.keepBetween(-NEVER, NEVER);
      return;
    }
    double reach = radius * grid.perCell + MARGIN;
    x.keepBetween(
        grid.columns(walls[Codes.LEFT]) + reach, grid.columns(walls[Codes.RIGHT]) - reach);
    y.keepBetween(grid.rows(walls[Codes.BOTTOM]) + reach, grid.rows(walls[Codes.TOP]) - reach);
  }

  /** Begins at a time of a flight; false if the path cannot be followed. */
  boolean start(
      Grid grid, double px, double py, double vx, double vy, double gx, double gy, double from) {
    this.grid = grid;
    double scale = grid.perCell;
    x.start(grid.columns(px), vx * scale, gx * scale, grid.columns);
    y.start(grid.rows(py), vy * scale, gy * scale, grid.rows);
    if (!(x.isInRange() && y.isInRange() && isNear(from))) {
      return false;
    }
    x.locate(from);
    y.locate(from);
    look();
    return true;
  }

  /** Finds the end of the piece. */
  private void look() {
    ahead = x.next <= y.next ? x : y;
    to = ahead.next;
  }

  private boolean isNear(double t) {
    return x.isNear(t) && y.isNear(t);
  }

  /**
   * Goes on to the next piece; false if the path cannot be followed further. That is asked where it
   * comes back to the grid: inside, the terms of a place do not outgrow the grid.
   */
  boolean advance() {
    boolean isFollowed = ahead.isInside() || isNear(to);
    ahead.cross();
    look();
    return isFollowed;
  }

  /** The {@link CellList} of the piece. */
  long list() {
    return grid.lists[grid.number(x.cell, y.cell)];
  }

  /** Whether a circle whose centre is in the cell touches no wall, for certain. */
  boolean isFree() {
    return x.isFree() && y.isFree();
  }

  /** One axis, in cells from the edge of the grid. */
  private static final class Axis {
    private double p;
    private double v;
    private double g;
    private int count;

    /** The time for one cell, without acceleration. */
    private double perSpeed;

    /** A circle whose centre is in the cells from low to below high touches no wall. */
    private int low;

    private int high;

    /** The number of the cell, -1 or the count of cells outside of the grid. */
    private int cell;

    /** The direction in which the next border is crossed. */
    private int step;

    /** The time at which it is. */
    private double next;

    void start(double p, double v, double g, int count) {
      this.p = p;
      this.v = v;
      this.g = g;
      this.count = count;
      perSpeed = g == 0 ? 1 / v : Double.NaN;
    }

    /** Whether rounding does not count at a time. */
    boolean isNear(double t) {
      return Math.abs(p) + (Math.abs(v) + Math.abs(g) * t) * t < FARTHEST;
    }

    boolean isInRange() {
      return isInRange(v) && isInRange(g);
    }

    private static boolean isInRange(double speed) {
      double size = Math.abs(speed);
      return size == 0 || (size < FASTEST && size > 1 / FASTEST);
    }

    void keepBetween(double low, double high) {
      boolean isSome = low < high;
      this.low = isSome ? (int) Math.ceil(low) : 0;
      this.high = isSome ? (int) Math.floor(high) : 0;
    }

    boolean isFree() {
      return cell >= low && cell < high;
    }

    boolean isInside() {
      return cell >= 0 && cell < count;
    }

    void locate(double t) {
      double place = p + (v + 0.5 * g * t) * t;
      cell = place < 0 ? -1 : (int) Math.min(place, count);
      double speed = v + g * t;
      step = (int) Math.signum(speed != 0 ? speed : g);
      aim(t);
    }

    void cross() {
      cell += step;
      aim(next);
    }

    /**
     * Finds the next border, from a time on at which the centre is in the cell. Where the path
     * turns just at a border, rounding may hide that it comes back: it then comes at once.
     */
    private void aim(double t) {
      next = isLeaving() || step == 0 ? NEVER : later(t, passage());
      if (next == NEVER && step * g < 0) {
        step = -step;
        double back = passage();
        next = isLeaving() ? NEVER : Math.max(t, back < NEVER ? back : -v / g);
      }
    }

    /** The later of two times; less work than {@link Math#max}, which minds signs of 0. */
    private static double later(double s, double t) {
      return s > t ? s : t;
    }

    /** Whether it goes away from the grid. */
    private boolean isLeaving() {
      return step < 0 ? cell < 0 : cell >= count;
    }

    /** The time at which the border ahead is crossed in the direction of the step; or NEVER. */
    private double passage() {
      double d = (step > 0 ? cell + 1 : cell) - p;
      if (g == 0) {
        return d * perSpeed;
      }
      double square = v * v + 2 * g * d;
      if (step * g > 0) { // just behind a turn at a border, rounding may make it negative
        square = Math.max(0, square);
      } else if (!(square >= 0)) {
        return NEVER;
      }
      double speed = step * Math.sqrt(square);
      if (step * v > 0) {
        return 2 * d / (v + speed);
      }
      return step * g > 0 ? (speed - v) / g : NEVER;
    }
  }
}
