// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Lines and pegs that go to a place by a time, and then rest. */
class MoveToTest {

  private static final double DT = 1 / 60.0;

  private static Vec2 place(World world, Kind kind, int id) {
    return kind == Kind.LINE ? world.line(id).start() : world.peg(id).center();
  }

  private static SceneBuilder paddle() {
    return Scene.builder().line(0, -10, 0, 10);
  }

  // The motion.

  @Test
  void itArrivesToTheBitAndRestsThere() {
    Random random = new Random(1);
    World world = new World(Scene.builder().line(0.1, 0.2, 3, 4).peg(5, 6, 0.5).build());
    for (int i = 0; i < 2000; i++) {
      Kind kind = random.nextBoolean() ? Kind.LINE : Kind.PEG;
      double x = random.nextGaussian() * Math.pow(10, random.nextInt(9) - 4);
      double y = random.nextGaussian();
      double arrival = world.now() + random.nextDouble();
      world.moveTo(kind, 0, x, y, arrival);
      world.advanceTo(world.now() + random.nextDouble() * (arrival - world.now()));
      world.advanceTo(arrival);
      assertThat(place(world, kind, 0)).isEqualTo(new Vec2(x, y));
      assertThat(world.velocity(kind, 0)).isEqualTo(Vec2.ZERO);
      world.advanceTo(arrival + random.nextDouble());
      assertThat(place(world, kind, 0)).isEqualTo(new Vec2(x, y));
      assertThat(world.velocity(kind, 0)).isEqualTo(Vec2.ZERO);
    }
  }

  /**
   * The velocity is rounded, and the place of arrival is not. So the place steps at the call: by
   * the rounding of the way and of the velocity, 2^-53 of the way each, and by that of the place.
   */
  @Test
  void thePlaceStepsAtTheCallByNoMoreThanRounding() {
    Random random = new Random(2);
    World world = new World(Scene.builder().line(0.1, 0.2, 3, 4).build());
    double most = 0;
    for (int i = 0; i < 20_000; i++) {
      Line before = world.line(0);
      double x = random.nextGaussian() * Math.pow(10, random.nextInt(9) - 4);
      double arrival = world.now() + random.nextDouble();
      world.moveTo(Kind.LINE, 0, x, random.nextGaussian(), arrival);
      double step = Math.abs(world.line(0).ax() - before.ax());
      double way = Math.abs(x - before.ax());
      double bound = 0x1p-52 * way + 0x1p-53 * Math.abs(before.ax());
      assertThat(step).isLessThanOrEqualTo(bound);
      most = Math.max(most, step / bound);
      world.advanceTo(world.now() + random.nextDouble() * (arrival - world.now()));
    }
    assertThat(most).isGreaterThan(0.3); // the bound is not idle
  }

  @Test
  void bothEndsOfALineMoveAlike() {
    World world = new World(Scene.builder().line(1, 2, 5, 7).build());
    world.moveTo(Kind.LINE, 0, 11, 22, 10);
    world.advanceTo(5);
    assertThat(world.line(0)).isEqualTo(new Line(6, 12, 10, 17));
    world.advanceTo(20);
    assertThat(world.line(0)).isEqualTo(new Line(11, 22, 15, 27));
  }

  @Test
  void anotherEditReplacesTheMotion() {
    World world = new World(Scene.builder().peg(0, 0, 1).build());
    world.moveTo(Kind.PEG, 0, 10, 0, 10);
    world.advanceTo(5);
    world.moveTo(Kind.PEG, 0, 5, 10, 7);
    world.advanceTo(6);
    assertThat(world.peg(0).center()).isEqualTo(new Vec2(5, 5));
    world.setVelocity(Kind.PEG, 0, 1, 0);
    world.advanceTo(16); // past both arrivals
    assertThat(world.peg(0).center()).isEqualTo(new Vec2(15, 5));
    world.moveTo(Kind.PEG, 0, 20, 5, 20);
    world.setShape(Kind.PEG, 0, new Circle(1, 1, 1));
    assertThat(world.velocity(Kind.PEG, 0)).isEqualTo(Vec2.ZERO);
    world.advanceTo(30);
    assertThat(world.peg(0).center()).isEqualTo(new Vec2(1, 1));
    world.moveTo(Kind.PEG, 0, 5, 1, 32);
    world.advanceTo(31);
    world.remove(Kind.PEG, 0);
    world.advanceTo(40);
    assertThat(world.contains(Kind.PEG, 0)).isFalse();
  }

  @Test
  void theMotionThatItHasAlreadyIsNoEdit() {
    World world = new World(paddle().circle(10, 0.3, 1, -0.1, 0.01).build());
    world.moveTo(Kind.LINE, 0, 6, -10, 3);
    world.advanceTo(1);
    Snapshot before = world.snapshot();
    world.moveTo(Kind.LINE, 0, 6, -10, 3);
    assertThat(world.snapshot()).isEqualTo(before);
    world.advanceTo(4);
    before = world.snapshot();
    world.moveTo(Kind.LINE, 0, 6, -10, 7);
    assertThat(world.snapshot()).isEqualTo(before);
  }

