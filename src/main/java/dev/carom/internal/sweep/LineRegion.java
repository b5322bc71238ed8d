// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

/**
 * Where the centre of a disk with a constant acceleration is beside a line that moves with the
 * velocity u: before its start, beside it, or beyond its end.
 */
final class LineRegion {

  static final int BEFORE = -1;
  static final int BESIDE = 0;
  static final int BEYOND = 1;

  /** Plain doubles leave it open. */
  static final int UNKNOWN = 2;

  /**
   * A projection on the line, or a height, at a rounded time: differences 2, products 3, sums 3, of
   * the terms; half an ulp of time moves it by 1 of twice the terms: 10 u, and the terms are
   * computed.
   */
  private static final double PLACE_BOUND = 16 * 0x1p-53;

  private static final double TINY = 0x1p-600;

  private static final double MOST = 0x1p150;

  private LineRegion() {}

  /** The region at the time that t is the rounding of. */
  static int at(
      double px, double py, double vx, double vy, double gx, double gy, double ax, double ay,
      double bx, double by, double ux, double uy, double t) {
    double wx = bx - ax;
    double wy = by - ay;
    int start = along(px, py, vx, vy, gx, gy, ax, ay, ux, uy, wx, wy, t);
    if (start < 0) {
      return BEFORE;
    }
    int end = along(px, py, vx, vy, gx, gy, bx, by, ux, uy, wx, wy, t);
    return end > 0 ? BEYOND : start > 0 && end < 0 ? BESIDE : UNKNOWN;
  }

  /**
   * The side of the line, +1 left or -1 right, at the time that t is the rounding of; 0 in doubt.
   */
  static int side(
      double px, double py, double vx, double vy, double gx, double gy, double ax, double ay,
      double bx, double by, double ux, double uy, double t) {
    return along(px, py, vx, vy, gx, gy, ax, ay, ux, uy, ay - by, bx - ax, t);
  }

  /** The {@link Contact} with a line, or {@link Contact#DOUBT}. */
  static int contact(int region, int side) {
    if (region == BEFORE || region == BEYOND) {
      return region == BEFORE ? Contact.START : Contact.END;
    }
    if (region == UNKNOWN || side == 0) {
      return Contact.DOUBT;
    }
    return side > 0 ? Contact.LEFT : Contact.RIGHT;
  }

  /** The sign of w.(p(t) - q); 0 in doubt. */
  private static int along(
      double px, double py, double vx, double vy, double gx, double gy, double qx, double qy,
      double ux, double uy, double wx, double wy, double t) {
    double x = Offset.head(px, qx, vx, ux, gx, t);
    double y = Offset.head(py, qy, vy, uy, gy, t);
    double late = t + GapRoot.EARLIEST; // covers half an ulp of a subnormal time
    double sizeX = Offset.size(px - qx, vx - ux, gx, late);
    double sizeY = Offset.size(py - qy, vy - uy, gy, late);
    double value = wx * x + wy * y;
    double terms = Math.abs(wx) * sizeX + Math.abs(wy) * sizeY;
    double bound = fma(PLACE_BOUND, terms, TINY);
    boolean isCertain = Math.abs(value) > bound && t < MOST && Math.abs(wx) + Math.abs(wy) < MOST;
    return isCertain ? UnitVectors.sign(value) : 0;
  }
}
