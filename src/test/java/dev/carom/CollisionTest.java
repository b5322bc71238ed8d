// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Two circles of a world, or few: when they collide, what the log says, and when they do not. */
class CollisionTest {

  private static Run run(SceneBuilder builder) {
    return Run.advance(new World(builder.build()), 100);
  }

  @Test
  void theLogNamesBothAndPointsFromTheSecondToTheFirst() {
    Run run = run(Scene.builder().circle(0, 0, 1, 2, 0).circle(12, 0, 3, -2, 0));
    assertThat(run.impacts())
        .containsExactly(
            new Impact(
                2, 0, Kind.CIRCLE, 1, 0, Feature.CIRCLE, 5, 0, -1, 0, 4, 4, Outcome.BOUNCED));
    assertThat(run.end().get(0).vx()).isEqualTo(-2);
    assertThat(run.end().get(1).vx()).isEqualTo(2);
    assertThat(run.end().get(0).x()).isEqualTo(4 - 2 * 98);
  }

  @Test
  void circlesThatIgnoreEachOtherDoNotCollide() {
    Run run = run(Scene.builder().collide(false).circle(0, 0, 1, 2, 0).circle(12, 0, 3, -2, 0));
    assertThat(run.impacts()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(doubles = {2, 1.5, 1e-3})
  void touchingOrOverlappingAndApproachingIsAnImpactAtTheStart(double distance) {
    Run run = run(Scene.builder().circle(0, 0, 1, 1, 0).circle(distance, 0, 1, 0, 0));
    assertThat(run.impacts()).hasSize(1);
    assertThat(run.impacts().get(0).time()).isZero();
    assertThat(run.end().get(0)).as("never nudged").isEqualTo(new Run.State(0, 0, 0, 0));
    assertThat(run.end().get(1).vx()).isEqualTo(1);
  }

  @ParameterizedTest
  @ValueSource(doubles = {2, 1.5, 1e-3})
  void touchingOrOverlappingAndLeavingIsNone(double distance) {
    assertThat(run(Scene.builder().circle(0, 0, 1, -1, 0).circle(distance, 0, 1, 0, 0)).impacts())
        .isEmpty();
    assertThat(run(Scene.builder().circle(0, 0, 1, 0, 1).circle(distance, 0, 1, 0, 0)).impacts())
        .as("tangentially")
        .isEmpty();
    assertThat(run(Scene.builder().circle(0, 0, 1, 3, 1).circle(distance, 0, 1, 3, 1)).impacts())
        .as("with the same velocity")
        .isEmpty();
  }

  /** Collisions at one time go by number, the lower first; one circle is hit from both sides. */
  @Test
  void simultaneousCollisionsAreTakenByNumber() {
    Run run =
        run(Scene.builder().circle(0, 0, 1, 0, 0).circle(-5, 0, 1, 1, 0).circle(5, 0, 1, -1, 0));
    assertThat(run.impacts().stream().map(Impact::time)).containsOnly(3.0);
    assertThat(run.impacts().get(0).id()).isEqualTo(1);
    assertThat(run.impacts().get(1).id()).isEqualTo(2);
    assertThat(run.end().stream().map(Run.State::vx)).containsExactly(0.0, -1.0, 1.0);
  }

  /**
   * Two circles fill a box from wall to wall; a third, heavy one comes down between them. A wall
   * that was inert for a jammed circle once stayed so when the heavy one pushed it on: it left the
   * box.
   */
  @Test
  void squeezedAgainstAWallACircleStaysInside() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 4, 100);
    scene.circle(1, 30, 1, 0, 0).restitution(0).circle(3, 30, 1, 0, 0).restitution(0);
    World world = new World(scene.circle(2, 60, 1, 0, -1e-3).mass(100).restitution(0).build());
    for (int call = 0; call < 20 && world.now() < 1e5; call++) {
      world.advanceTo(1e5);
    }
    assertThat(world.now()).isEqualTo(1e5);
    for (int i = 0; i < 3; i++) {
      assertThat(world.x(i)).isBetween(1 - 1e-9, 3 + 1e-9);
      assertThat(world.y(i)).isBetween(1 - 1e-9, 99 + 1e-9);
    }
  }

  /** Whichever of the two stands where. */
  @ParameterizedTest
  @ValueSource(doubles = {1.2, -1.2})
  void ofTwoThatItMeetsAtOneTimeTheSmallerIdIsFirst(double y) {
    SceneBuilder scene = Scene.builder().circle(0, 0, 1, 1, 0).circle(6, y, 1, 0, 0);
    World world = new World(scene.circle(6, -y, 1, 0, 0).build());
    world.step(5);
    assertThat(world.impacts().time(0)).isCloseTo(4.4, within(1e-15));
    assertThat(world.impacts().circle(0)).isZero();
    assertThat(world.impacts().id(0)).isOne();
    assertThat(world.impacts().id(1)).isEqualTo(2);
    assertThat(world.impacts().time(1)).isEqualTo(world.impacts().time(0));
  }

  /** Before it is certain when two meet, it is known but for some ulps. */
  @Test
  void aStepThatEndsJustBeforeAMeetingDoesNotReportIt() {
    Random random = new Random(1);
    for (int i = 0; i < 200; i++) {
      double speed = 1 + random.nextDouble();
      SceneBuilder builder = Scene.builder().circle(0, random.nextDouble(), 1, speed, 0);
      Scene scene = builder.circle(9 + random.nextDouble(), 0, 1, -random.nextDouble(), 0).build();
      World world = new World(scene);
      world.step(20);
      double time = world.impacts().time(0);
      World cut = new World(scene);
      cut.advanceTo(Math.nextDown(time));
      assertThat(cut.impacts().size()).isZero();
      cut.advanceTo(time);
      assertThat(cut.impacts().size()).isOne();
      assertThat(cut.impacts().time(0)).isEqualTo(time);
    }
  }

  /**
   * An infinite mass slides along a line that halts it, and crushes a circle in a corner. All that
   * is left of its approach to the line is rounding: impacts there change nothing, so the crushed
   * circle is not there for it again.
   */
  @Test
  void anInfiniteMassThatKeepsItsVelocityPassesOverACrushedCircle() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 12800, 10240);
    scene.line(12724, 9499, 12295, 9876).response(Response.HALT).line(10799, 8474, 10384, 7629);
    scene.circle(12136, 8935, 383, 0.9, 1.1).mass(Double.POSITIVE_INFINITY);
    World world = new World(scene.circle(11515, 9225, 1015, 0, 0).restitution(0.9).build());

    world.advanceTo(2000);
    assertThat(world.impacts().size()).isLessThan(500);
  }
}
