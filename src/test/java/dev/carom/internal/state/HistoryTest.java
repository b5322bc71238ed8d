// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What is kept of the past, and what is dropped. */
class HistoryTest {

  private static final CircleProperties PROPERTIES = new CircleProperties(1, 1, 0, 0, false);

  /** One more value in each unit of time, of which the last ten are kept. */
  private static Changes<Integer> changes(int end) {
    Changes<Integer> changes = new Changes<>();
    for (int i = 0; i < end; i++) {
      changes.set(i, i, i - 10);
    }
    return changes;
  }

  @Test
  void aValueHoldsUntilTheNextOne() {
    Changes<Integer> changes = changes(1000);
    for (int t = 990; t < 1000; t++) {
      assertThat(changes.at(t)).isEqualTo(t);
      assertThat(changes.at(Math.nextUp(t - 1.0))).isEqualTo(t - 1);
      assertThat(changes.at(t + 0.5)).isEqualTo(t);
    }
    assertThat(changes.at(1e9)).isEqualTo(999);
    assertThat(changes.last()).isEqualTo(999);
    assertThat(changes.since()).isEqualTo(999);
  }

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
  void anotherValueFromTheSameTimeReplacesTheFirst() {
    Changes<Integer> changes = changes(4);
    changes.set(3, 30, 0);
    changes.set(4, 40, 0);
    assertThat(changes.at(3)).isEqualTo(30);
    assertThat(changes.at(4)).isEqualTo(40);
    assertThat(changes.room()).isEqualTo(8);
    for (int i = 5; i < 8; i++) {
      changes.set(i, i, 0);
    }
    assertThat(changes.room()).as("eight values").isEqualTo(8);
  }

  /** Eleven are needed at the most: there is room for the next power of two, doubled once. */
  @Test
  void theRoomIsThatOfTheTimeThatIsKept() {
    assertThat(changes(16).room()).isEqualTo(16);
    assertThat(changes(1000).room()).isEqualTo(changes(1_000_000).room()).isBetween(16, 32);
    assertThat(changes(1000).start()).isBetween(960.0, 989.0);
  }

  private static FlightHistory flights(int end) {
    FlightHistory history = new FlightHistory();
    MovingCircle m = new MovingCircle();
    for (int i = 0; i < end; i++) {
      m.start(0, 2 * i, 0, 1, 2, 0, 1);
      m.gy = i % 2; // so that all rows have the columns of gravity, too
      m.t = i;
      history.add(m, i, PROPERTIES, i - 10);
    }
    return history;
  }

  @Test
  void flightsAreDroppedLikewise() {
    FlightHistory history = flights(1001);
    assertThat(history.room()).isBetween(16, 32);
    for (int t = 991; t <= 1000; t++) {
      assertThat(history.x(t + 0.25, null)).isEqualTo(2 * t + 0.5);
      assertThat(history.rows.gy(history.find(t))).isEqualTo(t % 2);
    }
  }

  @Test
  void anEndedHistoryHasNoRoomLeft() {
    FlightHistory history = flights(100);
    double start = history.start();
    history.end(100);
    assertThat(history.room()).isEqualTo((int) (100 - start));
    assertThat(history.start()).isEqualTo(start);
    assertThat(history.end()).isEqualTo(100);
    assertThat(history.x(95.5, null)).isEqualTo(191);
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
    ObstacleTable then = history.at(4, 1, 0, Filter.DEFAULT);
    assertThat(then).isEqualTo(obstacles);
    assertThat(then.lines.count()).isEqualTo(3);
    assertThat(then.size()).isEqualTo(1);
  }
}
