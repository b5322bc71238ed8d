// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.search.BoxTree;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.PegShape;
import dev.carom.internal.util.IntList;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.LongStream;

/**
 * The warnings of a scene, see {@code Scene.warnings}. The circles are searched in blocks that
 * double in number. In a scene with many overlaps the first blocks fill the list, and the search
 * ends.
 */
public final class Warnings {

  /** The most warnings that are listed. */
  static final int MOST_WARNINGS = 10_000;

  private static final int FIRST_BLOCK = 64;

  private final SceneData scene;
  private final ObstacleTable obstacles;
  private final Proximity proximity;
  private final List<Overlap> overlaps = new ArrayList<>();

  /**
   * The overlaps of the current block: in the upper half of a long the circle, in the lower half
   * the code of the obstacle or circle that it overlaps.
   */
  private LongStream.Builder found;

  /** A box of the tree, by the codes of walls. */
  private final double[] box = new double[Codes.WALLS];

  private Warnings(SceneData scene) {
    this.scene = scene;
    obstacles = ObstacleTable.of(scene);
    proximity = new Proximity(new ObstacleIndex(obstacles), () -> 0);
  }

  public static List<Overlap> of(SceneData scene) {
    Warnings warnings = new Warnings(scene);
    int count = scene.circleCount();
    int to = 0;
    for (int from = 0; from < count && warnings.overlaps.size() < MOST_WARNINGS; from = to) {
      to = Math.min(count, from + Math.max(FIRST_BLOCK, from));
      warnings.look(from, to);
    }
    return Collections.unmodifiableList(warnings.overlaps);
  }

  private void look(int from, int to) {
    found = LongStream.builder();
    for (int i = from; i < to; i++) {
      lookAtWalls(i);
    }
    BoxTree tree = tree(from, to);
    for (ObstacleRows rows : obstacles.kinds) {
      for (int code = rows.first(); code < rows.end; code++) {
        lookAtObstacle(code, rows, tree);
      }
    }
    if (obstacles.areSpecial()) {
      for (int i = from; i < to; i++) {
        lookAround(i);
      }
    }
    for (int j = from; scene.collide && j < scene.circleCount(); j++) {
      lookAtCircle(j, tree);
    }
    long[] sorted = found.build().sorted().distinct().toArray();
    for (int k = 0; k < sorted.length && overlaps.size() < MOST_WARNINGS; k++) {
      overlaps.add(overlap(scene, (int) (sorted[k] >>> Integer.SIZE), (int) sorted[k]));
    }
  }

  /** A tree of some of the circles. */
  private BoxTree tree(int from, int to) {
    double[] boxes = new double[(to - from) * BoxTree.BOX];
    for (int i = from; i < to; i++) {
      double x = scene.x(i);
      double y = scene.y(i);
      BoxTree.put(boxes, i - from, x, y, x, y, scene.radius(i));
    }
    return new BoxTree(IntStream.range(from, to).toArray(), boxes);
  }

  /** The circles of a tree that may overlap something, told by the boxes that it overlaps. */
  private int[] near(BoxTree tree, Predicate<double[]> overlapsBox) {
    IntList found = new IntList();
    tree.find(
        (boxes, k) -> {
          box[Codes.LEFT] = boxes[k + BoxTree.LEFT];
          box[Codes.BOTTOM] = boxes[k + BoxTree.BOTTOM];
          box[Codes.RIGHT] = boxes[k + BoxTree.RIGHT];
          box[Codes.TOP] = boxes[k + BoxTree.TOP];
          return !overlapsBox.test(box);
        },
        found);
    return found.toArray();
  }

  private Region disk(int i) {
    return Region.disk(scene.x(i), scene.y(i), scene.radius(i));
  }

  private void keep(int i, int code) {
    found.add((long) i << Integer.SIZE | code);
  }

  private void lookAtWalls(int i) {
    if (obstacles.wallsFor(scene.registry.filter(i)) == null) {
      return;
    }
    for (int wall = 0; Codes.isWall(wall); wall++) {
      if (disk(i).overlaps(obstacles, wall, 0)) {
        keep(i, wall);
      }
    }
  }

