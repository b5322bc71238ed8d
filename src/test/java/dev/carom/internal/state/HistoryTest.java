// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What is kept of the past, and what is dropped. */
class HistoryTest {

  private static final CircleProperties PROPERTIES = new CircleProperties(1, 1, 1, 0, 0, false);

  @Test
  void nothingHoldsBeforeTheFirstValue() {
    Changes<Integer> changes = new Changes<>();
    assertThat(changes.isEmpty()).isTrue();
    assertThat(changes.last()).isNull();
    changes.set(5, 50, 0);
    assertThat(changes.isEmpty()).isFalse();
    assertThat(changes.at(Math.nextDown(5.0))).isNull();
    assertThat(changes.at(5)).isEqualTo(50);
  }

  @Test
  void removedCirclesAreForgottenAfterTheTimeThatIsKept() {
    FlightHistories all = new FlightHistories(3);
    MovingCircle m = new MovingCircle();
    for (int id = 3; id < 50; id++) {
      m.start(0, id, 0, 1, 0, 0, 1);
      m.t = id;
      all.of(id).add(m, id, PROPERTIES, 0);
    }
    assertThat(all.get(2)).isNull();
    all.remove(10, 60);
    all.remove(49, 61);
    all.forget(Math.nextDown(60.0));
    assertThat(all.get(10)).isNotNull();
    all.forget(60);
    assertThat(all.get(10)).isNull();
    assertThat(all.get(11).x(60, null)).isEqualTo(11);
    assertThat(all.idsAt(Math.nextDown(61.0))).hasSize(46).contains(3, 9, 11, 49);
    assertThat(all.idsAt(61)).hasSize(45).doesNotContain(49);
    assertThat(all.idsAt(5)).containsExactly(3, 4, 5);
    assertThat(all.idLimitAt(20)).isEqualTo(21);
    all.forget(61);
    assertThat(all.idLimitAt(20)).as("all of it is dropped").isEqualTo(50);
    assertThat(all.idLimitAt(0)).isEqualTo(50);
  }

  @Test
  void aRemovedObstacleIsForgottenAfterTheTimeThatIsKept() {
    ObstacleTable obstacles = ObstacleTable.empty(null);
    int first = obstacles.add(1, 0, 0, 1, 0);
    ObstacleHistory history = new ObstacleHistory(obstacles);
    int second = obstacles.add(1, 0, 5, 1, 5);
    history.note(second, obstacles, 2, 0);
    for (int code : new int[] {first, second}) {
      obstacles.remove(code);
      history.note(code, obstacles, 3, 0);
    }
    int third = obstacles.add(1, 0, 7, 1, 7);
    history.note(third, obstacles, 4, 0);
    assertThat(history.at(second, 1)).isNull();
    history.forget(Math.nextDown(3.0));
    assertThat(history.at(first, 2)).startsWith(0, 0, 1, 0);
    assertThat(history.at(second, 2)).startsWith(0, 5, 1, 5);
    history.forget(3);
    assertThat(history.at(first, 4)).isNull();
    assertThat(history.at(second, 4)).isNull();
    ObstacleTable then = history.at(obstacles, 4, 1, 0, FilterBits.DEFAULT);
    assertThat(then).isEqualTo(obstacles);
    assertThat(then.lines.count()).isEqualTo(3);
    assertThat(then.size()).isEqualTo(1);
  }
}
