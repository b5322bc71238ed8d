// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.ObstacleKind.CIRCLE;
import static dev.carom.ObstacleKind.LINE;
import static dev.carom.ObstacleKind.PEG;
import static dev.carom.ObstacleKind.WALL;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.FlightTable;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.WorldState;
import java.math.BigInteger;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Contents of a snapshot, and the return to it. */
class SnapshotTest {

  private static SceneBuilder box(boolean collide) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 100, 100).collide(collide);
    builder.line(20, 20, 40, 40).oneWay().line(60, 20, 80, 30).peg(50, 70, 5);
    return builder.circle(10, 50, 3, 4, 1).circle(90, 50, 2, -3, 2).circle(50, 50, 4, 1, 1);
  }

  private static World world(boolean collide) {
    return new World(box(collide).build());
  }

  static Stream<Consumer<World>> changes() {
    return Stream.of(
        w -> w.step(1),
        w -> w.setVelocity(0, 4, 2),
        w -> w.setVelocity(0, 4, 1), // the same one: a new flight begins
        w -> w.setPosition(1, 80, 50),
        w -> w.setRadius(1, 2.5),
        w -> w.setMass(1, 2),
        w -> w.setRestitution(CIRCLE, 1, 0.5),
        w -> w.setRestitution(WALL, 2, 0.5),
        w -> w.setRestitution(LINE, 1, 0.5),
        w -> w.setRestitution(PEG, 0, 0.5),
        w -> w.setResponse(CIRCLE, 1, Response.HALT),
        w -> w.setResponse(WALL, 1, Response.HALT),
        w -> w.setResponse(LINE, 1, Response.HALT),
        w -> w.setResponse(PEG, 0, Response.SENSOR),
        w -> w.setFilter(CIRCLE, 1, 2, 3),
        w -> w.setFilter(WALL, 1, 2, 3),
        w -> w.setFilter(LINE, 1, 2, 3),
        w -> w.setFilter(PEG, 0, 2, 3),
        w -> w.setVelocity(LINE, 1, 0, 1),
        w -> w.setVelocity(PEG, 0, 1, 0),
        w -> w.setOneWay(0, false),
        w -> w.setOneWay(1, true),
        w -> w.moveLine(1, 60, 20, 80, 31),
        w -> w.movePeg(0, 50, 70, 4),
        w -> w.addLine(1, 1, 2, 2),
        w -> w.addPeg(1, 1, 0),
        w -> w.addCircle(5, 5, 1, 0, 0),
        w -> w.remove(LINE, 1),
        w -> w.remove(PEG, 0),
        w -> w.remove(CIRCLE, 1),
        w -> {
          // Back again, but a radius that was fine before is refused now.
          w.moveLine(1, 1e9, 20, 80, 30);
          w.moveLine(1, 60, 20, 80, 30);
        });
  }

  @ParameterizedTest
  @MethodSource("changes")
  void anyChangeMakesItAnother(Consumer<World> change) {
    for (boolean collide : new boolean[] {false, true}) {
      World one = world(collide);
      World two = world(collide);
      Run.step(one, 2.5);
      Run.step(two, 2.5);
      Snapshot before = one.snapshot();
      assertThat(before).isEqualTo(two.snapshot()).hasSameHashCodeAs(two.snapshot());
      change.accept(one);
      assertThat(one.snapshot()).isNotEqualTo(before);
      assertThat(one.snapshot().hash64()).isNotEqualTo(before.hash64());
      assertThat(two.snapshot()).as("what was taken before").isEqualTo(before);
      change.accept(two);
      assertThat(one.snapshot()).isEqualTo(two.snapshot());
      assertThat(one.snapshot().hash64()).isEqualTo(two.snapshot().hash64());
      one.restore(before);
      assertThat(one.snapshot()).isEqualTo(before);
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void whoWasRemovedDetermineNothing(boolean collide) {
    World one = world(collide);
    World two = world(collide);
    one.remove(CIRCLE, one.addCircle(80, 15, 2, 3, 4));
    int id = two.addCircle(80, 15, 2, -5, 1);
    two.setMass(id, 7);
    two.remove(CIRCLE, id);
    assertThat(one.snapshot()).isEqualTo(two.snapshot()).hasSameHashCodeAs(two.snapshot());
  }

  @ParameterizedTest
  @CsvSource({"false, 0", "true, 0", "false, -0.5", "true, -0.5"})
  void howARunWasCutIntoStepsDoesNotShow(boolean collide, double gravity) {
    SceneBuilder builder = box(collide).gravity(0, gravity).peg(80, 80, 3).response(Response.HALT);
    builder.line(10, 40, 90, 60).response(Response.SENSOR).peg(20, 80, 3).response(Response.SENSOR);
    Scene scene = builder.build();
    // Cells so small that a search goes only as far as a step needs.
    World one = new World(scene, EngineOptions.cells(0.25));
    World two = new World(scene, EngineOptions.cells(0.25));
    for (int i = 10; i <= 100; i += 10) {
      Run.to(one, i);
      for (int k = 99; k >= 0; k--) {
        Run.to(two, i - k / 10.0);
      }
      assertThat(two.snapshot()).isEqualTo(one.snapshot());
      World restored = new World(scene);
      restored.restore(one.snapshot());
      assertThat(restored.snapshot()).isEqualTo(one.snapshot());
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aRestoredWorldGoesOnAsTheOneItWasTakenFrom(boolean collide) {
    World one = world(collide);
    Run.step(one, 7);
    one.setVelocity(0, 5, -3);
    one.addCircle(50, 20, 2, -1, 3);
    one.remove(LINE, 0);
    Run.step(one, 3);
    Snapshot snapshot = one.snapshot();
    assertThat(snapshot.now()).isEqualTo(10);
    assertThat(snapshot).hasToString("Snapshot[now=10.0, circles=4, lines and pegs=2]");
    Run on = Run.step(one, 1, 50);
    assertThat(on.impacts()).hasSizeGreaterThan(10);
    World other = world(collide);
    Run.step(other, 33);
    for (World world : List.of(one, other)) {
      world.restore(snapshot);
      assertThat(world.now()).isEqualTo(10);
      assertThat(world.impacts().size()).isZero();
      assertThat(world.contains(LINE, 0)).isFalse();
      assertThat(world.circleCount()).isEqualTo(4);
      assertThat(Run.step(world, 1, 50)).isEqualTo(on);
    }
  }

  @Test
  void anotherBoxIsRefused() {
    Snapshot snapshot = world(false).snapshot();
    World other = new World(Scene.builder().bounds(0, 0, 50, 50).circle(9, 9, 1, 1, 1).build());
    Snapshot before = other.snapshot();
    assertThatThrownBy(() -> other.restore(snapshot))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "bounds of the snapshot is %s: expected this world's, %s"
                .formatted(new Bounds(0, 0, 100, 100), new Bounds(0, 0, 50, 50)));
    assertThat(other.snapshot()).isEqualTo(before);
    World open = new World(Scene.builder().circle(9, 9, 1, 1, 1).build());
    assertThatThrownBy(() -> open.restore(snapshot)).hasMessageEndingWith("this world's, none");
  }

  @Test
  void aWorldThatCollidesOtherwiseIsRefused() {
    Snapshot snapshot = world(false).snapshot();
    assertThatThrownBy(() -> world(true).restore(snapshot))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("collide of the snapshot is false: expected this world's, true");
  }

  // Sensors: each entry is reported once, whenever it was saved.

  private static World sensors() {
    return new World(
        Scene.builder()
            .collide(true)
            .line(50, 0, 50, 100)
            .response(Response.SENSOR)
            .line(50, 100, 50, 0)
            .response(Response.SENSOR)
            .peg(60, 50, 5)
            .response(Response.SENSOR)
            .circle(10, 50, 5, 5, 0)
            .circle(90, 50, 5, -5, 0)
            .response(Response.SENSOR)
            .circle(90, 45, 5, -5, 0)
            .response(Response.SENSOR)
            .build());
  }

  @Test
  void eachEntryIsReportedOnceWhereverTheRunIsSaved() {
    List<Run.Row> expected = Run.advance(sensors(), 20).impacts();
    assertThat(expected).hasSizeGreaterThan(8);
    for (Run.Row row : expected) {
      for (double at : new double[] {Math.nextDown(row.time()), row.time(), row.time() + 1e-9}) {
        World world = sensors();
        List<Run.Row> rows = new ArrayList<>(Run.advance(world, at).impacts());
        World other = sensors();
        other.restore(world.snapshot());
        rows.addAll(Run.advance(other, 20).impacts());
        assertThat(rows).isEqualTo(expected);
      }
    }
  }

  /** The first of two sensors at one place was found ahead, and removed before it was met. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void theOtherSensorIsReportedWhenOneWasRemoved(boolean collide) {
    SceneBuilder setup = Scene.builder().collide(collide);
    setup.line(50, 0, 50, 100).response(Response.SENSOR);
    setup.line(50, 100, 50, 0).response(Response.SENSOR).circle(10, 50, 5, 5, 0);
    World world = new World(setup.build());
    Run.step(world, 6);
    world.remove(LINE, 0);
    World other = new World(world.scene());
    other.restore(world.snapshot());
    assertThat(Run.advance(world, 20).impacts()).extracting(Run.Row::obstacle).containsExactly(1);
    assertThat(Run.advance(other, 20).impacts()).extracting(Run.Row::obstacle).containsExactly(1);
  }

  @Test
  void anotherPlaceMakesAnotherHashCode() {
    World world = new World(Scene.builder().circle(0, 0, 1, 1, 0).build());
    Snapshot before = world.snapshot();
    world.setPosition(0, 5, 0);
    assertThat(world.snapshot()).doesNotHaveSameHashCodeAs(before);
  }

  /** Each number of a circle counts, also one that no edit sets. */
  @Test
  void anotherNumberMakesAnotherHash() {
    World world = world(true);
    Run.step(world, 2.5);
    Snapshot snapshot = world.snapshot();
    long before = snapshot.hash64();
    FlightTable flights = snapshot.state.flights();
    for (int k = 0; k < flights.state.length; k++) {
      double number = flights.state[k];
      flights.state[k] = Math.nextUp(number);
      assertThat(snapshot.hash64()).as("number %s", k).isNotEqualTo(before);
      flights.state[k] = number;
    }
    for (int k = 0; k < flights.codes.length; k++) {
      flights.codes[k]++;
      assertThat(snapshot.hash64()).as("code %s", k).isNotEqualTo(before);
      flights.codes[k]--;
    }
    WorldState s = snapshot.state;
    WorldState other =
        new WorldState(
            s.now(),
            s.collide(),
            s.obstacles(),
            s.registry(),
            s.limits(),
            flights,
            Double.MIN_VALUE,
            s.gx(),
            s.gy());
    assertThat(new Snapshot(other).hash64()).as("tail of an edit").isNotEqualTo(before);
    flights.jams = new IgnoreList[] {IgnoreList.with(null, 5), null, null};
    assertThat(snapshot.hash64()).as("a jam").isNotEqualTo(before);
    flights.jams = null;
    assertThat(snapshot.hash64()).isEqualTo(before);
  }

  @Test
  void theHashIsThatOfTheWrittenBytes() throws NoSuchAlgorithmException {
    World world = world(true);
    Run.step(world, 7);
    byte[] written = SnapshotBytes.of(world.snapshot());
    byte[] digest = MessageDigest.getInstance("SHA-256").digest(written);
    long first8 = new BigInteger(1, Arrays.copyOf(digest, 8)).longValue();
    assertThat(world.snapshot().hash64()).isEqualTo(first8);
    assertThat(Long.toHexString(first8)).as("on any machine").isEqualTo("5fcce30d9e5cc78e");
  }
}
