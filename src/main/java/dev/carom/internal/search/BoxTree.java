// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.util.IntList;
import java.util.Arrays;

/**
 * A tree of bounding boxes over items, which are named by ints. Each node is the box of a run of
 * items. A run is divided across its longer side, so that nodes are nearly square. So neither a
 * distant item nor a large one spoils it. Immutable, safe for use by several threads.
 */
public final class BoxTree {

  // The places of the sides of a box.
  public static final int LEFT = 0;
  public static final int BOTTOM = 1;
  public static final int RIGHT = 2;
  public static final int TOP = 3;
  public static final int BOX = 4;

  /** A run of at most this many items is not divided further. */
  private static final int LEAF_SIZE = 8;

  /** A run is sorted once for so many halvings: with one, the nodes are squarer, but dearer. */
  private static final int HALVINGS = 4;

  /** Steps of a coordinate in the key by which items are sorted. */
  private static final double STEPS = 0x1p30;

  /** The items, sorted, and their boxes in the same order. */
  private final int[] items;

  private final double[] boxes;

  /** The box of node k, whose halves are nodes 2k + 1 and 2k + 2. */
  private final double[] nodes;

  private final int nodeCount;

  /** The largest absolute coordinate of a box. */
  public final double extent;

  /**
   * Makes the tree of some items.
   *
   * @param boxes {@link #BOX} numbers for each item; rounding is the caller's
   */
  public BoxTree(int[] items, double[] boxes) {
    long[] keys = new long[items.length]; // each has an item in its lower half
    Arrays.setAll(keys, k -> k);
    divide(boxes, keys, 0, items.length);
    this.items = new int[items.length];
    this.boxes = new double[items.length * BOX];
    for (int k = 0; k < items.length; k++) {
      this.items[k] = items[(int) keys[k]];
      System.arraycopy(boxes, (int) keys[k] * BOX, this.boxes, k * BOX, BOX);
    }
    int count = 1;
    for (int runs = (items.length + LEAF_SIZE - 1) / LEAF_SIZE; runs > 1; runs = (runs + 1) / 2) {
      count = 2 * count + 1;
    }
    nodeCount = count;
    nodes = nodes(this.boxes);
    double largest = 0;
    for (int k = 0; k < BOX; k++) {
      largest = Math.max(largest, Math.abs(nodes[k]));
    }
    extent = largest;
  }

  /**
   * Puts the box around a segment, grown by a radius, in the place of item k. The box covers all of
   * that, in spite of rounding.
   */
  public static void put(
      double[] boxes, int k, double ax, double ay, double bx, double by, double radius) {
    int at = k * BOX;
    boxes[at + LEFT] = Math.nextDown(Math.min(ax, bx) - radius);
    boxes[at + BOTTOM] = Math.nextDown(Math.min(ay, by) - radius);
    boxes[at + RIGHT] = Math.nextUp(Math.max(ax, bx) + radius);
    boxes[at + TOP] = Math.nextUp(Math.max(ay, by) + radius);
  }

  /**
   * Puts the box around an obstacle, which is the row at a place of an array, in place of item k.
   */
  static void put(double[] boxes, int k, ObstacleShape shape, double[] rows, int at, double grown) {
    int end = at + shape.toEnd;
    double ax = rows[at + ObstacleShape.X];
    double ay = rows[at + ObstacleShape.Y];
    double bx = rows[end + ObstacleShape.X];
    double by = rows[end + ObstacleShape.Y];
    put(boxes, k, ax, ay, bx, by, shape.radius(rows, at) + grown);
  }

  /** Sorts a run of items across its longer side, divides it there, and goes on with each part. */
  private static void divide(double[] boxes, long[] keys, int from, int to) {
    if (to - from > LEAF_SIZE) {
      boolean isHigh = length(boxes, keys, from, to, BOTTOM) > length(boxes, keys, from, to, LEFT);
      sort(boxes, keys, from, to, isHigh ? BOTTOM : LEFT);
      divideHalves(boxes, keys, from, to, HALVINGS);
    }
  }

