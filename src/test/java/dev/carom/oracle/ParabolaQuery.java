// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * A question about a circle with a constant acceleration. Of two circles the first one has it.
 *
 * @param straight the question without it
 * @param gx its x component
 * @param gy its y component
 */
public record ParabolaQuery(Query straight, double gx, double gy) {

  /** The exact answer. */
  public ParabolaContact truth() {
    return ParabolaOracle.answer(this);
  }

  /** The exact first contact from outside with a rounded time above s; -1 for any. */
  public ParabolaContact truthAfter(double s) {
    return ParabolaOracle.after(this, s);
  }

  /** The exact next contact with a thing that is touched at the start. */
  public ParabolaContact truthOfReturn() {
    return ParabolaReturnOracle.answer(this);
  }

  /** The end of the window. */
  public double end() {
    double[] n = straight.numbers();
    return n[n.length - 1];
  }

  /** Every number as a hexadecimal double. */
  public String hex() {
    return straight.hex() + ", gx " + Double.toHexString(gx) + ", gy " + Double.toHexString(gy);
  }

  boolean isFinite() {
    return straight.isFinite() && Double.isFinite(gx) && Double.isFinite(gy);
  }
}
