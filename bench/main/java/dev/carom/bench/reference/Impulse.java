// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

/**
 * The derivative of an impact: it maps derivatives of two states before to those after, in doubles.
 *
 * @param nx the normal, of any length
 * @param ny the normal, of any length
 * @param ux the velocity of the first against the second, before
 * @param uy the velocity of the first against the second, before
 * @param gn the acceleration of the first against the second, times n
 * @param bounce 1 + e
 * @param round whether the normal is the offset of two centres, and so turns with the place
 * @param overlapping whether the time of the impact does not depend on the places
 */
record Impulse(
    double nx,
    double ny,
    double ux,
    double uy,
    double gn,
    double bounce,
    boolean round,
    boolean overlapping) {

  Impulse fallingBy(double along) {
    return new Impulse(nx, ny, ux, uy, along, bounce, round, overlapping);
  }

  /**
   * With dp and du the differences of the derivatives: {@code dt = -(n.dp) / (n.u)}, {@code dn = dp
   * + u dt} if it turns, and {@code d(J n)} by the rules of products. An impact that is dt later
   * has a u that gravity has changed by dt times itself, before and after.
   */
  void push(double[] a, double shareA, double[] b, double shareB) {
    double px = a[0] - b[0];
    double py = a[1] - b[1];
    double dux = a[2] - b[2];
    double duy = a[3] - b[3];
    double un = ux * nx + uy * ny;
    double nn = nx * nx + ny * ny;
    double j = bounce * un / nn;
    double dt = overlapping ? 0 : -(nx * px + ny * py) / un;
    double dnx = round ? px + ux * dt : 0;
    double dny = round ? py + uy * dt : 0;
    double dun = dux * nx + duy * ny + gn * dt + ux * dnx + uy * dny;
    double dnn = 2 * (nx * dnx + ny * dny);
    double dj = bounce * (dun - un * dnn / nn) / nn;
    double dx = dj * nx + j * dnx;
    double dy = dj * ny + j * dny;
    add(a, shareA, j * dt, dx, dy);
    add(b, shareB, j * dt, dx, dy);
  }

  private void add(double[] row, double share, double shift, double dx, double dy) {
    row[0] += share * shift * nx;
    row[1] += share * shift * ny;
    row[2] -= share * dx;
    row[3] -= share * dy;
  }
}
