// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.Polygon;
import dev.carom.internal.sweep.SegmentSweep;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.DoubleList;
import dev.carom.internal.util.Index;

/** The points of an outline: joined lines that are one obstacle, a polyline or a solid polygon. */
public final class OutlinePoints {

  /** x, y, x, y, ... */
  private final double[] xy;

  private final boolean isSolid;

  public OutlinePoints(double[] xy, boolean isSolid) {
    this.xy = xy;
    this.isSolid = isSolid;
  }

  /** The points of sides, given by the rows of lines. */
  public static OutlinePoints of(double[][] sides, boolean isSolid) {
    DoubleList xy = new DoubleList();
    for (double[] side : sides) {
      xy.add(side[LineShape.AX], side[LineShape.AY]);
    }
    if (!isSolid) {
      double[] last = sides[sides.length - 1];
      xy.add(last[LineShape.BX], last[LineShape.BY]);
    }
    return new OutlinePoints(xy.toArray(), isSolid);
  }

  /** Refuses finite points that make no outline. */
  public void check() {
    int least = isSolid ? 3 : 2;
    if (count() < least) {
      throw Check.refused(
          "points",
          count() + " of them",
          "at least " + least + (isSolid ? ", as it is solid" : ""));
    }
    int repeated = repeated();
    if (repeated != Index.NONE) {
      throw Check.refused(
          "points[" + repeated + "]", text(repeated), "another point than the one before");
    }
    int[] crossing = crossing();
    if (crossing != null) {
      throw Check.refused(
          "points",
          "such that side %s and side %s meet".formatted(crossing[0], crossing[1]),
          "a polygon that neither crosses nor touches itself");
    }
  }

  /** Whether finite points, enough of them, make an outline. */
  public boolean isOne() {
    return repeated() == Index.NONE && crossing() == null;
  }

  /** The first point that is equal to the one before; NONE if there is none. */
  private int repeated() {
    for (int i = 0; i < sides(); i++) {
      int next = next(i);
      if (x(i) == x(next) && y(i) == y(next)) {
        return next;
      }
    }
    return Index.NONE;
  }

  /** Two sides of a polygon that meet, see {@link Polygon#crossing}; null if there are none. */
  private int[] crossing() {
    return isSolid ? Polygon.crossing(xy) : null;
  }

  private String text(int i) {
    return "(" + x(i) + ", " + y(i) + ")";
  }

  public double[] xy() {
    return xy;
  }

  public boolean isSolid() {
    return isSolid;
  }

  public int count() {
    return xy.length / 2;
  }

  public double x(int i) {
    return xy[2 * i];
  }

  public double y(int i) {
    return xy[2 * i + 1];
  }

  /** The number of sides, from each point to the next one. */
  public int sides() {
    return isSolid ? count() : count() - 1;
  }

  /** Whether a disk overlaps it: its lines, or, if it is solid, its inside. */
  public boolean overlaps(double px, double py, double r) {
    for (int i = 0; i < sides(); i++) {
      int j = next(i);
      if (SegmentSweep.overlaps(px, py, r, x(i), y(i), x(j), y(j))) {
        return true;
      }
    }
    return isSolid && Polygon.contains(xy, px, py);
  }

  private int next(int i) {
    return i + 1 == count() ? 0 : i + 1;
  }

  /** The numbers of a side, as a line has them. */
  public double[] side(int i) {
    return new double[] {x(i), y(i), x(next(i)), y(next(i))};
  }

  /** Where its sides are outside, see {@link ObstacleTable#outside}. */
  public int outside() {
    return isSolid ? -Polygon.winding(xy) : 0;
  }
}
