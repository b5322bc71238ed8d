// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Kind.CIRCLE;
import static dev.carom.Kind.LINE;
import static dev.carom.Kind.PEG;
import static dev.carom.Kind.WALL;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A snapshot of a recorded moment is the one that a world takes that stands there. {@link
 * PastCheck} compares them in random sessions of edits; here are moments within steps, and each
 * thing that changes without a new flight.
 */
class RewindTest {

  private static final int MOST = 1 << 16;

  private static Scene scene(Random random, boolean collide, double gravity) {
    SceneBuilder scene = RandomScenes.mixed(random).collide(collide).gravity(0, gravity);
    for (int i = 0; i < 4; i++) {
      scene.line(100 + 100 * i, 100, 140 + 100 * i, 130).velocity(random.nextInt(5) - 2, 1);
      scene.peg(100 + 150 * i, 500, 9).velocity(1, random.nextInt(5) - 2).filter(new Filter(2, 6));
      scene.circle(120 + 100 * i, 40, 8, 4, 5).filter(new Filter(4, 7)).mass(3);
    }
    scene.line(0, 250, 800, 330).response(Response.SENSOR);
    if (collide) {
      scene.circle(50, 560, 20, 9, -4).response(Response.SENSOR);
    }
    return scene.build();
  }

  private static void edit(World world, Random random) {
    int id = random.nextInt(world.idLimit(CIRCLE));
    if (!world.contains(CIRCLE, id)) {
      return;
    }
    switch (random.nextInt(9)) {
      case 0 -> world.setVelocity(id, random.nextGaussian() * 9, random.nextGaussian() * 9);
      case 1 -> world.setTraits(CIRCLE, id, world.traits(CIRCLE, id).withRestitution(0.9));
      case 2 ->
          world.setTraits(
              Kind.CIRCLE, id, world.traits(Kind.CIRCLE, id).withMass(1 + random.nextInt(4)));
      case 3 -> world.addCircle(400, 300, 4, 1, random.nextGaussian(), Traits.DEFAULT);
      case 4 -> world.addLine(random.nextInt(800), 100, random.nextInt(800), 500, Traits.DEFAULT);
      case 5 -> world.remove(CIRCLE, id);
      case 6 -> world.setVelocity(LINE, random.nextInt(60), 1, random.nextInt(3) - 1);
      case 7 ->
          world.setTraits(
              CIRCLE,
              id,
              world.traits(CIRCLE, id).withFilter(new Filter(1 + random.nextInt(3), 7)));
      default -> {
        int line = random.nextInt(60);
        world.setTraits(LINE, line, world.traits(LINE, line).withRestitution(0.8));
      }
    }
  }

  /** The recorded world never stood at most of these moments. */
  @ParameterizedTest
  @CsvSource({
    "1, false, 0",
    "2, true, 0",
    "3, false, 0",
    "4, true, 0",
    "5, false, -0.5",
    "6, true, -0.5",
    "7, false, 0",
    "8, true, -0.5"
  })
  void itIsThatOfAWorldThatStandsThere(int seed, boolean collide, double gravity) {
    Random random = new Random(seed);
    Scene scene = scene(random, collide, gravity);
    World world = new World(scene);
    World other = new World(scene);
    Timeline past = world.record(seed > 6 ? 9 : MOST);
    TreeMap<Double, Snapshot> expected = new TreeMap<>();
    double lastEdit = 0;
    for (int i = 0; i < 25; i++) {
      lastEdit = world.now();
      long edits = random.nextLong();
      edit(world, new Random(edits));
      edit(other, new Random(edits));
      double end = lastEdit + 4 * random.nextDouble();
      for (double t : random.doubles(4, lastEdit, end).sorted().toArray()) {
        other.advanceTo(t);
        expected.put(t, other.snapshot());
      }
      world.advanceTo(end);
      other.advanceTo(end);
    }
    assertThat(past.start()).isEqualTo(seed > 6 ? world.now() - 9 : 0);
    expected
        .tailMap(past.start())
        .forEach((t, then) -> assertThat(past.snapshot(t)).as("at %s", t).isEqualTo(then));
    World onwards = new World(scene);
    for (double t : expected.tailMap(lastEdit).keySet()) {
      onwards.restore(past.snapshot(t));
      onwards.advanceTo(world.now());
      assertThat(onwards.snapshot()).isEqualTo(world.snapshot());
    }
  }

  // Contact.

  private static Scene heap(boolean collide) {
    SceneBuilder scene = Scene.builder().collide(collide).gravity(0, 0.05).bounds(0, 0, 200, 400);
    scene.restitution(0.7).line(20, 390, 180, 390).restitution(0.7).peg(100, 300, 12);
    for (int i = 0; i < 12; i++) {
      scene.circle(30 + 45 * (i % 4) + i, 40 + 50 * (i / 4), 10, 0.3, -0.2).restitution(0.6);
    }
    return scene.build();
  }

