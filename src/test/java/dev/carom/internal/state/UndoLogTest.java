// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.sweep.Contact;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class UndoLogTest {

  private final CircleTable circles = new CircleTable(4);
  private final UndoLog undoLog = new UndoLog(1);

  @BeforeEach
  void fill() {
    for (int i = 0; i < circles.count; i++) {
      store(i, 100 * i, i == 1 ? IgnoreList.with(null, 7) : null);
    }
  }

  /** A circle of which each number is another one. */
  private void store(int i, int base, IgnoreList jam) {
    MovingCircle m = circles.body;
    m.start(i, base + 1, base + 2, base + 3, base + 4, base + 5, 0.5);
    m.t = base + 6;
    m.tl = 0x1p-60;
    m.cleared = base + 7;
    m.last = base + 10;
    m.next = base + 11;
    m.contact = Contact.END;
    m.lookahead = base + 12;
    m.stuck = base + 13;
    m.speedExponent = base + 14;
    m.turn = base % 3 - 1;
    m.pushed = base % 2 == 0;
    m.jam = jam;
    circles.storeAndSetDue(i);
  }

  private void save(int i) {
    circles.load(i);
    undoLog.save(circles.body);
  }

  private record Stored(
      List<Double> state, List<Integer> codes, List<Double> due, List<Optional<IgnoreList>> jams) {

    static Stored of(CircleTable c) {
      List<Double> due = new ArrayList<>();
      List<Optional<IgnoreList>> jams = new ArrayList<>();
      for (int i = 0; i < c.count; i++) {
        due.add(c.due.get(i));
        jams.add(Optional.ofNullable(c.jam(i)));
      }
      return new Stored(
          Arrays.stream(c.state).boxed().toList(),
          Arrays.stream(c.codes).boxed().toList(),
          due,
          jams);
    }
  }

  private void changeAll() {
    for (int i = 0; i < circles.count; i++) {
      double radius = circles.radius(i);
      store(i, 5000 + 100 * i, i == 0 ? IgnoreList.with(null, 8) : null);
      circles.state[circles.at(i) + FlightRow.RADIUS] = radius;
    }
  }

  @Test
  void whatWasNotedIsPutBack() {
    Stored before = Stored.of(circles);
    for (int i = 0; i < circles.count; i++) {
      save(i);
    }
    changeAll();
    assertThat(Stored.of(circles)).isNotEqualTo(before);
    undoLog.restore(circles);
    assertThat(Stored.of(circles)).isEqualTo(before);
  }

  @Test
  void othersStayAsTheyAre() {
    save(2);
    changeAll();
    Stored changed = Stored.of(circles);
    undoLog.restore(circles);
    for (int i : new int[] {0, 1, 3}) {
      assertThat(circles.x(i, 0)).isEqualTo(changed.state.get(circles.at(i)));
      assertThat(circles.due.get(i)).isEqualTo(changed.due.get(i));
    }
    assertThat(circles.vx(2, 0)).isEqualTo(204);
  }

  /** One that was noted before there was any jam, after one that was jammed in an earlier step. */
  @Test
  void aJamIsPutBackOrTakenAway() {
    save(1);
    undoLog.clear();
    save(3);
    save(1);
    store(3, 300, IgnoreList.with(null, 9));
    store(1, 100, null);
    undoLog.restore(circles);
    assertThat(circles.jam(3)).isNull();
    assertThat(circles.jam(1)).isEqualTo(IgnoreList.with(null, 7));
  }

  @Test
  void whatWasClearedOrPutBackIsForgotten() {
    save(0);
    undoLog.clear();
    save(1);
    undoLog.restore(circles);
    changeAll();
    Stored changed = Stored.of(circles);
    undoLog.restore(circles);
    assertThat(Stored.of(circles)).isEqualTo(changed);
  }
}
