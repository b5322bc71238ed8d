// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.PegShape;
import dev.carom.internal.util.Kind;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;

/**
 * Finds the obstacles that are near a point, or that overlap a disk or a box. Overlaps are decided
 * exactly, by the signs that the detector uses; to touch is not to overlap.
 *
 * <p>A box is an array of the coordinates of its sides, indexed by the codes of walls.
 */
public final class Proximity {

  public static final int NONE = -1;

  private final ObstacleTable obstacles;
  private final DoubleSupplier clock;

  /** Asks about some obstacles as they are at time 0. */
  public Proximity(ObstacleTable obstacles) {
    this(obstacles, () -> 0);
  }

  /**
   * Asks about some obstacles.
   *
   * @param clock tells the time at which moving obstacles are asked for
   */
  public Proximity(ObstacleTable obstacles, DoubleSupplier clock) {
    this.obstacles = obstacles;
    this.clock = clock;
  }

  /** The codes of the obstacles of one {@link Kind}. */
  public IntStream codes(int kind) {
    return obstacles.codes(kind);
  }

  /** The nearest obstacle; among equally near ones that of the smallest code. */
  public int nearest(double x, double y) {
    return nearest(obstacles.codes(), x, y);
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
    ObstacleRows rows = obstacles.of(code);
    return obstacles.moves(code)
        ? rows.shape.distance(placed(code), 0, x, y)
        : rows.shape.distance(rows.values, rows.offset(code), x, y);
  }

  /** The row of a moving obstacle now. */
  private double[] placed(int code) {
    return obstacles.rowAt(code, clock.getAsDouble(), 0);
  }

  /** The distance of a point from the rim of a disk; 0 inside. */
  public static double distance(double cx, double cy, double r, double x, double y) {
    return Math.max(0, StrictMath.hypot(x - cx, y - cy) - r);
  }

  // Overlap with a disk.

  public IntStream overlapping(double x, double y, double r) {
    return obstacles.codes().filter(code -> overlaps(code, x, y, r));
  }

  public boolean overlaps(int code, double x, double y, double r) {
    if (Codes.isWall(code)) {
      double p = Codes.isVertical(code) ? x : y;
      double wall = obstacles.walls[code];
      boolean isLower = Codes.isLower(code);
      return isLower ? isNearer(p, wall, r) : isNearer(wall, p, r);
    }
    ObstacleRows rows = obstacles.of(code);
    return obstacles.moves(code)
        ? rows.shape.overlaps(placed(code), 0, x, y, r)
        : rows.shape.overlaps(rows.values, rows.offset(code), x, y, r);
  }

  /** Whether {@code p - q < r}, exactly. */
  private static boolean isNearer(double p, double q, double r) {
    return Dyadic.of(p).minus(Dyadic.of(q)).minus(Dyadic.of(r)).sign() < 0;
  }

  /** Whether two disks overlap. */
  static boolean overlaps(double x1, double y1, double r1, double x2, double y2, double r2) {
    return Predicates.gap(x1, y1, x2, y2, r1, r2) < 0;
  }

  // Overlap with a box.

  public IntStream overlapping(double[] box) {
    return obstacles.codes().filter(code -> overlaps(code, box));
  }

  public boolean overlaps(int code, double[] box) {
    if (Codes.isWall(code)) {
      double wall = obstacles.walls[code];
      boolean isLower = Codes.isLower(code);
      return isLower ? box[code] < wall : box[code] > wall;
    }
    ObstacleRows rows = obstacles.of(code);
    return obstacles.moves(code)
        ? rows.shape.overlaps(placed(code), 0, box)
        : rows.shape.overlaps(rows.values, rows.offset(code), box);
  }

  /** Whether a disk and a box overlap. */
  static boolean overlaps(double cx, double cy, double r, double[] box) {
    return PegShape.overlaps(cx, cy, r, box);
  }
}
