// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Impact;
import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.Response;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Snapshot;
import dev.carom.World;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.MovingCircle;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which circles jam, what ends a jam, and what an edit clears. */
class CollidingEngineTest {

  /** More impacts than obstacles have to make a circle stuck. */
  private static final int MANY = 1_600;

  /**
   * The middle one meets both others at moments when both begin new flights: it never stood still.
   *
   * <pre>
   *   | (0)->   <-(2)   (1)-> |
   * </pre>
   */
  @Test
  void whoMeetsAnotherAtTheTimeOfItsOwnStartHasMoved() {
    SceneBuilder row = Scene.builder().bounds(0, 0, 12, 10);
    row.circle(2, 5, 1, 1, 0).circle(10, 5, 1, 1, 0).circle(6, 5, 1, -1, 0);
    World world = new World(row.build());
    for (int k = 0; k < MANY; k++) {
      world.step(2);
    }
    int rows = world.impacts().size();
    assertThat(rows).isEqualTo(2);
    assertThat(world.impacts().kind(rows - 1)).isEqualTo(Kind.CIRCLE);
    assertThat(world.impacts().approachSpeed(rows - 1)).isEqualTo(2);
    assertThat(Math.abs(world.vx(2))).isOne();
  }

  /**
   * The first one passes its motion through the second, which touches the rock, and gets it back:
   * the rock is hit at once by what begins its flight there, but has waited for it.
   *
   * <pre>
   *   |  (0)->   (1)( 2 )
   * </pre>
   */
  @Test
  void whoWaitedForWhatHitsItAtOnceHasNotStoodStill() {
    SceneBuilder cradle = Scene.builder().bounds(0, 0, 100, 10);
    cradle.circle(3, 5, 1, 1, 0).circle(7, 5, 1, 0, 0).circle(11, 5, 3, 0, 0);
    World world = new World(cradle.mass(Double.POSITIVE_INFINITY).build());
    for (int k = 0; k < MANY; k++) {
      world.step(8);
      assertThat(world.impacts().size()).isEqualTo(4);
    }
    assertThat(world.vx(0)).isOne();
  }

  /** A third of a time after 1: such a time has a tail. */
  private static final double THIRD = 0x1.5555555555555p-2;

