// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.search.BoxTree;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.util.IntList;
import java.util.Arrays;
import java.util.function.IntConsumer;

/** The circles of a scene in a {@link BoxTree}, which finds those near a segment or a point. */
final class CircleTree {

  /** A part of the terms of a cross product that is far more than its rounding. */
  private static final double ROUNDING = 0x1p-45;

  private final BoxTree tree;
  private final IntList near = new IntList();

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
    int[] items = new int[to - from];
    double[] boxes = new double[items.length * BoxTree.BOX];
    Arrays.setAll(items, k -> from + k);
    for (int k = 0; k < items.length; k++) {
      int row = items[k] * SceneData.CIRCLE_ROW;
      double x = circles[row + SceneData.X];
      double y = circles[row + SceneData.Y];
      BoxTree.put(boxes, k, x, y, x, y, circles[row + SceneData.RADIUS]);
    }
    tree = new BoxTree(items, boxes);
  }

  /** Finds all circles that come nearer to a segment than a radius, and perhaps others. */
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
    near.clear();
    tree.find(this::isApart, near);
    for (int k = 0; k < near.size(); k++) {
      found.accept(near.get(k));
    }
  }

  /**
   * Whether a box is certainly apart from the query: from its box, or from its segment. With the
   * centre c and half the size h of the box, that is {@code |cross(w, c - a)| > |wx| hy + |wy| hx +
   * r |w|}. NaN proves nothing.
   */
  private boolean isApart(double[] boxes, int k) {
    double x0 = boxes[k + BoxTree.LEFT];
    double y0 = boxes[k + BoxTree.BOTTOM];
    double x1 = boxes[k + BoxTree.RIGHT];
    double y1 = boxes[k + BoxTree.TOP];
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
