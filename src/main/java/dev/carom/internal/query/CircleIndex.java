// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.search.BoxTree;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import java.util.function.ToDoubleFunction;

/**
 * An index of the circles of a world where they are now: a {@link BoxTree} of their slots, and how
 * fast they move. It lasts until the next step or edit.
 *
 * <p>An index costs more than a question that tests each circle. So it is made once such questions
 * have tested as many circles as it costs.
 */
final class CircleIndex {

  /** Up to this many circles each one is tested. */
  private static final int FEW = 16;

  /** The index costs as much as so many questions that test each circle: measured. */
  private static final int COST = 4;

  private final CircleTable circles;
  private final CircleRegistry registry;

  private final boolean wanted;

  /** Null while there is no index. */
  private BoxTree tree;

  private long tested;

  /** The circles as they are now, in the order of the tree. */
  private CastTarget[] targets;

  /** The boxes of the velocities in each node of the tree. */
  private double[] velocities;

  /** The boxes of the accelerations in each node of the tree; null if no circle falls. */
  private double[] accelerations;

  CircleIndex(CircleTable circles, CircleRegistry registry, boolean wanted) {
    this.wanted = wanted;
    this.circles = circles;
    this.registry = registry;
  }

  /** Discards the index: circles have moved. */
  void forget() {
    tree = null;
    tested = 0;
  }

  /** Counts questions that are about to be asked, and makes the index once it pays. */
  void expect(int questions, double now) {
    int count = registry.count();
    if (wanted && tree == null && count > FEW) {
      tested += (long) count * questions;
      if (tested > (long) COST * count) {
        make(now);
      }
    }
  }

  private void make(double now) {
    int[] slots = registry.present().stream(slot -> !isThere(slot, now)).toArray();
    double[] boxes = new double[slots.length * BoxTree.BOX];
    CastTarget circle = new CastTarget();
    for (int k = 0; k < slots.length; k++) {
      circle.load(circles, slots[k], now);
      BoxTree.put(boxes, k, circle.x, circle.y, circle.x, circle.y, circle.r);
    }
    tree = new BoxTree(slots, boxes);
    targets = new CastTarget[slots.length];
    boolean falls = false;
    for (int k = 0; k < slots.length; k++) {
      targets[k] = new CastTarget().load(circles, tree.item(k), now);
      falls |= targets[k].isFalling();
    }
    velocities = nodes(boxes, each -> each.vx, each -> each.vy);
    accelerations = falls ? nodes(boxes, each -> each.gx, each -> each.gy) : null;
  }

  /** The boxes of the nodes of the tree around a vector of each circle. */
  private double[] nodes(
      double[] boxes, ToDoubleFunction<CastTarget> x, ToDoubleFunction<CastTarget> y) {
    for (int k = 0; k < targets.length; k++) {
      double vx = x.applyAsDouble(targets[k]);
      double vy = y.applyAsDouble(targets[k]);
      BoxTree.put(boxes, k, vx, vy, vx, vy, 0);
    }
    return tree.nodes(boxes);
  }

  /** The circle at a place of the order of the tree. */
  CastTarget circle(int place) {
    return targets[place];
  }

  /** Whether a circle is there, and not beyond the range of doubles. */
  boolean isThere(int slot, double now) {
    return registry.contains(slot)
        && Math.abs(circles.x(slot, now)) <= Double.MAX_VALUE
        && Math.abs(circles.y(slot, now)) <= Double.MAX_VALUE;
  }

  /** The tree of all circles; null to test each of them. */
  BoxTree tree() {
    return tree;
  }

  double[] velocities() {
    return velocities;
  }

  double[] accelerations() {
    return accelerations;
  }
}
