// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** "It always ends, and says how": circles that jam, and steps that run out of their budget. */
class EndsTest {

  /** The most elastic impacts with obstacles at one place. */
  private static final int PATIENCE = 1_536;

  /** For a call to have work for some thousand impacts only. */
  private static long jammed(Run run) {
    return run.impacts().stream().filter(row -> row.outcome() == Outcome.JAMMED).count();
  }

  // Infinitely many impacts in finite time.

  /**
   * Each bounce takes half of what leads it across, nothing stops what leads it in: infinitely many
   * impacts before the tip, where it stops.
   *
   * <pre>
   *               ____....---
   *   <====----   o ->  (comes from the right)
   *               ''''---....
   * </pre>
   */
  /** A circle that flies into a corner, where it loses half of its speed at each impact. */
  private static SceneBuilder wedge(double opening) {
    SceneBuilder builder = Scene.builder().line(0, 0, 100, opening).restitution(0.5);
    return builder.line(0, 0, 100, -opening).restitution(0.5).circle(50, 0, 0.1, -1, 0.01);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.5, 1, 2, 5})
  void anInelasticWedgeJams(double opening) {
    Run run = Run.advance(new World(wedge(opening).build()), 1000);
    assertThat(jammed(run)).isBetween(1L, 40L);
    assertThat(run.impacts().get(run.impacts().size() - 1).outcome())
        .as("the last row")
        .isEqualTo(Outcome.JAMMED);
    assertThat(run.impacts()).hasSizeBetween(10, 200);
    // It rests where it touches both lines: at the distance radius |w| / opening from the tip.
    double tip = 0.1 * Math.hypot(100, opening) / opening;
    Run.State end = run.end().get(0);
    assertThat(end.x()).isCloseTo(tip, within(1e-12));
    assertThat(end.y()).isCloseTo(0, within(1e-12));
    assertThat(Math.hypot(end.vx(), end.vy())).isZero();
  }

  /** Among circles that could collide, too, it stops where it is, not where its flight started. */
  @ParameterizedTest
  @ValueSource(doubles = {0.5, 2, 3})
  void anInelasticWedgeJamsToTheSameBitsWhereCirclesCollide(double opening) {
    SceneBuilder wedge = wedge(opening);
    Run alone = Run.advance(new World(wedge.build()), 1000);
    assertThat(jammed(alone)).isPositive();
    assertThat(Run.advance(new World(wedge.collide(true).build()), 1000)).isEqualTo(alone);
  }

  @Test
  void aJammedCircleStaysSo() {
    World world = new World(wedge(1).build());
    world.advanceTo(100);
    Run.State before = Run.states(world).get(0);
    Run later = Run.advance(world, 1e3, 1e6, 1e9);
    assertThat(later.impacts()).isEmpty();
    assertThat(later.end()).containsExactly(before);
  }

  /** The counts do not start anew at a step, even at steps of no length. */
  @Test
  void stepsDoNotResetTheCounts() {
    Scene scene = wedge(1).build();
    Run whole = Run.advance(new World(scene), 100);
    World world = new World(scene);
    double[] times = new double[4001];
    for (int i = 0; i < times.length; i++) {
      times[i] = i == times.length - 1 ? 100 : 40 + i * 0x1p-16;
    }
    assertThat(Run.advance(world, times)).isEqualTo(whole);
  }

  /**
   * A corridor of exactly one diameter, the motion neither along nor across it: it bounces without
   * getting anywhere until it may keep no motion across, and then it slides.
   *
   * <pre>
   *   =================
   *       ( o )  ->
   *   =================
   * </pre>
   */
  @Test
  void aStraightCorridorOfOneDiameterIsSlidThrough() {
    List<SceneBuilder> corridors =
        List.of(
            Scene.builder().line(-100, 0, 100, 0).line(-100, 4, 100, 4),
            Scene.builder().bounds(-100, 0, 100, 4));
    for (SceneBuilder corridor : corridors) {
      Run run = Run.advance(new World(corridor.circle(0, 2, 2, 1, 1).build()), 60);
      assertThat(run.impacts()).hasSizeBetween(PATIENCE, 2 * PATIENCE + 10);
      assertThat(run.impacts()).allMatch(row -> row.time() == 0);
      Run.State end = run.end().get(0);
      assertThat(end.x()).isCloseTo(60, within(1e-12));
      assertThat(end.y()).isCloseTo(2, within(1e-12));
      assertThat(end.vx()).isCloseTo(1, within(1e-15));
      assertThat(end.vy()).isCloseTo(0, within(1e-15));
    }
  }

  /** The lines along (4, 3), five apart; v is (4, 3.5), of which (4.24, 3.18) leads along them. */
  @Test
  void aSlantedCorridorOfOneDiameterIsSlidThrough() {
    SceneBuilder setup = Scene.builder().line(-400, -300, 400, 300).line(-403, -296, 397, 304);
    Scene scene = setup.circle(-1.5, 2, 2.5, 4, 3.5).build();
    Run run = Run.advance(new World(scene), 60);
    assertThat(run.impacts()).hasSizeBetween(PATIENCE, 4 * PATIENCE);
    Run.State end = run.end().get(0);
    assertThat(end.x()).isCloseTo(-1.5 + 60 * 4.24, within(1e-12));
    assertThat(end.y()).isCloseTo(2 + 60 * 3.18, within(1e-12));
    assertThat(end.vx()).isCloseTo(4.24, within(1e-12));
    assertThat(end.vy()).isCloseTo(3.18, within(1e-12));
  }

  /**
   * No number is exact here, and rounding may leave less room than the diameter, or some ulps more:
   * 1e16 impacts would be to be made.
   */
  @ParameterizedTest
  @CsvSource({"1,0.3", "1,0.33", "3,-0.7", "0.1,1", "7,5"})
  void corridorsOfAboutOneDiameterNeverGainEnergy(double wx, double wy) {
    double nx = -wy / Math.hypot(wx, wy);
    double ny = wx / Math.hypot(wx, wy);
    for (int ulps = -2; ulps <= 2; ulps++) {
      SceneBuilder builder =
          Scene.builder()
              .line(-99 * wx, -99 * wy, 99 * wx, 99 * wy)
              .line(4 * nx - 99 * wx, 4 * ny - 99 * wy, 4 * nx + 99 * wx, 4 * ny + 99 * wy)
              .circle(2 * nx, 2 * ny, 2 + ulps * Math.ulp(2.0), 1, 0.5);
      World world = new World(builder.build());
      world.advanceTo(20);
      assertThat(world.impacts().size()).isLessThan(2_000);
      assertThat(Math.hypot(world.vx(0), world.vy(0))).isLessThan(Math.hypot(1, 0.5) + 1e-12);
      double across = world.x(0) * nx + world.y(0) * ny;
      assertThat(across).as("stays between the lines").isCloseTo(2, within(1e-12));
    }
  }

  @Test
  void betweenTwoPegsThatLeaveNoRoomItStops() {
    SceneBuilder setup = Scene.builder().peg(0, 0, 1).peg(4, 0, 1).peg(2, -Math.sqrt(3), 0);
    Scene scene = setup.circle(2, 0, Math.sqrt(3), 0.5, -1).build();
    World world = new World(scene);
    world.advanceTo(10);
    assertThat(world.impacts().size()).isLessThan(4 * PATIENCE);
    assertThat(world.y(0)).isGreaterThan(-1e-9);
  }

  /** Each wall adds half: infinitely many impacts in finite time, and no largest speed. */
  @ParameterizedTest
  @CsvSource({"4,0", "4,3.5"})
  void bumpersAboveOneOnAllSidesEndInADefinedState(double vx, double vy) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 10, 10).restitution(1.5);
    World world = new World(scene.circle(5, 4, 1.5, vx, vy).build());
    boolean complete = world.advanceTo(60, Run.WORK);
    for (int call = 1; call < 5 && !complete; call++) {
      complete = world.advanceTo(60, Run.WORK);
    }
    assertThat(complete).isTrue();
    assertThat(world.x(0)).isBetween(1.5 - 1e-9, 8.5 + 1e-9);
    assertThat(world.y(0)).isBetween(1.5 - 1e-9, 8.5 + 1e-9);
    assertThat(world.vx(0)).isFinite();
    assertThat(world.vy(0)).isFinite();
  }

  /**
   * Among circles that collide, too. At speeds at which a circle could cross cells without end
   * within one ulp of the clock, it once went on through those behind the wall instead of hitting
   * it.
   */
  @Test
  void bumpersAboveOneEndAmongCirclesThatCollide() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 40, 40).restitution(1.1);
    scene.circle(37, 20, 2, 0, 0).mass(1e-3).circle(20, 20.5, 3, 1, 0);
    World world = new World(scene.build());
    world.advanceTo(100);
    for (int i = 0; i < 2; i++) {
      assertThat(world.x(i)).isBetween(2 - 1e-9, 38 + 1e-9);
      assertThat(world.y(i)).isBetween(2 - 1e-9, 38 + 1e-9);
    }
  }

  /**
   * It slid along the wall, which was inert for it; N then was larger, and the wall stayed inert.
   */
  @Test
  void aWallAlongWhichACircleSlidIsThereForItWhenAPegTurnsIt() {
    World world =
        new World(
            Scene.builder().collide(false).bounds(-100, 0, 100, 4).circle(0, 2, 2, 1, 1).build());
    world.advanceTo(0);
    world.addCircle(50, 2, 1, 0, 0, Traits.DEFAULT);
    world.addPeg(2, 4, 2 * Math.sqrt(2) - 2, Traits.DEFAULT);
    world.advanceTo(20);
    assertThat(world.y(0)).isBetween(2 - 1e-9, 2 + 1e-9);
  }

  // The budget of a step.

  /** With a small budget each may make 10,000 impacts a call; circles 3 and 5 need far more. */
  private static Scene busy() {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, 64, 64);
    for (int i = 0; i < 800; i++) {
      double speed = i == 3 ? 0x1p22 + 0.5 : i == 5 ? 0x1p21 : 1 + i / 64.0;
      builder.circle(8 + i % 48, 32, 1, speed, 0.25);
    }
    return builder.build();
  }

  private static final double LONG = 0.5;

  @Test
  void anUnfinishedWorldStandsAtAnEarlierTimeAsAWhole() {
    World world = new World(busy());
    assertThat(world.advanceTo(LONG, Run.work(world, 5))).isFalse();
    assertThat(world.now()).isPositive().isLessThan(LONG);
    assertThat(world.impacts().size()).isPositive();
    Run expected = Run.advance(new World(busy()), world.now());
    assertThat(Run.states(world)).isEqualTo(expected.end());
    assertThat(Run.rows(world.impacts())).isEqualTo(expected.impacts());
  }

  @Test
  void furtherCallsGoOnAndNothingIsDropped() {
    World world = new World(busy());
    List<Impact> rows = new ArrayList<>();
    int calls = 0;
    boolean complete;
    do {
      double before = world.now();
      complete = world.advanceTo(LONG, Run.work(world, 5));
      rows.addAll(Run.rows(world.impacts()));
      assertThat(world.now()).isGreaterThan(before);
      calls++;
    } while (!complete);
    assertThat(world.now()).isEqualTo(LONG);
    assertThat(calls).isGreaterThan(2);
    assertThat(new Run(rows, Run.states(world))).isEqualTo(Run.advance(new World(busy()), LONG));
  }

  /** A step that takes back its own impacts leaves those of earlier steps. */
  @Test
  void anUnfinishedStepTakesBackNothingButItsOwn() {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, 64, 64);
    builder.circle(32, 32, 1, 0, 0);
    World world = new World(builder.circle(50, 32, 1, 8, 0).build());
    world.step(2);
    assertThat(world.impacts().size()).isOne();
    world.setVelocity(0, 0x1p21, 0);
    assertThat(world.advanceTo(3, Run.work(world, 5))).isFalse();
    assertThat(Run.rows(world.impacts())).allMatch(row -> row.circle() == 0);
    assertThat(world.vx(1)).isEqualTo(-8);
    assertThat(world.x(1)).isCloseTo(60 - 8 * (world.now() - 2), within(1e-13));
  }

  /** 2,000,000 impacts, of which a circle may make all. */
  @Test
  void theBudgetIsSpentToTheLastImpact() {
    SceneBuilder builder =
        Scene.builder().collide(false).bounds(0, 0, 64, 64).circle(32, 32, 1, 0x1p27, 0);
    World world = new World(builder.circle(32, 32, 1, 0, 0).build());
    assertThatThrownBy(() -> world.step(1)).isInstanceOf(UnfinishedException.class);
    assertThat(world.impacts().size()).isEqualTo(2_000_000);
  }

  /** Impacts so soon that exact numbers tell when, on a slope of a thousand bits. */
  @Test
  void exactWorkIsPartOfTheBudget() {
    SceneBuilder builder =
        Scene.builder().bounds(0, -9, 9, 4).line(0, 0, 8, 0x1p-1000).circle(4, 2, 1, 0, -0x1p260);
    World world = new World(builder.build());
    assertThat(world.advanceTo(6_000 * 0x1p-259, Run.work(world, 5))).isFalse();
    assertThat(world.impacts().size()).isBetween(10, 5_000);
  }
}
