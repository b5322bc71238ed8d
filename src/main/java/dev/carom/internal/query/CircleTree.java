// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.state.SceneData;
import java.util.Arrays;
import java.util.Comparator;
import java.util.function.IntConsumer;

/**
 * A tree of bounding boxes over the circles of a scene. It finds the circles near a segment or a
 * point. The circles are sorted into vertical strips, and from bottom to top within a strip. Each
 * box holds a run of this order. So a distant or a large circle spoils only the boxes of its run.
 */
final class CircleTree {

  /** The most circles in a leaf. */
  private static final int LEAF_SIZE = 8;

  /** A part of the terms of a cross product that is far more than its rounding. */
  private static final double ROUNDING = 0x1p-45;

  // The places of the sides of a box.
  private static final int LEFT = 0;
  private static final int BOTTOM = 1;
  private static final int RIGHT = 2;
  private static final int TOP = 3;
  private static final int BOX = 4;

  private final double[] circles;
  private final int[] order;

  /** The box of node k, whose halves are nodes 2k + 1 and 2k + 2. */
  private final double[] boxes;

  // The query: a segment, and its box, grown by the radius.
  private double ax;
  private double ay;
  private double wx;
  private double wy;

  /** The radius times the length of the segment. */
  private double grown;

  private double left;
  private double bottom;
  private double right;
  private double top;

  /** Builds a tree over the circles from..to-1 of a scene, given by the rows of all. */
  CircleTree(double[] circles, int from, int to) {
    this.circles = circles;
    order = inStrips(circles, from, to);
    int nodes = 1;
    for (int runs = (order.length + LEAF_SIZE - 1) / LEAF_SIZE; runs > 1; runs = (runs + 1) / 2) {
      nodes = 2 * nodes + 1;
    }
    boxes = new double[(nodes + 1) * BOX];
    if (order.length > 0) {
      build(0, 0, order.length);
    }
  }

  private static int[] inStrips(double[] circles, int from, int to) {
    Integer[] byX = new Integer[to - from];
    Arrays.setAll(byX, k -> from + k);
    Arrays.sort(
        byX, Comparator.comparingDouble(i -> circles[i * SceneData.CIRCLE_ROW + SceneData.X]));
    int strip = LEAF_SIZE * (int) Math.ceil(Math.sqrt(byX.length / (double) LEAF_SIZE));
    for (int k = 0; k < byX.length; k += strip) {
      int end = Math.min(byX.length, k + strip);
      Arrays.sort(
          byX,
          k,
          end,
          Comparator.comparingDouble(i -> circles[i * SceneData.CIRCLE_ROW + SceneData.Y]));
    }
    return Arrays.stream(byX).mapToInt(i -> i).toArray();
  }

  /** Computes the boxes of a run of circles and of its halves. */
  private void build(int node, int from, int to) {
    int k = node * BOX;
    if (to - from <= LEAF_SIZE) {
      boxOf(order[from], k);
      for (int i = from + 1; i < to; i++) {
        boxOf(order[i], boxes.length - BOX);
        include(k, boxes.length - BOX);
      }
      return;
    }
    int middle = (from + to) >>> 1;
    build(2 * node + 1, from, middle);
    build(2 * node + 2, middle, to);
    System.arraycopy(boxes, (2 * node + 1) * BOX, boxes, k, BOX);
    include(k, (2 * node + 2) * BOX);
  }

  /** Writes the box of a circle to place k, widened so that rounding leaves no part outside. */
  private void boxOf(int circle, int k) {
    int row = circle * SceneData.CIRCLE_ROW;
    double x = circles[row + SceneData.X];
    double y = circles[row + SceneData.Y];
    double r = circles[row + SceneData.RADIUS];
    boxes[k + LEFT] = Math.nextDown(x - r);
    boxes[k + BOTTOM] = Math.nextDown(y - r);
    boxes[k + RIGHT] = Math.nextUp(x + r);
    boxes[k + TOP] = Math.nextUp(y + r);
  }

  private void include(int k, int other) {
    boxes[k + LEFT] = Math.min(boxes[k + LEFT], boxes[other + LEFT]);
    boxes[k + BOTTOM] = Math.min(boxes[k + BOTTOM], boxes[other + BOTTOM]);
    boxes[k + RIGHT] = Math.max(boxes[k + RIGHT], boxes[other + RIGHT]);
    boxes[k + TOP] = Math.max(boxes[k + TOP], boxes[other + TOP]);
  }

  /** Finds all circles nearer to a segment than a radius, and perhaps some more. */
  void near(double fromX, double fromY, double toX, double toY, double r, IntConsumer found) {
    ax = fromX;
    ay = fromY;
    wx = toX - ax;
    wy = toY - ay;
    grown = r * StrictMath.hypot(wx, wy);
    left = Math.nextDown(Math.min(ax, toX) - r);
    bottom = Math.nextDown(Math.min(ay, toY) - r);
    right = Math.nextUp(Math.max(ax, toX) + r);
    top = Math.nextUp(Math.max(ay, toY) + r);
    find(0, 0, order.length, found);
  }

  private void find(int node, int from, int to, IntConsumer found) {
    if (isApart(node * BOX)) {
      return;
    }
    if (to - from > LEAF_SIZE) {
      int middle = (from + to) >>> 1;
      find(2 * node + 1, from, middle, found);
      find(2 * node + 2, middle, to, found);
      return;
    }
    for (int i = from; i < to; i++) {
      boxOf(order[i], boxes.length - BOX);
      if (!isApart(boxes.length - BOX)) {
        found.accept(order[i]);
      }
    }
  }

  /**
   * Whether a box is certainly apart from the query: from its box, or from its segment. With the
   * centre c and half the size h of the box, that is {@code |cross(w, c - a)| > |wx| hy + |wy| hx +
   * r |w|}. NaN proves nothing.
   */
  private boolean isApart(int k) {
    double x0 = boxes[k + LEFT];
    double y0 = boxes[k + BOTTOM];
    double x1 = boxes[k + RIGHT];
    double y1 = boxes[k + TOP];
    if (x0 > right || x1 < left || y0 > top || y1 < bottom) {
      return true;
    }
    double cx = x0 / 2 + x1 / 2;
    double cy = y0 / 2 + y1 / 2;
    double hx = x1 / 2 - x0 / 2;
    double hy = y1 / 2 - y0 / 2;
    double ofX = Math.abs(wx);
    double ofY = Math.abs(wy);
    double halfWidth = ofX * hy + ofY * hx + grown;
    double terms =
        ofX * (Math.abs(cy) + Math.abs(ay) + hy) + ofY * (Math.abs(cx) + Math.abs(ax) + hx);
    double cross = Math.abs(wx * (cy - ay) - wy * (cx - ax));
    return cross > halfWidth + (ROUNDING * (terms + grown) + Double.MIN_NORMAL);
  }
}
