// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.UnitVector;
import dev.carom.internal.util.Check;

/**
 * The least translation that moves a circle out of an obstacle: along the normal n at the nearest
 * point, by {@code r - distance} (the minimum translation of C. Ericson, Real-Time Collision
 * Detection, 2005, 5.5).
 *
 * <p>The moved centre is rounded to doubles, so a bit more may be needed. With s the sum of the
 * largest coordinate and the radii, the length, r less a distance, errs by some ulps of s (up to
 * 4.3 were measured), and rounding two coordinates takes less than 1. So the tries, by 0, 1, 2, 4
 * and 8 ulps more, end there.
 *
 * @param x by how much along x
 * @param y by how much along y
 */
public record Separation(double x, double y) {

  private static final Separation NONE = new Separation(0, 0);

  private static final UnitVector ALONG_X = new UnitVector(1, 0);

  /** Tells whether a circle whose centre is at (x, y) overlaps the obstacle. */
  private interface Overlap {
    boolean at(double x, double y);
  }

  /** Returns the separation of a circle from a disk. */
  public static Separation ofDisk(
      double x, double y, double r, double cx, double cy, double radius) {
    Overlap overlap = (atX, atY) -> DiskSweep.overlaps(atX, atY, r, cx, cy, radius);
    if (!overlap.at(x, y)) {
      return NONE;
    }
    double dx = x - cx;
    double dy = y - cy;
    UnitVector n = dx == 0 && dy == 0 ? ALONG_X : UnitVectors.unit(x, y, cx, cy);
    double distance = dx * n.x() + dy * n.y();
    double radiusSum = r + radius;
    double size = Math.max(size(x, y), size(cx, cy));
    return out(x, y, overlap, n, radiusSum - distance, size + radiusSum);
  }

  /** Returns the separation of a circle from a line. */
  public static Separation ofLine(
      double x, double y, double r, double ax, double ay, double bx, double by) {
    Overlap overlap = (atX, atY) -> SegmentSweep.overlaps(atX, atY, r, ax, ay, bx, by);
    if (!overlap.at(x, y)) {
      return NONE;
    }
    boolean atEnd = Predicates.dot(x, y, bx, by, bx, by, ax, ay) >= 0;
    boolean beside = !atEnd && Predicates.dot(x, y, ax, ay, bx, by, ax, ay) > 0;
    double nearX = atEnd ? bx : ax;
    double nearY = atEnd ? by : ay;
    boolean ofSide = beside || (x == nearX && y == nearY);
    UnitVector n = ofSide ? sideNormal(x, y, ax, ay, bx, by) : UnitVectors.unit(x, y, nearX, nearY);
    double distance = (x - nearX) * n.x() + (y - nearY) * n.y();
    double size = Math.max(size(x, y), Math.max(size(ax, ay), size(bx, by)));
    return out(x, y, overlap, n, r - distance, size + r);
  }

  /** Returns the separation of a circle from the walls around it. */
  public static Separation ofWalls(
      double x, double y, double r, double xmin, double ymin, double xmax, double ymax) {
    return new Separation(ofWalls(x, r, xmin, xmax), ofWalls(y, r, ymin, ymax));
  }

  /** The part along the axis that two of the walls are across. */
  private static double ofWalls(double p, double r, double low, double high) {
    if (!WallSweep.overlaps(p, r, low, high)) {
      return 0;
    }
    boolean isLow = WallSweep.isNearer(p, low, r);
    double least = r - (isLow ? p - low : high - p);
    Overlap overlap =
        (at, y) -> isLow ? WallSweep.isNearer(at, low, r) : WallSweep.isNearer(high, at, r);
    double size = Math.max(Math.abs(isLow ? low : high), Math.abs(p)) + r;
    UnitVector n = isLow ? ALONG_X : new UnitVector(-1, 0);
    double out = out(p, 0, overlap, n, least, size).x();
    if (WallSweep.overlaps(p + out, r, low, high)) {
      throw Check.refused("radius", r, "one that fits between the walls at " + low + ", " + high);
    }
    return out;
  }

  /** The normal of a line on the side of a point; on the line the left one. */
  private static UnitVector sideNormal(
      double x, double y, double ax, double ay, double bx, double by) {
    if (ax == bx && ay == by) {
      return ALONG_X;
    }
    int side = Predicates.cross(bx, by, ax, ay, x, y, ax, ay);
    return UnitVectors.normal(side < 0 ? -1 : 1, ax, ay, bx, by);
  }

  private static double size(double x, double y) {
    return Math.max(Math.abs(x), Math.abs(y));
  }

  /** A translation along n of at least the given length, by which the circle comes out. */
  private static Separation out(
      double x, double y, Overlap overlap, UnitVector n, double least, double size) {
    if (!(size <= 0x1p1023)) {
      throw Check.refused("coordinate and radius together", size, "at most 2^1023");
    }
    double more = 0;
    double tx = least * n.x();
    double ty = least * n.y();
    while (overlap.at(x + tx, y + ty)) {
      more = more == 0 ? Math.ulp(size) : 2 * more;
      tx = (least + more) * n.x();
      ty = (least + more) * n.y();
    }
    return new Separation(tx, ty);
  }
}
