// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/**
 * Conservative advancement: go on by the time in which the gap cannot close, until it is below a
 * tolerance. With n the unit vector from the line's closest point to the centre, the gap g closes
 * no faster than at -v.n, since line and circle lie on two sides of a straight line across n that
 * moves along; so the next g / -v.n are free. Source: B. Mirtich, Impulse-based dynamic simulation
 * of rigid body systems, PhD thesis, Berkeley 1996, 2.3.
 *
 * <p>Contact is reported early, by up to the tolerance, and where the gap only comes below it.
 */
public final class AdvancementDetector extends LineDetector {

  private final double tolerance;

  /**
   * Sets the tolerance.
   *
   * @param tolerance the gap that counts as contact, greater than 0
   */
  public AdvancementDetector(double tolerance) {
    this.tolerance = tolerance;
  }

  @Override
  public double time(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double ax,
      double ay,
      double bx,
      double by,
      double end) {
    double wx = bx - ax;
    double wy = by - ay;
    double ww = wx * wx + wy * wy;
    double t = 0;
    while (t <= end) {
      pairTests++;
      double ex = px + t * vx - ax;
      double ey = py + t * vy - ay;
      double along = wx * ex + wy * ey;
      double s = along <= 0 ? 0 : along >= ww ? 1 : along / ww;
      double dx = ex - s * wx;
      double dy = ey - s * wy;
      double closing = -(vx * dx + vy * dy);
      if (!(closing > 0)) {
        return NEVER;
      }
      double distance = Math.sqrt(dx * dx + dy * dy);
      squareRoots++;
      double gap = distance - r;
      double next = t + gap * distance / closing;
      if (gap <= tolerance || next == t) {
        return t;
      }
      t = next;
    }
    return NEVER;
  }
}