  private static void editHeap(World world, Random random) {
    int ball = random.nextInt(12);
    switch (random.nextInt(9)) {
      case 0 -> world.setVelocity(ball, random.nextGaussian(), -random.nextInt(3));
      case 1 -> world.moveTo(LINE, 0, 20, 380, world.now() + 7);
      case 2 -> world.moveTo(LINE, 0, 20, 390, world.now() + 7);
      case 3 -> world.setGravity(random.nextInt(3) * 0.01, 0.05);
      case 4 -> world.setTraits(CIRCLE, ball, world.traits(CIRCLE, ball).withMass(2));
      case 5 -> world.addPeg(20 + random.nextInt(160), 200, 3, Traits.DEFAULT);
      default -> {} // some frames are as long as many ticks
    }
  }

  /**
   * What contact knows is kept at some times only, and played again from there. Edits, arrivals and
   * rests are between.
   */
  @ParameterizedTest
  @CsvSource({"1, true", "2, true", "3, true", "4, false", "5, false", "6, false"})
  void ofAHeapToo(int seed, boolean collide) {
    Random random = new Random(seed);
    World world = new World(heap(collide));
    World other = new World(heap(collide));
    Timeline past = world.record(seed % 3 == 0 ? 200 : MOST);
    TreeMap<Double, Snapshot> expected = new TreeMap<>();
    int inContact = 0;
    for (int i = 0; i < 60; i++) {
      double now = world.now();
      long edits = random.nextLong();
      editHeap(world, new Random(edits));
      editHeap(other, new Random(edits));
      double end = now + (i == 40 ? 600 : 1 + random.nextInt(25));
      for (double t : random.doubles(3, now, end).sorted().toArray()) {
        other.advanceTo(t);
        expected.put(t, other.snapshot());
        inContact += other.isResting(0) ? 0 : 1;
      }
      world.advanceTo(end);
      other.advanceTo(end);
      expected.put(end, other.snapshot());
      expected.remove(now); // an edit follows, or what an arrival brings about
    }
    assertThat(inContact).isGreaterThan(40);
    expected
        .tailMap(past.start())
        .forEach((t, then) -> assertThat(past.snapshot(t)).as("at %s", t).isEqualTo(then));
    past.stop();
    expected
        .tailMap(past.start())
        .forEach((t, then) -> assertThat(past.snapshot(t)).as("at %s", t).isEqualTo(then));
  }

  /** A flight in contact begins without the tail of the impact that brought it about. */
  @Test
  void atImpactsThatLeadIntoContact() {
    for (int seed = 0; seed < 20; seed++) {
      World world = new World(fourBalls(new Random(seed)));
      Timeline past = world.record(MOST);
      TreeMap<Double, Snapshot> expected = new TreeMap<>();
      for (int k = 0; world.advanceToImpact(600); k++) {
        if (k % 2 == 0 && !world.advanceTo(600, 1)) {
          world.advanceTo(world.now());
        }
        expected.put(world.now(), world.snapshot());
      }
      expected.forEach((t, then) -> assertThat(past.snapshot(t)).as("at %s", t).isEqualTo(then));
    }
  }

  private static Scene fourBalls(Random random) {
    SceneBuilder scene = Scene.builder().gravity(0, 0.05).bounds(0, 0, 200, 400).restitution(0.7);
    for (int i = 0; i < 4; i++) {
      scene.circle(30 + 45 * i + random.nextInt(9), 40, 10, 0.3 * random.nextInt(5), -0.2);
      scene.restitution(0.6);
    }
    return scene.build();
  }

  // Changes within flights.

  /** Snapshots before and after each change, then one more change of the same kind. */
  @CollidingOrNot
  void eachPropertyIsRecorded(boolean collide) {
    World world = SnapshotTest.world(collide);
    Timeline past = world.record(MOST);
    TreeMap<Double, Snapshot> expected = new TreeMap<>();
    for (Consumer<World> change : SnapshotTest.changes().toList()) {
      world.step(0.125);
      Snapshot before = world.snapshot();
      change.accept(world);
      assertThat(world.snapshot()).isNotEqualTo(before);
      world.step(0); // what an edit brought about happens now
      expected.put(world.now(), world.snapshot());
    }
    world.step(1);
    expected.forEach((t, then) -> assertThat(past.snapshot(t)).as("at %s", t).isEqualTo(then));
    for (double t : expected.keySet()) {
      assertThat(past.snapshot(Math.nextDown(t))).isNotEqualTo(expected.get(t));
    }
  }

  private static World sensors() {
    return new World(
        Scene.builder()
            .circle(0, 0, 1, 1, 0)
            .response(Response.SENSOR)
            .circle(10, 0, 1, 0, 0)
            .circle(20, 0, 1, 0, 0)
            .circle(30, 0, 1, 0, 0)
            .build());
  }

