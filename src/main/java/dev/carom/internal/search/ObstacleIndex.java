// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;

/**
 * The indexes of obstacles that questions use: a tree of boxes for each kind, and for casts a grid
 * for each power of two among the radii asked with. They are apart from the grids of stepping, so
 * no question changes what a step does.
 *
 * <p>An index costs more than a question that tests each obstacle. So it is made once such
 * questions have tested as many obstacles as it costs. Obstacles that change later are <i>loose</i>
 * and tested beside it. When that has cost as much, it is made anew. When they are many, it is
 * dropped. Obstacles that move are in no index.
 *
 * <p>Without changes of the obstacles it is safe for use by several threads.
 */
public final class ObstacleIndex {

  /** Up to this many lines and pegs each one is tested. */
  private static final int FEW = 8;

  /** The index costs as much as so many questions that test each obstacle: measured. */
  private static final int COST = 16;

  /** The radii of point rays, and all below 2^-20 of the size of the scene, share a grid. */
  private static final int OCTAVES = 20;

  public final ObstacleTable obstacles;

  /** The search that is copied for each thread. It knows the extent of the obstacles. */
  private final FlightSearch model;

  /** The obstacles that changed since the index was made. */
  private final CodeSet loose = new CodeSet();

  /** How many obstacles were tested for want of an index. */
  private final AtomicLong tested = new AtomicLong();

  private final Map<Integer, Grid> grids = new ConcurrentHashMap<>();

  /** The tree of each kind that has rows, in their order; null while there is no index. */
  private volatile BoxTree[] trees;

  /** The exponents of the least and of the largest radius for which a grid is made. */
  private volatile int leastExponent;

  private volatile int mostExponent;

  /** The margin of the lists of the grids. */
  private double margin = Grid.MARGIN;

  /** Whether an index may be made; if not, each obstacle is tested. */
  public final boolean wanted;

  public ObstacleIndex(ObstacleTable obstacles) {
    this(obstacles, true);
  }

  public ObstacleIndex(ObstacleTable obstacles, boolean wanted) {
    this.obstacles = obstacles;
    this.wanted = wanted;
    model = new FlightSearch(obstacles, loose);
  }

  /** A search for one thread; it is valid until the obstacles change. */
  public FlightSearch search() {
    return new FlightSearch(model);
  }

  /** The obstacles to be tested beside the trees. */
  public CodeSet loose() {
    return loose;
  }

  /** Counts questions that are about to be asked, and makes the index once it pays. */
  public void expect(int questions) {
    if (!wanted) {
      return;
    }
    int size = obstacles.staticSize();
    int each = trees == null ? size : loose.size;
    if (each > 0 && tested.addAndGet((long) each * questions) > (long) COST * size) {
      make();
    }
  }

  /** The tree of the obstacles of a kind; null to test each of them. */
  public BoxTree tree(int kind) {
    BoxTree[] all = trees;
    return all == null ? null : all[kind - obstacles.lines.kind()];
  }

  /** The grid for casts of a radius; null to test each obstacle. */
  public Grid grid(double radius) {
    if (trees == null) {
      return null;
    }
    int exponent = Math.max(leastExponent, Math.getExponent(radius));
    if (exponent > mostExponent) {
      return null;
    }
    Grid grid = grids.get(exponent);
    return grid != null ? grid : grids.computeIfAbsent(exponent, this::newGrid);
  }

  private Grid newGrid(int exponent) {
    return new Grid(obstacles, Math.scalb(1.0, exponent + 1), 0, margin);
  }

  private synchronized void make() {
    tested.set(0);
    if (obstacles.staticSize() <= FEW || (trees != null && loose.size == 0)) {
      return;
    }
    forget();
    BoxTree[] made = new BoxTree[obstacles.kinds.size()];
    double size = 0;
    for (int k = 0; k < made.length; k++) {
      made[k] = tree(obstacles.kinds.get(k));
      size = Math.max(size, size(made[k]));
    }
    mostExponent =
        Grid.serves(obstacles.extent()) ? Math.getExponent(size) : Double.MIN_EXPONENT - 1;
    leastExponent = Math.max(Double.MIN_EXPONENT, mostExponent - OCTAVES);
    trees = made;
  }

  private BoxTree tree(ObstacleRows rows) {
    LiveCodes present = rows.present();
    int[] codes = present.stream(code -> !obstacles.isStatic(code)).toArray();
    double[] boxes = new double[codes.length * BoxTree.BOX];
    for (int i = 0; i < codes.length; i++) {
      BoxTree.put(boxes, i, rows.shape, rows.values, rows.offset(codes[i]), 0);
    }
    return new BoxTree(codes, boxes);
  }

  /** The larger side of the box around all items. */
  private static double size(BoxTree tree) {
    return tree.size() == 0
        ? 0
        : Math.max(
            tree.side(BoxTree.RIGHT) - tree.side(BoxTree.LEFT),
            tree.side(BoxTree.TOP) - tree.side(BoxTree.BOTTOM));
  }

  /** Prepares for circles that fall. */
  public synchronized void beginFalls() {
    margin = Grid.MARGIN_OF_FALLS;
    grids.clear();
  }

  private void forget() {
    trees = null;
    grids.clear();
    loose.clear();
  }

  // Changes.

  /** Notes that a line or a peg that never moved is new, elsewhere, or gone. */
  public void changed(int code) {
    model.lookAgain(code);
    if (trees != null) {
      loose.add(code);
      if (Grids.areTooMany(loose.size, obstacles.staticSize())) {
        forget();
      }
    }
  }

  /** Notes that all obstacles may be others. */
  public void changedAll() {
    model.lookAgainAtAll();
    forget();
  }
}
