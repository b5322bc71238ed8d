// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.search.BoxTree;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import java.util.Arrays;

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

  /** The circles as they are now, by their slots. */
  private double[] rows;

  /** The number of the last cast that found each circle, by its slot. */
  private int[] foundBy = new int[0];

  private int cast;

  /** The box of all velocities, and that of all accelerations and 0. */
  private final double[] velocities = new double[BoxTree.BOX];

  private final double[] accelerations = new double[BoxTree.BOX];

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
    int end = slots.length == 0 ? 0 : slots[slots.length - 1] + 1;
    rows = new double[end * CastTarget.ROW];
    foundBy = new int[end];
    cast = 0;
    Arrays.fill(velocities, Double.NaN);
    Arrays.fill(accelerations, 0);
    CastTarget circle = new CastTarget();
    for (int k = 0; k < slots.length; k++) {
      int slot = slots[k];
      circle.load(circles, slot, now).save(rows, slot * CastTarget.ROW);
      BoxTree.put(boxes, k, circle.x, circle.y, circle.x, circle.y, circle.r);
      include(velocities, circle.vx, circle.vy);
      include(accelerations, circle.gx, circle.gy);
    }
    tree = new BoxTree(slots, boxes);
  }

  /** Extends a box to a point; one of NaN is empty. */
  private static void include(double[] box, double x, double y) {
    box[BoxTree.LEFT] = x > box[BoxTree.LEFT] ? box[BoxTree.LEFT] : x;
    box[BoxTree.BOTTOM] = y > box[BoxTree.BOTTOM] ? box[BoxTree.BOTTOM] : y;
    box[BoxTree.RIGHT] = x < box[BoxTree.RIGHT] ? box[BoxTree.RIGHT] : x;
    box[BoxTree.TOP] = y < box[BoxTree.TOP] ? box[BoxTree.TOP] : y;
  }

  /** Loads a circle of the index. */
  CastTarget load(int slot, CastTarget circle) {
    return circle.load(rows, slot * CastTarget.ROW);
  }

  /** Begins a cast: each circle is new to it. */
  void beginCast() {
    if (++cast == 0) { // after 2^32 casts
      Arrays.fill(foundBy, 0);
      cast = 1;
    }
  }

  /** Whether this cast finds a circle for the first time. */
  boolean isNew(int slot) {
    boolean isNew = foundBy[slot] != cast;
    foundBy[slot] = cast;
    return isNew;
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
