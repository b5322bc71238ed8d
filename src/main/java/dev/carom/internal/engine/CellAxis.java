// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

/**
 * The cells along an axis. A place is counted from the origin, where a cell begins.
 *
 * <p>Near the origin all cells have one width w: N of them on either side. Beyond these each N
 * cells are twice as wide as the N before. So a circle that flies away for ever enters N cells
 * while its distance doubles, and what is spread over a larger area, as a gas that expands, still
 * has as many cells.
 *
 * <p>These are the spacings of floating-point numbers. Let F(0) = N, F(1), F(2), ... be the numbers
 * with log2(N) bits after the first one. Cell c begins at {@code (F(c) - N) w} if c is at least 0,
 * and its mirror image, cell -1 - c, ends at the mirror image of that place.
 */
final class CellAxis {

  /** The bits of a double after its first one. */
  private static final int FRACTION = 52;

  private final double width;

  /** N. */
  private final double near;

  /** The bits of a double that F leaves out. */
  private final int shift;

  /** The bits of F(0). Those of F(c) are greater by c. */
  private final long origin;

  /**
   * @param width of a cell near the origin
   * @param near N: a power of two, at least 2
   */
  CellAxis(double width, int near) {
    this.width = width;
    this.near = near;
    shift = FRACTION - Math.getExponent(near);
    origin = Double.doubleToRawLongBits(near) >> shift;
  }

  /** The cell of a place. */
  double cell(double place) {
    double f = Math.abs(place) / width + near;
    double finite = f < Double.MAX_VALUE ? f : Double.MAX_VALUE;
    long c = (Double.doubleToRawLongBits(finite) >> shift) - origin;
    return place < 0 ? -1 - c : c;
  }

  /** The place where a cell begins, which is where the one before it ends. */
  double edge(double cell) {
    return isFar(cell) ? farEdge(cell) : cell * width;
  }

  /** Whether a cell is one of the wider ones. */
  boolean isFar(double cell) {
    return Math.abs(cell) > near;
  }

  /** Whether a place is in a cell or on its edge. */
  boolean holds(double cell, double place) {
    return Math.abs(cell + 0.5) < near
        ? place >= cell * width && place <= (cell + 1) * width
        : place >= edge(cell) && place <= edge(cell + 1);
  }

  private double farEdge(double cell) {
    double f = Double.longBitsToDouble(((long) Math.abs(cell) + origin) << shift);
    return Math.copySign((f - near) * width, cell);
  }
}
