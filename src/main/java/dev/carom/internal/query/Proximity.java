// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.search.BoxTree;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.KindNumber;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.function.DoubleSupplier;
import java.util.function.IntConsumer;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/** Finds the obstacles that are near a point, or that overlap a {@link Region}. */
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

  /**
   * The nearest obstacle of a kind, {@link Index#NONE} if there is none; of equally near ones the
   * first. Of an outline it is a side.
   *
   * @param seen the codes that count
   */
  public int nearest(int kind, double x, double y, IntPredicate seen) {
    index.expect(1);
    int[] around = kind == KindNumber.LINE ? around(x, y, seen) : new int[0];
    if (around.length > 0) {
      return around[0];
    }
    NearestItem nearest = new NearestItem(seen, code -> distance(code, x, y));
    search(nearest, kind, x, y);
    return nearest.item();
  }

  /** The first sides of the solid polygons that contain a point, ascending. */
  int[] around(double x, double y, IntPredicate seen) {
    if (!obstacles.areSpecial()) {
      return new int[0];
    }
    double now = clock.getAsDouble();
    NavigableMap<Integer, Boolean> inside = new TreeMap<>();
    for (int code : near(KindNumber.LINE, new BoxTree.Outside().set(-Double.MAX_VALUE, y, x, y))) {
      if (obstacles.outside(code) != 0 && seen.test(code)) {
        inside.merge(
            obstacles.firstOf(code), obstacles.isCrossed(code, x, y, now), Boolean::logicalXor);
      }
    }
    return inside.keySet().stream().filter(inside::get).mapToInt(code -> code).toArray();
  }

  private void search(NearestItem nearest, int kind, double x, double y) {
    BoxTree tree = kind == KindNumber.WALL ? null : index.tree(kind);
    if (tree == null) {
      obstacles.codes(kind).forEach(nearest::look);
      return;
    }
    besideTree(kind, nearest::look);
    nearest.search(tree, x, y);
  }

  /** The distance of a point from an obstacle. */
  public double distance(int code, double x, double y) {
    if (Codes.isWall(code)) {
      return Math.abs((Codes.isVertical(code) ? x : y) - obstacles.walls[code]);
    }
    ObstacleRows rows = obstacles.of(code);
    return obstacles.moves(code)
        ? rows.shape.distance(obstacles.rowAt(code, clock.getAsDouble(), 0), 0, x, y)
        : rows.shape.distance(rows.values, rows.offset(code), x, y);
  }

  /** The distance of a point from the rim of a disk; 0 inside. */
  public static double distance(double cx, double cy, double r, double x, double y) {
    return Math.max(0, StrictMath.hypot(x - cx, y - cy) - r);
  }

  /**
   * The obstacles of a kind that overlap a region, ascending; of an outline the sides that do, or,
   * of a solid one around it, the first.
   *
   * @param seen the codes that count
   */
  public int[] overlapping(int kind, Region region, IntPredicate seen) {
    index.expect(1);
    double now = clock.getAsDouble();
    IntStream found =
        IntStream.of(near(kind, region.outside))
            .filter(code -> seen.test(code) && region.overlaps(obstacles, code, now));
    int[] around = kind == KindNumber.LINE ? around(region.x(), region.y(), seen) : new int[0];
    return IntStream.concat(found, IntStream.of(around)).sorted().distinct().toArray();
  }

  /** The obstacles of a kind that may overlap a box, and others; ascending unless there is none. */
  private int[] near(int kind, BoxTree.Outside outside) {
    IntList found = new IntList();
    BoxTree tree = kind == KindNumber.WALL ? null : index.tree(kind);
    if (tree == null) {
      obstacles.codes(kind).forEach(found::add);
    } else {
      tree.find(outside, found);
      besideTree(kind, found::add);
    }
    return found.filtered(obstacles::isThere);
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
}