  @Test
  void anArrivalSoSoonThatTheVelocityIsInfiniteIsRefused() {
    World world = new World(paddle().build());
    Snapshot before = world.snapshot();
    assertThatThrownBy(() -> world.moveTo(Kind.LINE, 0, 9, 99, Double.MIN_VALUE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("line 0: arrival is 4.9E-324: expected late enough after 0.0 for this way");
    assertThat(world.snapshot()).isEqualTo(before);
  }

  // Circles in the way.

  @CollidingOrNot
  void aBallInFrontLeavesWithTwiceTheVelocity(boolean collide) {
    World world = new World(paddle().circle(5, 0, 1, 0, 0).collide(collide).build());
    world.moveTo(Kind.LINE, 0, 8, -10, 4);
    world.advanceTo(10);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.impacts().time(0)).isEqualTo(2);
    assertThat(world.vx(0)).isEqualTo(4);
    assertThat(world.x(0)).isEqualTo(5 + 8 * 4);
  }

  @CollidingOrNot
  void beyondItsArrivalItPushesNothing(boolean collide) {
    World world = new World(paddle().circle(5, 0, 1, 0, 0).collide(collide).build());
    world.moveTo(Kind.LINE, 0, 3.9, -10, 4);
    world.advanceTo(100);
    assertThat(world.impacts().size()).isZero();
    assertThat(world.x(0)).isEqualTo(5);
    world.setVelocity(0, -1, 0);
    world.advanceTo(110);
    assertThat(world.impacts().time(0)).isCloseTo(100.1, within(1e-12));
    assertThat(world.vx(0)).isEqualTo(1);
  }

  /** A ball that follows a paddle catches up only as it stops. */
  @CollidingOrNot
  void aBallBehindHitsThePaddleAtRest(boolean collide) {
    World world = new World(paddle().circle(-2, 0, 1, 1, 0).collide(collide).build());
    world.moveTo(Kind.LINE, 0, 4, -10, 4);
    world.advanceTo(10);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.impacts().time(0)).isEqualTo(5);
    assertThat(world.vx(0)).isEqualTo(-1);
  }

  /** One that touches it all the time, too. */
  @CollidingOrNot
  void aBallInTouchHitsThePaddleAsItStops(boolean collide) {
    World world = new World(paddle().circle(-1, 0, 1, 1, 0).collide(collide).build());
    world.moveTo(Kind.LINE, 0, 4, -10, 4);
    world.advanceTo(10);
    assertThat(world.impacts().time(world.impacts().size() - 1)).isEqualTo(4);
    assertThat(world.vx(0)).isEqualTo(-1);
    assertThat(world.x(0)).isEqualTo(-3);
  }

  /** A ball that is set in front of it at the time of its arrival meets a paddle at rest. */
  @CollidingOrNot
  void aBallThatComesAtTheArrivalIsNotPushed(boolean collide) {
    World world = new World(paddle().circle(50, 0, 1, 0, 0).collide(collide).build());
    world.moveTo(Kind.LINE, 0, 4, -10, 4);
    world.advanceTo(4);
    int ball = world.addCircle(5, 0, 1, 0, 0, Traits.DEFAULT);
    world.advanceTo(5);
    assertThat(world.impacts().size()).isZero();
    assertThat(world.vx(ball)).isZero();
  }

  /** With {@code setShape} in each frame most of them pass. */
  @CollidingOrNot
  void aPaddleSentSomewhereInEachFrameLetsNoBallThrough(boolean collide) {
    assertThat(passed(collide, true)).isZero();
    assertThat(passed(collide, false)).isGreaterThan(20);
  }

  /** The number of 300 balls above a floor that moves up and down which come to be below it. */
  private static int passed(boolean collide, boolean pushes) {
    Random random = new Random(3);
    SceneBuilder scene = Scene.builder().bounds(0, -200, 3000, 400).collide(collide);
    scene.line(-10, 0, 3010, 0);
    for (int i = 0; i < 300; i++) {
      scene.circle(5 + 10 * i, 10 + 100 * random.nextDouble(), 1, 0, -300);
    }
    World world = new World(scene.build());
    for (int frame = 1; frame <= 240; frame++) {
      double y = 40 * Math.sin(0.25 * frame);
      if (pushes) {
        world.moveTo(Kind.LINE, 0, -10, y, frame * DT);
        world.advanceTo(frame * DT);
      } else {
        world.advanceTo(frame * DT);
        world.setShape(Kind.LINE, 0, new Line(-10, y, 3010, y));
      }
    }
    int below = 0;
    for (int i = 0; i < 300; i++) {
      below += world.y(i) < world.line(0).ay() ? 1 : 0;
    }
    return below;
  }

