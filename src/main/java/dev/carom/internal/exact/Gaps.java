// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import java.util.function.UnaryOperator;

/**
 * The equations of a contact: the gap between a disk and an obstacle, as a polynomial in time.
 *
 * <p>A line w from a to b has three Voronoi regions: before its start a, beside it, and beyond its
 * end b. A disk or a point has one. Each region has a gap of its own: the square of the distance
 * less that of the radius, {@code d.d - r^2} at an end; {@code cross(w, d)^2 - r^2 w.w} beside the
 * line, where the factor w.w spares a division. Here d is the offset of the moving centre from that
 * end. The disk touches the obstacle when the gap of the region of its centre is 0.
 *
 * <p>The equations stand here once, for each kind of {@link Numbers}; those of what turns in {@link
 * TurningGaps}.
 */
public class Gaps<P extends Ring<P>> {

  /** The region before the start of a line, and the only one of a disk. */
  public static final int BEFORE = 0;

  public static final int BESIDE = 1;
  public static final int BEYOND = 2;

  /** The region is not known. */
  public static final int UNKNOWN = 3;

  private P x;
  private P y;
  private P endX;
  private P endY;
  private P wx;
  private P wy;
  private P r;

  /**
   * Sets the motion and the obstacle.
   *
   * @param x the offset of the centre from the start of the line, or from the centre of a disk
   * @param endX the same from the end of the line; of a disk, from its centre
   * @param wx the vector of the line, as constants; 0 of a disk
   * @param r the radius, of two disks the sum of theirs, as a constant
   */
  public Gaps<P> set(P x, P y, P endX, P endY, P wx, P wy, P r) {
    this.x = x;
    this.y = y;
    this.endX = endX;
    this.endY = endY;
    this.wx = wx;
    this.wy = wy;
    this.r = r;
    return this;
  }

  /** The offset of the centre from the end of the line in a region. */
  public P x(int region) {
    return region == BEYOND ? endX : x;
  }

  public P y(int region) {
    return region == BEYOND ? endY : y;
  }

  public P r() {
    return r;
  }

  /** The gap in a region. */
  public P gap(int region) {
    return region == BESIDE ? ofSide() : ofEnd(x(region), y(region));
  }

  /** The gap of an end: {@code d.d - r^2}. */
  private P ofEnd(P dx, P dy) {
    return dx.times(dx).plus(dy.times(dy)).minus(r.times(r));
  }

  /** The gap of the side of a line, times w.w: {@code cross(w, d)^2 - r^2 w.w}. */
  private P ofSide() {
    P height = height();
    P length = wx.times(wx).plus(wy.times(wy));
    return height.times(height).minus(r.times(r).times(length));
  }

  /** The height over the line, times its length: {@code cross(w, d)}. */
  public P height() {
    return wx.times(y).minus(wy.times(x));
  }

  /** The projection on the line, from its start: {@code w.d}. At most 0 before the line. */
  public P fromStart() {
    return wx.times(x).plus(wy.times(y));
  }

  /** The projection on the line, from its end: {@code w.(d - w)}. At least 0 beyond the line. */
  public P fromEnd() {
    return wx.times(endX).plus(wy.times(endY));
  }

  /** Whether the obstacle turns. */
  public boolean turns() {
    return false;
  }

  /**
   * A polynomial with the sign of the rate of a gap. {@link TurningGaps} have gaps with positive
   * factors, so it is not the derivative of the polynomial.
   */
  public P rate(P gap, int region, UnaryOperator<P> derivative) {
    return derivative.apply(gap);
  }

  /**
   * A polynomial with the sign of the gap of an end, or of a height, less its value at the start;
   * but for a constant term.
   */
  public P aboveStart(P gap, UnaryOperator<P> atStart) {
    return gap;
  }
}
