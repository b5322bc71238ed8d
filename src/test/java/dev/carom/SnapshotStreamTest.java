// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactRow;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.SizeLimits;
import dev.carom.internal.util.KindNumber;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Random;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Snapshots as bytes: whole ones are read back, all others refused. */
class SnapshotStreamTest {

  /** Before the columns of the first pair of a circle in contact. */
  private static final String PAIR = "pair ";

  // Where things stand in the stream of small(), in bytes.
  private static final int VERSION = 8;
  private static final int NOW = 12;
  private static final int LARGEST = 21;
  private static final int LEAST = 29;
  private static final int XMAX = 46;
  private static final int BOUNDS_E = 70;
  private static final int BOUNDS_TRAITS = 78;
  private static final int LINES = 87;
  private static final int LINE_AX = 92;
  private static final int LINE_E = LINE_AX + 32;
  private static final int PEGS = LINE_AX + 45;
  private static final int PEG_RADIUS = PEGS + 21;
  private static final int MOTIONS = PEGS + 38;
  private static final int CIRCLES = MOTIONS + 4;
  private static final int ID = CIRCLES + 8;
  private static final int TRAITS = ID + 8;
  private static final int MASS = TRAITS + 1;
  private static final int FLIGHT = TRAITS + 2 * 9 + 1;
  private static final int LAST = FLIGHT + 2 * 9 * 8 + 3;
  private static final int STUCK = LAST + 16;
  private static final int WORD = LAST + 8;
  private static final int TAIL_OF_EDIT = LAST + 2 * 5 * 4 + 2;

  private static Snapshot read(byte[] bytes) throws IOException {
    return Snapshot.read(new ByteArrayInputStream(bytes));
  }

  private static byte[] small() {
    return small(0);
  }

  /** A line and a peg that move with a velocity, and two circles. */
  private static byte[] small(double velocity) {
    SceneBuilder scene = Scene.builder().collide(false).bounds(0, 0, 100, 100);
    scene.line(10, 20, 30, 40).velocity(velocity, 0).peg(50, 50, 5).velocity(0, velocity);
    World world = new World(scene.circle(70, 70, 3, 1, -2).circle(20, 80, 3, 1, -2).build());
    world.step(40);
    return SnapshotBytes.of(world.snapshot());
  }

  @Test
  void theBytesAreThoseOfTheJavadoc() throws IOException {
    int rest = size(room());
    int circle = size(room().circle(50, 50, 5, 1, 2)) - rest;
    int line = size(room().line(10, 20, 30, 40)) - rest;
    int peg = size(room().peg(50, 50, 5)) - rest;
    int moving = size(room().line(10, 20, 30, 40).velocity(1, 0)) - rest - line;
    int falling = size(room().gravity(0, -1).circle(50, 50, 5, 1, 2)) - rest - circle;
    int open = size(Scene.builder());
    assertThat(size(room().peg(50, 50, 5).velocity(1, 0)) - rest - peg).isEqualTo(moving);
    assertThat(Files.readString(Path.of("main/java/dev/carom/Snapshot.java")))
        .contains(circle + " bytes a circle", line + " a line, " + peg + " a peg")
        .contains(moving + " more for each line or peg that moves")
        .contains(rest + " for the rest, " + open + " without bounds")
        .contains("falls, slides or rests, all take " + falling + " more")
        .contains("in the present flight of any, all take " + sensed() / 2 + " more");
    String recipes = "main/javadoc/dev.carom/dev/carom/doc-files/recipes.html";
    assertThat(Files.readString(Path.of(recipes)))
        .contains(
            String.format(
                Locale.ROOT, "takes %,d bytes: %d a circle", 1000 * circle + rest, circle))
        .contains(
            String.format(
                Locale.ROOT,
                "%,d: %d a circle",
                1000 * (circle + falling) + rest,
                circle + falling));
  }