  // The past.

  @ParameterizedTest
  @CsvSource({"false, 0", "false, -10", "true, 0", "true, -10"})
  void aTimelineKnowsThePast(boolean collide, double gravity) {
    SceneBuilder scene = paddle().bounds(-20, -20, 20, 20).gravity(0, gravity).collide(collide);
    for (int i = 0; i < 6; i++) {
      scene.circle(3 + 2 * i, 2 * i - 5, 0.8, -i, 1).restitution(0.5);
    }
    World world = new World(scene.build());
    Timeline past = world.record(100);
    List<Line> lines = new ArrayList<>();
    List<Double> places = new ArrayList<>();
    for (int frame = 0; frame <= 60; frame++) {
      if (frame % 10 == 0) {
        world.moveTo(Kind.LINE, 0, 6 * Math.sin(frame), -10 + frame / 10.0, world.now() + 0.7);
      }
      lines.add(world.line(0));
      places.add(world.x(2));
      world.advanceTo((frame + 1) / 10.0);
    }
    for (int frame = 60; frame >= 0; frame--) {
      assertThat(past.shape(Kind.LINE, 0, frame / 10.0)).isEqualTo(lines.get(frame));
      assertThat(past.x(2, frame / 10.0)).isEqualTo(places.get(frame));
    }
    World again = new World(world.scene());
    again.restore(past.snapshot(5.35)); // on the way to the arrival at 5.7
    again.advanceTo(5.95);
    World straight = new World(world.scene());
    straight.restore(past.snapshot(5.95));
    assertThat(again.snapshot()).isEqualTo(straight.snapshot());
  }

  // Questions.

  @Test
  void aCastSeesItOnItsWayAndAtRest() {
    World world = new World(paddle().build());
    world.moveTo(Kind.LINE, 0, 4, -10, 4);
    Circle ball = new Circle(20, 0, 1);
    Impact onTheWay = world.cast(new SweptCircle(ball, new Vec2(-9, 0)), 100).orElseThrow();
    assertThat(onTheWay.time()).isEqualTo(1.9);
    Impact atRest = world.cast(new SweptCircle(ball, new Vec2(-1, 0)), 100).orElseThrow();
    assertThat(atRest.time()).isEqualTo(15);
    assertThat(atRest.point()).isEqualTo(new Vec2(4, 0));
    assertThat(world.cast(new SweptCircle(ball, new Vec2(-1, 0)), 14)).isEmpty();
    assertThat(world.cast(new SweptCircle(new Circle(4, 0, 1), new Vec2(20, 0)), 100)).isEmpty();
    world.advanceTo(4);
    assertThat(world.cast(new SweptCircle(ball, new Vec2(-1, 0)), 100).orElseThrow().time())
        .isEqualTo(15);
    Casts casts = new Casts();
    casts.add(20, 0, 1, -1, 0);
    casts.add(-20, 0, 1, 1, 0);
    world.cast(casts, 100);
    assertThat(casts.time(0)).isEqualTo(15);
    assertThat(casts.time(1)).isEqualTo(23);
    world.advanceTo(5);
    world.cast(casts, 100);
    assertThat(casts.time(0)).isEqualTo(15);
    assertThat(world.velocity(Kind.LINE, 0)).isEqualTo(Vec2.ZERO);
  }

  /** Where circles ignore each other, a path is the one that the world goes. */
  @ParameterizedTest
  @ValueSource(doubles = {0, -10})
  void aTraceFollowsTheWorld(double gravity) {
    Random random = new Random(7);
    for (int i = 0; i < 40; i++) {
      Circle ball = new Circle(-15 + random.nextInt(12), 4, 0.5);
      Vec2 v = new Vec2(8 * random.nextDouble(), random.nextGaussian());
      SceneBuilder scene = paddle().bounds(-20, -20, 20, 20).gravity(0, gravity);
      World world =
          new World(scene.line(-20, -5, 20, -5).circle(ball.x(), 4, 0.5, v.x(), v.y()).build());
      world.moveTo(Kind.LINE, 0, 3 * random.nextGaussian(), -10, 1 + random.nextDouble());
      world.moveTo(Kind.LINE, 1, -20, -6 * random.nextDouble(), 1 + 2 * random.nextDouble());
      Trajectory path = world.trace(0, v.x(), v.y(), 5, 1000);
      for (int k = 1; k <= 50; k++) {
        world.advanceTo(k / 10.0);
        assertThat(path.at(k / 10.0).x()).as("%s at %s", i, k).isCloseTo(world.x(0), within(1e-9));
        assertThat(path.at(k / 10.0).y()).as("%s at %s", i, k).isCloseTo(world.y(0), within(1e-9));
      }
    }
  }
}
