// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

/**
 * The path of a straight flight u of a time h as something sees it that turns. With d from the
 * pivot to the centre at the start, {@code c = 1 + q h s} and s from 0 to 1, it is
 *
 * <pre>
 * conj(c)^2 (d + u h s) / |c|^2
 * </pre>
 *
 * <p>a rational Bezier curve of degree 3. So it lies in the hull of d and three control points,
 * {@code d + k d + l u} with complex numbers k and l of the turn alone. What keeps these three on
 * one side of a line that turns along keeps the whole path there; of each u that asks a half plane.
 */
final class Arc {

  /** The number of control points after the start. */
  static final int POINTS = 3;

  private double h;
  private double dx;
  private double dy;
  private double qx;
  private double qy;
  private final double[] kx = new double[POINTS];
  private final double[] ky = new double[POINTS];
  private final double[] lx = new double[POINTS];
  private final double[] ly = new double[POINTS];
  private final double[] length = new double[POINTS];

  // A half plane of velocities: those whose part along the unit normal is at least the drift, less
  // the gap over the time.
  double nx;
  double ny;
  double drift;

  /** Sets the turn of a part, the time, and the place of the centre. */
  void set(Parts parts, int part, double x, double y, double time) {
    h = time;
    qx = parts.qx[part];
    qy = parts.qy[part];
    dx = x - parts.pivotX[part];
    dy = y - parts.pivotY[part];
    double a = qx * h;
    double b = qy * h;
    double third = 1 + 2 * a / 3;
    double twoThirds = 1 + (4 * a + (a * a + b * b)) / 3;
    double end = (1 + a) * (1 + a) + b * b;
    double turn = 2 * b / 3;
    point(0, 0, -turn / third, h / (3 * third), 0);
    double k = turn / twoThirds;
    double l = 2 * h / (3 * twoThirds);
    point(1, -k * b, -k * (2 + a), l * (1 + a), -l * b);
    k = 3 * turn / end;
    l = h / end;
    point(2, -k * b, -k * (1 + a), l * ((1 + a) * (1 + a) - b * b), -2 * l * (1 + a) * b);
  }

  private void point(int i, double realK, double imagK, double realL, double imagL) {
    kx[i] = realK;
    ky[i] = imagK;
    lx[i] = realL;
    ly[i] = imagL;
    length[i] = Math.sqrt(realL * realL + imagL * imagL);
  }

  /** The way from the start to control point i, of a flight (ux, uy). */
  double wayX(int i, double ux, double uy) {
    return (kx[i] * dx - ky[i] * dy) + (lx[i] * ux - ly[i] * uy);
  }

  double wayY(int i, double ux, double uy) {
    return (kx[i] * dy + ky[i] * dx) + (lx[i] * uy + ly[i] * ux);
  }

  /**
   * Finds the half plane that keeps control point i within a gap, along the normal n at the start.
   */
  void bound(int i, double normalX, double normalY, double gap) {
    nx = (lx[i] * normalX + ly[i] * normalY) / length[i];
    ny = (lx[i] * normalY - ly[i] * normalX) / length[i];
    double way = normalX * wayX(i, 0, 0) + normalY * wayY(i, 0, 0);
    drift = -way / length[i] - Math.max(0, gap) * (1 / length[i] - 1 / h);
  }

  /** The strictest of the three for a flight. */
  void boundStrictly(double normalX, double normalY, double gap, double ux, double uy) {
    int strictest = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < POINTS; i++) {
      bound(i, normalX, normalY, gap);
      double opening = ux * nx + uy * ny - drift;
      if (opening < least) {
        least = opening;
        strictest = i;
      }
    }
    bound(strictest, normalX, normalY, gap);
  }

  /**
   * Finds the bound of a momentum v: in the middle of the time, to which it belongs, it has the
   * speed of the point under the centre, along the normal of then. An impulse acts along the normal
   * at the start, which is the middle between two momenta: so a slide errs by the second order only
   * (as SHAKE does: Ryckaert, Ciccotti, Berendsen, Numerical integration of the cartesian equations
   * of motion of a system with constraints, Journal of Computational Physics 23, 1977).
   */
  void middle(double normalX, double normalY, double vx, double vy) {
    double a = 1 + qx * h / 2;
    double b = qy * h / 2;
    double square = a * a + b * b;
    double re = (a * a - b * b) / square;
    double im = 2 * a * b / square;
    double thenX = re * normalX - im * normalY;
    double thenY = re * normalY + im * normalX;
    double middleX = dx + vx * h / 2;
    double middleY = dy + vy * h / 2;
    double speed = 2 * qy / square * (thenY * middleX - thenX * middleY);
    nx = normalX;
    ny = normalY;
    drift = speed + (normalX - thenX) * vx + (normalY - thenY) * vy;
  }
}