  /** How many bytes more two circles take once one of them is a sensor that reported the other. */
  private static int sensed() {
    SceneBuilder scene = room().collide(true).circle(20, 50, 3, 4, 0);
    World world = new World(scene.circle(50, 50, 3, 0, 0).response(Response.SENSOR).build());
    int before = SnapshotBytes.of(world.snapshot()).length;
    world.step(7);
    assertThat(world.impacts().size()).isOne();
    return SnapshotBytes.of(world.snapshot()).length - before;
  }

  @CollidingOrNot
  void aLineOrPegThatWasRemovedTakesAByteAndACircleNone(boolean collide) throws IOException {
    World world = new World(room().collide(collide).circle(50, 50, 5, 1, 2).build());
    int before = SnapshotBytes.of(world.snapshot()).length;
    for (int i = 0; i < 100; i++) {
      world.remove(Kind.CIRCLE, world.addCircle(20, 20, 1, i, 3, Traits.DEFAULT));
      world.remove(Kind.LINE, world.addLine(0, i, 5, i, Traits.DEFAULT));
      world.remove(Kind.PEG, world.addPeg(i, 0, 1, Traits.DEFAULT));
    }
    world.addCircle(20, 20, 1, 1, 3, Traits.DEFAULT);
    byte[] after = SnapshotBytes.of(world.snapshot());
    assertThat(after).hasSize(before + 200 + 105);
    assertThat(read(after)).isEqualTo(world.snapshot());
  }

  @CollidingOrNot
  void aWorldGoesOnWithoutThoseThatWereRemoved(boolean collide) {
    World world = new World(RandomScenes.responses(new Random(5)).collide(collide).build());
    for (int i = 0; i < 20; i++) {
      int id = world.addCircle(30 + i, 40, 3, 1, i, Traits.DEFAULT);
      world.step(0.5);
      world.remove(Kind.CIRCLE, i % 3 == 0 ? i / 3 : id);
    }
    World other = new World(world.scene());
    other.restore(SnapshotBytes.copy(world.snapshot()));
    assertThat(other.addCircle(0, 0, 3, 2, 1, Traits.DEFAULT))
        .isEqualTo(world.addCircle(0, 0, 3, 2, 1, Traits.DEFAULT));
    for (int i = 0; i < 5; i++) {
      world.step(3);
      other.step(3);
      assertThat(Run.rows(other.impacts())).isEqualTo(Run.rows(world.impacts()));
    }
    assertThat(other.snapshot()).isEqualTo(world.snapshot());
  }

  private static SceneBuilder room() {
    return Scene.builder().collide(false).bounds(0, 0, 100, 100);
  }

  private static int size(SceneBuilder scene) {
    return SnapshotBytes.of(new World(scene.build()).snapshot()).length;
  }

  @CollidingOrNot
  void aStreamHoldsOneSnapshotAfterAnother(boolean collide) throws IOException {
    World world = new World(RandomScenes.responses(new Random(3)).collide(collide).build());
    world.step(20);
    Snapshot one = world.snapshot();
    world.remove(Kind.CIRCLE, 7);
    world.remove(Kind.LINE, 8);
    world.remove(Kind.PEG, 9);
    world.setTraits(
        Kind.CIRCLE, 6, world.traits(Kind.CIRCLE, 6).withMass(Double.POSITIVE_INFINITY));
    world.step(1);
    Snapshot two = world.snapshot();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    one.write(out);
    two.write(out);
    out.write(42);
    ByteArrayInputStream in = new ByteArrayInputStream(out.toByteArray());
    assertThat(Snapshot.read(in)).isEqualTo(one);
    Snapshot read = Snapshot.read(in);
    assertThat(read).isEqualTo(two);
    assertThat(in.read()).isEqualTo(42);
    World other = new World(world.scene());
    other.restore(read);
    other.step(30);
    world.step(30);
    assertThat(other.snapshot()).isEqualTo(world.snapshot());
  }

