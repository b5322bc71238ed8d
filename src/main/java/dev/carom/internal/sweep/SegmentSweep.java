// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.Predicates;

/**
 * A disk that moves against a line: the mathematics of a swept circle against a segment. A line may
 * move, too, with the velocity u; v below is then the velocity of the disk less u.
 *
 * <p>The disk touches the line a-b when its centre enters the capsule of radius r around it: a
 * strip of width 2 r along {@code w = b - a}, closed by a disk around each end. With {@code d = p -
 * a}, the centre's distance from the infinite line is {@code |cross(w, d)| / |w|}. The capsule is
 * convex, so the first contact is found without comparing times:
 *
 * <ol>
 *   <li>Inside the strip, {@code cross(w, d)^2 <= r^2 w.w}, the centre cannot come to the flat side
 *       from outside any more. Beyond an end only that end's disk can be entered; between the ends
 *       the line is overlapped, which is an impact now if the distance falls.
 *   <li>Outside, it must first cross the strip's edge on its side (+1 left, -1 right of w). If it
 *       does not approach, it misses. If it does, it meets the edge at {@code t = (|cross(w, d)| -
 *       r |w|) / |cross(w, v)|}, and there its projection on w says which part it enters: the side,
 *       or the disk of the end which it is beyond. Scaled by {@code |cross(w, v)| / |w|}, that
 *       projection is {@code -side cross(d, v) |w| - r (v.w)}: on which side of the corner {@code a
 *       + side r n} the path passes. It is compared by its signed squares ({@link
 *       Predicates#corner}).
 * </ol>
 *
 * Decisions are signs of polynomials, taken by {@link Predicates}. None takes a root.
 *
 * <p>The methods for straight flights take all numbers of a question as arguments, ten and more.
 * For a value there is no time: a question about a line takes 23 ns, and 36 ns if its numbers are
 * put into a {@link Fall} first (medians of 2 million random questions, OpenJDK 17).
 */
public final class SegmentSweep {

  private SegmentSweep() {}

  /**
   * The part of the line that is hit first, at any time from 0 on, with NOW added for time 0; or
   * MISS.
   */
  public static int contact(
      double px, double py, double r, double vx, double vy, double ax, double ay, double bx,
      double by, double ux, double uy) {
    // strip = cross(w, d)^2 - r^2 w.w
    if (Predicates.discriminant(bx, by, ax, ay, px, py, ax, ay, r, 0) < 0) {
      int side = Predicates.cross(bx, by, ax, ay, px, py, ax, ay);
      return outside(side, px, py, r, vx, vy, ax, ay, bx, by, ux, uy);
    }
    return inside(px, py, r, vx, vy, ax, ay, bx, by, ux, uy);
  }

  /** Whether the distance of the centre from the line is less than the radius, exactly. */
  public static boolean overlaps(
      double px, double py, double r, double ax, double ay, double bx, double by) {
    if (Predicates.dot(px, py, ax, ay, bx, by, ax, ay) <= 0) {
      return DiskSweep.overlaps(px, py, r, ax, ay, 0);
    }
    if (Predicates.dot(px, py, bx, by, bx, by, ax, ay) >= 0) {
      return DiskSweep.overlaps(px, py, r, bx, by, 0);
    }
    return Predicates.discriminant(bx, by, ax, ay, px, py, ax, ay, r, 0) > 0;
  }

  /**
   * The correctly rounded time of a contact, {@code +infinity} if it is a MISS or later than the
   * window's end T.
   */
  public static double time(
      int contact, double px, double py, double r, double vx, double vy, double ax, double ay,
      double bx, double by, double ux, double uy, double T) {
    if (contact == Contact.MISS) {
      return Double.POSITIVE_INFINITY;
    }
    if ((contact & Contact.NOW) != 0) {
      return 0;
    }
    if (contact == Contact.START) {
      return DiskSweep.time(Contact.LATER, px, py, r, vx, vy, ax, ay, 0, ux, uy, T);
    }
    if (contact == Contact.END) {
      return DiskSweep.time(Contact.LATER, px, py, r, vx, vy, bx, by, 0, ux, uy, T);
    }
    int side = contact == Contact.LEFT ? 1 : -1;
    return SideSweep.time(side, px, py, r, vx, vy, ax, ay, bx, by, ux, uy, T);
  }

  /** The centre starts inside the strip. */
  private static int inside(
      double px, double py, double r, double vx, double vy, double ax, double ay, double bx,
      double by, double ux, double uy) {
    if (Predicates.dot(px, py, ax, ay, bx, by, ax, ay) <= 0) {
      return endpoint(Contact.START, px, py, r, vx, vy, ax, ay, ux, uy);
    }
    if (Predicates.dot(px, py, bx, by, bx, by, ax, ay) >= 0) {
      return endpoint(Contact.END, px, py, r, vx, vy, bx, by, ux, uy);
    }
    int side = Predicates.cross(bx, by, ax, ay, px, py, ax, ay);
    boolean approaches = side * Predicates.cross(bx, by, ax, ay, vx, vy, ux, uy) < 0;
    return approaches ? Contact.NOW | sideOf(side) : Contact.MISS;
  }

  /** The centre starts outside the strip, on the given side. */
  private static int outside(
      int side, double px, double py, double r, double vx, double vy, double ax, double ay,
      double bx, double by, double ux, double uy) {
    if (side * Predicates.cross(bx, by, ax, ay, vx, vy, ux, uy) >= 0) {
      return Contact.MISS;
    }
    if (Predicates.corner(side, px, py, ax, ay, vx, vy, ux, uy, bx, by, ax, ay, r) <= 0) {
      return endpoint(Contact.START, px, py, r, vx, vy, ax, ay, ux, uy);
    }
    if (Predicates.corner(side, px, py, bx, by, vx, vy, ux, uy, bx, by, ax, ay, r) >= 0) {
      return endpoint(Contact.END, px, py, r, vx, vy, bx, by, ux, uy);
    }
    return sideOf(side);
  }

  private static int sideOf(int side) {
    return side > 0 ? Contact.LEFT : Contact.RIGHT;
  }

  private static int endpoint(
      int end, double px, double py, double r, double vx, double vy, double x, double y, double ux,
      double uy) {
    return switch (DiskSweep.contact(px, py, r, vx, vy, x, y, 0, ux, uy)) {
      case Contact.MISS -> Contact.MISS;
      case Contact.NOW -> Contact.NOW | end;
      default -> end;
    };
  }
}
