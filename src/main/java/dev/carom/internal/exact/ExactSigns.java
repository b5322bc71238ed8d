// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * The signs of the polynomials of {@link Predicates} in numbers of one kind: the equations stand
 * here once. Double-double numbers have a bound, and recognise no tie. Sums of doubles are without
 * rounding, as {@link Dyadic} numbers are, which have no limits. The arguments are those of {@link
 * Predicates}.
 */
public abstract class ExactSigns<N extends Ring<N>> {

  public static final ExactSigns<Expansion> SUMS =
      new ExactSigns<>() {
        @Override
        Expansion difference(double a, double b) {
          return Expansion.difference(a, b);
        }

        @Override
        int sign(Expansion value) {
          return value.isExact() ? value.sign() : Predicates.UNDECIDED;
        }
      };

  public static final ExactSigns<Dyadic> NUMBERS =
      new ExactSigns<>() {
        @Override
        Dyadic difference(double a, double b) {
          return Dyadic.difference(a, b);
        }

        @Override
        int sign(Dyadic value) {
          return value.sign();
        }
      };

  abstract N difference(double a, double b);

  /** The sign, or {@link Predicates#UNDECIDED} where a number is beyond the limits of its kind. */
  abstract int sign(N value);

  /** The sign of cross(a - b, c - d). */
  public final int cross(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    return sign(
        cross(difference(ax, bx), difference(ay, by), difference(cx, dx), difference(cy, dy)));
  }

  /** The sign of |a - b|^2 - (r + s)^2. */
  public final int gap(double ax, double ay, double bx, double by, double r, double s) {
    N sum = difference(r, -s);
    return sign(square(difference(ax, bx), difference(ay, by)).minus(sum.times(sum)));
  }

  /** The sign of |a - b|^2 (r + s)^2 - cross(a - b, c - d)^2. */
  public final int discriminant(
      double ax,
      double ay,
      double bx,
      double by,
      double cx,
      double cy,
      double dx,
      double dy,
      double r,
      double s) {
    N px = difference(ax, bx);
    N py = difference(ay, by);
    N sum = difference(r, -s);
    N cross = cross(px, py, difference(cx, dx), difference(cy, dy));
    return sign(square(px, py).times(sum.times(sum)).minus(cross.times(cross)));
  }

  /** The sign of x |x| |w|^2 - y |y|: x = -side cross(p - a, v - u), y = r (v - u).w, w = b - c. */
  public final int corner(
      int side,
      double px,
      double py,
      double ax,
      double ay,
      double vx,
      double vy,
      double ux,
      double uy,
      double bx,
      double by,
      double cx,
      double cy,
      double r) {
    N sx = difference(vx, ux);
    N sy = difference(vy, uy);
    N wx = difference(bx, cx);
    N wy = difference(by, cy);
    N x = cross(difference(px, ax), difference(py, ay), sx, sy).times(difference(-side, 0));
    N y = sx.times(wx).plus(sy.times(wy)).times(difference(r, 0));
    int signX = sign(x);
    int signY = sign(y);
    if (signX != signY || signX == 0) {
      boolean isOpen = signX == Predicates.UNDECIDED || signY == Predicates.UNDECIDED;
      return isOpen ? Predicates.UNDECIDED : signX != 0 ? signX : -signY;
    }
    int order = sign(x.times(x).times(square(wx, wy)).minus(y.times(y)));
    return order == Predicates.UNDECIDED ? order : signX * order;
  }

  private N cross(N ax, N ay, N bx, N by) {
    return ax.times(by).minus(ay.times(bx));
  }

  private N square(N x, N y) {
    return x.times(x).plus(y.times(y));
  }
}
