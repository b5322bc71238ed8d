// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Kind.CIRCLE;
import static dev.carom.Kind.LINE;
import static dev.carom.Kind.PEG;
import static dev.carom.Kind.WALL;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigInteger;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Contents of a snapshot, and the return to it. */
class SnapshotTest {

  private static SceneBuilder box(boolean collide) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 100, 100).collide(collide);
    builder.line(20, 20, 40, 40).oneWay().line(60, 20, 80, 30).peg(50, 70, 5);
    return builder.circle(10, 50, 3, 4, 1).circle(90, 50, 2, -3, 2).circle(50, 50, 4, 1, 1);
  }

  static World world(boolean collide) {
    return new World(box(collide).build());
  }

  /** Edits, each of which changes something, alone and after those before it. */
  static Stream<Consumer<World>> changes() {
    return Stream.of(
        w -> w.step(1),
        w -> w.setVelocity(0, 4, 2),
        w -> w.setVelocity(0, 4, 1), // the same one: a new flight begins
        w -> w.setPosition(1, 80, 50),
        w -> w.setShape(Kind.CIRCLE, 1, new Circle(w.x(1), w.y(1), 2.5)),
        w -> w.setTraits(Kind.CIRCLE, 1, w.traits(Kind.CIRCLE, 1).withMass(2)),
        w -> w.setTraits(CIRCLE, 2, w.traits(CIRCLE, 2).withMass(Double.POSITIVE_INFINITY)),
        w -> w.setTraits(CIRCLE, 1, w.traits(CIRCLE, 1).withRestitution(0.5)),
        w -> w.setTraits(WALL, 2, w.traits(WALL, 2).withRestitution(0.5)),
        w -> w.setTraits(LINE, 1, w.traits(LINE, 1).withRestitution(0.5)),
        w -> w.setTraits(PEG, 0, w.traits(PEG, 0).withRestitution(0.5)),
        w -> w.setTraits(CIRCLE, 1, w.traits(CIRCLE, 1).withResponse(Response.HALT)),
        w -> w.setTraits(WALL, 1, w.traits(WALL, 1).withResponse(Response.HALT)),
        w -> w.setTraits(LINE, 1, w.traits(LINE, 1).withResponse(Response.HALT)),
        w -> w.setTraits(PEG, 0, w.traits(PEG, 0).withResponse(Response.SENSOR)),
        w -> w.setTraits(CIRCLE, 1, w.traits(CIRCLE, 1).withFilter(new Filter(2, 3))),
        w -> w.setTraits(WALL, 1, w.traits(WALL, 1).withFilter(new Filter(2, 3))),
        w -> w.setTraits(LINE, 1, w.traits(LINE, 1).withFilter(new Filter(2, 3))),
        w -> w.setTraits(PEG, 0, w.traits(PEG, 0).withFilter(new Filter(2, 3))),
        w -> w.setVelocity(LINE, 1, 0, 1),
        w -> w.setVelocity(PEG, 0, 1, 0),
        w -> w.setTraits(Kind.LINE, 0, w.traits(Kind.LINE, 0).withOneWay(false)),
        w -> w.setTraits(Kind.LINE, 1, w.traits(Kind.LINE, 1).withOneWay(true)),
        w -> w.setShape(Kind.LINE, 1, new Line(60, 20, 80, 31)),
        w -> w.setShape(Kind.PEG, 0, new Circle(50, 70, 4)),
        w -> w.addLine(1, 1, 2, 2, Traits.DEFAULT),
        w -> w.addPeg(1, 1, 0, Traits.DEFAULT),
        w -> w.addCircle(5, 5, 1, 0, 0, Traits.DEFAULT),
        w -> {
          // Back again, but a radius that was fine before is refused now.
          w.setShape(Kind.LINE, 1, new Line(1e9, 20, 80, 30));
          w.setShape(Kind.LINE, 1, new Line(60, 20, 80, 30));
        },
        w -> w.remove(LINE, 1),
        w -> w.remove(PEG, 0),
        w -> w.remove(CIRCLE, 1));
  }

  @ParameterizedTest
  @MethodSource("changes")
  void anyChangeMakesItAnother(Consumer<World> change) {
    for (boolean collide : new boolean[] {false, true}) {
      World one = world(collide);
      World two = world(collide);
      one.step(2.5);
      two.step(2.5);
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

  @CollidingOrNot
  void whoWasRemovedDetermineNothing(boolean collide) {
    World one = world(collide);
    World two = world(collide);
    one.remove(CIRCLE, one.addCircle(80, 15, 2, 3, 4, Traits.DEFAULT));
    int id = two.addCircle(80, 15, 2, -5, 1, Traits.DEFAULT);
    two.setTraits(Kind.CIRCLE, id, two.traits(Kind.CIRCLE, id).withMass(7));
    two.remove(CIRCLE, id);
    assertThat(one.snapshot()).isEqualTo(two.snapshot()).hasSameHashCodeAs(two.snapshot());
  }

  @CollidingOrNot
  void aRestoredWorldGoesOnAsTheOneItWasTakenFrom(boolean collide) {
    World one = world(collide);
    one.step(7);
    one.setVelocity(0, 5, -3);
    one.addCircle(50, 20, 2, -1, 3, Traits.DEFAULT);
    one.remove(LINE, 0);
    one.step(3);
    Snapshot snapshot = one.snapshot();
    assertThat(snapshot.now()).isEqualTo(10);
    assertThat(snapshot).hasToString("Snapshot[now=10.0, circles=4, lines and pegs=2]");
    Run on = Run.step(one, 1, 50);
    assertThat(on.impacts()).hasSizeGreaterThan(10);
    World other = world(collide);
    other.step(33);
    for (World world : List.of(one, other)) {
      world.restore(snapshot);
      assertThat(world.now()).isEqualTo(10);
      assertThat(world.impacts().size()).isZero();
      assertThat(world.contains(LINE, 0)).isFalse();
      assertThat(world.count(Kind.CIRCLE)).isEqualTo(4);
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

  @Test
  void theHashIsThatOfTheWrittenBytes() throws NoSuchAlgorithmException {
    World world = world(true);
    world.step(7);
    byte[] written = SnapshotBytes.of(world.snapshot());
    byte[] digest = MessageDigest.getInstance("SHA-256").digest(written);
    long first8 = new BigInteger(1, Arrays.copyOf(digest, 8)).longValue();
    assertThat(world.snapshot().hash64()).isEqualTo(first8);
    assertThat(Long.toHexString(first8)).as("on any machine").isEqualTo("7c1ac6469a2ed7f0");
  }
}
