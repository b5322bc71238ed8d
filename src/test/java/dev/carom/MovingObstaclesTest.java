// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Lines and pegs with a constant velocity: they push circles, and nothing deflects them. */
class MovingObstaclesTest {

  private static World world(SceneBuilder scene) {
    return new World(scene.build());
  }

  @Test
  void aWallThatMovesWithUTurnsVIntoMinusVPlusTwoU() {
    World world =
        world(Scene.builder().line(0, -10, 0, 10).velocity(3, 0).circle(10, 0, 1, -2, 0.5));
    world.advanceTo(3); // they meet at (10 - 1) / (2 + 3)
    ImpactLog log = world.impacts();
    assertThat(log.size()).isEqualTo(1);
    assertThat(log.time(0)).isEqualTo(9 / 5.0);
    assertThat(log.kind(0)).isEqualTo(Kind.LINE);
    assertThat(log.feature(0)).isEqualTo(Feature.SIDE);
    assertThat(log.approachSpeed(0)).isEqualTo(5);
    assertThat(log.x(0)).isCloseTo(5.4, within(1e-14));
    assertThat(world.vx(0)).isEqualTo(2 + 2 * 3);
    assertThat(world.vy(0)).isEqualTo(0.5);
    assertThat(world.line(0)).isEqualTo(new Line(9, -10, 9, 10));
  }

