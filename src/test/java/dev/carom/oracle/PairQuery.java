// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** When do two moving circles hit each other, within the time 0..end? */
public record PairQuery(
    double x1,
    double y1,
    double r1,
    double vx1,
    double vy1,
    double x2,
    double y2,
    double r2,
    double vx2,
    double vy2,
    double end)
    implements Query {

  /** From the numbers in the order of the record. */
  public static PairQuery of(double... n) {
    return new PairQuery(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10]);
  }

  /** Whether the second circle rests: it can then be asked for as a peg. */
  public boolean isPeg() {
    return vx2 == 0 && vy2 == 0;
  }

  @Override
  public Query with(double... numbers) {
    return of(numbers);
  }

  @Override
  public Contact truth() {
    return Oracle.pair(this);
  }

  @Override
  public Answer ask(Detector detector) {
    return detector.pair(this);
  }

  @Override
  public double[] numbers() {
    return new double[] {x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, end};
  }
}
