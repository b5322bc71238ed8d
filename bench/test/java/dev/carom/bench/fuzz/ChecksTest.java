// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.ObstacleKind;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Timeline;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Each check sees what it is there for. */
class ChecksTest {

  private final Rounding rounding = new Rounding();

  private static SceneBuilder box() {
    return Scene.builder().bounds(0, 0, 100, 100).line(50, 20, 50, 80).peg(80, 50, 4);
  }

  private static Flight flight(double px, double py, double qx, double qy) {
    double speed = Math.hypot(qx - px, qy - py);
    return new Flight(0, 5, 0, 1, px, py, qx, qy, qx - px, qy - py, speed);
  }

  private void check(World world, Flight... flights) throws FindingException {
    rounding.keepPlace(100);
    rounding.keepSpeed(100, 100);
    new Crossings(world, rounding).check(List.of(flights).stream().map(List::of).toList());
  }

  private void assertFound(String message, World world, Flight... flights) {
    assertThatThrownBy(() -> check(world, flights))
        .isInstanceOf(FindingException.class)
        .hasMessageContaining(message);
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

    world.setOneWay(0, true);
    check(world, flight(60, 50, 40, 50));
    assertFound("THROUGH", world, flight(40, 50, 60, 50));
    world.setResponse(ObstacleKind.LINE, 0, Response.SENSOR);
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

    assertThatThrownBy(() -> new StepFlights(world, timeline, 0, rounding).all())
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
      world.setRestitution(ObstacleKind.CIRCLE, 0, 1);
      assertThatThrownBy(energy::end)
          .isInstanceOf(FindingException.class)
          .hasMessageContaining("energy of circle 0 went from 81.0");
    }
  }

  /** Infinite masses give and take energy, but only where they meet others. */
  @Test
  void energyFromNowhereIsFoundBesideInfiniteMasses() throws FindingException {
    World world =
        new World(
            Scene.builder()
                .collide(true)
                .circle(0, 0, 1, 1, 0)
                .mass(Double.POSITIVE_INFINITY)
                .circle(4, 0, 1, 0, 0)
                .build());
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
}
