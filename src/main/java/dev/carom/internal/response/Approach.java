// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

/**
 * The normal along which a round pair is kept apart in a flight. Any unit normal n with {@code n.q
 * >= rho}, for the vector q between the centres and the distance rho at which they touch, gives a
 * line between them: they do not meet while {@code n.(q + m) >= rho}. The one of now is right for
 * contacts. For a flight m that is long beside the distance it forbids more than needed. So where
 * that would forbid m, the normal is that of the place where m is nearest, or touches first.
 */
final class Approach {

  double nx;
  double ny;
  double gap;

  /** Sets the normal and the gap of now. */
  void set(double normalX, double normalY, double itsGap) {
    nx = normalX;
    ny = normalY;
    gap = itsGap;
  }

  /** Turns the normal for a flight m, and gives the gap along that. */
  void turn(double rho, double mx, double my) {
    double along = mx * nx + my * ny;
    if (gap <= 0 || gap + along >= 0) {
      return;
    }
    double d = gap + rho;
    double square = mx * mx + my * my;
    double towards = -d * along;
    double least = gap * (gap + 2 * rho);
    double touches = towards * towards - square * least;
    double s = touches > 0 ? least / (towards + Math.sqrt(touches)) : towards / square;
    s = Math.min(1, s);
    double x = d * nx + s * mx;
    double y = d * ny + s * my;
    double length = Math.sqrt(x * x + y * y);
    x /= length;
    y /= length;
    gap = d * (nx * x + ny * y) - rho;
    nx = x;
    ny = y;
  }
}
