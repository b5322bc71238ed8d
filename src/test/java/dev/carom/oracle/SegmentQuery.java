// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** When does the circle (p, r), moving with v, hit the line a-b, within the time 0..end? */
public record SegmentQuery(
    double ax,
    double ay,
    double bx,
    double by,
    double px,
    double py,
    double r,
    double vx,
    double vy,
    double end)
    implements Query {

  /** From the numbers in the order of the record. */
  public static SegmentQuery of(double... n) {
    return new SegmentQuery(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9]);
  }

  @Override
  public Query with(double... numbers) {
    return of(numbers);
  }

  @Override
  public Contact truth() {
    return Oracle.line(this);
  }

  @Override
  public Answer ask(Detector detector) {
    return detector.line(this);
  }

  @Override
  public double[] numbers() {
    return new double[] {ax, ay, bx, by, px, py, r, vx, vy, end};
  }
}