  private static void divideHalves(double[] boxes, long[] keys, int from, int to, int halvings) {
    if (halvings == 0) {
      divide(boxes, keys, from, to);
    } else if (to - from > LEAF_SIZE) {
      int middle = (from + to) >>> 1;
      divideHalves(boxes, keys, from, middle, halvings - 1);
      divideHalves(boxes, keys, middle, to, halvings - 1);
    }
  }

  /** The length on one axis of the range that the middles of a run's boxes take. */
  private static double length(double[] boxes, long[] keys, int from, int to, int axis) {
    return end(boxes, keys, from, to, axis, 1) - end(boxes, keys, from, to, axis, -1);
  }

  /** Sorts a run of items by the middles of their boxes on one axis, in steps of their range. */
  private static void sort(double[] boxes, long[] keys, int from, int to, int axis) {
    double least = end(boxes, keys, from, to, axis, -1);
    double scale = STEPS / (end(boxes, keys, from, to, axis, 1) / 2 - least / 2);
    for (int i = from; i < to; i++) {
      int item = (int) keys[i];
      int step = (int) ((middle(boxes, item, axis) / 2 - least / 2) * scale);
      keys[i] = ((long) step << Integer.SIZE) | item;
    }
    Arrays.sort(keys, from, to);
  }

  /** The least middle of a run's boxes on one axis, or the largest: in the direction -1 or 1. */
  private static double end(
      double[] boxes, long[] keys, int from, int to, int axis, int direction) {
    double farthest = Double.NEGATIVE_INFINITY;
    for (int i = from; i < to; i++) {
      double middle = direction * middle(boxes, (int) keys[i], axis);
      farthest = middle > farthest ? middle : farthest;
    }
    return direction * farthest;
  }

  private static double middle(double[] boxes, int item, int axis) {
    return boxes[item * BOX + axis] / 2 + boxes[item * BOX + axis + RIGHT] / 2;
  }

  /** The boxes of the nodes around some boxes of the items, which are in the order of the tree. */
  public double[] nodes(double[] ofItems) {
    double[] made = new double[nodeCount * BOX];
    if (items.length > 0) {
      build(ofItems, made, 0, 0, items.length);
    }
    return made;
  }

  /** Finds the boxes of a run of items, and of its halves. */
  private static void build(double[] boxes, double[] nodes, int node, int from, int to) {
    int k = node * BOX;
    if (to - from <= LEAF_SIZE) {
      System.arraycopy(boxes, from * BOX, nodes, k, BOX);
      for (int i = from + 1; i < to; i++) {
        include(nodes, k, boxes, i * BOX);
      }
      return;
    }
    int middle = (from + to) >>> 1;
    build(boxes, nodes, 2 * node + 1, from, middle);
    build(boxes, nodes, 2 * node + 2, middle, to);
    System.arraycopy(nodes, (2 * node + 1) * BOX, nodes, k, BOX);
    include(nodes, k, nodes, (2 * node + 2) * BOX);
  }

  static void include(double[] nodes, int k, double[] from, int other) {
    nodes[k + LEFT] = Math.min(nodes[k + LEFT], from[other + LEFT]);
    nodes[k + BOTTOM] = Math.min(nodes[k + BOTTOM], from[other + BOTTOM]);
    nodes[k + RIGHT] = Math.max(nodes[k + RIGHT], from[other + RIGHT]);
    nodes[k + TOP] = Math.max(nodes[k + TOP], from[other + TOP]);
  }

  public int size() {
    return items.length;
  }

  /** The item at a place of the order of the tree. */
  public int item(int place) {
    return items[place];
  }

  /** The boxes of the nodes: node k at {@code k * BOX}. */
  public double[] nodes() {
    return nodes;
  }

  /** A side of the box around all items: {@link #LEFT} to {@link #TOP}. There must be an item. */
  public double side(int side) {
    return nodes[side];
  }

  // Items that a test does not reject.

  /** A test that rejects boxes. */
  public interface Rejects {

    /** Whether nothing in the box at place k of an array is of interest. */
    boolean test(double[] boxes, int k);
  }

