// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Filter;
import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.internal.sweep.Contact;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Every copy of a circle's state holds every field of {@link MovingCircle}: a field that is added
 * there and forgotten in one of the copies fails here.
 */
class CircleFieldsTest {

  /** The number of the circle, and its filter, which the registry keeps. */
  private static final Set<String> PASSING = Set.of("id", "filter");

  /** Fields that tell what is ahead; a snapshot leaves them out, and the next search finds them. */
  private static final Set<String> AHEAD =
      Set.of("cleared", "next", "contact", "sensedCode", "lookahead");

  /** Only an awake member of those in contact has them. */
  private static final Set<String> MOMENTUM = Set.of("px", "py", "ax", "ay");

  private static Map<String, Object> fields(MovingCircle m) throws IllegalAccessException {
    Map<String, Object> values = new LinkedHashMap<>();
    for (Field field : MovingCircle.class.getDeclaredFields()) {
      if (!Modifier.isStatic(field.getModifiers()) && !PASSING.contains(field.getName())) {
        values.put(field.getName(), field.get(m));
      }
    }
    return values;
  }

  private static Map<String, Object> without(Map<String, Object> values, Set<String> names) {
    Map<String, Object> left = new LinkedHashMap<>(values);
    left.keySet().removeAll(names);
    return left;
  }

  /** A circle like no other, so that what a copy leaves out shows. */
  private static MovingCircle filled(int base) throws IllegalAccessException {
    MovingCircle m = new MovingCircle();
    int next = base;
    for (Field field : MovingCircle.class.getDeclaredFields()) {
      if (!Modifier.isStatic(field.getModifiers()) && !PASSING.contains(field.getName())) {
        set(m, field, next++);
      }
    }
    m.mode = MovingCircle.ALONE;
    m.contactRow = null;
    m.contact = Contact.END;
    return m;
  }

  private static void set(MovingCircle m, Field field, int value) throws IllegalAccessException {
    if (field.getType() == double.class) {
      field.setDouble(m, value + 0.5);
    } else if (field.getType() == int.class) {
      field.setInt(m, value);
    } else if (field.getType() == boolean.class) {
      field.setBoolean(m, true);
    } else if (field.getType() == double[].class) {
      double[] row = new double[ContactRow.SIZE];
      row[ContactRow.END] = value;
      field.set(m, row);
    } else {
      field.set(m, IgnoreList.with(null, value));
    }
  }

  /** What a copy of a circle returns, loaded over one whose fields are all others. */
  private interface Copy {
    void copy(MovingCircle from, MovingCircle to);
  }

  /** Some fields exclude each other, so each is tried alone, on a circle that flies freely. */
  private static void assertHeld(Set<String> excepted, Copy copy) throws IllegalAccessException {
    int held = 0;
    for (Field field : MovingCircle.class.getDeclaredFields()) {
      String name = field.getName();
      if (Modifier.isStatic(field.getModifiers())
          || PASSING.contains(name)
          || excepted.contains(name)) {
        continue;
      }
      MovingCircle m = new MovingCircle();
      m.start(0, 1, 2, 3, 4, 5, 0.5);
      Object before = field.get(m);
      boolean isSmall = Set.of("contact", "mode").contains(name);
      set(m, field, isSmall ? 1 : 70);
      if (MOMENTUM.contains(name)) {
        m.mode = MovingCircle.AWAKE;
      } else if (name.equals("contactRow")) {
        m.mode = MovingCircle.FROZEN;
      }
      if (name.equals("contact")) {
        m.next = 7; // only an impact has a contact
      }
      if (name.equals("sensedHead") || name.equals("sensedTail")) {
        m.sensedPartner = 7; // only a contact with another circle has a time
      }
      assertThat(field.get(m)).as(name).isNotEqualTo(before);
      MovingCircle loaded = filled(200);
      copy.copy(m, loaded);
      Set<String> unheld = new HashSet<>(excepted);
      unheld.addAll(m.mode == MovingCircle.AWAKE ? Set.of() : MOMENTUM);
      assertThat(without(fields(loaded), unheld)).as(name).isEqualTo(without(fields(m), unheld));
      held++;
    }
    assertThat(held).isGreaterThan(15);
  }

