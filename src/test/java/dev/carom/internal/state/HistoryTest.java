// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.util.KindNumber;
import java.util.ArrayList;
import java.util.List;
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
    assertThat(history.at(first, 2)).isNull();
    assertThat(history.at(second, 2)).isNull();
    assertThat(history.at(first, 4)).isNull();
    assertThat(history.at(second, 4)).isNull();
    ObstacleTable then = history.at(obstacles, 4, 1, 0, FilterBits.DEFAULT);
    assertThat(then).isEqualTo(obstacles);
    assertThat(then.lines.count()).isEqualTo(3);
    assertThat(then.size()).isEqualTo(1);
    obstacles.remove(third);
    history.note(third, obstacles, 5, 0);
    history.forget(4);
    assertThat(history.at(third, 4)).startsWith(0, 7, 1, 7);
    history.forget(5);
    assertThat(history.at(obstacles, 5, 1, 0, FilterBits.DEFAULT)).isEqualTo(obstacles);
  }

  /** Beside a copy that was made then. */
  @Test
  void allObstaclesAreAsTheyWere() {
    ObstacleTable obstacles = ObstacleTable.empty(ObstacleTable.walls(0, 0, 9, 9));
    int line = obstacles.add(KindNumber.LINE, 1, 2, 3, 4);
    int other = obstacles.add(KindNumber.LINE, 2, 3, 4, 5);
    int peg = obstacles.add(KindNumber.PEG, 5, 6, 1);
    obstacles.setVelocity(other, 3, 4, 0);
    ObstacleHistory history = new ObstacleHistory(obstacles);
    List<Runnable> changes =
        List.of(
            () -> obstacles.move(line, new double[] {2, 2, 4, 4}, 0),
            () -> obstacles.setVelocity(line, 1, 2, 1),
            () -> obstacles.setRestitution(line, 0.5),
            () -> obstacles.setTraits(line, ContactFlags.with(0, ContactFlags.HALT)),
            () -> obstacles.setFilter(line, FilterBits.of(2, 3)),
            () -> obstacles.setFilter(Codes.LEFT, FilterBits.of(4, 5)),
            () -> obstacles.setVelocity(line, 0, 0, 6),
            () -> obstacles.remove(line));
    List<ObstacleTable> past = new ArrayList<>();
    for (Runnable change : changes) {
      change.run();
      history.note(line, obstacles, past.size(), 0);
      past.add(obstacles.copy());
    }
    int added = obstacles.add(KindNumber.PEG, 7, 8, 2);
    history.note(added, obstacles, past.size(), 0);
    past.add(obstacles.copy());
    obstacles.remove(peg);
    history.note(peg, obstacles, past.size(), 0);
    past.add(obstacles.copy());
    for (int k = 0; k < past.size(); k++) {
      long filter = past.get(k).filter(Codes.LEFT);
      ObstacleTable then = history.at(obstacles, k + 0.5, 1, 0, filter);
      assertThat(then).as("after change %s", k).isEqualTo(past.get(k));
    }
  }

  /** A row for each second, from the fourth on in flights that began earlier; eight are kept. */
  @Test
  void changesWithinAFlightHoldFromTheirTimesOn() {
    FlightHistory history = new FlightHistory();
    MovingCircle m = new MovingCircle();
    for (int k = 0; k < 199; k++) {
      m.start(0, 10 * k, 5, 1, 1, 0, 1);
      m.t = k < 3 ? k : k - 1;
      history.add(m, k, PROPERTIES, k - 9);
      assertThat(history.since()).isEqualTo(k);
      for (int past = Math.max(0, k - 8); past <= k; past++) {
        double since = past < 3 ? 0.5 : 1.5;
        assertThat(history.x(past + 0.5, null)).isEqualTo(10 * past + since);
        assertThat(history.find(past)).isEqualTo(history.find(past + 0.5));
      }
    }
    m.start(0, -7, 5, 1, 0, 0, 1);
    m.t = 198;
    history.add(m, 198, PROPERTIES, 0);
    assertThat(history.x(198, null)).as("replaced").isEqualTo(-7);
    assertThat(history.x(197.5, null)).isEqualTo(1970 + 1.5);
    assertThat(history.room()).isGreaterThan(history.newest() + 1);
    history.end(200);
    assertThat(history.room()).isEqualTo(history.newest() + 1);
    assertThat(history.end()).isEqualTo(200);
  }

  @Test
  void propertiesAndNoPredictionAreLoaded() {
    FlightHistory history = new FlightHistory();
    MovingCircle m = new MovingCircle();
    m.start(0, 1, 2, 1, 0, 0, 1);
    CircleProperties larger = new CircleProperties(2, 1, 0.5, 0, 0, false);
    history.add(m, 0, PROPERTIES, 0);
    history.add(m, 3, larger, 0);
    assertThat(history.radius(2.9)).isEqualTo(PROPERTIES.radius());
    assertThat(history.radius(3)).isEqualTo(larger.radius());
    assertThat(history.properties()).isEqualTo(larger);
    MovingCircle then = new MovingCircle();
    then.next = Codes.line(5);
    then.cleared = 9;
    assertThat(history.load(2, then)).isEqualTo(PROPERTIES);
    assertThat(then.x).isEqualTo(1);
    assertThat(then.next).isEqualTo(MovingCircle.NOTHING);
    assertThat(then.cleared).isZero();
  }
}