  private void lookAtObstacle(int code, ObstacleRows rows, BoxTree tree) {
    if (obstacles.isSensor(code)) {
      return;
    }
    int k = rows.offset(code);
    double[] values = rows.values;
    for (int i : near(tree, sides -> rows.shape.overlaps(values, k, sides))) {
      if (FilterBits.meet(obstacles.filter(code), scene.registry.filter(i))
          && disk(i).overlaps(obstacles, code, 0)
          && !(obstacles.isOneWay(code) && isPassed(values, k, i))) {
        keep(i, obstacles.firstOf(code));
      }
    }
  }

  /** Looks for the solid polygons around the centre of a circle. */
  private void lookAround(int i) {
    IntPredicate meets = obstacles.met(scene.registry.filter(i));
    for (int code : proximity.around(scene.x(i), scene.y(i), meets)) {
      if (!obstacles.isSensor(code)) {
        keep(i, code);
      }
    }
  }

  /** Whether a one-way line is not there for a circle: its centre is not strictly left of it. */
  private boolean isPassed(double[] values, int k, int i) {
    double ax = values[k + LineShape.AX];
    double ay = values[k + LineShape.AY];
    double bx = values[k + LineShape.BX];
    double by = values[k + LineShape.BY];
    return LineShape.side(ax, ay, bx, by, scene.x(i), scene.y(i)) <= 0;
  }

  private void lookAtCircle(int j, BoxTree tree) {
    if (scene.registry.isSensor(j)) {
      return;
    }
    double x = scene.x(j);
    double y = scene.y(j);
    double r = scene.radius(j);
    for (int i : near(tree, sides -> PegShape.overlaps(x, y, r, sides))) {
      if (i < j && !passes(i, j) && disk(i).overlapsDisk(x, y, r)) {
        keep(i, Codes.circle(j));
      }
    }
  }

  /** Whether two circles pass through each other. */
  private boolean passes(int i, int j) {
    return scene.registry.isSensor(i)
        || !scene.registry.meet(i, j)
        || Math.min(scene.registry.mass(i), scene.registry.mass(j)) == Double.POSITIVE_INFINITY;
  }

  /**
   * A circle that overlaps the thing with a code, whose distance from it is below the least one.
   */
  public record Overlap(int circle, int code, double distance, double least) {}

  /**
   * The overlap of a circle and a thing. A distance that rounding raised to the least one, or
   * beyond, is given as the double below it.
   */
  static Overlap overlap(SceneData scene, int i, int code) {
    double least = scene.radius(i);
    double distance;
    if (Codes.isWall(code)) {
      distance = distanceFromWall(scene, i, code);
    } else if (Codes.isCircle(code)) {
      int j = Codes.slot(code);
      distance = StrictMath.hypot(scene.x(i) - scene.x(j), scene.y(i) - scene.y(j));
      least += scene.radius(j);
    } else {
      distance = distanceFromSpine(scene, i, code);
      least += scene.obstacles.radius(code);
    }
    return new Overlap(i, code, Math.min(distance, Math.nextDown(least)), least);
  }

  /** The distance from the nearest side of an outline, which is below 0 inside a solid one. */
  private static double distanceFromSpine(SceneData scene, int i, int code) {
    double x = scene.x(i);
    double y = scene.y(i);
    ObstacleRows rows = scene.obstacles.of(code);
    double distance =
        scene
            .obstacles
            .codesOf(code)
            .mapToDouble(each -> rows.shape.distanceFromSpine(rows.values, rows.offset(each), x, y))
            .min()
            .orElseThrow();
    return scene.obstacles.isInside(code, x, y, 0) ? -distance : distance;
  }

  private static double distanceFromWall(SceneData scene, int i, int wall) {
    double p = Codes.isVertical(wall) ? scene.x(i) : scene.y(i);
    boolean isLower = Codes.isLower(wall);
    return isLower ? p - scene.obstacles.walls[wall] : scene.obstacles.walls[wall] - p;
  }
}