  /** Rejects boxes that are apart from a given box; a side that is NaN is no limit. */
  public static final class Outside implements Rejects {

    private double left;
    private double bottom;
    private double right;
    private double top;

    /** Sets the box. */
    public Outside set(double newLeft, double newBottom, double newRight, double newTop) {
      left = newLeft;
      bottom = newBottom;
      right = newRight;
      top = newTop;
      return this;
    }

    @Override
    public boolean test(double[] boxes, int k) {
      return boxes[k + LEFT] > right
          || boxes[k + RIGHT] < left
          || boxes[k + BOTTOM] > top
          || boxes[k + TOP] < bottom;
    }
  }

  /**
   * Finds the items for which a test rejects neither their box nor that of a run that holds them.
   */
  public void find(Rejects rejects, IntList found) {
    if (items.length > 0) {
      find(0, 0, items.length, rejects, found);
    }
  }

  private void find(int node, int from, int to, Rejects rejects, IntList found) {
    if (rejects.test(nodes, node * BOX)) {
      return;
    }
    if (to - from > LEAF_SIZE) {
      int middle = (from + to) >>> 1;
      find(2 * node + 1, from, middle, rejects, found);
      find(2 * node + 2, middle, to, rejects, found);
      return;
    }
    for (int i = from; i < to; i++) {
      if (!rejects.test(boxes, i * BOX)) {
        found.add(items[i]);
      }
    }
  }

  // Items in the order of time, or of another number.

  /** A search for the item that comes first. */
  public interface First {

    /** A time before which no item of a node comes; infinite if none does, NaN if unknown. */
    double entry(int node);

    /** The time after which no item is of interest; NaN for no limit. */
    double limit();

    /** Looks at the item at a place of the order of the tree. */
    void look(int place);
  }

  /** Shows a search all items that may come before its limit; those of earlier runs come first. */
  public void first(First search) {
    if (items.length > 0 && !(search.entry(0) > search.limit())) {
      first(0, 0, items.length, search);
    }
  }

  private void first(int node, int from, int to, First search) {
    if (to - from <= LEAF_SIZE) {
      for (int place = from; place < to; place++) {
        search.look(place);
      }
      return;
    }
    int middle = (from + to) >>> 1;
    int lower = 2 * node + 1;
    double ofLower = search.entry(lower);
    double ofUpper = search.entry(lower + 1);
    boolean upperFirst = ofUpper < ofLower;
    if (upperFirst && !(ofUpper > search.limit())) {
      first(lower + 1, middle, to, search);
    }
    if (!(ofLower > search.limit())) {
      first(lower, from, middle, search);
    }
    if (!upperFirst && !(ofUpper > search.limit())) {
      first(lower + 1, middle, to, search);
    }
  }

  // Items near a point.

  /** A search for the item that is nearest to a point. */
  public interface Nearest {

    /** Looks at an item. */
    void look(int item);

    /** The square of the distance beyond which no item is of interest; NaN for no limit. */
    double limit();
  }

  /** Shows a search all items whose boxes are within its limit; items of nearer runs come first. */
  public void nearest(double x, double y, Nearest search) {
    first(
        new First() {
          @Override
          public double entry(int node) {
            return distance2(nodes, node * BOX, x, y);
          }

          @Override
          public double limit() {
            return search.limit();
          }

          @Override
          public void look(int place) {
            if (!(distance2(boxes, place * BOX, x, y) > search.limit())) {
              search.look(items[place]);
            }
          }
        });
  }

  /** The square of the distance of a point from a box, which errs by a few ulps of the extent. */
  private static double distance2(double[] boxes, int k, double x, double y) {
    double dx = outside(boxes[k + LEFT], boxes[k + RIGHT], x);
    double dy = outside(boxes[k + BOTTOM], boxes[k + TOP], y);
    return dx * dx + dy * dy;
  }

  /** How far a coordinate is outside of a range: branch-free, as that is unpredictable. */
  private static double outside(double low, double high, double p) {
    return 0.5 * (Math.abs(p - low) + Math.abs(p - high) - (high - low));
  }
}