  /** A removed thing keeps its id, and is not counted. */
  @Test
  void whatWasRemovedIsNotAmongWhatIsLookedAt() {
    SceneBuilder scene = Scene.builder().circle(0, 0, 1, 1, 0);
    for (int i = 0; i < 3; i++) {
      scene.line(20 + i, -5, 20 + i, 5).peg(-20 - i, 0, 1);
    }
    World world = new World(scene.build());
    world.remove(Kind.LINE, 1);
    world.remove(Kind.PEG, 2);
    World other = new World(world.scene());
    other.restore(SnapshotBytes.copy(world.snapshot()));
    assertThat(other.toString())
        .isEqualTo(world.toString())
        .contains("4 lines and pegs without a grid");
    world.remove(Kind.LINE, 0); // most are gone by now
    world.remove(Kind.PEG, 1);
    other.restore(SnapshotBytes.copy(world.snapshot()));
    assertThat(other.toString())
        .isEqualTo(world.toString())
        .contains("2 lines and pegs without a grid");
  }

  /** Eight bytes for each thing of a kind, once one of them has a filter of its own. */
  @Test
  void filtersAreKept() {
    World world = new World(room().line(10, 20, 30, 40).line(0, 0, 1, 1).peg(50, 50, 5).build());
    world.addCircle(70, 70, 3, 1, -2, Traits.DEFAULT);
    world.addCircle(20, 80, 3, 1, -2, Traits.DEFAULT);
    int plain = SnapshotBytes.of(world.snapshot()).length;
    world.setTraits(Kind.WALL, 0, world.traits(Kind.WALL, 0).withFilter(new Filter(7, 6)));
    assertThat(SnapshotBytes.of(world.snapshot())).hasSize(plain);
    world.setTraits(Kind.LINE, 1, world.traits(Kind.LINE, 1).withFilter(new Filter(2, -1)));
    assertThat(SnapshotBytes.of(world.snapshot())).hasSize(plain + 16);
    world.setTraits(Kind.CIRCLE, 0, world.traits(Kind.CIRCLE, 0).withFilter(new Filter(1, 4)));
    assertThat(SnapshotBytes.of(world.snapshot())).hasSize(plain + 32);
    World other = new World(world.scene());
    other.restore(SnapshotBytes.copy(world.snapshot()));
    assertThat(other.snapshot()).isEqualTo(world.snapshot());
    assertThat(other.traits(Kind.WALL, 3).filter()).isEqualTo(new Filter(7, 6));
    assertThat(other.traits(Kind.LINE, 0).filter()).isEqualTo(Filter.DEFAULT);
    assertThat(other.traits(Kind.LINE, 1).filter()).isEqualTo(new Filter(2, -1));
    assertThat(other.traits(Kind.PEG, 0).filter()).isEqualTo(Filter.DEFAULT);
    assertThat(other.traits(Kind.CIRCLE, 0).filter()).isEqualTo(new Filter(1, 4));
    assertThat(other.traits(Kind.CIRCLE, 1).filter()).isEqualTo(Filter.DEFAULT);
  }

  @Test
  void aJamIsKept() throws IOException {
    Snapshot snapshot = read(small());
    snapshot.state.flights().jams =
        new IgnoreList[] {null, IgnoreList.with(IgnoreList.with(null, 3), Codes.peg(0))};
    assertThat(snapshot).isNotEqualTo(read(small()));
    assertThat(SnapshotBytes.copy(snapshot)).isEqualTo(snapshot);
  }

  @Test
  void everyByteThatIsNotAsWrittenIsNoticed() throws IOException {
    byte[] whole = small();
    assertThat(read(whole)).isNotNull();
    for (int i = 0; i < whole.length; i++) {
      for (int bits : new int[] {1, 0x80, 0xff, 0x40}) {
        byte[] other = whole.clone();
        other[i] ^= (byte) bits;
        assertThatThrownBy(() -> read(other))
            .as("byte %d, bits %x", i, bits)
            .isInstanceOf(IOException.class)
            .hasMessageStartingWith("snapshot ");
      }
    }
  }

  @Test
  void everySnapshotThatEndsEarlyIsNoticed() throws IOException {
    byte[] whole = small();
    for (int length = 0; length < whole.length; length++) {
      byte[] part = Arrays.copyOf(whole, length);
      assertThatThrownBy(() -> read(part))
          .as("%d bytes", length)
          .isInstanceOf(IOException.class)
          .hasMessage("snapshot is truncated: expected more bytes");
    }
  }

