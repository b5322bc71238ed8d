// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.Impact;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Snapshot;
import dev.carom.Timeline;
import dev.carom.World;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Each check sees what it is there for. */
class ChecksTest extends FlightChecks {

  private static SceneBuilder box() {
    return Scene.builder()
        .collide(false)
        .bounds(0, 0, 100, 100)
        .line(50, 20, 50, 80)
        .peg(80, 50, 4);
  }

  private static Flight flight(double px, double py, double qx, double qy) {
    double speed = Math.hypot(qx - px, qy - py);
    return new Flight(0, 5, 0, 1, px, py, qx, qy, qx - px, qy - py, 0, 0, speed, true);
  }

  @Test
  void flightsThatNobodyMayMakeAreFound() throws FindingException {
    World world = new World(box().circle(20, 50, 5, 1, 0).build());

    assertFound("THROUGH", world, flight(40, 50, 60, 50));
    assertFound("nearer to line 0", world, flight(40, 50, 45.000001, 50));
    assertFound("nearer to line 0", world, flight(30, 15.01, 70, 15.01));
    assertFound("nearer to peg 0", world, flight(60, 41.01, 98, 41.01));
    assertFound("over the left wall", world, flight(10, 50, 4.9999, 50));
    check(world, flight(40, 50, 45, 50));
    check(world, flight(30, 15, 70, 15));
    check(world, flight(60, 41, 95, 41));
  }

  /** A line that goes right and a peg that goes left; each flight takes one unit of time. */
  private static World withMovingThings() {
    SceneBuilder scene = box().line(10, 5, 10, 95).velocity(20, 0).peg(95, 90, 3).velocity(-30, 0);
    World world = new World(scene.circle(20, 50, 5, 1, 0).build());
    world.setTraits(
        Kind.CIRCLE,
        0,
        world.traits(Kind.CIRCLE, 0).withResponse(Response.SENSOR)); // nothing happens to it
    world.advanceTo(1);
    return world;
  }

  @Test
  void flightsThroughThingsThatMoveAreFound() throws FindingException {
    World world = withMovingThings();
    assertThat(world.line(1)).isEqualTo(new Line(30, 5, 30, 95));

    assertFound("THROUGH", world, flight(20, 50, 20, 50));
    assertFound("THROUGH", world, flight(20, 50, 28, 50));
    assertFound("nearer to line 1", world, flight(20, 50, 34.999999, 50));
    assertFound("nearer to peg 1", world, flight(80, 82.01, 80, 82.01));
    check(world, flight(20, 50, 35, 50));
    check(world, flight(9, 50, 25, 50));
    check(world, flight(80, 81.99, 80, 81.99));
    check(world, flight(95, 81, 65, 81.9)); // it flies along below the peg
  }

  /** A line that turns from upright to level in one unit of time. */
  @Test
  void flightsThroughThingsThatTurnAreFound() throws FindingException {
    World world = new World(box().circle(20, 50, 5, 1, 0).response(Response.SENSOR).build());
    Timeline timeline = world.record(10);
    world.turn(Kind.LINE, 0, 50, 50, Math.PI / 2, 1);
    world.advanceTo(1);
    rounding.keepPlace(100);
    TurnCheck turns = new TurnCheck(world, rounding, passed, Set.of("line 0"), timeline);

    for (Flight hit : List.of(flight(60, 50, 60, 50), flight(40, 30, 40, 90))) {
      assertThatThrownBy(() -> turns.check(List.of(List.of(hit))))
          .isInstanceOf(FindingException.class)
          .hasMessageContaining("nearer to line 0, which turns, than");
    }
    turns.check(List.of(List.of(flight(90, 50, 90, 50), flight(60, 60, 75, 70))));
    check(world, flight(60, 60, 75, 70)); // it is level now
  }

