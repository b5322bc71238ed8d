// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.sweep.SegmentSweep;
import dev.carom.internal.util.Kind;
import java.util.stream.IntStream;

/**
 * Which obstacles are near a point, or overlap a disk or a box. Overlaps are decided exactly, by
 * the signs that the detector uses; to touch is not to overlap.
 *
 * <p>A box is the coordinates of its sides, by the codes of walls.
 */
public final class Proximity {

  public static final int NONE = -1;

  private final ObstacleTable obstacles;

  public Proximity(ObstacleTable obstacles) {
    this.obstacles = obstacles;
  }

  /** The codes of all walls, lines and pegs that are there. */
  private IntStream codes() {
    return IntStream.concat(codes(Kind.WALL), IntStream.concat(codes(Kind.LINE), codes(Kind.PEG)));
  }

  /** The codes of one {@link Kind} of what stands still. */
  public IntStream codes(int kind) {
    return switch (kind) {
      case Kind.WALL -> IntStream.range(0, obstacles.walls == null ? 0 : Codes.WALLS);
      case Kind.LINE -> obstacles.presentLines().stream(obstacles::isGone);
      case Kind.PEG -> obstacles.presentPegs().stream(obstacles::isGone);
      default -> IntStream.empty();
    };
  }

  /** The nearest obstacle; of equally near ones that of the smallest code. */
  public int nearest(double x, double y) {
    return nearest(codes(), x, y);
  }

  /** The nearest of some obstacles, NONE if there are none. */
  public int nearest(IntStream codes, double x, double y) {
    double least = Double.POSITIVE_INFINITY;
    int nearest = NONE;
    for (int code : codes.toArray()) {
      double distance = distance(code, x, y);
      if (nearest == NONE || distance < least) {
        least = distance;
        nearest = code;
      }
    }
    return nearest;
  }

  private double distance(int code, double x, double y) {
    if (Codes.isWall(code)) {
      return Math.abs((Codes.isVertical(code) ? x : y) - obstacles.walls[code]);
    }
    int k = obstacles.offset(code);
    if (Codes.isLine(code)) {
      return distanceFromLine(obstacles.lines, k, x, y);
    }
    double[] p = obstacles.pegs;
    return distance(
        p[k + ObstacleTable.X], p[k + ObstacleTable.Y], p[k + ObstacleTable.RADIUS], x, y);
  }

  /** The distance of a point from the line whose row begins at a place in an array. */
  static double distanceFromLine(double[] lines, int k, double x, double y) {
    double ax = lines[k + ObstacleTable.AX];
    double ay = lines[k + ObstacleTable.AY];
    double bx = lines[k + ObstacleTable.BX];
    double by = lines[k + ObstacleTable.BY];
    double s = Coordinates.fraction(ax, ay, bx, by, x, y);
    double footX = Coordinates.onSegment(s, ax, bx);
    double footY = Coordinates.onSegment(s, ay, by);
    return StrictMath.hypot(x - footX, y - footY);
  }

  /** The distance of a point from the rim of a disk; 0 inside. */
  public static double distance(double cx, double cy, double r, double x, double y) {
    return Math.max(0, StrictMath.hypot(x - cx, y - cy) - r);
  }

  // What overlaps a disk.

  public IntStream overlapping(double x, double y, double r) {
    return codes().filter(code -> overlaps(code, x, y, r));
  }

  public boolean overlaps(int code, double x, double y, double r) {
    if (Codes.isWall(code)) {
      double p = Codes.isVertical(code) ? x : y;
      double wall = obstacles.walls[code];
      boolean isLower = Codes.isLower(code);
      return isLower ? isNearer(p, wall, r) : isNearer(wall, p, r);
    }
    int k = obstacles.offset(code);
    if (Codes.isLine(code)) {
      return overlapsLine(obstacles.lines, k, x, y, r);
    }
    double[] p = obstacles.pegs;
    return overlaps(
        p[k + ObstacleTable.X], p[k + ObstacleTable.Y], p[k + ObstacleTable.RADIUS], x, y, r);
  }

  /** Whether {@code p - q < r}, exactly. */
  private static boolean isNearer(double p, double q, double r) {
    return Dyadic.of(p).minus(Dyadic.of(q)).minus(Dyadic.of(r)).sign() < 0;
  }

  /** Whether two disks overlap. */
  static boolean overlaps(double x1, double y1, double r1, double x2, double y2, double r2) {
    return Predicates.gap(x1, y1, x2, y2, r1, r2) < 0;
  }

  private static boolean overlapsLine(double[] lines, int k, double x, double y, double r) {
    double ax = lines[k + ObstacleTable.AX];
    double ay = lines[k + ObstacleTable.AY];
    double bx = lines[k + ObstacleTable.BX];
    double by = lines[k + ObstacleTable.BY];
    return SegmentSweep.overlaps(x, y, r, ax, ay, bx, by);
  }

  // What overlaps a box.

  public IntStream overlapping(double[] box) {
    return codes().filter(code -> overlaps(code, box));
  }

  public boolean overlaps(int code, double[] box) {
    if (Codes.isWall(code)) {
      double wall = obstacles.walls[code];
      boolean isLower = Codes.isLower(code);
      return isLower ? box[code] < wall : box[code] > wall;
    }
    int k = obstacles.offset(code);
    if (Codes.isLine(code)) {
      return overlapsLine(obstacles.lines, k, box);
    }
    double[] p = obstacles.pegs;
    return overlaps(
        p[k + ObstacleTable.X], p[k + ObstacleTable.Y], p[k + ObstacleTable.RADIUS], box);
  }

  /** A disk and a box: the box's point nearest to the centre is in the disk. */
  static boolean overlaps(double cx, double cy, double r, double[] box) {
    double x = Math.max(box[Codes.LEFT], Math.min(cx, box[Codes.RIGHT]));
    double y = Math.max(box[Codes.BOTTOM], Math.min(cy, box[Codes.TOP]));
    boolean inside = x == cx && y == cy;
    return inside ? r > 0 || isInside(box, x, y) : Predicates.gap(cx, cy, x, y, r, 0) < 0;
  }

  private static boolean isInside(double[] box, double x, double y) {
    return x > box[Codes.LEFT]
        && x < box[Codes.RIGHT]
        && y > box[Codes.BOTTOM]
        && y < box[Codes.TOP];
  }

  /**
   * A line and a box overlap unless they can be parted: by a horizontal or a vertical line, or by
   * the line itself, with all corners on one side of it.
   */
  private static boolean overlapsLine(double[] lines, int k, double[] box) {
    double ax = lines[k + ObstacleTable.AX];
    double ay = lines[k + ObstacleTable.AY];
    double bx = lines[k + ObstacleTable.BX];
    double by = lines[k + ObstacleTable.BY];
    if (Math.max(ax, bx) <= box[Codes.LEFT]
        || Math.min(ax, bx) >= box[Codes.RIGHT]
        || Math.max(ay, by) <= box[Codes.BOTTOM]
        || Math.min(ay, by) >= box[Codes.TOP]) {
      return false;
    }
    int left = 0;
    int right = 0;
    for (int corner = 0; corner < 4; corner++) {
      double x = box[corner % 2 == 0 ? Codes.LEFT : Codes.RIGHT];
      double y = box[corner / 2 == 0 ? Codes.BOTTOM : Codes.TOP];
      int side = Predicates.cross(bx, by, ax, ay, x, y, ax, ay);
      left += side > 0 ? 1 : 0;
      right += side < 0 ? 1 : 0;
    }
    boolean isPoint = ax == bx && ay == by;
    return isPoint || (left > 0 && right > 0);
  }
}
