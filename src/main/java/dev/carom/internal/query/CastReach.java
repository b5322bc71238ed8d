// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.search.BoxTree;
import dev.carom.internal.state.MovingCircle;

/**
 * Where a circle is now that a cast can touch in some part of its path. All circles of a {@link
 * CircleIndex} have velocities and accelerations of a known range. So a circle that is touched at a
 * time t is now at {@code p + (v - velocity) t - acceleration t^2 / 2}, give or take the radii.
 */
final class CastReach {

  /** In units of the terms of a position: far more than its rounding. */
  private static final double ROUNDING = 0x1p-40;

  /** The first piece of a path is so many distances between neighbours long: measured. */
  private static final double FIRST_PIECE = 2;

  private final BoxTree.Outside outside = new BoxTree.Outside();

  private MovingCircle m;
  private BoxTree tree;

  /** The boxes of all velocities and accelerations. */
  private double[] velocities;

  private double[] accelerations;

  /** The length of the first piece of the path. */
  private double piece;

  /** The largest speed of a circle, that relative to the cast, and the largest acceleration. */
  private double others;

  private double speed;
  private double pull;

  // The box around the places of circles that can be touched.
  private double left;
  private double bottom;
  private double right;
  private double top;

  /** Begins a cast among the circles of an index, of which there is one at least. */
  void start(MovingCircle cast, CircleIndex index) {
    m = cast;
    tree = index.tree();
    velocities = index.velocities();
    accelerations = index.accelerations();
    double width = tree.side(BoxTree.RIGHT) - tree.side(BoxTree.LEFT);
    double height = tree.side(BoxTree.TOP) - tree.side(BoxTree.BOTTOM);
    piece = FIRST_PIECE * (m.radius + Math.sqrt(width / tree.size() * height));
    others = farthest(velocities, 0, 0);
    speed = farthest(velocities, m.vx, m.vy);
    pull = farthest(accelerations, 0, 0);
  }

  /** The largest Manhattan distance of a point from those of a box. */
  private static double farthest(double[] box, double x, double y) {
    return Math.max(box[BoxTree.RIGHT] - x, x - box[BoxTree.LEFT])
        + Math.max(box[BoxTree.TOP] - y, y - box[BoxTree.BOTTOM]);
  }

  /**
   * The end of the piece of the path that begins at a time. A piece is longer than the first one by
   * the way that circles have come closer before it.
   */
  double end(double from) {
    double way = piece + (others + 0.5 * pull * from) * from;
    double fastest = speed + pull * from;
    return from + 2 * way / (fastest + Math.sqrt(fastest * fastest + 2 * pull * way));
  }

  /** A test that rejects boxes without circles that the cast can touch between two times. */
  BoxTree.Outside between(double from, double to) {
    double terms = Math.abs(m.x) + Math.abs(m.y) + tree.extent + (speed + pull * to) * to;
    double reach = m.radius + ROUNDING * (m.radius + terms);
    left = m.x - reach - lead(BoxTree.RIGHT, m.vx, 1, from, to);
    bottom = m.y - reach - lead(BoxTree.TOP, m.vy, 1, from, to);
    right = m.x + reach + lead(BoxTree.LEFT, m.vx, -1, from, to);
    top = m.y + reach + lead(BoxTree.BOTTOM, m.vy, -1, from, to);
    return outside.set(left, bottom, right, top);
  }

  /** How far a circle can get ahead of the cast on one axis, in a direction: +1 or -1. */
  private double lead(int side, double v, int direction, double from, double to) {
    double u = direction * (velocities[side] - v);
    double g = direction * accelerations[side];
    double straight = Math.max(u * from, u * to);
    return g == 0 ? straight : straight + 0.5 * Math.max(g * from * from, g * to * to);
  }

  /**
   * Whether the cast is beyond all circles since the last piece began, and none comes up with it.
   */
  boolean isPast() {
    return (left > tree.side(BoxTree.RIGHT) && isSlow(BoxTree.RIGHT, m.vx))
        || (bottom > tree.side(BoxTree.TOP) && isSlow(BoxTree.TOP, m.vy))
        || (right < tree.side(BoxTree.LEFT) && isFast(BoxTree.LEFT, m.vx))
        || (top < tree.side(BoxTree.BOTTOM) && isFast(BoxTree.BOTTOM, m.vy));
  }

  private boolean isSlow(int side, double v) {
    return velocities[side] <= v && accelerations[side] <= 0;
  }

  private boolean isFast(int side, double v) {
    return velocities[side] >= v && accelerations[side] >= 0;
  }
}
