// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Who touches is found, whatever the sizes; lists take in and let go. */
class NeighborsTest {

  private static Circles circles(Scene scene) {
    Circles circles = Circles.colliding(scene.circleCount());
    for (int i = 0; i < circles.count; i++) {
      circles.start(scene, i);
      circles.keep(i, circles.mover);
    }
    return circles;
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
    Circles circles = circles(scene);
    for (Bounds bounds : new Bounds[] {null, scene.bounds}) {
      Neighbors neighbors = new Neighbors(circles, new Roster(scene), bounds, diameters, 0);
      for (int i = 0; i < circles.count; i++) {
        int[] found = new int[circles.count + 9];
        int size = follow(neighbors.followers(), found, neighbors.find(i, found));
        Set<Integer> visited = new HashSet<>(Arrays.stream(found, 0, size).boxed().toList());
        assertThat(visited).as("each once").hasSize(size);
        for (int j = 0; j < circles.count; j++) {
          if (j != i && touch(scene.circle(i), scene.circle(j))) {
            assertThat(visited).contains(j);
          }
        }
      }
    }
  }

  /** Adds those that follow in the lists. */
  private static int follow(int[] followers, int[] found, int size) {
    int end = size;
    for (int k = 0; k < end; k++) {
      if (followers[found[k]] != Cells.NONE) {
        found[end++] = followers[found[k]];
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
    Neighbors neighbors = new Neighbors(circles(scene), new Roster(scene), null, 1, 0);
    assertThat(neighbors.crossing(0)).isEqualTo(Double.POSITIVE_INFINITY);
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
    Neighbors neighbors = new Neighbors(circles(scene), new Roster(scene), scene.bounds, 1, 0);
    int inside = 0;
    for (int i = 0; i < scene.circleCount(); i++) {
      Circle c = scene.circle(i);
      double wall = Math.min(Math.min(c.x() + 3, 97 - c.x()), Math.min(c.y() - 2, 52 - c.y()));
      if (neighbors.isInside(i)) {
        assertThat(wall).isGreaterThan(1);
        inside++;
      } else {
        assertThat(wall).isLessThan(1 + 2 * 2.1);
      }
    }
    assertThat(inside).isGreaterThan(300);
  }

  @Test
  void cellsHoldWhatWasAddedAndNotRemovedSince() {
    for (int[] previous : new int[][] {null, new int[3]}) {
      Cells cells = new Cells(4, 8, new int[3], previous);
      cells.add(0, -1, -1);
      cells.add(1, 3, 7);
      cells.add(2, 3, -1);
      assertThat(around(cells, 2, 6)).as("wrapped around").containsExactlyInAnyOrder(0, 1, 2);
      assertThat(around(cells, 1, 7)).isEmpty();
      cells.remove(1, 3, 7);
      assertThat(around(cells, 4, 8)).containsExactlyInAnyOrder(0, 2);
      cells.remove(2, 3, -1);
      cells.add(2, 4, 8);
      assertThat(around(cells, 4, 8)).containsExactlyInAnyOrder(0, 2);
      assertThat(around(cells, 2, 6)).containsExactly(0);
      cells.remove(0, -1, -1);
      assertThat(around(cells, 2, 6)).isEmpty();
    }
  }

  private static List<Integer> around(Cells cells, int column, int row) {
    int[] found = new int[12];
    int size = cells.follow(found, 0, cells.around(column, row, found, 0));
    return Arrays.stream(found, 0, size).boxed().toList();
  }
}
