// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import java.util.function.UnaryOperator;

/**
 * The equations of a contact with an obstacle that turns about a pivot. A vector v of it, seen from
 * the pivot, is {@code v c^2 / n} at the time t, with the complex number {@code c = 1 + q t} and
 * {@code n = |c|^2}. Written with {@code V = v c^2}, the heights and projections times n are
 * polynomials, and so are the gaps times n, that of the side times n^2:
 *
 * <pre>
 * height       cross(W, d) - cross(w, a) n
 * projections  W.d - (w.a) n             from the start
 *              W.d - (w.b) n             from the end
 * gaps         height^2 - r^2 w.w n^2    of the side
 *              n (d.d + e.e - r^2) - 2 E.d    of an end e
 * </pre>
 *
 * <p>Here d is the centre of the disk, a and b are the ends, all seen from the pivot, and w = b -
 * a.
 */
public final class TurningGaps<P extends Ring<P>> extends Gaps<P> {

  // c^2, and |c|^2.
  private P re;
  private P im;
  private P n;

  // The centre, the ends and the line.
  private P dx;
  private P dy;
  private P ax;
  private P ay;
  private P bx;
  private P by;
  private P wx;
  private P wy;
  private P r;

  // Made when they are first asked for: W, W.d and d.d.
  private P lineX;
  private P lineY;
  private P along;
  private P square;

  /**
   * Sets the rotation.
   *
   * @param c1 the real part of c
   * @param c2 its imaginary part
   */
  public TurningGaps<P> turn(P c1, P c2) {
    P square1 = c1.times(c1);
    P square2 = c2.times(c2);
    P product = c1.times(c2);
    re = square1.minus(square2);
    im = product.plus(product);
    n = square1.plus(square2);
    return this;
  }

  /** Sets the disk and the obstacle, see {@link Gaps#set}; the places are seen from the pivot. */
  public TurningGaps<P> set(
      P itsDx, P itsDy, P itsAx, P itsAy, P itsBx, P itsBy, P itsWx, P itsWy, P itsR) {
    dx = itsDx;
    dy = itsDy;
    ax = itsAx;
    ay = itsAy;
    bx = itsBx;
    by = itsBy;
    wx = itsWx;
    wy = itsWy;
    r = itsR;
    lineX = null;
    along = null;
    square = null;
    return this;
  }

  /** The offset of the centre from the end of the line in a region, times n. */
  @Override
  public P x(int region) {
    return n.times(dx).minus(turnedX(endX(region), endY(region)));
  }

  @Override
  public P y(int region) {
    return n.times(dy).minus(turnedY(endX(region), endY(region)));
  }

  private P endX(int region) {
    return region == BEYOND ? bx : ax;
  }

  private P endY(int region) {
    return region == BEYOND ? by : ay;
  }

  private P turnedX(P x, P y) {
    return x.times(re).minus(y.times(im));
  }

  private P turnedY(P x, P y) {
    return x.times(im).plus(y.times(re));
  }

  @Override
  public P r() {
    return r;
  }

  @Override
  public P gap(int region) {
    return region == BESIDE ? ofSide() : ofEnd(endX(region), endY(region));
  }

  private P ofEnd(P x, P y) {
    if (square == null) {
      square = dx.times(dx).plus(dy.times(dy));
    }
    P product = turnedX(x, y).times(dx).plus(turnedY(x, y).times(dy));
    P rest = x.times(x).plus(y.times(y)).minus(r.times(r));
    return n.times(square.plus(rest)).minus(product.plus(product));
  }

  private P ofSide() {
    P height = height();
    P length = wx.times(wx).plus(wy.times(wy));
    return height.times(height).minus(r.times(r).times(length).times(n.times(n)));
  }

  @Override
  public P height() {
    return lineX()
        .times(dy)
        .minus(lineY.times(dx))
        .minus(wx.times(ay).minus(wy.times(ax)).times(n));
  }

  @Override
  public P fromStart() {
    return along().minus(wx.times(ax).plus(wy.times(ay)).times(n));
  }

  @Override
  public P fromEnd() {
    return along().minus(wx.times(bx).plus(wy.times(by)).times(n));
  }

  /** The line at the time t, times n. */
  public P lineX() {
    if (lineX == null) {
      lineX = turnedX(wx, wy);
      lineY = turnedY(wx, wy);
    }
    return lineX;
  }

  public P lineY() {
    lineX();
    return lineY;
  }

  private P along() {
    if (along == null) {
      along = lineX().times(dx).plus(lineY.times(dy));
    }
    return along;
  }

  @Override
  public boolean turns() {
    return true;
  }

  /** That of {@code g / n^k} times {@code n^(k + 1)}: {@code g' n - k g n'}. */
  @Override
  public P rate(P gap, int region, UnaryOperator<P> derivative) {
    P growth = gap.times(derivative.apply(n));
    P rate = derivative.apply(gap).times(n).minus(growth);
    return region == BESIDE ? rate.minus(growth) : rate;
  }

  /** The gap is over n what is compared with its value at the start. */
  @Override
  public P aboveStart(P gap, UnaryOperator<P> atStart) {
    return gap.minus(atStart.apply(gap).times(n));
  }
}
