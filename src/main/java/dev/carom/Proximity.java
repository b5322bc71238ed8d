// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.stream.IntStream;

/**
 * Which obstacles are near a point, or overlap a disk or a box. Overlaps are decided exactly, by
 * the signs that the detector uses; to touch is not to overlap.
 */
final class Proximity {

  static final int NONE = -1;

  private final Obstacles obstacles;

  Proximity(Obstacles obstacles) {
    this.obstacles = obstacles;
  }

  /** The codes of all walls, lines and pegs that are there. */
  private IntStream codes() {
    return IntStream.concat(
        codes(ObstacleKind.WALL),
        IntStream.concat(codes(ObstacleKind.LINE), codes(ObstacleKind.PEG)));
  }

  /** The codes of one kind of what stands still. */
  IntStream codes(ObstacleKind kind) {
    return switch (kind) {
      case WALL -> IntStream.range(0, obstacles.bounds == null ? 0 : Obstacles.WALLS);
      case LINE -> obstacles.presentLines().stream(obstacles::isGone);
      case PEG -> obstacles.presentPegs().stream(obstacles::isGone);
      case CIRCLE -> IntStream.empty();
    };
  }

  /** The nearest obstacle; of equally near ones that of the smallest code. */
  int nearest(double x, double y) {
    return nearest(codes(), x, y);
  }

  /** The nearest of some obstacles, NONE if there are none. */
  int nearest(IntStream codes, double x, double y) {
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
    Obstacle thing = obstacles.thing(code);
    if (thing instanceof Line line) {
      Vec2 foot = line.closestPoint(new Vec2(x, y));
      return StrictMath.hypot(x - foot.x(), y - foot.y());
    }
    if (thing instanceof Circle peg) {
      return distance(peg, x, y);
    }
    Bounds b = obstacles.bounds;
    return Math.abs(
        switch (code) {
          case Obstacles.LEFT -> x - b.xmin();
          case Obstacles.RIGHT -> x - b.xmax();
          case Obstacles.BOTTOM -> y - b.ymin();
          default -> y - b.ymax();
        });
  }

  /** The distance from the rim of a disk; 0 inside. */
  static double distance(Circle disk, double x, double y) {
    return Math.max(0, StrictMath.hypot(x - disk.x(), y - disk.y()) - disk.radius());
  }

  IntStream overlapping(Circle disk) {
    return codes().filter(code -> overlaps(code, disk));
  }

  IntStream overlapping(Bounds box) {
    return codes().filter(code -> overlaps(code, box));
  }

  boolean overlaps(int code, Circle disk) {
    Obstacle thing = obstacles.thing(code);
    if (thing instanceof Line line) {
      return overlap(line, disk);
    }
    if (thing instanceof Circle peg) {
      return overlap(peg, disk);
    }
    Bounds b = obstacles.bounds;
    return switch (code) {
      case Obstacles.LEFT -> isNearer(disk.x(), b.xmin(), disk.radius());
      case Obstacles.RIGHT -> isNearer(b.xmax(), disk.x(), disk.radius());
      case Obstacles.BOTTOM -> isNearer(disk.y(), b.ymin(), disk.radius());
      default -> isNearer(b.ymax(), disk.y(), disk.radius());
    };
  }

  /** Whether {@code p - q < r}, exactly. */
  private static boolean isNearer(double p, double q, double r) {
    return Dyadic.of(p).minus(Dyadic.of(q)).minus(Dyadic.of(r)).sign() < 0;
  }

  static boolean overlap(Circle a, Circle b) {
    return Predicates.gap(a.x(), a.y(), b.x(), b.y(), a.radius(), b.radius()) < 0;
  }

  private static boolean overlap(Line l, Circle disk) {
    double x = disk.x();
    double y = disk.y();
    double r = disk.radius();
    if (Predicates.dot(x, y, l.ax(), l.ay(), l.bx(), l.by(), l.ax(), l.ay()) <= 0) {
      return Predicates.gap(x, y, l.ax(), l.ay(), r, 0) < 0;
    }
    if (Predicates.dot(x, y, l.bx(), l.by(), l.bx(), l.by(), l.ax(), l.ay()) >= 0) {
      return Predicates.gap(x, y, l.bx(), l.by(), r, 0) < 0;
    }
    return Predicates.reach(l.bx(), l.by(), l.ax(), l.ay(), x, y, l.ax(), l.ay(), r, 0) > 0;
  }

  boolean overlaps(int code, Bounds box) {
    Obstacle thing = obstacles.thing(code);
    if (thing instanceof Line line) {
      return overlap(line, box);
    }
    if (thing instanceof Circle peg) {
      return overlap(peg, box);
    }
    Bounds b = obstacles.bounds;
    return switch (code) {
      case Obstacles.LEFT -> box.xmin() < b.xmin();
      case Obstacles.RIGHT -> box.xmax() > b.xmax();
      case Obstacles.BOTTOM -> box.ymin() < b.ymin();
      default -> box.ymax() > b.ymax();
    };
  }

  /** A disk and a box: the box's point nearest to the centre is in the disk. */
  static boolean overlap(Circle disk, Bounds box) {
    double x = Math.max(box.xmin(), Math.min(disk.x(), box.xmax()));
    double y = Math.max(box.ymin(), Math.min(disk.y(), box.ymax()));
    boolean inside = x == disk.x() && y == disk.y();
    return inside
        ? disk.radius() > 0 || isInside(box, x, y)
        : Predicates.gap(disk.x(), disk.y(), x, y, disk.radius(), 0) < 0;
  }

  private static boolean isInside(Bounds box, double x, double y) {
    return x > box.xmin() && x < box.xmax() && y > box.ymin() && y < box.ymax();
  }

  /**
   * A line and a box overlap unless they can be parted: by a horizontal or a vertical line, or by
   * the line itself, with all corners on one side of it.
   */
  private static boolean overlap(Line l, Bounds box) {
    if (Math.max(l.ax(), l.bx()) <= box.xmin()
        || Math.min(l.ax(), l.bx()) >= box.xmax()
        || Math.max(l.ay(), l.by()) <= box.ymin()
        || Math.min(l.ay(), l.by()) >= box.ymax()) {
      return false;
    }
    int left = 0;
    int right = 0;
    for (int corner = 0; corner < 4; corner++) {
      double x = corner % 2 == 0 ? box.xmin() : box.xmax();
      double y = corner / 2 == 0 ? box.ymin() : box.ymax();
      int side = Predicates.cross(l.bx(), l.by(), l.ax(), l.ay(), x, y, l.ax(), l.ay());
      left += side > 0 ? 1 : 0;
      right += side < 0 ? 1 : 0;
    }
    boolean isPoint = l.ax() == l.bx() && l.ay() == l.by();
    return isPoint || (left > 0 && right > 0);
  }
}
