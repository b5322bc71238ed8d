// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.search.BoxTree;
import dev.carom.internal.util.Index;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;

/** The nearest of the items that it looked at; of equally near ones the smallest. */
final class NearestItem implements BoxTree.Nearest {

  /** In units of the coordinates: far more than the rounding of a distance. */
  private static final double ROUNDING = 0x1p-44;

  private final IntPredicate seen;
  private final IntToDoubleFunction distance;
  private int item = Index.NONE;
  private double least = Double.POSITIVE_INFINITY;

  /** By how much a computed distance may differ from the true one. */
  private double error;

  private double limit = Double.POSITIVE_INFINITY;

  /** Looks for the nearest of those that count, by a computed distance from a point. */
  NearestItem(IntPredicate seen, IntToDoubleFunction distance) {
    this.seen = seen;
    this.distance = distance;
  }

  /** Looks at those items of a tree that may be nearest to the point. */
  void search(BoxTree tree, double x, double y) {
    error = ROUNDING * (Math.abs(x) + Math.abs(y) + tree.extent) + Double.MIN_NORMAL;
    setLimit();
    tree.nearest(x, y, this);
  }

  @Override
  public void look(int other) {
    double its = distance.applyAsDouble(other);
    if (Double.isNaN(its)) {
      return; // removed
    }
    boolean nearer = item == Index.NONE || its < least || (its == least && other < item);
    if (nearer && seen.test(other)) {
      item = other;
      least = its;
      setLimit();
    }
  }

  private void setLimit() {
    limit = (least + error) * (least + error) * (1 + 0x1p-40) + Double.MIN_NORMAL;
  }

  @Override
  public double limit() {
    return limit;
  }

  /** The item, or NONE. */
  int item() {
    return item;
  }
}
