// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.LongStream;

/**
 * What a scene warns of: see {@link Scene#warnings}. The circles are taken in blocks, each twice as
 * large as the one before: where most overlap most, the first blocks have as many as are listed.
 */
final class Warnings {

  /** So many are listed. */
  static final int MOST = 10_000;

  private static final int FIRST_BLOCK = 64;

  private static final List<String> WALLS = List.of("left", "right", "bottom", "top");

  private final Scene scene;
  private final Obstacles obstacles;
  private final Proximity proximity;
  private final List<String> texts = new ArrayList<>();

  /** Of the block in hand, each a circle and, below it, the code of what it overlaps. */
  private LongStream.Builder found;

  private Warnings(Scene scene) {
    this.scene = scene;
    obstacles = Obstacles.of(scene);
    proximity = new Proximity(obstacles);
  }

  static List<String> of(Scene scene) {
    Warnings warnings = new Warnings(scene);
    int count = scene.circleCount();
    int to = 0;
    for (int from = 0; from < count && warnings.texts.size() < MOST; from = to) {
      to = Math.min(count, from + Math.max(FIRST_BLOCK, from));
      warnings.look(from, to);
    }
    return Collections.unmodifiableList(warnings.texts);
  }

  private void look(int from, int to) {
    found = LongStream.builder();
    for (int i = from; i < to; i++) {
      lookAtWalls(i);
    }
    CircleTree tree = new CircleTree(scene.circles, from, to);
    for (int code = Obstacles.WALLS; code < obstacles.endOfLines; code++) {
      lookAtLine(code, tree);
    }
    for (int code = Obstacles.PEGS; code < obstacles.endOfPegs; code++) {
      lookAtPeg(code, tree);
    }
    for (int j = from; scene.collide && j < scene.circleCount(); j++) {
      lookAtCircle(j, tree);
    }
    long[] sorted = found.build().sorted().toArray();
    for (int k = 0; k < sorted.length && texts.size() < MOST; k++) {
      texts.add(text(scene, (int) (sorted[k] >>> Integer.SIZE), (int) sorted[k]));
    }
  }

  private void keep(int i, int code) {
    found.add((long) i << Integer.SIZE | code);
  }

  private void lookAtWalls(int i) {
    if (scene.bounds == null || isInside(i)) {
      return;
    }
    Circle circle = scene.circle(i);
    for (int wall = 0; wall < Obstacles.WALLS; wall++) {
      if (proximity.overlaps(wall, circle)) {
        keep(i, wall);
      }
    }
  }

  /** Whether a circle is within the bounds for certain: what rounding left apart is apart. */
  private boolean isInside(int i) {
    double x = scene.circles[i * Scene.CIRCLE];
    double y = scene.circles[i * Scene.CIRCLE + 1];
    double r = scene.circles[i * Scene.CIRCLE + 2];
    Bounds b = scene.bounds;
    return x - r > b.xmin() && x + r < b.xmax() && y - r > b.ymin() && y + r < b.ymax();
  }

  private void lookAtLine(int code, CircleTree tree) {
    if (obstacles.isSensor(code)) {
      return;
    }
    Line line = (Line) obstacles.thing(code);
    boolean oneWay = obstacles.isOneWay(code);
    tree.nearLine(
        line,
        i -> {
          Circle circle = scene.circle(i);
          if (proximity.overlaps(code, circle) && !(oneWay && passes(circle, line))) {
            keep(i, code);
          }
        });
  }

  /** A one-way line is there only for a centre strictly left of it. */
  private static boolean passes(Circle circle, Line l) {
    return Predicates.cross(l.bx(), l.by(), l.ax(), l.ay(), circle.x(), circle.y(), l.ax(), l.ay())
        <= 0;
  }

  private void lookAtPeg(int code, CircleTree tree) {
    if (!obstacles.isSensor(code)) {
      Circle peg = (Circle) obstacles.thing(code);
      tree.nearDisk(
          peg,
          i -> {
            if (Proximity.overlap(peg, scene.circle(i))) {
              keep(i, code);
            }
          });
    }
  }

  private void lookAtCircle(int j, CircleTree tree) {
    if (!isSensor(j)) {
      Circle circle = scene.circle(j);
      tree.nearDisk(
          circle,
          i -> {
            if (i < j && !passes(i, j) && Proximity.overlap(circle, scene.circle(i))) {
              keep(i, Obstacles.CIRCLES + j);
            }
          });
    }
  }

  private boolean isSensor(int i) {
    return Traits.isSensor(Traits.of(scene.circleTraits, i));
  }

  /** Whether two circles go through each other. */
  private boolean passes(int i, int j) {
    return isSensor(i) || Math.min(scene.masses[i], scene.masses[j]) == Double.POSITIVE_INFINITY;
  }

  /** What is told of a circle and what it overlaps. */
  static String text(Scene scene, int i, int code) {
    Circle circle = scene.circle(i);
    double r = circle.radius();
    if (code < Obstacles.WALLS) {
      String wall = "the " + WALLS.get(code) + " wall";
      return text(i, wall, distance(circle, scene.bounds, code), r, "its radius");
    }
    if (code < Obstacles.PEGS) {
      int id = code - Obstacles.WALLS;
      Vec2 foot = scene.line(id).closestPoint(new Vec2(circle.x(), circle.y()));
      double distance = distance(circle, foot.x(), foot.y());
      return text(i, ObstacleKind.LINE.nameOf(id), distance, r, "its radius");
    }
    boolean isPeg = code < Obstacles.CIRCLES;
    ObstacleKind kind = isPeg ? ObstacleKind.PEG : ObstacleKind.CIRCLE;
    int id = isPeg ? code - Obstacles.PEGS : code - Obstacles.CIRCLES;
    Circle other = isPeg ? scene.peg(id) : scene.circle(id);
    double distance = distance(circle, other.x(), other.y());
    return text(i, kind.nameOf(id), distance, r + other.radius(), "the sum of both radii");
  }

  private static double distance(Circle circle, double x, double y) {
    return StrictMath.hypot(circle.x() - x, circle.y() - y);
  }

  private static double distance(Circle circle, Bounds b, int wall) {
    return switch (wall) {
      case Obstacles.LEFT -> circle.x() - b.xmin();
      case Obstacles.RIGHT -> b.xmax() - circle.x();
      case Obstacles.BOTTOM -> circle.y() - b.ymin();
      default -> b.ymax() - circle.y();
    };
  }

  /**
   * A distance that rounding took to what is expected, or beyond, is told as the next one below.
   */
  private static String text(int i, String thing, double distance, double least, String what) {
    return "%s: distance from %s is %s: expected at least %s, %s"
        .formatted(
            ObstacleKind.CIRCLE.nameOf(i),
            thing,
            Math.min(distance, Math.nextDown(least)),
            least,
            what);
  }
}