  private static CircleTable falling(CircleTable circles) {
    circles.allowGravity();
    return circles;
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void theTableHoldsThem(boolean collide) throws IllegalAccessException {
    CircleTable circles = falling(collide ? CircleTable.colliding(3) : new CircleTable(3));
    assertHeld(
        Set.of(),
        (from, to) -> {
          circles.put(1, from);
          circles.load(1, to);
        });
  }

  /** A collision reads neither the prediction nor the thing hit last, which it sets. */
  @Test
  void theTableHoldsThemForAMeeting() throws IllegalAccessException {
    CircleTable circles = falling(CircleTable.colliding(3));
    assertHeld(
        Set.of("cleared", "next", "contact", "sensedCode", "lookahead", "last"),
        (from, to) -> {
          circles.put(1, from);
          circles.loadForMeeting(circles.state, circles.codes, 1, to);
        });
  }

  @Test
  void theTableReadsTheFilterFromTheRegistry() {
    Scene scene =
        Scene.builder()
            .collide(false)
            .circle(0, 0, 1, 0, 0)
            .circle(9, 0, 1, 0, 0)
            .filter(new Filter(6, 5))
            .build();
    CircleTable circles = CircleTable.colliding(2);
    MovingCircle m = circles.body;
    circles.load(1, m);
    assertThat(m.filter).isEqualTo(FilterBits.DEFAULT);
    CircleRegistry registry = new CircleRegistry(Internals.data(scene), 1);
    circles.setFilters(registry, ObstacleTable.of(Internals.data(scene)));
    circles.load(1, m);
    assertThat(m.filter).isEqualTo(FilterBits.of(6, 5));
    circles.loadForMeeting(circles.state, circles.codes, 0, m);
    assertThat(m.filter).isEqualTo(FilterBits.DEFAULT);
    circles.loadForMeeting(circles.state, circles.codes, 1, m);
    assertThat(m.filter).isEqualTo(FilterBits.of(6, 5));
  }

  /** Its restitution is not that of a flight, and stays. */
  @Test
  void theTableTakesOverANewFlight() throws IllegalAccessException {
    CircleTable circles = falling(CircleTable.colliding(3));
    assertHeld(
        Set.of("cleared", "next", "contact", "sensedCode", "restitution"),
        (from, to) -> {
          circles.storeNewFlight(circles.state, circles.codes, 1, from);
          circles.load(1, to);
        });
  }

  @Test
  void theUndoLogPutsThemBack() throws IllegalAccessException {
    CircleTable circles = falling(new CircleTable(3));
    assertHeld(
        Set.of(),
        (from, to) -> {
          UndoLog undoLog = new UndoLog(1);
          from.id = 2;
          undoLog.save(from);
          circles.storeAndSetDue(2, to);
          undoLog.restore(circles);
          circles.load(2, to);
          assertThat(circles.due.get(2)).isEqualTo(from.due());
        });
  }

  /** Each number of a recorded flight changes one of the answers. */
  @Test
  void aTimelineHoldsTheFlight() throws IllegalAccessException {
    MovingCircle m = filled(1);
    double[] answers = answers(m);
    for (String name : new String[] {"x", "y", "vx", "vy", "t", "tl", "radius"}) {
      MovingCircle other = filled(1);
      Field field =
          Arrays.stream(MovingCircle.class.getDeclaredFields())
              .filter(f -> f.getName().equals(name))
              .findAny()
              .orElseThrow();
      field.setDouble(other, field.getDouble(other) + 0.25);
      assertThat(answers(other)).as(name).isNotEqualTo(answers);
    }
  }

  private static FlightHistory history(MovingCircle m) {
    CircleProperties properties =
        new CircleProperties(m.radius, 1, m.restitution, 0, m.filter, true);
    FlightHistory history = new FlightHistory();
    history.add(m, m.t, properties, 0);
    if (m.contactRow != null) {
      history.keepContact(m.t, m.contactRow, 0);
    }
    return history;
  }

  /** Where the clock is too coarse for a flight, walls keep it inside: also a point. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5})
  void aTimelineTellsWhomWallsConfine(double radius) {
    double[] walls = ObstacleTable.walls(0, 0, 10, 10);
    MovingCircle m = new MovingCircle();
    m.start(0, 5, 5, radius, 1, 2, 1);
    FlightHistory past = new FlightHistory();
    past.add(m, 0, new CircleProperties(radius, 1, 1, 0, 0, true), 0);
    past.add(m, 60, new CircleProperties(radius, 1, 1, 0, 0, false), 0);
    assertThat(new double[] {past.x(50, walls), past.y(50, walls), past.radius(50)})
        .containsExactly(10 - radius, 10 - radius, radius);
    assertThat(new double[] {past.x(60, walls), past.y(60, walls), past.radius(60)})
        .containsExactly(65, 125, radius);
  }

  @Test
  void aTimelineHoldsThem() throws IllegalAccessException {
    assertHeld(AHEAD, (from, to) -> history(from).load(Math.max(50, from.t), to));
  }

  private static double[] answers(MovingCircle m) {
    FlightHistory history = history(m);
    int k = history.find(50);
    return new double[] {
      history.x(50, null),
      history.y(50, null),
      history.rows.vx(k, 50),
      history.rows.vy(k, 50),
      history.radius(50)
    };
  }
}
