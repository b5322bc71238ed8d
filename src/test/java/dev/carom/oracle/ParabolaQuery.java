// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.stream.DoubleStream;

/**
 * A question about a circle with a constant acceleration. Of two circles the first one has it.
 *
 * @param straight the question without it
 * @param gx its x component
 * @param gy its y component
 */
public record ParabolaQuery(Query straight, double gx, double gy) implements Question {

  @Override
  public ParabolaContact truth() {
    return straight instanceof WallQuery q
        ? CurveOracle.bounds(q, gx, gy)
        : CurveOracle.of(this).first();
  }

  /** The exact first contact from outside with a rounded time above s; -1 for any. */
  public ParabolaContact truthAfter(double s) {
    return CurveOracle.of(this).entry(s);
  }

  /** The exact next contact with a thing that is touched at the start. */
  public ParabolaContact truthOfReturn() {
    return gx == 0 && gy == 0 ? ParabolaContact.MISS : CurveOracle.of(this).back();
  }

  /** The end of the window. */
  public double end() {
    double[] n = straight.numbers();
    return n[n.length - 1];
  }

  /** Whether it is about a line. */
  public boolean isOfLine() {
    return straight instanceof SegmentQuery || straight instanceof MovingLineQuery;
  }

  /** The numbers about a line or another disk in the order of the detector of falls, and times. */
  public double[] numbers(double... times) {
    double[] n = straight.numbers();
    boolean moves = straight instanceof MovingLineQuery;
    double ux = moves ? n[9] : 0;
    double uy = moves ? n[10] : 0;
    DoubleStream all =
        isOfLine()
            ? DoubleStream.of(n[4], n[5], n[6], n[7], n[8], gx, gy, n[0], n[1], n[2], n[3], ux, uy)
            : DoubleStream.of(n[0], n[1], n[2], n[3], n[4], gx, gy, n[5], n[6], n[7], n[8], n[9]);
    return DoubleStream.concat(all, DoubleStream.of(times)).toArray();
  }

  @Override
  public String hex() {
    return straight.hex() + ", gx " + Double.toHexString(gx) + ", gy " + Double.toHexString(gy);
  }

  @Override
  public boolean isFair() {
    return straight.isFair() && Double.isFinite(gx) && Double.isFinite(gy);
  }
}
