// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.Predicates;

/** A disk; its spine is its centre. */
public final class PegShape extends ObstacleShape {

  public static final PegShape INSTANCE = new PegShape();

  /** The place of the radius in a row, behind the centre. */
  public static final int RADIUS = 2;

  private PegShape() {
    super("peg", 2, "x", "y", "radius");
  }

  @Override
  public double distanceFromSpine(double[] rows, int k, double x, double y) {
    return StrictMath.hypot(x - rows[k + X], y - rows[k + Y]);
  }

  @Override
  public boolean overlaps(double[] rows, int k, double x, double y, double r) {
    return Predicates.gap(rows[k + X], rows[k + Y], x, y, rows[k + RADIUS], r) < 0;
  }

  @Override
  public boolean overlaps(double[] rows, int k, double[] box) {
    return overlaps(rows[k + X], rows[k + Y], rows[k + RADIUS], box);
  }

  /** A disk and a box overlap if the box's point nearest to the centre is in the disk. */
  public static boolean overlaps(double cx, double cy, double r, double[] box) {
    double x = Math.max(box[WallSweep.LEFT], Math.min(cx, box[WallSweep.RIGHT]));
    double y = Math.max(box[WallSweep.BOTTOM], Math.min(cy, box[WallSweep.TOP]));
    boolean inside = x == cx && y == cy;
    return inside ? r > 0 || isInside(box, x, y) : Predicates.gap(cx, cy, x, y, r, 0) < 0;
  }

  private static boolean isInside(double[] box, double x, double y) {
    return x > box[WallSweep.LEFT]
        && x < box[WallSweep.RIGHT]
        && y > box[WallSweep.BOTTOM]
        && y < box[WallSweep.TOP];
  }
}