  @Test
  void aCircleWithoutBounceGoesAlong() {
    World world =
        world(
            Scene.builder()
                .line(0, -50, 0, 50)
                .velocity(3, 0)
                .circle(10, 0, 1, 0, 1)
                .restitution(0));
    world.advanceTo(3);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.vx(0)).isEqualTo(3);
    world.advanceTo(10);
    assertThat(world.impacts().size()).isZero();
    assertThat(world.x(0)).isEqualTo(31);
  }

  @Test
  void anObstacleThatIsToldToStayKeepsTheGrid() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 100, 100);
    for (int i = 0; i < 100; i++) {
      double x = i % 10 * 10 + 3;
      double y = i / 10 * 10 + 3;
      scene.line(x, y, x + 2, y + 2);
    }
    World world = new World(scene.circle(1, 1, 1, 1, 0.3).build());
    world.advanceTo(5);
    String before = world.toString();
    assertThat(before).contains("1 grid");
    world.setVelocity(Kind.LINE, 5, 0, 0);
    assertThat(world).hasToString(before);
  }

  /** What leaves the range of doubles is told to be at its edge. */
  @Test
  void anObstacleStaysWithinTheDoubles() throws Exception {
    World world = new World(Scene.builder().line(0, 0, 1, 0).velocity(1e300, 0).build());
    Timeline timeline = world.record(3);
    world.advanceTo(1e10);
    Line last = new Line(Double.MAX_VALUE, 0, Double.MAX_VALUE, 0);
    assertThat(world.line(0)).isEqualTo(last);
    assertThat(timeline.shape(Kind.LINE, 0, 1e10)).isEqualTo(last);
    world.setVelocity(Kind.LINE, 0, 0, 1);
    assertThat(world.line(0)).isEqualTo(last);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    world.snapshot().write(out);
    assertThat(Snapshot.read(new ByteArrayInputStream(out.toByteArray())))
        .isEqualTo(world.snapshot());
  }

  @Test
  void edgesOfTheInterface() {
    World world = world(Scene.builder().bounds(0, 0, 9, 9).peg(4, 4, 1).circle(1, 1, 1, 0, 0));
    assertThatThrownBy(() -> Scene.builder().circle(0, 0, 1, 0, 0).velocity(1, 0))
        .isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> Scene.builder().peg(0, 0, 1).velocity(1, Double.POSITIVE_INFINITY))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("peg 0: vy is Infinity: expected a finite number");
    world.setVelocity(Kind.CIRCLE, 0, 2, 3);
    assertThat(world.velocity(Kind.CIRCLE, 0)).isEqualTo(new Vec2(2, 3));
    assertThat(world.velocity(Kind.WALL, 0)).isEqualTo(new Vec2(0, 0));
  }

  /** Squeezed between a moving line and a wall, alone or among others, whatever it bounces like. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9, 1, 1.1})
  void aSqueezedCircleIsJammedAndPassedOver(double e) {
    for (boolean collide : new boolean[] {false, true}) {
      for (double vy : new double[] {0, 0.25}) {
        World world =
            world(
                Scene.builder()
                    .collide(collide)
                    .bounds(0, 0, 100, 100)
                    .line(50, -10, 50, 110)
                    .velocity(1, 0)
                    .circle(80, 50, 5, 0.5, vy)
                    .restitution(e));
        String name = "e = " + e + ", collide " + collide + ", vy " + vy;
        boolean jammed = false;
        double last = 0;
        for (int frame = 1; frame <= 120; frame++) {
          world.step(1);
          for (int i = 0; i < world.impacts().size(); i++) {
            jammed |= world.impacts().outcome(i) == Outcome.JAMMED;
            last = world.impacts().time(i);
          }
        }
        assertThat(jammed).as(name).isTrue();
        assertThat(last).as(name).isLessThan(40 + 1e-13); // then the line touches it at the wall
        assertThat(world.vx(0)).as(name).isZero();
        // It is stuck where it moves by less than 2^-16 of its radius between impacts.
        assertThat(world.x(0)).as(name).isCloseTo(95, within(0x1p-16 * 5));
        assertThat(world.line(0).ax()).as(name).isEqualTo(170);
      }
    }
  }

  /**
   * Each impact adds 2 to the speed, and the speed times the gap stays about 36. So the gap is
   * about 0.01 after the 1,536 impacts that make the circle stuck, and it stops within that.
   */
  @Test
  void twoMovingLinesSqueezeACircle() {
    for (boolean collide : new boolean[] {false, true}) {
      for (double mass : new double[] {1, Double.POSITIVE_INFINITY}) {
        World world =
            world(
                Scene.builder()
                    .collide(collide)
                    .line(0, -50, 0, 50)
                    .velocity(1, 0)
                    .line(40, -50, 40, 50)
                    .velocity(-1, 0)
                    .circle(20, 0, 2, 0.3, 0)
                    .mass(mass));
        world.advanceTo(100);
        assertThat(world.velocity(Kind.CIRCLE, 0)).isEqualTo(new Vec2(0, 0));
        assertThat(world.x(0)).isCloseTo(20, within(0.01));
      }
    }
  }

  /** Pushed along a slanted line, a circle without bounce slides: it is not squeezed. */
  @ParameterizedTest
  @ValueSource(doubles = {20, 45, 70})
  void aCircleThatCanEscapeSlides(double degrees) {
    double slope = Math.tan(Math.toRadians(degrees));
    for (boolean collide : new boolean[] {false, true}) {
      World world =
          world(
              Scene.builder()
                  .collide(collide)
                  .line(-500, 0, 500, 1000 * slope)
                  .line(-100, -4000, -100, 4000)
                  .velocity(1, 0)
                  .circle(-80, 480 * slope, 2, 0, -1)
                  .restitution(0));
      world.advanceTo(60);
      assertThat(world.vx(0))
          .as("degrees %s, collide %s", degrees, collide)
          .isCloseTo(1, within(1e-15));
      assertThat(world.vy(0)).as("degrees %s", degrees).isCloseTo(slope, within(1e-15));
      // It touches both lines: the moving one is at -40, and the slanted one is 2 below its centre.
      double above = 2 / Math.cos(Math.toRadians(degrees));
      assertThat(world.x(0)).isCloseTo(-38, within(1e-13));
      assertThat(world.y(0)).isCloseTo(slope * (500 - 38) + above, within(1e-12));
    }
  }

  @Test
  void theNextImpactAfterItWasPassedOverFreesACircle() {
    World world =
        world(
            Scene.builder()
                .bounds(0, 0, 100, 100)
                .line(90, 40, 90, 60)
                .velocity(1, 0)
                .circle(98, 50, 2, 0, 0)
                .circle(20, 50, 2, 1, 0));
    world.advanceTo(30);
    assertThat(world.vx(0)).isZero();
    world.advanceTo(80); // the other circle comes at 74
    assertThat(world.vx(0)).as("it went to the wall and came back").isZero();
    assertThat(world.vx(1)).as("it was hit by it").isEqualTo(-1);
  }

  /** Also where it gets its new velocity at the place and the time at which a flight begins. */
  @CollidingOrNot
  void whatHasLeftACircleThatItCrushedIsMetAgain(boolean collide) {
    World world =
        world(
            Scene.builder()
                .collide(collide)
                .line(-10, -50, -10, 50)
                .velocity(1, 0)
                .line(10, -50, 10, 50)
                .velocity(-1, 0)
                .peg(0, -90, 1)
                .velocity(5, 0)
                .circle(0, 0, 1, 0, 0));
    world.advanceTo(20);
    assertThat(world.velocity(Kind.CIRCLE, 0)).isEqualTo(new Vec2(0, 0));
    world.setShape(
        Kind.PEG, 0, new Circle(-2, 0, 1)); // the circle is stuck, so it goes along with the peg
    world.advanceTo(21);
    assertThat(world.vx(0)).isCloseTo(5, within(1e-12));
    world.remove(Kind.PEG, 0);
    world.advanceTo(24);
    assertThat(world.impacts().size()).as("the line that went ahead").isOne();
    assertThat(world.impacts().id(0)).isZero();
    assertThat(world.impacts().time(0)).isCloseTo(22.25, within(0.01));
    assertThat(world.vx(0)).isCloseTo(2 * 1 - 5, within(1e-12));
  }

  @Test
  void questionsSeeItWhereItIsNow() {
    World world =
        world(Scene.builder().line(0, -10, 0, 10).velocity(3, 0).peg(0, 50, 1).velocity(0, 2));
    world.advanceTo(4);
    assertThat(world.nearest(12, 0, Kind.LINE).map(Nearest::id).orElse(-1)).isZero();
    assertThat(world.overlapping(Kind.LINE, new Circle(12, 0, 0.5))).containsExactly(0);
    assertThat(world.overlapping(Kind.LINE, new Circle(0, 0, 0.5))).isEmpty();
    assertThat(world.overlapping(Kind.PEG, new Bounds(-1, 57, 1, 58))).containsExactly(0);
    Impact impact =
        world.cast(new SweptCircle(new Circle(22, 0, 1), new Vec2(0, 0)), 10).orElseThrow();
    assertThat(impact.time()).isEqualTo(3);
    assertThat(impact.point()).as("where it is then").isEqualTo(new Vec2(21, 0));
    assertThat(impact.approachSpeed()).isEqualTo(3);
    Trajectory path = world.trace(new SweptCircle(new Circle(22, 0, 1), new Vec2(-6, 0)), 1, 2, 5);
    assertThat(path.impacts().get(0).time()).isEqualTo(1);
    assertThat(path.velocityAt(1.5)).isEqualTo(new Vec2(12, 0));
    assertThat(path.impacts().get(0).point()).isEqualTo(new Vec2(15, 0));
    Circle asker = new Circle(0, 64, 1);
    assertThat(world.cast(new SweptCircle(asker, new Vec2(0, -2)), 10).orElseThrow().point())
        .isEqualTo(new Vec2(0, 61));
  }

  @Test
  void anImpactIsWhereTheObstacleIsThen() {
    Circle circle = new Circle(22, 0, 1);
    Line line = new Line(12, -10, 12, 10);
    SweptCircle resting = new SweptCircle(circle, Vec2.ZERO);
    Impact ofLine = resting.cast(line, new Vec2(3, 0), 10).orElseThrow();
    assertThat(ofLine.point()).isEqualTo(new Vec2(21, 0));
    SweptCircle other = new SweptCircle(12, 0, 1, 4, 0);
    Impact ofCircle = resting.cast(other, 10).orElseThrow();
    assertThat(ofCircle.point()).isEqualTo(new Vec2(21, 0));
    assertThat(resting.withAcceleration(0, -1).cast(other, 10)).isEmpty();
    SceneBuilder scene = Scene.builder().circle(12, 0, 1, 4, 0);
    Impact ofWorld = world(scene).cast(new SweptCircle(circle, Vec2.ZERO), 10).orElseThrow();
    assertThat(ofWorld.point()).isEqualTo(new Vec2(21, 0));
    World still = world(Scene.builder().line(12, -10, 12, 10).velocity(3, 0));
    Impact ofScene =
        still.scene().resolver().cast(new SweptCircle(circle, Vec2.ZERO), 10).orElseThrow();
    assertThat(ofScene.point()).isEqualTo(new Vec2(21, 0));
  }

  @Test
  void aSceneFileHasTheVelocity() throws Exception {
    SceneBuilder setup = Scene.builder().line(0, 0, 1, 1).velocity(0.1, -0.2).oneWay();
    Scene scene = setup.peg(5, 5, 1).velocity(0, 3).peg(8, 8, 1).build();
    StringBuilder text = new StringBuilder();
    scene.write(text);
    assertThat(text.toString()).contains("vx=0.1,vy=-0.2").contains("vx=0.0,vy=3.0");
    Scene back = Scene.read(new java.io.StringReader(text.toString()), "moving.csv");
    assertThat(back).isEqualTo(scene);
    assertThat(back.velocity(Kind.PEG, 0)).isEqualTo(new Vec2(0, 3));
    assertThatThrownBy(
            () -> Scene.read(new java.io.StringReader("circle,0,0,1,0,0,vx=1\n"), "bad.csv"))
        .hasMessageContaining("key \"vx\" is unknown");
  }
}
