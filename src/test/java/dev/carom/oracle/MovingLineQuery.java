// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * When does the circle (p, r), moving with v, hit the line a-b, moving with u, within the time
 * 0..end?
 */
public record MovingLineQuery(
    double ax,
    double ay,
    double bx,
    double by,
    double px,
    double py,
    double r,
    double vx,
    double vy,
    double ux,
    double uy,
    double end)
    implements Query {

  /** A family of such queries, each made of one about a line at rest: all goes with u besides. */
  static Family<Query> of(Family<Query> still) {
    return Family.mirrored("moving_" + still.name(), draw -> of(draw, still.next(draw)));
  }

  /** The same contact, but for rounding, on a line that moves with a velocity u. */
  static Query of(Draw draw, Query still) {
    double[] n = still.numbers();
    // Half of the differences v - u are exact, and the rest are as near to it as rounding leaves
    // it.
    double ux = velocity(draw, n[7]);
    double uy = velocity(draw, n[8]);
    return new MovingLineQuery(
        n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7] + ux, n[8] + uy, ux, uy, n[9]);
  }

  private static double velocity(Draw draw, double v) {
    return switch (draw.whole(0, 3)) {
      case 0 -> draw.whole(-4, 4) * v;
      case 1 -> draw.whole(-8, 8);
      case 2 -> draw.in(-1, 1) * Math.abs(v);
      default -> draw.sign() * draw.log(1e-9, 1e9);
    };
  }

  @Override
  public Query with(double... n) {
    return new MovingLineQuery(
        n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10], n[11]);
  }

  @Override
  public Contact truth() {
    return Oracle.movingLine(this);
  }

  @Override
  public Answer ask(Detector detector) {
    return detector.movingLine(this);
  }

  @Override
  public double[] numbers() {
    return new double[] {ax, ay, bx, by, px, py, r, vx, vy, ux, uy, end};
  }
}