  @Test
  void thingsThatMovePassOverJammedCirclesOnly() throws FindingException {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 100, 100).line(50, 0, 50, 100).velocity(8, 0);
    World squeezed = new World(scene.circle(94, 50, 5, 0, 0).build());
    passed.enter(squeezed);
    squeezed.advanceTo(6);
    double x = squeezed.x(0);
    Flight standing = new Flight(0, 5, 5.5, 6, x, 50, x, 50, 0, 0, 0, 0, 0, true);
    Flight moving = new Flight(0, 5, 5.5, 6, x, 50, x, 50.5, 0, 1, 0, 0, 1, true);

    assertFound("nearer to line 0", squeezed, standing);
    passed.read(squeezed.impacts());
    check(squeezed, standing);
    assertFound("nearer to line 0", squeezed, moving);
    squeezed.setVelocity(0, 1, 0);
    passed.end();
    assertFound("nearer to line 0", squeezed, standing);
  }

  /** It was nearer already, and does not come still nearer. */
  @Test
  void whatOverlapsMayLeave() throws FindingException {
    World world = new World(box().circle(20, 50, 5, 1, 0).build());

    check(world, flight(48, 50, 40, 50));
    check(world, flight(3, 50, 3, 60));
    assertFound("nearer to line 0", world, flight(48, 50, 49, 50));
  }

  @Test
  void whatIsNotThereIsPassed() throws FindingException {
    World world = new World(box().circle(20, 50, 5, 1, 0).build());

    world.setTraits(Kind.LINE, 0, world.traits(Kind.LINE, 0).withOneWay(true));
    check(world, flight(60, 50, 40, 50));
    assertFound("THROUGH", world, flight(40, 50, 60, 50));
    world.setTraits(Kind.LINE, 0, world.traits(Kind.LINE, 0).withResponse(Response.SENSOR));
    check(world, flight(40, 50, 60, 50));
  }

  @Test
  void circlesThatPassThroughEachOtherAreFound() throws FindingException {
    World world =
        new World(box().collide(true).circle(20, 50, 5, 1, 0).circle(20, 70, 5, 0, 0).build());
    Flight up = flight(20, 50, 20, 90);
    Flight resting = flight(25, 70, 25, 70);

    assertFound("come nearer", world, up, resting);
    check(world, up, flight(30, 70, 30, 70));
  }

  @Test
  void aFlightThatTurnsWithoutAnImpactIsFound() {
    World world = new World(box().circle(20, 50, 5, 1, 0).build());
    Timeline timeline = world.record(10);
    world.step(1);
    world.setVelocity(0, 0, 1);
    world.step(1);

    assertThatThrownBy(
            () -> new StepFlights(world, timeline, 0, rounding, new DeepHits(), false).all())
        .isInstanceOf(FindingException.class)
        .hasMessageContaining("not continuous");
  }

  @Test
  void energyThatIsLostOrGainedIsFound() throws FindingException {
    for (double e : new double[] {0.5, 1.5}) {
      World world = new World(box().circle(20, 50, 5, -9, 0).restitution(e).build());
      EnergyCheck energy = new EnergyCheck(world, 1);
      energy.begin();
      world.step(3);

      energy.end();
      world.setTraits(Kind.CIRCLE, 0, world.traits(Kind.CIRCLE, 0).withRestitution(1));
      assertThatThrownBy(energy::end)
          .isInstanceOf(FindingException.class)
          .hasMessageContaining("energy of circle 0 went from 81.0");
    }
  }

  @Test
  void energyFromNowhereIsFoundBesideThingsThatMove() throws FindingException {
    SceneBuilder scene =
        Scene.builder().collide(false).line(0, -10, 0, 10).velocity(1, 0).circle(3, 0, 1, 0, 0);
    World world = new World(scene.circle(3, 50, 1, 1, 0).build());
    EnergyCheck energy = new EnergyCheck(world, 1);
    energy.begin();
    world.step(3);
    assertThat(world.vx(0)).isEqualTo(2);
    energy.end();
    world.setVelocity(1, 2, 0);
    assertThatThrownBy(energy::end).hasMessageContaining("energy of circle 1 went from 1.0 to 4.0");
  }

  /** Infinite masses give and take energy, but only where they meet others. */
  @Test
  void energyFromNowhereIsFoundBesideInfiniteMasses() throws FindingException {
    SceneBuilder scene = Scene.builder();
    scene.circle(0, 0, 1, 1, 0).mass(Double.POSITIVE_INFINITY).circle(4, 0, 1, 0, 0);
    World world = new World(scene.build());
    EnergyCheck energy = new EnergyCheck(world, 1);
    energy.begin();
    world.step(1);
    energy.end();
    world.setVelocity(1, 3, 0);
    assertThatThrownBy(energy::end).hasMessageContaining("energy of all went from 0.0 to 9.0");
    world.setVelocity(1, 0, 0);
    energy.begin();
    world.step(2);
    assertThat(world.vx(1)).isEqualTo(2);
    energy.end();
  }

  @Test
  void theLogOfAStepIsAsItMustBe() throws FindingException {
    World world = new World(box().circle(20, 50, 5, -9, 3).build());
    world.step(3);

    LogCheck.check(world, 0);
    assertThat(world.impacts().size()).isPositive();
    assertThatThrownBy(() -> LogCheck.check(world, 2.5)).hasMessageContaining("row 0 is at");
  }

  @Test
  void whoLeavesTheBoundsIsFound() throws FindingException {
    World world = new World(box().circle(20, 50, 5, 1, 0).build());
    PlaceCheck places = new PlaceCheck();
    places.enter(world);
    places.begin();
    world.setPosition(0, 5, 50);
    places.end(false);
    world.setPosition(0, 5 - 1e-12, 50);
    assertThatThrownBy(() -> places.end(false)).hasMessageContaining("circle 0 left the bounds by");
    places.begin();
    world.setPosition(0, -9, 50);
    places.end(false); // it was outside
  }

  private static SceneBuilder doors() {
    SceneBuilder builder = Scene.builder().circle(0, 0, 1, 0, 0);
    builder.circle(-5, 0, 1, 1, 0).mass(Double.POSITIVE_INFINITY);
    return builder.circle(5, 0, 1, -1, 0).mass(Double.POSITIVE_INFINITY);
  }

  @Test
  void infiniteMassesPassOverCrushedCirclesOnly() throws FindingException {
    World world = new World(doors().build());
    world.advanceTo(3.5);
    Flight resting = new Flight(0, 1, 3.5, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, true);
    Flight door = new Flight(1, 1, 3.5, 4, -1.5, 0, -1, 0, 1, 0, 0, 0, 1, true);
    Flight moving = new Flight(0, 1, 3.5, 4, 0, 0, 0.1, 0, 0.2, 0, 0, 0, 0.2, true);

    assertFound("come nearer", world, resting, door);
    masses.read(world.impacts());
    check(world, resting, door);
    assertFound("come nearer", world, moving, door);
    world.advanceTo(9);
    masses.end();
    assertFound("come nearer", world, resting, door);
  }

  @Test
  void anInfiniteMassThatIsDeflectedIsFound() throws FindingException {
    World world = new World(doors().build());
    masses.enter(world);
    Flight before = new Flight(1, 1, 0, 1, -5, 0, -4, 0, 1, 0, 0, 0, 1, true);
    Flight after = new Flight(1, 1, 1, 2, -4, 0, -3.5, 0, 0.5, 0, 0, 0, 1, true);
    masses.check(List.of(List.of(before)));
    assertThatThrownBy(() -> masses.check(List.of(List.of(before, after))))
        .hasMessageContaining("deflected an infinite mass");
  }

  @Test
  void infiniteMassesThatBounceOffEachOtherAreFound() throws FindingException {
    World world = new World(Scene.builder().circle(0, 0, 1, 1, 0).circle(3, 0, 1, 0, 0).build());
    masses.enter(world);
    world.step(2);
    masses.read(world.impacts());
    world.setTraits(
        Kind.CIRCLE, 0, world.traits(Kind.CIRCLE, 0).withMass(Double.POSITIVE_INFINITY));
    world.setTraits(
        Kind.CIRCLE, 1, world.traits(Kind.CIRCLE, 1).withMass(Double.POSITIVE_INFINITY));
    assertThatThrownBy(() -> masses.read(world.impacts()))
        .hasMessageContaining("infinite masses 0 and 1: BOUNCED");
  }

  private static World trapped() {
    return new World(
        Scene.builder()
            .line(-10, -2, 10, -2)
            .line(-8, -6, 4, 8)
            .line(8, -6, -4, 8)
            .circle(0, 0, 5, 3, 1)
            .collide(false)
            .build());
  }

  @Test
  void whoIsJammedAndGoesOnIsFound() throws FindingException {
    World world = trapped();
    Timeline timeline = world.record(10_000);
    JamCheck jam = new JamCheck(Set.of(0), 1);
    world.step(1);
    jam.check(world, timeline, true);
    world.setVelocity(0, 1, 2);
    world.step(1);
    assertThatThrownBy(() -> jam.check(world, timeline, true))
        .hasMessageContaining("circle 0 was jammed, and makes another row");
    jam.edited();
    jam.check(world, timeline, true);
  }

  @Test
  void whoStillMovesAfterAStepMayMakeMoreRows() throws FindingException {
    World world = trapped();
    Timeline timeline = world.record(10_000);
    JamCheck jam = new JamCheck(Set.of(0), 1);
    jam.check(world, timeline, true);
    world.step(1);
    jam.check(world, timeline, true);
  }

  @Test
  void whoMakesTooManyRowsAtOnePlaceIsFound() throws FindingException {
    World world = trapped();
    Timeline timeline = world.record(10_000);
    JamCheck jam = new JamCheck(Set.of(), 1);
    world.step(1);
    jam.check(world, timeline, true);
    assertThatThrownBy(() -> jam.check(world, timeline, true))
        .hasMessageContaining("circle 0 made 1601 rows at one place");
  }

  /** As if something had hit it, that moves. */
  @Test
  void whoIsFreedMayBeJammedAgain() throws FindingException {
    World world = trapped();
    Timeline timeline = world.record(10_000);
    JamCheck jam = new JamCheck(Set.of(), 1);
    for (int i = 0; i < 3; i++) {
      world.step(1);
      jam.check(world, timeline, true);
      world.setVelocity(0, 1, 2);
    }
  }

  @Test
  void whatDependsOnHowItIsPlayedIsFound() throws FindingException {
    World world = new World(box().circle(20, 50, 5, -9, 3).circle(60, 50, 5, 2, 3).build());
    OtherWays ways = new OtherWays(world.scene(), 1);
    Snapshot before = world.snapshot();
    Timeline timeline = world.record(100);
    world.step(9);
    ways.check(before, world, timeline);
    Snapshot between = world.snapshot();
    world.setVelocity(0, 8, 2);
    world.step(9);
    assertThatThrownBy(() -> ways.check(between, world, timeline)).hasMessageContaining("expected");
    ways.checkAlone(1, between, world, rows(world, 1));
    assertThatThrownBy(() -> ways.checkAlone(0, between, world, rows(world, 0)))
        .hasMessageContaining("circle 0 alone");
  }

  private static List<Impact> rows(World world, int circle) {
    return OtherWays.rows(world).stream().filter(row -> row.circle() == circle).toList();
  }

  @Test
  void aStepThatDoesNotEndIsFound() throws FindingException {
    Scene scene = Scene.builder().bounds(0, 0, 2.000001, 9).circle(1, 5, 1, 99, 0).build();
    StepWatch watch = new StepWatch(scene, 1, Set.of(), null, 100, 1);
    watch.step(1e-6);
    watch.demandEnd();
    watch.step(1);
    assertThatThrownBy(watch::demandEnd).hasMessageContaining("a step did not end, at 0.0");
  }
}
