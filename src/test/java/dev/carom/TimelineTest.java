// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Kind.CIRCLE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.internal.state.Codes;
import dev.carom.internal.util.KindNumber;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A timeline tells what the world told when it stood there. */
class TimelineTest {

  /** The state of one circle at one time, by a world or its timeline. */
  private record Moment(double t, int id, double x, double y, double vx, double vy, double radius) {

    static Moment of(World w, int id) {
      return new Moment(w.now(), id, w.x(id), w.y(id), w.vx(id), w.vy(id), w.radius(id));
    }

    static Moment of(Timeline line, int id, double t) {
      double radius = ((Circle) line.shape(CIRCLE, id, t)).radius();
      return new Moment(
          t, id, line.x(id, t), line.y(id, t), line.vx(id, t), line.vy(id, t), radius);
    }
  }

  private static World falling() {
    return new World(Scene.builder().line(-9, 0, 9, 0).circle(0, 5, 1, 0, -2).build());
  }

  @CollidingOrNot
  void onlyTheLastSoMuchTimeIsKept(boolean collide) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 10, 10).collide(collide);
    World world = new World(scene.circle(5, 2, 1, 4, 0).circle(5, 8, 1, 0, 0).build());
    Timeline timeline = world.record(3);
    world.step(3); // walls at 1, 3; a flight lasts 2
    assertThat(timeline.start()).isZero();
    world.step(2);
    assertThat(timeline.start()).isEqualTo(2);
    world.step(100);
    assertThat(timeline.start()).isEqualTo(102);
    assertThat(timeline.end()).isEqualTo(105);
    assertThat(timeline.contains(Kind.CIRCLE, 0, Math.nextDown(102.0))).isFalse();
    assertThat(timeline.x(0, 102)).isEqualTo(5);
    assertThat(timeline.x(0, 103)).isEqualTo(1);
    assertThat(timeline.x(0, 104.5)).isEqualTo(7);
    assertThat(timeline.x(1, 102)).as("has one flight only").isEqualTo(5);
  }

  /** A circle that hits too much takes the others back: what they did then never happened. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 20_000})
  void whatAStepTookBackLeavesNoTrace(int duration) {
    SceneBuilder scene =
        Scene.builder()
            .collide(false)
            .bounds(0, 0, 100, 100)
            .circle(5, 50, 1, 20, 0)
            .line(0, 0, 100, 0)
            .line(0, 2 + 0x1p-30, 100, 2 + 0x1p-30)
            .circle(50, 1, 1, 1e-3, 1);
    for (int i = 0; i < 400; i++) {
      scene.circle(50, 80, 1, 0, 0); // the more circles, the fewer impacts each may make
    }
    World world = new World(scene.build());
    Timeline timeline = world.record(duration);
    assertThat(world.advanceTo(50, Run.work(world, 5))).isFalse();
    assertThat(world.now()).isBetween(0.0, 1.0);
    assertThat(timeline.end()).isEqualTo(world.now());
    assertThat(Moment.of(timeline, 0, world.now())).isEqualTo(Moment.of(world, 0));
    assertThat(timeline.x(0, 0)).isEqualTo(5);
    assertThat(timeline.x(1, timeline.start())).isBetween(49.0, 51.0);
    world.remove(CIRCLE, 1);
    world.step(10);
    assertThat(Moment.of(timeline, 0, world.now())).isEqualTo(Moment.of(world, 0));
  }

  private static void assertUnknown(Timeline timeline, Kind kind, int id, double t) {
    assertThatThrownBy(() -> timeline.shape(kind, id, t))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "%s %d is unknown at %s: expected one that was there then",
            kind.name().toLowerCase(Locale.ROOT), id, t);
  }

  @Test
  void whatIsNotKnownIsRefused() {
    World world = falling();
    world.step(1);
    Timeline timeline = world.record(9);
    world.step(1);
    for (double t : new double[] {2.5, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThat(timeline.contains(Kind.CIRCLE, 0, t)).isFalse();
      assertThatThrownBy(() -> timeline.x(0, t))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("t is %s: expected a time of the recording, from 1.0 to 2.0".formatted(t));
    }
    for (int id : new int[] {-1, 1, Integer.MAX_VALUE}) {
      assertThat(timeline.contains(Kind.CIRCLE, id, 1.5)).isFalse();
      assertThatThrownBy(() -> timeline.vy(id, 1.5)).hasMessageStartingWith("circle " + id);
      assertUnknown(timeline, Kind.CIRCLE, id, 1.5);
    }
    for (int id : new int[] {-1, 0}) {
      for (double t : new double[] {0.5, 2.5, Double.NaN}) {
        String message = "t is %s: expected a time of the recording, from 1.0 to 2.0".formatted(t);
        assertThatThrownBy(() -> timeline.shape(Kind.LINE, id, t)).hasMessage(message);
        assertThatThrownBy(() -> timeline.shape(Kind.PEG, id, t)).hasMessage(message);
      }
    }
    for (double duration : new double[] {-1, Double.NaN}) {
      assertThatThrownBy(() -> world.record(duration))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("duration is " + duration + ": expected at least 0");
    }
    assertThat(timeline.end()).as("the old one goes on").isEqualTo(2);
    world.step(1);
    assertThat(timeline.end()).isEqualTo(3);
  }

  @CollidingOrNot
  void aTimelineThatStoppedStaysAsItIs(boolean collide) {
    World world =
        new World(
            Scene.builder().collide(collide).line(-9, 0, 9, 0).circle(0, 5, 1, 0, -2).build());
    Timeline first = world.record(9);
    world.step(1);
    first.stop();
    world.step(3);
    assertThat(first.end()).isEqualTo(1);
    assertThat(first.contains(Kind.CIRCLE, 0, 3)).isFalse();
    Timeline second = world.record(9);
    world.step(1);
    assertThat(first.end()).isEqualTo(1);
    assertThat(List.of(second.start(), second.end())).containsExactly(4.0, 5.0);
    assertThat(second.y(0, 5)).isEqualTo(7);
  }

  /** Of two recordings one after the other, the first stopped when the second began. */
  @Test
  void toStopARecordingThatEndedDoesNothing() {
    World world = falling();
    Timeline first = world.record(9);
    world.step(1);
    Timeline second = world.record(9);
    first.stop();
    world.step(1);
    assertThat(first.end()).isEqualTo(1);
    assertThat(second.end()).isEqualTo(2);
    second.stop();
    second.stop();
    world.step(1);
    assertThat(second.end()).isEqualTo(2);
  }

  /** One question for all kinds: what was there, as the world said it then. */
  @Test
  void theShapeOfEachKindIsTold() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 40, 50).circle(5, 6, 1, 2, 1);
    scene.line(20, 20, 30, 20).velocity(1, 0).peg(20, 40, 2);
    World world = new World(scene.build());
    Timeline timeline = world.record(9);
    world.step(2);
    world.setShape(Kind.CIRCLE, 0, new Circle(world.x(0), world.y(0), 0.5));
    world.step(1);
    assertThat(timeline.shape(Kind.CIRCLE, 0, 1.5)).isEqualTo(new Circle(8, 7.5, 1));
    assertThat(timeline.shape(Kind.CIRCLE, 0, 2.5)).isEqualTo(new Circle(10, 8.5, 0.5));
    assertThat(timeline.shape(Kind.LINE, 0, 2.5)).isEqualTo(new Line(22.5, 20, 32.5, 20));
    assertThat(timeline.shape(Kind.PEG, 0, 2.5)).isEqualTo(new Circle(20, 40, 2));
    assertThat(timeline.shape(Kind.WALL, 3, 2.5)).isEqualTo(new Bounds(0, 0, 40, 50));
    assertUnknown(timeline, Kind.WALL, 4, 2.5);
    assertUnknown(timeline, Kind.CIRCLE, 1, 2.5);
    assertThatThrownBy(() -> timeline.shape(Kind.CIRCLE, 0, 4)).hasMessageStartingWith("t is 4.0");
  }

  /** Beyond the doubles there is no disk: the largest place is told. */
  @Test
  void theShapeOfACircleFarAwayIsAtTheEdge() {
    World world = new World(Scene.builder().circle(0, 0, 1, 1e300, 0).build());
    Timeline timeline = world.record(Double.POSITIVE_INFINITY);
    world.step(1e10);
    assertThat(timeline.x(0, 1e10)).isInfinite();
    assertThat(timeline.shape(Kind.CIRCLE, 0, 1e10)).isEqualTo(new Circle(Double.MAX_VALUE, 0, 1));
  }

  // Lines and pegs.

  /** An id is that of a line, or of a peg, however large it is. */
  @Test
  void idsThatNoneHasAreThoseOfNothing() {
    World world = new World(Scene.builder().line(0, 0, 1, 1).peg(5, 5, 1).peg(7, 7, 2).build());
    Timeline timeline = world.record(9);
    world.step(1);
    assertThat(timeline.shape(Kind.PEG, 1, 0.5)).isEqualTo(new Circle(7, 7, 2));
    assertThat(timeline.contains(Kind.PEG, 1, 0.5)).isTrue();
    assertThat(timeline.contains(Kind.PEG, 1, 1.5)).isFalse();
    assertThat(timeline.contains(Kind.WALL, 0, 0.5)).as("no bounds").isFalse();
    assertThat(timeline.contains(Kind.LINE, Codes.limit(KindNumber.LINE), 0.5)).isFalse();
    assertUnknown(timeline, Kind.LINE, Codes.limit(KindNumber.LINE), 0.5);
    assertThat(timeline.contains(Kind.LINE, -1, 0.5)).isFalse();
    assertUnknown(timeline, Kind.LINE, -1, 0.5);
    assertThat(timeline.contains(Kind.PEG, -1, 0.5)).isFalse();
    assertUnknown(timeline, Kind.PEG, -1, 0.5);
  }

  /** Later flights are not recorded: so nothing ends more than two units of time ago. */
  @Test
  void whatFollowsAfterARecordingDropsNothing() {
    World world = new World(Scene.builder().bounds(0, 0, 10, 10).circle(5, 5, 1, 4, 0).build());
    Timeline timeline = world.record(2);
    world.step(1.5);
    timeline.stop();
    world.step(20);
    world.setVelocity(0, 1, 0);
    assertThat(timeline.start()).isZero();
    assertThat(timeline.end()).isEqualTo(1.5);
    assertThat(timeline.x(0, 0.5)).isEqualTo(7);
  }

  // Removed things.

  /** One comes and bounces once, another one goes, ten are there. */
  private static World turnover(boolean collide, int rounds, Timeline[] past) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 100, 100).collide(collide);
    for (int i = 0; i < 10; i++) {
      scene.circle(5 + 10 * i, 2, 1, 0, -1);
    }
    World world = new World(scene.build());
    past[0] = world.record(4);
    for (int i = 0; i < rounds; i++) {
      world.step(1);
      world.remove(CIRCLE, i);
      world.addCircle(5 + 10 * (i % 10), 2, 1, 0, -1, Traits.DEFAULT);
    }
    return world;
  }

  @CollidingOrNot
  void ofRemovedCirclesTheFirstAreDropped(boolean collide) {
    Timeline[] past = new Timeline[1];
    turnover(collide, 4, past);
    assertThat(past[0].start()).as("none was dropped yet").isZero();
    assertThat(past[0].y(0, 0.5)).isEqualTo(1.5);

    World world = turnover(collide, 200, past);
    assertThat(past[0].start()).isEqualTo(196);
    for (int id = 196; id < 200; id++) {
      assertThat(past[0].contains(Kind.CIRCLE, id, id + 0.5)).isTrue();
    }
    assertThat(past[0].contains(Kind.CIRCLE, 195, 195.5)).isFalse();
    assertThatThrownBy(() -> past[0].x(195, 195.5)).hasMessageContaining("from 196.0");
    assertThat(world.count(Kind.CIRCLE)).isEqualTo(10);
  }

  @Test
  void thatNoneIsLeftDropsNothing() {
    Timeline[] past = new Timeline[1];
    World world = turnover(false, 0, past);
    world.step(1);
    for (int id = 0; id < 10; id++) {
      world.remove(CIRCLE, id);
    }
    world.step(1);
    assertThat(past[0].start()).isZero();
    assertThat(past[0].y(3, 0.25)).isEqualTo(1.75);
  }

  private static long usedMemory() {
    System.gc();
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }

  /** With 500 bytes for each of the removed circles it would be 500 MB. */
  @Tag("long")
  @Test
  void whatCameAndWentTakesNoMemory() {
    Timeline[] past = new Timeline[1];
    World young = turnover(false, 1000, past);
    long before = usedMemory();
    World old = turnover(false, 1_000_000, past);
    assertThat(usedMemory() - before).isLessThan(20_000_000);
    assertThat(past[0].start()).isGreaterThan(999_000);
    assertThat(old.count(Kind.CIRCLE)).isEqualTo(young.count(Kind.CIRCLE));
  }

  /**
   * With all that contact knows at each tick it would be 450, and 400 with a stand at each edit. A
   * kilobyte of each circle is for its first and last stand, half a one for each edit.
   */
  @Tag("long")
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aMemberOfAHeapTakesAHundredBytesATick(boolean areEdited) {
    SceneBuilder scene = Scene.builder().gravity(0, 0.05).bounds(0, 0, 227, 700).restitution(0.8);
    scene.line(0, 690, 227, 690).restitution(0.8);
    for (int i = 0; i < 100; i++) {
      scene.circle(20 + 22 * (i % 9), 680 - 30 * (i / 9), 10, 0.1 * (i % 7), 0).restitution(0.8);
    }
    World world = new World(scene.build());
    Timeline[] timeline = {world.record(1000)};
    for (int frame = 1; frame <= 1000; frame++) {
      if (areEdited) {
        world.setVelocity(Kind.LINE, 0, 0, frame % 2 == 0 ? 0.1 : -0.1);
      }
      world.advanceTo(frame);
    }
    timeline[0].stop();
    long flights = 0;
    for (int i = 0; i < 100; i++) {
      flights += timeline[0].recorder.track(i, 1000).rows.capacity();
    }
    int rest = 100 * 1000 + (areEdited ? 1000 * 500 : 0);
    long with = usedMemory();
    timeline[0] = null;
    assertThat(with - usedMemory()).isBetween(95 * flights, 100 * flights + rest);
    assertThat(flights).isGreaterThan(15_000);
    assertThat(world.now()).isEqualTo(1000);
  }

  @Test
  void ofRemovedLinesAndPegsTheFirstAreDropped() {
    World world = new World(Scene.builder().line(0, 0, 1, 0).peg(5, 5, 1).build());
    Timeline timeline = world.record(3);
    world.step(1);
    world.remove(Kind.LINE, 0);
    for (int i = 1; i <= 10; i++) {
      int line = world.addLine(0, i, 1, i, Traits.DEFAULT);
      world.step(1);
      world.remove(Kind.LINE, line);
    }
    // The seventh line was removed at time 8.
    assertThat(timeline.start()).isEqualTo(8);
    assertThat(timeline.contains(Kind.LINE, 0, 8)).isFalse();
    assertUnknown(timeline, Kind.LINE, 0, 8);
    assertThat(timeline.contains(Kind.LINE, 7, 8)).isFalse();
    assertUnknown(timeline, Kind.LINE, 7, 8);
    assertThat(timeline.shape(Kind.LINE, 8, 8)).isEqualTo(new Line(0, 8, 1, 8));
    assertThat(timeline.shape(Kind.LINE, 9, 9.5)).isEqualTo(new Line(0, 9, 1, 9));
    assertThat(timeline.shape(Kind.PEG, 0, 11)).isEqualTo(new Circle(5, 5, 1));
    assertThatThrownBy(() -> timeline.shape(Kind.LINE, 6, 7.5)).hasMessageContaining("from 8.0");
  }

  /** A line is some 50 bytes in the world, and was 200 more in its recording. */
  @Tag("long")
  @Test
  void whatCameAndWentOfLinesTakesAFewBytes() {
    World world = new World(Scene.builder().build());
    Timeline timeline = world.record(100);
    int rounds = 500_000;
    long before = usedMemory();
    for (int i = 0; i < rounds; i++) {
      world.remove(Kind.LINE, world.addLine(0, 1, 2, 3, Traits.DEFAULT));
      world.step(1);
    }
    assertThat(usedMemory() - before).isLessThan(120L * rounds);
    assertThat(timeline.start()).isEqualTo(rounds - 100);
  }
}
