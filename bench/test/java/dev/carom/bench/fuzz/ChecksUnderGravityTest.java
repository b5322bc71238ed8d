// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.Kind;
import dev.carom.Outcome;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Timeline;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Each check sees what it is there for, where circles fall. */
class ChecksUnderGravityTest extends FlightChecks {

  private static SceneBuilder box() {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 100, 100).gravity(0, -8);
    return builder.line(30, 20, 70, 20).peg(80, 50, 4);
  }

  private static World world() {
    return new World(box().circle(20, 50, 5, 1, 0).build());
  }

  /** For one unit of time, from a place with a velocity. */
  private static Flight flight(double px, double py, double vx, double vy) {
    return flight(px, py, vx, vy, -8, true);
  }

  private static Flight flight(
      double px, double py, double vx, double vy, double ay, boolean begins) {
    double qy = py + vy + ay / 2;
    return new Flight(0, 5, 0, 1, px, py, px + vx, qy, vx, vy, 0, ay, Math.abs(vy) + 8, begins);
  }

  /** It is at rest for a moment after half a unit of time, one unit above or below its start. */
  @Test
  void parabolasThatNobodyMayFlyAreFound() throws FindingException {
    World world = world();

    check(world, flight(50, 14, 0, 4).within(0, 0.4));
    assertFound("nearer to line 0", world, flight(50, 14.1, 0, 4));
    check(world, flight(50, 14, 0, 4));
    check(world, flight(50, 26, 0, 0).within(0, 0.5));
    assertFound("nearer to line 0", world, flight(50, 26, 0, 0).within(0, 0.51));
    assertFound("THROUGH", world, flight(50, 26, 0, -30));
    check(world, flight(76, 40, 8, 4));
    assertFound("nearer to peg 0", world, flight(76, 40.01, 8, 4));
    check(world, flight(8, 94, 0, 4));
    assertFound("over the top wall", world, flight(8, 94.01, 0, 4));
  }

  /** Its chord is clear of the end of the line, the arc above it is not. */
  @Test
  void anArcOverAnObstacleIsNoChord() throws FindingException {
    World world = world();

    check(world, flight(18, 19, 8, 4).within(0, 0.5));
    assertFound("nearer to line 0", world, flight(20.5, 14.5, 8, 8));
  }

  /** Deep inside, a circle is hit back at the depth at which it started. */
  @Test
  void whatWasHitLastIsHitAgainAsDeepAsAtTheStart() throws FindingException {
    World world = world();

    check(world, flight(50, 22, 0, 4));
    assertFound("nearer to line 0", world, flight(50, 22, 0, 3.9));
    check(world, flight(50, 22, 0, 3.9, -8, false)); // its start may have been deeper
    check(world, flight(50, 3, 0, 4));
    assertFound("over the bottom wall", world, flight(50, 3, 0, 3.9));
  }

  @Test
  void aFallThroughAPlatformIsFound() throws FindingException {
    World world = world();
    world.setTraits(Kind.LINE, 0, world.traits(Kind.LINE, 0).withOneWay(true));

    check(world, flight(50, 10, 0, 30));
    assertFound("nearer to line 0", world, flight(50, 40, 0, -30));
    assertFound("nearer to line 0", world, flight(50, 25, 0, 1));
    check(world, flight(50, 15, 0, 1));
  }

  /** They fall alike, or one of them rests. */
  @Test
  void circlesThatFallThroughEachOtherAreFound() throws FindingException {
    World world =
        new World(box().collide(true).circle(20, 50, 5, 1, 0).circle(20, 70, 5, 0, 0).build());
    Flight below = flight(20, 50, 0, 0);

    check(world, below, flight(20, 60, 0, 0));
    assertFound("come nearer", world, below, flight(20, 60.1, 0, -0.2));
    check(world, flight(20, 50, 0, 0, 0, true), flight(20, 64, 0, 0));
    assertFound("come nearer", world, flight(20, 50, 0, 0, 0, true), flight(20, 63.9, 0, 0));
  }

  private List<Flight> flights(World world, Timeline timeline) throws FindingException {
    return new StepFlights(world, timeline, 0, rounding, new DeepHits(), false).all().get(0);
  }

  /** A slide off a table and a fall: the log knows nothing of the edge. */
  @Test
  void theEndOfASlideIsFound() throws FindingException {
    SceneBuilder scene = Scene.builder().gravity(0, -8).line(0, 0, 10, 0);
    World world = new World(scene.circle(7, 1, 1, 4, 0).restitution(0).build());
    Timeline timeline = world.record(10);
    world.step(2);

    assertThat(world.impacts().size()).isOne();
    assertThat(world.impacts().outcome(0)).isEqualTo(Outcome.SETTLED);
    List<Flight> flights = flights(world, timeline);
    Flight first = flights.get(0);
    Flight last = flights.get(flights.size() - 1);
    assertThat(first.ay()).isZero();
    assertThat(last.ay()).isEqualTo(-8);
    new SupportCheck(world, rounding, passed).check(List.of(flights));
  }

  @Test
  void whoHitSomethingDeepInsideIsKnown() {
    World world = world();
    DeepHits deep = new DeepHits();
    for (double y : new double[] {27, 23}) {
      world.setPosition(0, 50, y);
      world.setVelocity(0, 0, -1);
      Timeline timeline = world.record(10);
      world.step(0.7);
      deep.read(world, timeline);
      assertThat(world.impacts().size()).isPositive();
      assertThat(deep.isDeep(0)).isEqualTo(y == 23);
    }
  }

  /** It goes on sliding in the line after it has met a light circle. */
  @Test
  void aCollisionDoesNotEndADeepSlide() {
    SceneBuilder scene = Scene.builder().gravity(0, -8).line(0, 20, 100, 20);
    scene.circle(20, 23, 5, 4, -1).restitution(0);
    World world = new World(scene.circle(40, 24, 4, 0, 0).restitution(0).mass(1e-9).build());
    DeepHits deep = new DeepHits();
    Timeline timeline = world.record(10);
    world.step(3);
    deep.read(world, timeline);
    assertThat(world.impacts().kind(2)).isEqualTo(Kind.CIRCLE);
    assertThat(deep.isDeep(0)).isTrue();
    deep.read(world, timeline);
    assertThat(deep.isDeep(0)).isTrue();
    assertThat(deep.isDeep(1)).isFalse();
  }

  @Test
  void aTurnWithoutAnImpactIsFound() {
    World world = world();
    Timeline timeline = world.record(10);
    world.step(1);
    world.setPosition(0, 20, 60);
    world.step(1);

    assertThatThrownBy(() -> flights(world, timeline)).hasMessageContaining("not continuous");
  }

  @Test
  void whatHangsInTheAirIsFound() throws FindingException {
    World world = world();
    SupportCheck support = new SupportCheck(world, rounding, passed);

    support.check(List.of(List.of(flight(20, 50, 0, 0))));
    support.check(List.of(List.of(flight(50, 25, 3, 0, 0, true))));
    support.check(List.of(List.of(flight(20, 5, 3, 0, 0, true))));
    support.check(List.of(List.of(flight(80, 59, 3, 0, 0, true))));
    for (Flight hanging : List.of(flight(20, 50, 0, 0, 0, true), flight(80, 59.1, 3, 0, 0, true))) {
      assertThatThrownBy(() -> support.check(List.of(List.of(hanging))))
          .hasMessageContaining("nothing carries");
    }
    assertThatThrownBy(() -> support.check(List.of(List.of(flight(50, 25, 3, 0, -4, true)))))
        .hasMessageContaining("does not fall by a part of");
  }

  @Test
  void whoLeavesTheBoundsIsFoundUnlessItWasOutside() throws FindingException {
    World world = world();
    PlaceCheck places = new PlaceCheck();
    places.enter(world);
    places.begin();
    world.setPosition(0, 4, 50);
    assertThatThrownBy(() -> places.end(false)).hasMessageContaining("circle 0 left the bounds by");
    places.begin();
    world.setPosition(0, 9, 50);
    places.begin();
    world.setPosition(0, 4, 50);
    places.end(false);
    world.setPosition(0, 9, 50);
    world.setGravity(0, 0);
    places.begin();
    world.setPosition(0, 4, 50);
    assertThatThrownBy(() -> places.end(false)).hasMessageContaining("circle 0 left the bounds by");
  }

  @Test
  void energyOfMotionAndHeightTogetherIsCompared() throws FindingException {
    World world = world();
    EnergyCheck energy = new EnergyCheck(world, 1);
    energy.begin();
    world.step(5);
    energy.end();
    assertThat(world.y(0)).isNotEqualTo(50);
    world.setPosition(0, world.x(0), world.y(0) + 1e-9);
    assertThatThrownBy(energy::end).hasMessageContaining("energy of all went from 801.0");
  }

  /** The velocity of a ball that rolls off a peg may lag behind its place by a bit, and no more. */
  @Test
  void contactMayAddABitOfEnergy() throws FindingException {
    World world = new World(box().circle(80.001, 59, 5, 0, 0).restitution(0.5).build());
    EnergyCheck energy = new EnergyCheck(world, 1);
    energy.begin();
    world.step(0.01);
    assertThat(world.impacts().kind(0)).isEqualTo(Kind.PEG);
    energy.end();
    world.setVelocity(0, 0, 5);
    assertThatThrownBy(energy::end).hasMessageContaining("energy of all went from 944.0");
  }
}