  @Test
  void theBoundHoldsForReportsToo() {
    World world = sensors();
    Timeline past = world.record(32);
    world.advanceTo(20);
    assertThat(past.start()).isZero();
    world.advanceTo(40);
    assertThat(past.start()).isEqualTo(8);
    assertThatThrownBy(() -> past.snapshot(7))
        .hasMessage("t is 7.0: expected a time of the recording, from 8.0 to 40.0");
    World then = sensors();
    then.advanceTo(8);
    assertThat(past.snapshot(8)).isEqualTo(then.snapshot());
  }

  @Test
  void theBoundHoldsForPropertiesToo() {
    World world = SnapshotTest.world(false);
    Timeline past = world.record(3 * 0.125);
    for (int i = 1; i <= 5; i++) {
      world.step(0.125);
      world.setTraits(Kind.CIRCLE, 0, world.traits(Kind.CIRCLE, 0).withMass(i));
    }
    assertThat(past.start()).isEqualTo(2 * 0.125);
    for (int i = 1; i <= 5; i++) {
      world.step(0.125);
      world.setTraits(WALL, 0, world.traits(WALL, 0).withRestitution(1.0 / i));
    }
    world.step(0.125);
    assertThat(past.start()).isEqualTo(8 * 0.125);
    world.restore(past.snapshot(past.start()));
    assertThat(world.traits(WALL, 0).restitution()).isEqualTo(1.0 / 3);
  }

  // Stuck circles.

  // The ends of a recording.

  /** A circle that was turned against the wall that it touches bounces with the next step. */
  @Test
  void atTheEndImpactsAreYetToCome() {
    World world = new World(Scene.builder().bounds(0, 0, 10, 10).circle(1, 5, 1, 1, 0).build());
    Timeline past = world.record(MOST);
    world.setVelocity(0, -1, 0);
    Snapshot before = world.snapshot();
    assertThat(past.snapshot(0)).isEqualTo(before);
    assertThat(past.snapshot(-0.0)).isEqualTo(before);
    world.step(0);
    Snapshot after = world.snapshot();
    assertThat(after).isNotEqualTo(before);
    world.step(1);
    assertThat(past.snapshot(0)).isEqualTo(after);
  }

  @Test
  void theEndOfARecordingThatStoppedStays() {
    World world = SnapshotTest.world(true);
    Timeline first = world.record(MOST);
    world.step(3);
    Snapshot atThree = world.snapshot();
    Timeline second = world.record(MOST);
    world.addLine(1, 1, 2, 2, Traits.DEFAULT);
    world.setTraits(WALL, 0, world.traits(WALL, 0).withRestitution(0.5));
    Snapshot edited = world.snapshot();
    second.stop();
    world.remove(CIRCLE, 0);
    world.step(3);
    assertThat(first.snapshot(3)).isEqualTo(atThree);
    assertThat(second.snapshot(3)).isEqualTo(edited);
    World then = SnapshotTest.world(true);
    then.step(2);
    assertThat(first.snapshot(2)).isEqualTo(then.snapshot());
  }

  @Test
  void timesThatAreNotRecordedAreRefused() {
    World world = SnapshotTest.world(false);
    world.step(1);
    Timeline past = world.record(MOST);
    world.step(1);
    for (double t : new double[] {0.5, 2.5, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThatThrownBy(() -> past.snapshot(t))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("t is %s: expected a time of the recording, from 1.0 to 2.0".formatted(t));
    }
  }

  /** Those that came and went leave their ids, also when the recording has dropped them. */
  @CollidingOrNot
  void idsAreNotGivenAgain(boolean collide) {
    World world = SnapshotTest.world(collide);
    Timeline past = world.record(2);
    TreeMap<Double, Snapshot> expected = new TreeMap<>();
    for (int i = 0; i < 100; i++) {
      world.remove(CIRCLE, world.addCircle(80, 80, 1, 0, i, Traits.DEFAULT));
      world.remove(PEG, world.addPeg(5, i, 1, Traits.DEFAULT));
      expected.put(world.now(), world.snapshot());
      world.step(0.125);
    }
    assertThat(past.start()).isGreaterThan(0);
    expected
        .tailMap(past.start())
        .forEach((t, then) -> assertThat(past.snapshot(t)).as("at %s", t).isEqualTo(then));
    world.restore(past.snapshot(past.start()));
    int ids = world.idLimit(CIRCLE);
    assertThat(world.addCircle(80, 80, 1, 0, 0, Traits.DEFAULT)).isEqualTo(ids).isGreaterThan(50);
    assertThat(world.ids(CIRCLE)).hasSize(4);
    assertThat(Arrays.stream(world.ids(PEG)).max()).hasValue(0);
  }
}
