// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;

import dev.carom.internal.exact.PrecisionCounter;

/**
 * The time at which a moving disk meets a point at rest, such as an endpoint of a line. This is
 * {@link DiskSweep#time} with a second disk of radius 0 and velocity 0. The terms that are 0 are
 * left out.
 */
public final class PointSweep {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private PointSweep() {}

  /**
   * The correctly rounded time of a {@link Contact#LATER} impact.
   *
   * @param root the plain root, the result of {@link SegmentFilter#timeOfEnd}
   */
  public static double time(
      double px, double py, double r, double vx, double vy, double x, double y, double root) {
    double time = firstStep(px, py, r, vx, vy, x, y, root);
    if (time < NEVER) {
      PrecisionCounter.ROOTS.add();
      return time;
    }
    return DiskSweep.time(Contact.LATER, px, py, r, vx, vy, x, y, 0, 0, 0, NEVER);
  }

  /** The same by one step from the plain root; NaN or infinity if one step does not decide. */
  static double firstStep(
      double px, double py, double r, double vx, double vy, double x, double y, double t) {
    double dx = px - x;
    double dy = py - y;
    double rr = r * r;
    double dd = dx * dx + dy * dy;
    double w = dd + rr;
    double a = vx * vx + vy * vy;
    double k = vx * dy - vy * dx;
    // Only the residue depends on t, so the rest is computed while the root is still being taken.
    double half = 0.5 / Math.sqrt(a * rr - k * k);
    return TimeOfImpact.corrected(t, residue(px, py, r, vx, vy, x, y, t), a, w, half);
  }

  /** {@code e.e - r^2} at {@code e = d + v t}. Cancelling terms have head and tail. */
  private static double residue(
      double px, double py, double r, double vx, double vy, double qx, double qy, double t) {
    double dx = px - qx;
    double dy = py - qy;
    double mx = vx * t;
    double my = vy * t;
    double x = dx + mx;
    double y = dy + my;
    double xl = sumTail(dx, mx, x) + (differenceTail(px, qx, dx) + productTail(vx, t, mx));
    double yl = sumTail(dy, my, y) + (differenceTail(py, qy, dy) + productTail(vy, t, my));
    return TimeOfImpact.gap(x, xl, y, yl, r, 0);
  }
}
