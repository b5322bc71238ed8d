// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** When does the circle (p, r), moving with v, hit one of four walls, within the time 0..end? */
public record WallQuery(
    double px,
    double py,
    double r,
    double vx,
    double vy,
    double xmin,
    double ymin,
    double xmax,
    double ymax,
    double end)
    implements Query {

  /** From the numbers in the order of the record. */
  public static WallQuery of(double... n) {
    return new WallQuery(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9]);
  }

  @Override
  public Query with(double... numbers) {
    return of(numbers);
  }

  @Override
  public Contact truth() {
    return Oracle.bounds(this);
  }

  @Override
  public Answer ask(Detector detector) {
    return detector.bounds(this);
  }

  @Override
  public double[] numbers() {
    return new double[] {px, py, r, vx, vy, xmin, ymin, xmax, ymax, end};
  }
}
