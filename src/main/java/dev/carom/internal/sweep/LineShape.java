// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.Predicates;

/** A line from a to b: its spine, with no radius. */
public final class LineShape extends ObstacleShape {

  public static final LineShape INSTANCE = new LineShape();

  // The columns of a row.
  public static final int AX = 0;
  public static final int AY = 1;
  public static final int BX = 2;
  public static final int BY = 3;

  /** From a coordinate of the start to that of the end. */
  public static final int END = BX - AX;

  /** The number of doubles in a row: these and the restitution. */
  public static final int ROW = 5;

  private LineShape() {
    super("line", 4, "ax", "ay", "bx", "by");
  }

  @Override
  public double distanceFromSpine(double[] rows, int k, double x, double y) {
    double ax = rows[k + AX];
    double ay = rows[k + AY];
    double bx = rows[k + BX];
    double by = rows[k + BY];
    double s = Coordinates.fraction(ax, ay, bx, by, x, y);
    double footX = Coordinates.onSegment(s, ax, bx);
    double footY = Coordinates.onSegment(s, ay, by);
    return StrictMath.hypot(x - footX, y - footY);
  }

  @Override
  public boolean overlaps(double[] rows, int k, double x, double y, double r) {
    return SegmentSweep.overlaps(x, y, r, rows[k + AX], rows[k + AY], rows[k + BX], rows[k + BY]);
  }

  /**
   * A line and a box overlap unless they can be separated: by a horizontal or a vertical line, or
   * by the line itself, with all corners of the box on one side. The corners that lie farthest to
   * its left and to its right decide that.
   */
  @Override
  public boolean overlaps(double[] rows, int k, double[] box) {
    double ax = rows[k + AX];
    double ay = rows[k + AY];
    double bx = rows[k + BX];
    double by = rows[k + BY];
    double left = box[WallSweep.LEFT];
    double right = box[WallSweep.RIGHT];
    double bottom = box[WallSweep.BOTTOM];
    double top = box[WallSweep.TOP];
    if (Math.max(ax, bx) <= left
        || Math.min(ax, bx) >= right
        || Math.max(ay, by) <= bottom
        || Math.min(ay, by) >= top) {
      return false;
    }
    boolean up = by > ay;
    boolean on = bx > ax;
    return (ax == bx && ay == by)
        || (side(ax, ay, bx, by, up ? left : right, on ? top : bottom) > 0
            && side(ax, ay, bx, by, up ? right : left, on ? bottom : top) < 0);
  }

  /** The sign of cross(b - a, p - a): positive if p is to the left of the line. */
  public static int side(double ax, double ay, double bx, double by, double x, double y) {
    return Predicates.cross(bx, by, ax, ay, x, y, ax, ay);
  }
}
