// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.CollidingScenes;
import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.queue.CalendarQueue;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.util.Index;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Circles that touch are found, whatever their sizes; cells add and remove circles. */
class NeighborGridTest {

  private static CircleTable circles(Scene scene) {
    CircleTable circles = CircleTable.colliding(scene.circleCount());
    for (int i = 0; i < circles.count; i++) {
      circles.start(Internals.data(scene), i);
      circles.put(i, circles.body);
    }
    return circles;
  }

  private static NeighborGrid grid(Scene scene, CircleTable circles) {
    return grid(scene, circles, Internals.data(scene).obstacles.walls, 1);
  }

  private static NeighborGrid grid(
      Scene scene, CircleTable circles, double[] walls, double diameters) {
    int[] slots = new CircleRegistry(Internals.data(scene), 1).slots();
    return new NeighborGrid(circles, slots, walls, diameters, 0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1.5, 5, 1000})
  void allThatTouchAreVisited(double diameters) {
    allThatTouchAreVisited(CollidingScenes.mixed(new Random(1), 200).build(), diameters);
    allThatTouchAreVisited(alike(new Random(2), 200), diameters);
  }

  /** Circles of one radius: they need one level only. */
  private static Scene alike(Random random, int count) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 30, 30).collide(true);
    for (int i = 0; i < count; i++) {
      builder.circle(30 * random.nextDouble(), 30 * random.nextDouble(), 1, 0, 0);
    }
    return builder.build();
  }

  private static void allThatTouchAreVisited(Scene scene, double diameters) {
    CircleTable circles = circles(scene);
    int touching = 0;
    for (double[] walls : new double[][] {null, Internals.data(scene).obstacles.walls}) {
      NeighborGrid neighbors = grid(scene, circles, walls, diameters);
      for (int i = 0; i < circles.count; i += 3) {
        neighbors.leave(i);
        assertThat(neighbors.enter(i, 0)).isTrue();
      }
      for (int i = 0; i < circles.count; i++) {
        int[] found = new int[circles.count + 9];
        int size = follow(circles, found, neighbors.find(circles.codes, i, found));
        Set<Integer> visited = new HashSet<>(Arrays.stream(found, 0, size).boxed().toList());
        assertThat(visited).as("each once").hasSize(size);
        for (int j = 0; j < circles.count; j++) {
          if (j != i && touch(scene.circle(i), scene.circle(j))) {
            assertThat(visited).contains(j);
            touching++;
          }
        }
      }
    }
    assertThat(touching).isPositive();
  }

  /** Adds those that follow in the lists. */
  private static int follow(CircleTable circles, int[] found, int size) {
    int end = size;
    for (int k = 0; k < end; k++) {
      int follower = circles.codes[CircleTable.collidingCodesAt(found[k]) + CircleTable.FOLLOWER];
      if (follower != Index.NONE) {
        found[end++] = follower;
      }
    }
    return end;
  }

  private static boolean touch(Circle a, Circle b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y()) <= a.radius() + b.radius();
  }

  @Test
  void whatStandsStillLeavesNoCell() {
    Scene scene = Scene.builder().circle(3, 4, 1, 0, 0).collide(true).build();
    CircleTable circles = circles(scene);
    NeighborGrid neighbors = grid(scene, circles, null, 1);
    assertThat(crossing(neighbors, circles)).isEqualTo(Double.POSITIVE_INFINITY);
  }

  /** Where none is near, a circle anywhere in its cell is further than its radius from any wall. */
  @Test
  void wallsAreNearOnlyAtTheEdge() {
    Random random = new Random(3);
    SceneBuilder builder = Scene.builder().bounds(-3, 2, 97, 52).collide(true);
    for (int i = 0; i < 500; i++) {
      builder.circle(100 * random.nextDouble() - 3, 50 * random.nextDouble() + 2, 1, 0, 0);
    }
    Scene scene = builder.circle(1e3, 20, 1, 0, 0).circle(20, -1e3, 1, 0, 0).build();
    CircleTable circles = circles(scene);
    NeighborGrid neighbors = grid(scene, circles);
    int inside = 0;
    for (int i = 0; i < scene.circleCount(); i++) {
      Circle c = scene.circle(i);
      double wall = Math.min(Math.min(c.x() + 3, 97 - c.x()), Math.min(c.y() - 2, 52 - c.y()));
      if (neighbors.isInside(circles.state, i)) {
        assertThat(wall).isGreaterThan(1);
        inside++;
      } else {
        assertThat(wall).isLessThan(1 + 2 * 2.1);
      }
    }
    assertThat(inside).isGreaterThan(300);
  }

  /**
   * Wherever in its cell a wall is touched, it is asked there: also close to where the cell ends,
   * and so far from the origin that places are hardly finer than a thousandth of a radius.
   */
  @ParameterizedTest
  @CsvSource({"0, 1, 0x1p-11", "0x1p40, 0.25, 0x1p-11"})
  void whoTouchesAWallIsNotInside(double far, double radius, double step) {
    for (int k = 0; k * step < 3 * radius; k++) {
      double right = far + 16 * radius + k * step;
      SceneBuilder scene = Scene.builder().bounds(far, 0, right, 16 * radius);
      for (int i = 0; i < 50; i++) {
        scene.circle(right - radius, 8 * radius, radius, 1, 0);
      }
      Scene built = scene.build();
      CircleTable circles = circles(built);
      NeighborGrid neighbors = grid(built, circles);
      assertThat(neighbors.isInside(circles.state, 0)).as("wall at %s", right).isFalse();
    }
  }

  @Test
  void cellsHoldWhatWasAddedAndNotRemovedSince() {
    CellGrid cells = new CellGrid(4, 8);
    int[] codes = CircleTable.colliding(3).codes;
    cellsHoldWhatWasAddedAndNotRemovedSince(
        cells,
        (i, place) -> cells.add(codes, i, place),
        (i, place) -> cells.remove(codes, i, place),
        place -> around(cells, codes, place));
    for (int[] previous : new int[][] {null, new int[3]}) {
      CellLinks lists = new CellLinks(new CellGrid(4, 8), new int[3], previous);
      cellsHoldWhatWasAddedAndNotRemovedSince(
          lists.cells, lists::add, lists::remove, place -> around(lists, place));
    }
  }

  private interface Change {
    void of(int i, int place);
  }

  private static void cellsHoldWhatWasAddedAndNotRemovedSince(
      CellGrid cells, Change add, Change remove, IntFunction<List<Integer>> around) {
    // Columns that are beyond the last one go on in the next row, and rows in the first one.
    add.of(0, cells.cell(-1, -1));
    add.of(1, cells.cell(3, 6));
    add.of(2, cells.cell(3, -1));
    assertThat(around.apply(cells.cell(2, 6)))
        .as("around the ring")
        .containsExactlyInAnyOrder(0, 1, 2);
    assertThat(around.apply(cells.cell(1, 7))).isEmpty();
    remove.of(1, cells.cell(3, 6));
    assertThat(around.apply(cells.cell(4, 7))).containsExactlyInAnyOrder(0, 2);
    remove.of(2, cells.cell(3, -1));
    add.of(2, cells.cell(4, 8));
    assertThat(around.apply(cells.cell(0, 9))).containsExactly(2);
    assertThat(around.apply(cells.cell(2, 6))).containsExactly(0);
    remove.of(0, cells.cell(-1, -1));
    assertThat(around.apply(cells.cell(2, 6))).isEmpty();
  }

  /** Whatever the order in which circles come to a cell and go. */
  @Test
  void aListLosesWhoGoes() {
    Random random = new Random(8);
    CellGrid cells = new CellGrid(4, 4);
    int[] codes = CircleTable.colliding(20).codes;
    Set<Integer> listed = new HashSet<>();
    for (int k = 0; k < 500; k++) {
      int i = random.nextInt(20);
      if (listed.remove(i)) {
        cells.remove(codes, i, 5);
      } else {
        cells.add(codes, i, 5);
        listed.add(i);
      }
      assertThat(around(cells, codes, 5)).containsExactlyInAnyOrderElementsOf(listed);
    }
  }

  /** The lists that are read ahead are those through which a search goes then. */
  @Test
  void whatIsReadAheadIsWhatIsLookedAt() {
    Random random = new Random(4);
    CellGrid cells = new CellGrid(16, 8);
    int[] codes = CircleTable.colliding(90).codes;
    for (int i = 0; i < 90; i++) {
      cells.add(codes, i, cells.cell(random.nextInt(16), random.nextInt(8)));
    }
    int[] lists = new int[20];
    int[] found = new int[100];
    int[][] steps = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (int k = 0; k < 200; k++) {
      int column = random.nextInt(30) - 10;
      int row = random.nextInt(30) - 10;
      cells.listsAround(column, row, lists, 2);
      cells.firsts(lists, 2, 11);
      int size = cells.around(cells.cell(column, row), found, 0);
      assertThat(heads(lists, 2, 11)).isEqualTo(heads(found, 0, size));
      int dx = steps[k % 4][0];
      int dy = steps[k % 4][1];
      cells.listsAhead(column, row, dx, dy, lists, 11);
      cells.firsts(lists, 11, 16);
      int ahead = cells.cell(column + 2 * dx, row + 2 * dy);
      size = cells.beside(ahead, cells.step(-Math.abs(dx)), found, 0);
      assertThat(heads(lists, 13, 16)).isEqualTo(heads(found, 0, size));
      assertThat(lists[11]).isEqualTo(cells.first(cells.cell(column, row)));
      assertThat(lists[12]).isEqualTo(cells.first(cells.cell(column + dx, row + dy)));
    }
  }

  /** A circle that looks around itself finds all others; itself only where it is not the first. */
  @Test
  void theFirstOfAListDoesNotFindItself() {
    Random random = new Random(6);
    CellGrid cells = new CellGrid(8, 8);
    CircleTable circles = CircleTable.colliding(90);
    int[] codes = circles.codes;
    int[] places = random.ints(90).toArray();
    for (int i = 0; i < 90; i++) {
      cells.add(codes, i, places[i]);
    }
    int[] found = new int[100];
    for (int i = 0; i < 90; i++) {
      int self = i;
      List<Integer> others = new ArrayList<>(around(cells, codes, places[i]));
      int first = cells.first(places[i]);
      others.removeIf(j -> j == self && j == first);
      int size = follow(circles, found, cells.others(codes, i, places[i], found));
      assertThat(Arrays.stream(found, 0, size).boxed()).containsExactlyInAnyOrderElementsOf(others);
    }
  }

  private static Set<Integer> heads(int[] lists, int from, int to) {
    return Arrays.stream(lists, from, to)
        .filter(i -> i != Index.NONE)
        .boxed()
        .collect(Collectors.toSet());
  }

  /** Right, left, up, down. */
  @ParameterizedTest
  @CsvSource({"3, 0.25", "-3, -0.25", "0.25, 3", "-0.25, -3"})
  void aWayLeadsIntoTheCellThatIsEnteredNext(double vx, double vy) {
    Scene scene = Scene.builder().circle(3, 4, 1, vx, vy).circle(-30, -40, 1, 0, 0).build();
    CircleTable circles = circles(scene);
    NeighborGrid neighbors = grid(scene, circles, null, 1);
    int column = neighbors.column(0);
    int row = neighbors.row(0);
    double crossing = crossing(neighbors, circles);
    int way = circles.codes[CircleTable.collidingCodesAt(0) + CircleTable.WAY];
    assertThat(CellExit.columns(way)).isEqualTo((int) Math.signum((int) vx));
    assertThat(CellExit.rows(way)).isEqualTo((int) Math.signum((int) vy));
    neighbors.cross(circles.state, circles.codes, 0, way, new int[11]);
    assertThat(neighbors.column(0)).isEqualTo(column + CellExit.columns(way));
    assertThat(neighbors.row(0)).isEqualTo(row + CellExit.rows(way));
    assertThat(around(neighbors, circles, neighbors.column(0), neighbors.row(0))).contains(0);
    assertThat(crossing(neighbors, circles)).isGreaterThan(crossing);
  }

  /** Where a new flight starts, in any direction and far, or in the same cell still. */
  @Test
  void whoBeginsANewFlightIsListedWhereThatStarts() {
    Scene scene = alike(new Random(6), 40);
    CircleTable circles = circles(scene);
    NeighborGrid neighbors = grid(scene, circles);
    Random random = new Random(7);
    int stayed = 0;
    for (int k = 0; k < 400; k++) {
      int i = random.nextInt(40);
      int a = CircleTable.collidingAt(i);
      int coordinate = random.nextBoolean() ? FlightRow.X : FlightRow.Y;
      circles.state[a + coordinate] += random.nextGaussian() * (random.nextInt(4) + 0.1);
      int before = neighbors.column(i) * 1000 + neighbors.row(i);
      neighbors.comeBack(circles.state, i);
      int column = neighbors.column(i);
      int row = neighbors.row(i);
      stayed += before == column * 1000 + row ? 1 : 0;
      neighbors.leave(i);
      assertThat(around(neighbors, circles, column, row)).as("once").doesNotContain(i);
      assertThat(neighbors.enter(i, 0)).isTrue();
      assertThat(neighbors.column(i)).isEqualTo(column);
      assertThat(neighbors.row(i)).isEqualTo(row);
    }
    assertThat(stayed).isBetween(100, 300);
  }

  /** Prefetched values end in nothing but a sum. */
  @Test
  void readingAheadChangesNothing() {
    Scene scene = alike(new Random(5), 40);
    CircleTable circles = circles(scene);
    NeighborGrid neighbors = grid(scene, circles);
    int[] ids = new int[CalendarQueue.MOST_PREFETCHED];
    for (int k = 0; k < ids.length; k++) {
      ids[k] = k * 7 % 40;
      int c = CircleTable.collidingCodesAt(ids[k]);
      circles.codes[c + CircleTable.KIND] = k % (EventKind.CROSSING + 4);
      circles.codes[c + CircleTable.PARTNER] = k % 40;
    }
    double[] state = circles.state.clone();
    int[] codes = circles.codes.clone();
    CalendarQueue queue = new CalendarQueue(40, (i, j) -> i < j);
    EventPrefetcher ahead =
        new EventPrefetcher(circles, new CircleRegistry(Internals.data(scene), 1), neighbors);
    for (int size = 0; size <= ids.length; size++) {
      ahead.next(queue, ids, size);
    }
    assertThat(circles.state).isEqualTo(state);
    assertThat(circles.codes).isEqualTo(codes);
  }

  private static List<Integer> around(
      NeighborGrid neighbors, CircleTable circles, int column, int row) {
    CellGrid cells = neighbors.cells(0);
    return around(cells, circles.codes, cells.cell(column, row));
  }

  private static List<Integer> around(CellGrid cells, int[] codes, int place) {
    int[] found = new int[60];
    int size = cells.around(place, found, 0);
    for (int k = 0; k < size; k++) {
      int follower = codes[CircleTable.collidingCodesAt(found[k]) + CircleTable.FOLLOWER];
      if (follower != Index.NONE) {
        found[size++] = follower;
      }
    }
    return Arrays.stream(found, 0, size).boxed().toList();
  }

  private static List<Integer> around(CellLinks lists, int place) {
    int[] found = new int[60];
    int size = lists.around(place, found, 0);
    return Arrays.stream(found, 0, size).boxed().toList();
  }

  private static double crossing(NeighborGrid neighbors, CircleTable circles) {
    return neighbors.nextCrossing(circles.state, circles.codes, 0);
  }
}
