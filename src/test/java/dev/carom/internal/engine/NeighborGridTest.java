// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.RandomScenes;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.queue.CalendarQueue;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Circles that touch are found, whatever their sizes; cells add and remove circles. */
class NeighborGridTest {

  private static CircleTable circles(Scene scene) {
    CircleTable circles = CircleTable.colliding(scene.count(Kind.CIRCLE));
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
    allThatTouchAreVisited(RandomScenes.crowd(new Random(1), 200).build(), diameters);
    allThatTouchAreVisited(alike(new Random(2), 200), diameters);
  }

  /** Circles of one radius: they need one level only. */
  private static Scene alike(Random random, int count) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 30, 30);
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
          if (j != i
              && touch(
                  (Circle) scene.shape(Kind.CIRCLE, i), (Circle) scene.shape(Kind.CIRCLE, j))) {
            assertThat(visited).contains(j);
            touching++;
          }
        }
      }
    }
    assertThat(touching).isPositive();
  }

  /** In narrow grids, too, where a search is wider than a row of cells. */
  @ParameterizedTest
  @ValueSource(doubles = {0.1, 3, 30})
  void allNearAPlaceAreFoundOnce(double width) {
    Random random = new Random(3);
    SceneBuilder builder = Scene.builder();
    for (int i = 0; i < 20; i++) {
      double radius = i % 5 == 0 ? 4 : 1;
      builder.circle(width * random.nextDouble(), 90 * random.nextDouble(), radius, 0, 0);
    }
    Scene scene = builder.build();
    CircleTable circles = circles(scene);
    NeighborGrid neighbors = grid(scene, circles);
    for (int k = 0; k < 500; k++) {
      Circle disk = new Circle(width * random.nextDouble(), 90 * random.nextDouble(), k % 40);
      IntList found = new IntList();
      neighbors.addNear(disk.x(), disk.y(), disk.radius(), found);
      List<Integer> all = IntStream.range(0, found.size()).mapToObj(found::get).toList();
      assertThat(all).doesNotHaveDuplicates();
      for (int i = 0; i < circles.count; i++) {
        if (touch(disk, (Circle) scene.shape(Kind.CIRCLE, i))) {
          assertThat(all).contains(i);
        }
      }
    }
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

  private static Set<Integer> heads(int[] lists, int from, int to) {
    return Arrays.stream(lists, from, to)
        .filter(i -> i != Index.NONE)
        .boxed()
        .collect(Collectors.toSet());
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
}
