// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * What a collision does to two velocities: with the offset {@code n = x1 - x2}, of any length, and
 * {@code u = v1 - v2}, the impulse is {@code J = (1 + e) (u.n) / ((w1 + w2) (n.n))}, w = 1/m the
 * inverse masses, and {@code v1 -= w1 J n}, {@code v2 += w2 J n}. A circle of infinite mass goes on
 * as it was; two of them pass through each other, which is reported.
 */
final class PairResponse {

  private final double[] inverseMasses;
  private final int firstCode;
  private final Response response;
  private final Impulse impulse = new Impulse();

  /** The code of circle i, for what was hit last, is the first one plus i. */
  PairResponse(double[] masses, int firstCode, Response response) {
    this.firstCode = firstCode;
    this.response = response;
    inverseMasses = new double[masses.length];
    for (int i = 0; i < masses.length; i++) {
      inverseMasses[i] = 1 / masses[i];
    }
  }

  /** Whether two circles just hit each other and neither changed since, or are jammed together. */
  boolean skips(Circles circles, int i, int j) {
    int lastI = circles.codes[i * Circles.CODES + Circles.LAST];
    int lastJ = circles.codes[j * Circles.CODES + Circles.LAST];
    if (lastI == firstCode + j && lastJ == firstCode + i) {
      return true;
    }
    Jam a = circles.jam(i);
    Jam b = circles.jam(j);
    return a != null && b != null && a.makesInert(firstCode + j) && b.makesInert(firstCode + i);
  }

  /**
   * Changes the velocities of two circles in contact, the lower number first, and writes the log.
   */
  void resolve(Mover a, Mover b, ImpactLog log) {
    double nx = a.x - b.x;
    double ny = a.y - b.y;
    double ux = a.vx - b.vx;
    double uy = a.vy - b.vy;
    double un = Response.dot(ux, uy, nx, ny);
    double share = b.radius / (a.radius + b.radius);
    log.add(a.t, a.id, ObstacleKind.CIRCLE, b.id, Feature.CIRCLE);
    log.set(Math.fma(share, nx, b.x), Math.fma(share, ny, b.y), nx, ny, un);
    double speed = Math.abs(ux) + Math.abs(uy);
    boolean stuckA = response.countStuck(a, firstCode + b.id, a.flown * speed);
    boolean stuckB = response.countStuck(b, firstCode + a.id, b.flown * speed);
    double w1 = inverseMasses[a.id];
    double w2 = inverseMasses[b.id];
    if (un < 0 && w1 + w2 > 0) {
      double e = stuckA || stuckB ? 0 : a.restitution * b.restitution;
      impulse.of(1 + e, ux, uy, nx, ny);
      double share1 = w1 / (w1 + w2);
      double share2 = w2 / (w1 + w2);
      a.vx = impulse.change(a.vx, -share1, nx);
      a.vy = impulse.change(a.vy, -share1, ny);
      b.vx = impulse.change(b.vx, share2, nx);
      b.vy = impulse.change(b.vy, share2, ny);
      Response.stopBeyondRange(a);
      Response.stopBeyondRange(b);
    }
    if (response.isJammed(a) && response.isJammed(b)) {
      a.jam = a.jam.made();
      b.jam = b.jam.made();
      log.setJammed();
    }
    a.last = firstCode + b.id;
    b.last = firstCode + a.id;
    a.newFlight();
    b.newFlight();
  }
}
