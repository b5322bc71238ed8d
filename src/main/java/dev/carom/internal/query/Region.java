// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.search.BoxTree;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.sweep.PegShape;
import dev.carom.internal.sweep.WallSweep;
import java.util.Arrays;

/**
 * A disk or a box, and what overlaps it. Overlaps are decided exactly, by the signs that the
 * detector uses; to touch is not to overlap.
 */
public abstract class Region {

  /** Rejects boxes apart from the region. */
  final BoxTree.Outside outside = new BoxTree.Outside();

  private Region() {}

  public static Region disk(double x, double y, double r) {
    return new Disk(x, y, r);
  }

  /**
   * A box.
   *
   * @param sides the coordinates of its sides, by the codes of walls
   */
  public static Region box(double[] sides) {
    return new Box(sides);
  }

  /** A point inside of it. */
  abstract double x();

  abstract double y();

  /** Whether it overlaps the outer side of a wall. */
  abstract boolean overlapsWall(int wall, double place);

  abstract boolean overlaps(ObstacleShape shape, double[] rows, int k);

  abstract boolean overlapsDisk(double x, double y, double r);

  /** Whether it overlaps an obstacle at a given time. */
  final boolean overlaps(ObstacleTable obstacles, int code, double now) {
    if (Codes.isWall(code)) {
      return overlapsWall(code, obstacles.walls[code]);
    }
    ObstacleRows rows = obstacles.of(code);
    return obstacles.moves(code)
        ? overlaps(rows.shape, obstacles.rowAt(code, now, 0), 0)
        : overlaps(rows.shape, rows.values, rows.offset(code));
  }

  private static final class Disk extends Region {

    private final double x;
    private final double y;
    private final double r;

    Disk(double x, double y, double r) {
      this.x = x;
      this.y = y;
      this.r = r;
      outside.set(
          Math.nextDown(x - r), Math.nextDown(y - r), Math.nextUp(x + r), Math.nextUp(y + r));
    }

    @Override
    double x() {
      return x;
    }

    @Override
    double y() {
      return y;
    }

    @Override
    boolean overlapsWall(int wall, double place) {
      double p = Codes.isVertical(wall) ? x : y;
      return Codes.isLower(wall)
          ? WallSweep.isNearer(p, place, r)
          : WallSweep.isNearer(place, p, r);
    }

    @Override
    boolean overlaps(ObstacleShape shape, double[] rows, int k) {
      return shape.overlaps(rows, k, x, y, r);
    }

    @Override
    boolean overlapsDisk(double otherX, double otherY, double otherR) {
      return Predicates.gap(otherX, otherY, x, y, otherR, r) < 0;
    }
  }

  private static final class Box extends Region {

    private final double[] sides;

    Box(double[] sides) {
      this.sides = Arrays.stream(sides).map(Box::finite).toArray();
      outside.set(sides[Codes.LEFT], sides[Codes.BOTTOM], sides[Codes.RIGHT], sides[Codes.TOP]);
    }

    private static double finite(double side) {
      return Math.max(-Double.MAX_VALUE, Math.min(side, Double.MAX_VALUE));
    }

    @Override
    double x() {
      return sides[Codes.LEFT] / 2 + sides[Codes.RIGHT] / 2;
    }

    @Override
    double y() {
      return sides[Codes.BOTTOM] / 2 + sides[Codes.TOP] / 2;
    }

    @Override
    boolean overlapsWall(int wall, double place) {
      return Codes.isLower(wall) ? sides[wall] < place : sides[wall] > place;
    }

    @Override
    boolean overlaps(ObstacleShape shape, double[] rows, int k) {
      return shape.overlaps(rows, k, sides);
    }

    @Override
    boolean overlapsDisk(double x, double y, double r) {
      return PegShape.overlaps(x, y, r, sides);
    }
  }
}