  /** As many as can be told, of which none follows. */
  @ParameterizedTest
  @ValueSource(ints = {LINES, PEGS, CIRCLES + 4})
  void aLargeNumberOfThingsAloneIsRefused(int at) throws IOException {
    byte[] bytes = small();
    ByteBuffer.wrap(bytes).putInt(at, Codes.limit(KindNumber.LINE));
    assertThatThrownBy(() -> read(bytes)).isInstanceOf(IOException.class);
  }

  /** With the sum that fits. */
  private static void seal(byte[] bytes) {
    CRC32 sum = new CRC32();
    sum.update(bytes, 0, bytes.length - 8);
    ByteBuffer.wrap(bytes).putLong(bytes.length - 8, sum.getValue());
  }

  private static void assertRefused(byte[] bytes, String message) {
    seal(bytes);
    assertThatThrownBy(() -> read(bytes))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith("snapshot cannot be read: " + message);
  }

  @Test
  void anotherVersionIsRefused() {
    byte[] bytes = small();
    ByteBuffer.wrap(bytes).putInt(VERSION, 1);
    assertRefused(
        bytes, "its format version is 1: expected 14, the only one that this library reads");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        NOW + " | -1 | now is -1.0: expected a finite number, at least 0",
        NOW + " | NaN | now is NaN",
        NOW + " | 1 | a flight starts at ",
        LARGEST + " | -5 | largest coordinate is -5.0",
        LARGEST
            + " | 1e15 | least radius is 3.0: expected 2^10 ulps of the largest coordinate, 1.0E15",
        LARGEST
            + " | 30 | coordinate is 40.0: expected at most the stored largest coordinate, 30.0",
        LEAST + " | 0 | least radius is 0.0: expected 2^10 ulps of the largest coordinate, 100.0",
        LEAST + " | 4 | radius is 3.0: expected at least 4.0",
        LEAST + " | NaN | least radius is NaN",
        XMAX + " | -1 | xmax is -1.0",
        BOUNDS_E + " | -1 | restitution is -1.0",
        LINE_AX + " | NaN | a number of line 0 is NaN",
        LINE_AX + " | Infinity | a number of line 0 is Infinity",
        LINE_E + " | -1 | restitution is -1.0",
        PEG_RADIUS + " | -1 | radius is -1.0",
        MASS + " | 0 | mass is 0.0",
        FLIGHT + " | NaN | a number of a circle is NaN",
        (FLIGHT + 16) + " | Infinity | vx is Infinity",
        (FLIGHT + 24) + " | Infinity | vy is Infinity",
        (FLIGHT + 40) + " | 1 | the tail of a time is 1.0",
        (FLIGHT + 48) + " | 0 | radius is 0.0",
        (FLIGHT + 56) + " | -1 | a flight is known for -1.0",
        (FLIGHT + 64) + " | -1 | restitution is -1.0",
        TAIL_OF_EDIT + " | -1 | the tail of the time of an edit is -1.0",
        TAIL_OF_EDIT + " | 1 | the tail of the time of an edit is 1.0",
        TAIL_OF_EDIT + " | NaN | the tail of the time of an edit is NaN",
      })
  void numbersThatMakeNoSenseAreRefused(String at, double number, String message) {
    byte[] bytes = small();
    ByteBuffer.wrap(bytes).putDouble(Integer.parseInt(at), number);
    assertRefused(bytes, message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        LAST + " | -2 | code -2 does not exist",
        LAST + " | 5 | code 5 does not exist",
        LAST + " | 268435457 | code 268435457 does not exist",
        LAST + " | 536870914 | code 536870914 does not exist",
        STUCK + " | -1 | the number of impacts at one place is -1",
        (LAST + 12) + " | 5 | the flights are not as they are saved",
        (LAST + 4) + " | 5 | the flights are not as they are saved",
        STUCK + " | 16777217 | the number of impacts at one place is 16777217",
        WORD + " | 1 | the flights are not as they are saved",
        WORD + " | 64 | the flights are not as they are saved",
        ID + " | -1 | circle id is -1: expected 0 to 1",
        ID + " | 2 | circle id is 2: expected 0 to 1",
        (ID + 4) + " | 0 | circle id is 0: expected 1 to 1",
        (CIRCLES + 4) + " | 3 | count is 3: expected 0 to 2",
        CIRCLES + " | -1 | count is -1: expected 0 to 1610612736",
        CIRCLES + " | 1610612737 | count is 1610612737: expected 0 to 1610612736",
        CIRCLES + " | 2147483647 | count is 2147483647",
        LINES + " | -1 | count is -1: expected 0",
        LINES + " | 268435453 | count is 268435453: expected 0 to 268435452",
        PEGS + " | 268435457 | count is 268435457: expected 0 to 268435456",
      })
  void codesAndCountsThatMakeNoSenseAreRefused(int at, int number, String message) {
    byte[] bytes = small();
    ByteBuffer.wrap(bytes).putInt(at, number);
    assertRefused(bytes, message);
  }

  /** After years of coming and going. */
  @Test
  void manyMoreIdsThanCirclesAreTaken() throws IOException {
    byte[] bytes = small();
    ByteBuffer.wrap(bytes).putInt(CIRCLES, 1_000_000_000);
    seal(bytes);
    Snapshot read = read(bytes);
    assertThat(SnapshotBytes.of(read)).isEqualTo(bytes);
    World world = new World(Scene.builder().collide(false).bounds(0, 0, 100, 100).build());
    world.restore(read);
    assertThat(world.addCircle(50, 20, 4, 1, 1, Traits.DEFAULT)).isEqualTo(1_000_000_000);
    world.step(1);
    assertThat(world.x(1_000_000_000)).isEqualTo(51);
  }

  @Test
  void numbersAtTheirLimitsAreTaken() throws IOException {
    byte[] bytes = small();
    ByteBuffer numbers = ByteBuffer.wrap(bytes);
    numbers.putDouble(LEAST, SizeLimits.leastRadius(numbers.getDouble(LARGEST)));
    numbers.putDouble(FLIGHT + 40, Math.ulp(numbers.getDouble(FLIGHT + 32)));
    numbers.putDouble(TAIL_OF_EDIT, Math.ulp(numbers.getDouble(NOW)));
    numbers.putInt(STUCK, 1 << 24);
    seal(bytes);
    assertThat(SnapshotBytes.of(read(bytes))).isEqualTo(bytes);
  }

  @Test
  void whatDoesNotBeginAsOneIsRefused() {
    byte[] bytes = small();
    bytes[0]++;
    assertRefused(bytes, "its first 8 bytes are not those of a snapshot");
  }

  @Test
  void aSensedCircleThatMakesNoSenseIsRefused() throws IOException {
    Snapshot snapshot = read(small());
    snapshot.state.flights().putSensed(1, 5, 0, 0);
    assertThat(SnapshotBytes.copy(snapshot)).isEqualTo(snapshot);
    snapshot.state.flights().putSensed(1, 5, 0, -3);
    assertRefused(SnapshotBytes.of(snapshot), "a partner is circle -3");
    snapshot.state.flights().putSensed(1, Double.NaN, 0, 0);
    assertRefused(SnapshotBytes.of(snapshot), "a number of a circle is NaN");
    snapshot.state.flights().putSensed(1, 5, 0, MovingCircle.NOT_SENSED);
    assertRefused(SnapshotBytes.of(snapshot), "the flights are not as they are saved");
  }

  @Test
  void aJamWithNothingIsRefused() throws IOException {
    Snapshot snapshot = read(small());
    snapshot.state.flights().jams = new IgnoreList[] {null, IgnoreList.with(null, 77)};
    assertRefused(SnapshotBytes.of(snapshot), "code 77 does not exist");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0 | 3 | count is 3: expected 0 to 2",
        "4 | 0 | code 0 does not exist",
        "4 | 5 | code 5 does not exist",
        "4 | 268435456 | code 268435456 does not exist", // before itself
        "4 | 536870912 | code 536870912 does not exist",
        "8 | 4 | code 4 does not exist", // a second time
      })
  void codesOfMovingObstaclesThatMakeNoSenseAreRefused(int at, int number, String message) {
    byte[] bytes = small(0.125);
    ByteBuffer.wrap(bytes).putInt(MOTIONS + at, number);
    assertRefused(bytes, message);
  }

  @Test
  void aTurnOfMoreThanAQuarterIsRefused() throws IOException {
    byte[] bytes = small(0.125);
    ByteBuffer.wrap(bytes).putDouble(MOTIONS + 68, -1 / 64.0).putDouble(MOTIONS + 84, 64);
    assertRefused(bytes, "an obstacle turns by 1.0");
    ByteBuffer.wrap(bytes).putDouble(MOTIONS + 68, -1 / 128.0);
    seal(bytes);
    assertThat(SnapshotBytes.of(read(bytes))).isEqualTo(bytes);
  }

  /** The velocity of each end, and the end of the motion. */
  @Test
  void aMotionIsKeptAsAWhole() throws IOException {
    byte[] bytes = small(0.125);
    ByteBuffer.wrap(bytes).putDouble(MOTIONS + 28, 0.5).putDouble(MOTIONS + 84, 50);
    seal(bytes);
    assertThat(SnapshotBytes.of(read(bytes))).isEqualTo(bytes);
  }

  // Under gravity: of each circle its acceleration, support and slow contacts, then gravity.

  private static final int FALLS = FLIGHT + 2 * 9 * 8 + 1;
  private static final int GRAVITY = TAIL_OF_EDIT + 2 * 24 + 8;

  private static byte[] falling() {
    SceneBuilder scene = Scene.builder().collide(false).bounds(0, 0, 100, 100).gravity(0, -0.125);
    scene.line(10, 20, 30, 40).peg(50, 50, 5).circle(70, 70, 3, 1, -2).circle(20, 80, 3, 1, -2);
    World world = new World(scene.build());
    world.step(2);
    return SnapshotBytes.of(world.snapshot());
  }

  /** A circle is carried by a wall, a line or a peg, and leaves the top of a line. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "MOVES | 12 | NaN | the velocity of an obstacle is NaN",
        "MOVES | 20 | Infinity | the velocity of an obstacle is Infinity",
        "MOVES | 36 | -Infinity | the velocity of an obstacle is -Infinity",
        "MOVES | 44 | NaN | pivotX of an obstacle is NaN",
        "MOVES | 52 | Infinity | pivotY of an obstacle is Infinity",
        "MOVES | 60 | NaN | an obstacle turns by NaN",
        "MOVES | 68 | 0.5 | an obstacle turns by Infinity",
        "MOVES | 76 | -1 | an obstacle moves since -1.0",
        "MOVES | 76 | 41 | an obstacle moves since 41.0",
        "MOVES | 84 | -1 | an obstacle moves until -1.0",
        "MOVES | 84 | NaN | an obstacle moves until NaN",
        "FLIGHT | 0 | NaN | a number of a circle is NaN",
        "FLIGHT | 8 | NaN | a number of a circle is NaN",
        "FLIGHT | 72 | NaN | a number of a circle is NaN",
        "FLIGHT | 80 | NaN | a number of a circle is NaN",
        "FLIGHT | 48 | Infinity | radius is Infinity",
        "FLIGHT | 48 | -0.0 | radius is -0.0",
        "FALLS | 0 | NaN | gx is NaN",
        "FALLS | 8 | Infinity | gy is Infinity",
        "FALLS | 24 | Infinity | gx is Infinity",
        "FALLS | 16 | 6 | code 5 does not exist",
        "FALLS | 16 | 536870913 | code 536870912 does not exist",
        "FALLS | 16 | -6 | code 5 does not exist",
        "GRAVITY | 0 | NaN | gx is NaN",
        "GRAVITY | 8 | -Infinity | gy is -Infinity",
      })
  void numbersOfWhatMovesOrFallsThatMakeNoSenseAreRefused(
      String place, int at, double number, String message) {
    byte[] bytes = place.equals("MOVES") ? small(0.125) : falling();
    int start =
        switch (place) {
          case "MOVES" -> MOTIONS;
          case "FLIGHT" -> FLIGHT;
          case "FALLS" -> FALLS;
          default -> GRAVITY;
        };
    ByteBuffer.wrap(bytes).putDouble(start + at, number);
    assertRefused(bytes, message);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1, 4, 5, 268435457, -5, -4})
  void supportsAtTheirLimitsAreTaken(double number) throws IOException {
    byte[] bytes = falling();
    ByteBuffer.wrap(bytes).putDouble(FALLS + 16, number);
    seal(bytes);
    assertThat(SnapshotBytes.of(read(bytes))).isEqualTo(bytes);
  }

  @Test
  void whatRestsCrushesNothing() throws IOException {
    Snapshot snapshot = read(small());
    snapshot.state.flights().jams = new IgnoreList[] {null, IgnoreList.crushedBy(null, 4)};
    assertRefused(SnapshotBytes.of(snapshot), "code 4 does not exist");
  }

  /**
   * A circle at rest in a wedge: an awake member's tick has a length above 0, and does not end
   * before the snapshot. Its first pair is one with a line.
   */
  @ParameterizedTest
  @CsvSource({
    ContactRow.TAU + ", 0, a tick ends at ",
    ContactRow.END + ", 0.9999999999999999, a tick ends at 0.9999999999999999",
    "0, NaN, a number of a circle in contact is NaN",
    ContactRow.MARGIN + ", -1, the margin of a circle is -1.0",
    ContactRow.PULL + ", -1, the pull on a circle is -1.0",
    PAIR + ContactRow.OTHER + ", -2, the other one of a pair is -2.0",
    PAIR + ContactRow.OTHER + ", 1, the other one of a pair is 1.0",
    PAIR + ContactRow.OTHER + ", 0.5, the other one of a pair is 0.5",
    PAIR + ContactRow.KEY + ", -1, the other one of a pair is -1.0",
    PAIR + ContactRow.KEY + ", 0.5, the other one of a pair is -1.0",
    PAIR + ContactRow.IMPULSE + ", -1, an impulse is -1.0",
    PAIR + ContactRow.FLAGS + ", 4, an impulse is ",
    PAIR + ContactRow.FLAGS + ", 0.5, an impulse is ",
    ContactRow.MARGIN + ", 0,",
    ContactRow.PULL + ", 0,",
    PAIR + ContactRow.IMPULSE + ", 0,",
    PAIR + ContactRow.FLAGS + ", 3,",
  })
  void numbersOfContactAreChecked(String column, double number, String refusal) throws IOException {
    SceneBuilder scene = Scene.builder().gravity(0, -10).line(-10, 10, 0, 0).line(0, 0, 10, 10);
    World world = new World(scene.circle(0.5, 4, 1, 0, 0).restitution(0).build());
    world.advanceTo(1);
    Snapshot snapshot = read(SnapshotBytes.of(world.snapshot()));
    int k = column.startsWith(PAIR) ? ContactRow.SIZE : 0;
    k += Integer.parseInt(column.replace(PAIR, ""));
    snapshot.state.flights().contactRows[0][k] = number;
    byte[] bytes = SnapshotBytes.of(snapshot);
    if (refusal == null) {
      assertThat(SnapshotBytes.of(read(bytes))).isEqualTo(bytes);
    } else {
      assertRefused(bytes, refusal);
    }
  }

  @Test
  void traitsThatMakeNoSenseAreRefused() {
    for (byte traits : new byte[] {2, 3, 4, -1}) {
      byte[] bytes = small();
      bytes[BOUNDS_TRAITS] = traits;
      assertRefused(bytes, "traits are " + traits);
    }
  }

  @ParameterizedTest
  @CsvSource({"LINES, 24", "LINES, 3", "LINES, -2", "PEGS, 4", "TRAITS, 3"})
  void soAreThoseOfThings(String kind, byte traits) {
    byte[] bytes = small();
    int at = "LINES".equals(kind) ? LINES + 4 : "PEGS".equals(kind) ? PEGS + 4 : TRAITS;
    bytes[at] = traits;
    assertRefused(bytes, "traits are " + traits);
  }
}
