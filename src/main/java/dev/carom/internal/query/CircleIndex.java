// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.search.BoxTree;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.util.IntList;
import java.util.Arrays;

/**
 * An index of the circles of a world where they are now: a {@link BoxTree} of their slots, and the
 * largest speeds. It lasts until the next step or edit.
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

  /** The number of the last cast that found each circle, by its slot. */
  private int[] foundBy = new int[0];

  private int cast;

  /** No circle is faster on an axis. */
  private double fastestX;

  private double fastestY;

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
    LiveCodes present = registry.present();
    IntList slots = new IntList();
    fastestX = 0;
    fastestY = 0;
    for (int i = 0; i < present.size(); i++) {
      int slot = present.get(i);
      if (isThere(slot, now)) {
        slots.add(slot);
        fastestX = Math.max(fastestX, Math.abs(circles.vx(slot, now)));
        fastestY = Math.max(fastestY, Math.abs(circles.vy(slot, now)));
      }
    }
    int[] items = slots.toArray();
    double[] boxes = new double[items.length * BoxTree.BOX];
    for (int k = 0; k < items.length; k++) {
      double x = circles.x(items[k], now);
      double y = circles.y(items[k], now);
      BoxTree.put(boxes, k, x, y, x, y, circles.radius(items[k]));
    }
    tree = new BoxTree(items, boxes);
    foundBy = new int[items.length == 0 ? 0 : items[items.length - 1] + 1];
    cast = 0;
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

  double fastestX() {
    return fastestX;
  }

  double fastestY() {
    return fastestY;
  }
}
