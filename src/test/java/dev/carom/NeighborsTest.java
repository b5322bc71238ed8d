// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Who touches is found, whatever the sizes; lists take in and let go. */
class NeighborsTest {

  private static Circles circles(Scene scene) {
    Circles circles = new Circles(scene.circleCount());
    for (int i = 0; i < circles.count; i++) {
      circles.start(scene, i);
      circles.store(i);
    }
    return circles;
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1.5, 5, 1000})
  void allThatTouchAreVisited(double diameters) {
    Scene scene = CollidingScenes.mixed(new Random(1), 200).build();
    Circles circles = circles(scene);
    for (Bounds bounds : new Bounds[] {null, scene.bounds}) {
      Neighbors neighbors = new Neighbors(circles, bounds, diameters);
      for (int i = 0; i < circles.count; i++) {
        Set<Integer> visited = new HashSet<>();
        neighbors.visitAll(i, (self, other) -> visited.add(other));
        assertThat(visited).doesNotContain(i);
        for (int j = 0; j < circles.count; j++) {
          if (j != i && touch(scene.circle(i), scene.circle(j))) {
            assertThat(visited).contains(j);
          }
        }
      }
    }
  }

  private static boolean touch(Circle a, Circle b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y()) <= a.radius() + b.radius();
  }

  @Test
  void whatStandsStillLeavesNoCell() {
    Circles circles = circles(Scene.builder().circle(3, 4, 1, 0, 0).collide(true).build());
    Neighbors neighbors = new Neighbors(circles, null, 1);
    neighbors.newFlight(0);
    assertThat(neighbors.crossing(0)).isEqualTo(Double.POSITIVE_INFINITY);
  }

  @Test
  void cellsHoldWhatWasAddedAndNotRemovedSince() {
    Cells cells = new Cells(3, 4, 8);
    cells.add(0, -1, -1);
    cells.add(1, 3, 7);
    cells.add(2, 3, -1);
    assertThat(cells.first(3, 7)).as("wrapped around").isEqualTo(2);
    cells.remove(1, 3, 7);
    assertThat(cells.next[2]).isZero();
    cells.remove(2, 3, 7);
    assertThat(cells.first(-1, -1)).isZero();
    cells.remove(0, -1, -1);
    assertThat(cells.first(-1, -1)).isEqualTo(Cells.NONE);
  }
}
