// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.search.BoxTree;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.PegShape;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.Kind;
import java.util.function.DoubleSupplier;
import java.util.function.IntConsumer;
import java.util.function.IntPredicate;

/**
 * Finds the obstacles that are near a point, or that overlap a disk or a box. Overlaps are decided
 * exactly, by the signs that the detector uses; to touch is not to overlap.
 *
 * <p>A box is an array of the coordinates of its sides, indexed by the codes of walls.
 */
public final class Proximity {

  private final ObstacleIndex index;
  private final ObstacleTable obstacles;
  private final DoubleSupplier clock;

  /**
   * Asks about the obstacles of an index.
   *
   * @param clock tells the time at which moving obstacles are asked for
   */
  public Proximity(ObstacleIndex index, DoubleSupplier clock) {
    this.index = index;
    this.clock = clock;
    obstacles = index.obstacles;
  }

  // The nearest obstacle.

  /** The nearest obstacle, {@link Index#NONE} if there is none; of equally near ones the first. */
  public int nearest(double x, double y) {
    index.expect(1);
    NearestItem nearest = new NearestItem(code -> true, code -> distance(code, x, y));
    for (int kind = Kind.WALL; kind < Kind.CIRCLE; kind++) {
      search(nearest, kind, x, y);
    }
    return nearest.item();
  }

  /**
   * The nearest obstacle of a kind, {@link Index#NONE} if there is none.
   *
   * @param seen the codes that count
   */
  public int nearest(int kind, double x, double y, IntPredicate seen) {
    index.expect(1);
    NearestItem nearest = new NearestItem(seen, code -> distance(code, x, y));
    search(nearest, kind, x, y);
    return nearest.item();
  }

  private void search(NearestItem nearest, int kind, double x, double y) {
    BoxTree tree = kind == Kind.WALL ? null : index.tree(kind);
    if (tree == null) {
      obstacles.codes(kind).forEach(nearest::look);
      return;
    }
    besideTree(kind, nearest::look);
    nearest.search(tree, x, y);
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

  /** All obstacles that overlap a disk, ascending. */
  public int[] overlapping(double x, double y, double r) {
    return overlapping(Kind.WALL, Kind.CIRCLE, x, y, r, code -> true);
  }

  /**
   * The obstacles of a kind that overlap a disk, ascending.
   *
   * @param seen the codes that count
   */
  public int[] overlapping(int kind, double x, double y, double r, IntPredicate seen) {
    return overlapping(kind, kind + 1, x, y, r, seen);
  }

  private int[] overlapping(int from, int to, double x, double y, double r, IntPredicate seen) {
    double now = clock.getAsDouble();
    return find(
        from,
        to,
        outside(x, y, r),
        code -> seen.test(code) && overlaps(obstacles, code, x, y, r, now));
  }

  /** A test that rejects boxes apart from the one around a disk. */
  static BoxTree.Outside outside(double x, double y, double r) {
    return new BoxTree.Outside()
        .set(Math.nextDown(x - r), Math.nextDown(y - r), Math.nextUp(x + r), Math.nextUp(y + r));
  }

  /** Whether an obstacle overlaps a disk at a given time. */
  static boolean overlaps(
      ObstacleTable obstacles, int code, double x, double y, double r, double now) {
    if (Codes.isWall(code)) {
      double p = Codes.isVertical(code) ? x : y;
      double wall = obstacles.walls[code];
      boolean isLower = Codes.isLower(code);
      return isLower ? isNearer(p, wall, r) : isNearer(wall, p, r);
    }
    ObstacleRows rows = obstacles.of(code);
    return obstacles.moves(code)
        ? rows.shape.overlaps(obstacles.rowAt(code, now, 0), 0, x, y, r)
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

  /** All obstacles that overlap a box, ascending. */
  public int[] overlapping(double[] box) {
    return find(Kind.WALL, Kind.CIRCLE, outside(box), code -> overlaps(code, box));
  }

  /**
   * The obstacles of a kind that overlap a box, ascending.
   *
   * @param seen the codes that count
   */
  public int[] overlapping(int kind, double[] box, IntPredicate seen) {
    return find(kind, kind + 1, outside(box), code -> seen.test(code) && overlaps(code, box));
  }

  /** A test that rejects boxes apart from a given one. */
  static BoxTree.Outside outside(double[] box) {
    return new BoxTree.Outside()
        .set(box[Codes.LEFT], box[Codes.BOTTOM], box[Codes.RIGHT], box[Codes.TOP]);
  }

  private boolean overlaps(int code, double[] box) {
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

  /** The obstacles of some kinds that pass a test, which none outside of a box does. */
  private int[] find(int fromKind, int toKind, BoxTree.Outside box, IntPredicate test) {
    index.expect(1);
    IntList found = new IntList();
    for (int kind = fromKind; kind < toKind; kind++) {
      BoxTree tree = kind == Kind.WALL ? null : index.tree(kind);
      if (tree == null) {
        obstacles.codes(kind).forEach(found::add);
      } else {
        tree.find(box, found);
        besideTree(kind, found::add);
      }
    }
    return found.filtered(code -> isLive(code) && test.test(code));
  }

  /** Names the obstacles of a kind that are in no tree: those that changed, and those that move. */
  private void besideTree(int kind, IntConsumer action) {
    CodeSet loose = index.loose();
    for (int i = 0; i < loose.size; i++) {
      if (Codes.kind(loose.codes[i]) == kind) {
        action.accept(loose.codes[i]);
      }
    }
    ObstacleMotions motions = obstacles.motions();
    for (int i = 0; i < motions.count(); i++) {
      if (Codes.kind(motions.code(i)) == kind) {
        action.accept(motions.code(i));
      }
    }
  }

  private boolean isLive(int code) {
    return Codes.isWall(code) || !obstacles.isGone(code);
  }
}
