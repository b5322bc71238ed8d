// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SweptCircle;
import dev.carom.Traits;
import dev.carom.World;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.FlightTable;
import dev.carom.internal.state.MovingCircle;
import org.junit.jupiter.api.Test;

/** Worlds of so many lines or pegs that grids list them, and what edits change there. */
class StaticSceneTest {

  private static final int MANY = 20;

  /** A room with many short lines along its ceiling. */
  private static SceneBuilder room() {
    SceneBuilder scene = Scene.builder().collide(false).bounds(0, 0, 100, 100);
    for (int i = 0; i < MANY; i++) {
      scene.line(5 * i, 95, 5 * i + 3, 95);
    }
    return scene;
  }

  /** The time of the first impact of circle 0, which comes from (10, 50) along x. */
  private static double firstImpact(World world) {
    world.advanceTo(world.now() + 100);
    assertThat(world.impacts().size()).isPositive();
    assertThat(world.impacts().circle(0)).isZero();
    return world.impacts().time(0);
  }

  @Test
  void theModelCountsTheCells() {
    SceneBuilder scene = Scene.builder().circle(0, 50, 5, 1, 0);
    for (int i = 0; i < 9; i++) {
      scene.line(10 * i, 0, 10 * i, 40);
    }
    // 80 by 40, grown by the radius on each side, and a ring of cells around: 11 by 7.
    assertThat(Internals.world(scene.build(), EngineOptions.cells(10)).toString())
        .endsWith("; circles that collide, 9 lines and pegs in 1 grid of 77 cells]");
  }

  @Test
  void whatStandsOutAtTheRimIsHit() {
    SceneBuilder scene =
        Scene.builder().collide(false).circle(-50, 9.5, 1, 1, 0).circle(45, 50, 1, 0, -1);
    for (int i = 0; i < MANY; i++) {
      scene.peg(30 * i, 0, 10);
    }
    World world = new World(scene.build());
    assertThat(firstImpact(world))
        .isEqualTo(
            new SweptCircle(-50, 9.5, 1, 1, 0).timeToCircle(new SweptCircle(0, 0, 10, 0, 0), 100));
  }

  /** A new flight would round the place where it begins. */
  @Test
  void aLineThatNoneMeetsChangesNoBit() {
    SceneBuilder scene = room();
    for (int i = 0; i < MANY; i++) {
      scene.circle(20 + i / 3.0, 10 + 3 * i, 1, 0.1 * (i + 1) / 3, 0.01 / (i + 3));
    }
    World world = new World(scene.build());
    World edited = new World(scene.build());
    world.advanceTo(1 / 3.0);
    edited.advanceTo(1 / 3.0);
    edited.addLine(5, 0, 5, 100, Traits.DEFAULT);
    world.advanceTo(10 / 7.0);
    edited.advanceTo(10 / 7.0);
    for (int i = 0; i < MANY; i++) {
      assertThat(edited.x(i)).isEqualTo(world.x(i));
      assertThat(edited.y(i)).isEqualTo(world.y(i));
    }
  }

  /** At the time of an event: before a sensor those of lower codes, before anything else all. */
  @Test
  void sensorsAreReportedBeforeWhatIsFoundAtTheirTime() {
    Scene scene = Scene.builder().line(0, 0, 1, 0).response(Response.SENSOR).peg(0, 0, 1).build();
    StaticScene staticScene = new StaticScene(Internals.data(scene), EngineOptions.CHOSEN);
    assertThat(staticScene.sensedBefore(Codes.line(0))).isEqualTo(Codes.line(0) - 1);
    assertThat(staticScene.sensedBefore(Codes.peg(0))).isEqualTo(Integer.MAX_VALUE);
  }

  /**
   * The flight saved of a circle in (0, 0) whose way along x leads to a sensor, line 1, at time 4.
   */
  private static FlightTable saved(MovingCircle m, double now) {
    SceneBuilder builder = Scene.builder().line(50, 0, 60, 0).circle(0, 0, 1, 1, 0);
    Scene scene = builder.line(5, -9, 5, 9).response(Response.SENSOR).build();
    new StaticScene(Internals.data(scene), EngineOptions.CHOSEN).forgetPrediction(m, now);
    FlightTable states = new FlightTable(1);
    states.put(0, m);
    return states;
  }

  private static MovingCircle sensing(int next, int sensedCode) {
    MovingCircle m = new MovingCircle();
    m.start(0, 0, 0, 1, 1, 0, 1);
    m.cleared = 4;
    m.next = next;
    m.sensedCode = sensedCode;
    return m;
  }

  private static FlightTable reported(double sensed, int code) {
    FlightTable states = new FlightTable(1);
    MovingCircle m = new MovingCircle();
    m.start(0, 0, 0, 1, 1, 0, 1);
    m.forgetPrediction(sensed, code);
    states.put(0, m);
    return states;
  }

  /** Before the time at which it still has something to meet all is told by the time alone. */
  @Test
  void whatWasSensedByNowIsToldWhateverASearchFoundAhead() {
    int sensor = Codes.line(1);
    FlightTable expected = reported(3.5, Integer.MAX_VALUE);
    assertThat(saved(sensing(sensor, 0), 3.5)).isEqualTo(expected);
    assertThat(saved(sensing(MovingCircle.NOTHING, 7), 3.5)).isEqualTo(expected);
    assertThat(saved(sensing(sensor, 0), 4)).isEqualTo(reported(4, sensor - 1));
    assertThat(saved(sensing(Codes.line(0), 0), 4)).isEqualTo(reported(4, Integer.MAX_VALUE));
  }

  /** Where a search ended at a time that is now, another one tells what is still to be met. */
  @Test
  void whatIsStillToBeSensedNowIsSearchedFor() {
    int sensor = Codes.line(1);
    MovingCircle all = sensing(MovingCircle.NOTHING, sensor);
    assertThat(saved(all, 4)).isEqualTo(reported(all.latestBy(4), Integer.MAX_VALUE));
    assertThat(saved(sensing(MovingCircle.NOTHING, 0), 4)).isEqualTo(reported(4, sensor - 1));
  }
}