  /** It stays in its place, but what hits it again and again comes from far away. */
  @Test
  void whoRestsIsNotStuckHoweverOftenItIsHit() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 100, 20);
    scene.circle(50, 10, 5, 0, 0).mass(Double.POSITIVE_INFINITY).circle(20, 10, 1, -43, 0);
    World world = new World(scene.build());
    int impacts = 0;
    for (int i = 1; i <= 100; i++) {
      world.advanceTo(100 * i);
      impacts += world.impacts().size();
    }
    assertThat(impacts).isEqualTo(10_000);
    assertThat(Math.abs(world.vx(1))).isEqualTo(43);
  }

  /**
   * The step ends at the double nearest to the moment of contact, a little before it: the flight
   * that an edit begins there begins at that moment. Put back a little, and so fast that a time
   * does not tell its contact from its beginning, it is reported anew.
   */
  @Test
  void whatASensorReportedIsNewToAFlightThatBeginsBeforeIt() {
    SceneBuilder scene = Scene.builder().circle(2, 0, 1, 0, 0);
    World world = new World(scene.response(Response.SENSOR).circle(-THIRD, 0, 1, 0, 0).build());
    world.advanceTo(1);
    world.setVelocity(1, 1, 0);
    world.advanceTo(1 + THIRD);
    assertThat(world.impacts().size()).isOne();
    assertThat(world.x(1)).isEqualTo(-0x1p-54);
    world.step(0);
    assertThat(world.impacts().size()).as("of the same flight").isZero();
    world.setVelocity(1, 1, 0);
    assertThat(world.x(1)).isZero();
    world.step(0);
    assertThat(world.impacts().size()).as("of one that begins with the contact").isZero();
    world.setPosition(1, -0x1p-50, 0);
    world.setVelocity(1, 0x1p90, 0);
    // Within the last place of the clock it flies 2^38 radii far.
    world.step(0);
    assertThat(world.impacts().size()).as("of a new one").isOne();
    assertThat(world.impacts().time(0)).isEqualTo(1 + THIRD);
  }

  /**
   * So late that the first circle, from its cell of now, comes to the second one within the last
   * place of the time: put back by an ulp, the second one is met again at the time to which the
   * first has reported it, and it is the first that finds it.
   */
  @Test
  void aNewFlightIsNewToWhomReportedItsOldOneJustThen() {
    SceneBuilder scene = Scene.builder().circle(-8, 0, 1, 0, 0);
    World world = new World(scene.circle(2, 0, 1, 0, 0).response(Response.SENSOR).build());
    world.advanceTo(0x1p40);
    world.setVelocity(0, 0x1p17, 0);
    world.step(0);
    assertThat(world.impacts().size()).isOne();
    Snapshot reported = world.snapshot();
    world.setPosition(1, Math.nextUp(2.0), 0);
    world.step(0);
    assertThat(world.impacts().size()).isOne();
    assertThat(world.impacts().time(0)).isEqualTo(0x1p40);

    // An edit comes after the report, and does so in a world that goes on from there.
    World other = new World(world.scene());
    other.restore(reported);
    other.setVelocity(1, 0, 0x1p17);
    other.advanceTo(Math.nextUp(0x1p40));
    assertThat(other.y(1)).isEqualTo(0x1p17 * (0x1p-12 - 0x1p-14));
  }

  @Test
  void aSensorReportsAgainWhatIsGoneBackTo() {
    SceneBuilder scene = Scene.builder().circle(-8, 0, 1, 1, 0);
    World world = new World(scene.circle(2, 0, 1, 0, 0).response(Response.SENSOR).build());
    Snapshot before = world.snapshot();
    for (int k = 0; k < 2; k++) {
      world.step(9);
      assertThat(world.impacts().size()).isOne();
      world.restore(before);
    }
  }

  /** Relative speed of an approach beside a speed of 1: half of that of two. */
  private static final double FAINT = 0x1p-48;

  /**
   * Two that are jammed to each other rise together. The second one comes by little more than
   * rounding; by less, as long as the first one moves away, to a line that takes that from it.
   *
   * <pre>
   *   | (0)(1)
   * </pre>
   */
  @Test
  void whatATurnAtALineDrivesTogetherIsThereAgain() {
    for (int first = 0; first < 2; first++) {
      assertThat(hits(first, 2.25 * FAINT)).startsWith(Kind.LINE, Kind.CIRCLE);
      assertThat(hits(first, 1.25 * FAINT)).containsExactly(Kind.LINE);
    }
  }

  /** The kinds of the obstacles that are hit if the circle of that id moves to the line. */
  private static List<Kind> hits(int first, double speedOfTheSecond) {
    SceneBuilder builder = Scene.builder().line(-1, -9, -1, 9);
    for (int i = 0; i < 2; i++) {
      boolean second = i != first;
      builder.circle(second ? 2 : 0, 0, 1, second ? -speedOfTheSecond : -FAINT / 2, 1);
    }
    Scene scene = builder.build();
    World world = new World(scene);
    Snapshot jammed = world.snapshot();
    for (int i = 0; i < 2; i++) {
      MovingCircle m = new MovingCircle();
      Internals.state(jammed).flights().get(i, m);
      m.jam = IgnoreList.with(null, Codes.circle(1 - i));
      Internals.state(jammed).flights().put(i, m);
    }
    world.restore(jammed);
    world.step(1);
    return Run.rows(world.impacts()).stream().map(Impact::kind).toList();
  }

  /** It is in no cell: an edit takes it out of none, and one that brings it back into one. */
  @Test
  void whoFliesOutOfTheRangeOfDoublesCanBeBroughtBack() {
    double unit = 1e306;
    SceneBuilder scene = Scene.builder().circle(0, 0, unit, 100 * unit, 0);
    World world = new World(scene.circle(0, 9 * unit, unit, 0, 0).build());
    world.advanceTo(2);
    assertThat(world.x(0)).isInfinite();
    for (int k = 0; k < 3; k++) {
      world.setVelocity(0, -unit, 0);
      world.step(1);
    }
    world.setPosition(0, 0, 4 * unit);
    world.setVelocity(0, 0, unit);
    world.step(4);
    assertThat(world.impacts().size()).isOne();
    assertThat(world.vy(1)).isEqualTo(unit);
  }

  /** Twice such a coordinate is beyond it. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void circlesMeetNearTheEndOfTheRangeOfDoubles(boolean upright) {
    SceneBuilder scene = Scene.builder();
    for (double place : new double[] {1.5e308, 1.6e308}) {
      double v = place < 1.6e308 ? 1e304 : 0;
      scene.circle(
          upright ? 0 : place, upright ? place : 0, 1e306, upright ? 0 : v, upright ? v : 0);
    }
    World world = new World(scene.build());
    world.step(1_000);
    assertThat(world.impacts().size()).isOne();
  }
}
