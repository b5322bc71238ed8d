// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

/** Arithmetic on coordinates, also where their differences overflow. */
public final class Coordinates {

  private Coordinates() {}

  /** Clamps a coordinate to the range of finite doubles. */
  public static double within(double x) {
    return Math.abs(x) <= Double.MAX_VALUE
        ? x
        : Math.max(-Double.MAX_VALUE, Math.min(x, Double.MAX_VALUE));
  }

  /** a / (a + b) for two radii; 0 if both are. */
  public static double share(double a, double b) {
    double sum = a + b;
    return sum == 0 ? 0 : sum <= Double.MAX_VALUE ? a / sum : a / 2 / (a / 2 + b / 2);
  }

  /** a + s (b - a), also where b - a overflows. */
  public static double between(double s, double a, double b) {
    double w = b - a;
    return Double.isInfinite(w) ? (1 - s) * a + s * b : fma(s, w, a);
  }

  /** The same with s clamped to 0..1: exactly a or b beyond an end, and a if s is NaN. */
  public static double onSegment(double s, double a, double b) {
    return !(s > 0) ? a : s >= 1 ? b : between(s, a, b);
  }

  /**
   * The projection of p on the line from a to b, as a fraction: s = (p - a).w / w.w with w = b - a.
   * It is computed as a cosine times lengths; NaN for zero length.
   */
  public static double fraction(double ax, double ay, double bx, double by, double px, double py) {
    double ofW = scale(ax, ay, bx, by);
    double ofD = scale(ax, ay, px, py);
    double wx = ofW * bx - ofW * ax;
    double wy = ofW * by - ofW * ay;
    double dx = ofD * px - ofD * ax;
    double dy = ofD * py - ofD * ay;
    double w = Math.max(Math.abs(wx), Math.abs(wy));
    double d = Math.max(Math.abs(dx), Math.abs(dy));
    double ux = wx / w;
    double uy = wy / w;
    double along = d == 0 ? 0 : (dx / d) * ux + (dy / d) * uy;
    // The quotient of the lengths comes last: it may be infinite.
    return along == 0 ? 0 * ux : along / (ux * ux + uy * uy) * (d / w) * (ofW / ofD);
  }

  /** 1, or 0.5 if the difference of two points overflows. */
  private static double scale(double ax, double ay, double bx, double by) {
    return Double.isInfinite(bx - ax) || Double.isInfinite(by - ay) ? 0.5 : 1;
  }
}
