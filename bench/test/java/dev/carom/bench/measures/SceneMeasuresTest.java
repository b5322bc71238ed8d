// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static dev.carom.bench.measures.Found.reason;
import static dev.carom.bench.measures.Found.value;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.results.Row;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SceneMeasuresTest {

  private static final int FRAMES = 20;

  /** Three circles of radius 2 and 4 that meet nothing. */
  private static final Scene FREE =
      Scene.builder()
          .collide(false)
          .circle(0, 0, 2, 1, 0)
          .circle(0, 50, 2, 3, 0)
          .circle(0, 100, 4, 0, 2)
          .build();

  private static List<Row> rows(Scene scene, Contender contender) {
    Subject subject =
        new Subject("a scene", scene, FRAMES, Optional.of(new FreeFlight(scene, FRAMES)));
    return ScenePart.measure(new Trial("a scene", contender), subject);
  }

  @Test
  void theErrorOfAFrameDoesNotAddUp() {
    List<Row> rows = rows(FREE, Drunkard.astray(0.06));

    assertThat(value(rows, "frame_error", "max")).isCloseTo(0.03, within(1e-13));
    assertThat(value(rows, "frame_error", "median")).isCloseTo(0.03, within(1e-13));
    assertThat(rows.get(0).n()).isEqualTo(60);
  }

  /** 0.03 radii a frame for two circles: more than 0.1 after 4; 0.015 for the third: after 7. */
  @Test
  void theHorizonIsTheFirstFrameBeyondATenthOfARadius() {
    List<Row> rows = rows(FREE, Drunkard.astray(0.06));

    assertThat(value(rows, "horizon", "any")).isEqualTo(4);
    assertThat(value(rows, "horizon", "median")).isEqualTo(4);
    assertThat(value(rows, "drift_trajectory", "median@10")).isCloseTo(0.3, within(1e-12));
    assertThat(value(rows, "drift_trajectory", "p5@20")).isCloseTo(0.3, within(1e-12));
    assertThat(value(rows, "drift_trajectory", "p95@20")).isCloseTo(0.6, within(1e-12));
  }

  @Test
  void aRunThatIsNeverLostHasItsHorizonBeyondTheLastFrame() {
    List<Row> rows = rows(FREE, Methods.CAROM);

    assertThat(value(rows, "horizon", "any")).isEqualTo(FRAMES + 1);
    assertThat(value(rows, "frame_error", "max")).isZero();
    assertThat(value(rows, "reversal_error", "max")).isZero();
    assertThat(value(rows, "energy_drift", "max")).isZero();
  }

  /** Speed times 1.01 a frame: energy times 1.0201. */
  @Test
  void energyIsThatOfTheWorstCircle() {
    List<Row> rows = rows(FREE, Drunkard.gaining(1.01));

    assertThat(value(rows, "energy_drift", "max"))
        .isCloseTo(Math.pow(1.0201, FRAMES) - 1, within(1e-12));
    assertThat(value(rows, "drift_energy", "p5@10"))
        .isCloseTo(Math.pow(1.0201, 10) - 1, within(1e-12));
  }

  /** 30 radii of 2 at a speed of 2: 30 frames there and 30 back, astray by 0.06 of radius 2. */
  @Test
  void reversalDoesNotUndoAFaultThatHasADirection() {
    List<Row> rows = rows(FREE, Drunkard.astray(0.06));

    assertThat(value(rows, "reversal_error", "max")).isCloseTo(1.8, within(1e-12));
  }

  /** A line from (0, 0) to (0, 10), and a circle of radius 1 that meets nothing. */
  @ParameterizedTest(name = "{0}")
  @CsvSource({
    "across the middle,                       -1.5,  5,   1,   0, 1, 0.5",
    "beyond the end,                          -1.5, 10.5, 1,   0, 0, 0.292893218813",
    "beside it,                               -1.5,  5,   0,   1, 0, 0",
    "along it,                                   0, -5,   0,   1, 0, 1",
    "up to it and no further,                -20.5,  5,   1,   0, 0, 0.5"
  })
  void aCircleThatCrossesALineHasTunnelled(
      String story, double x, double y, double vx, double vy, int count, double depth) {
    Scene scene = Scene.builder().line(0, 0, 0, 10).circle(x, y, 1, vx, vy).build();

    List<Row> rows = rows(scene, Drunkard.astray(0));

    assertThat(value(rows, "tunnelled", "circles")).as(story).isEqualTo(count);
    assertThat(value(rows, "penetration", "max")).isCloseTo(depth, within(1e-12));
  }

  /** From (-3, 9) by an impact above the end to (3, 9): the way round fits into the frame. */
  @Test
  void aLegalTripRoundAnEndIsNoTunnelling() {
    Scene scene =
        Scene.builder().line(0, 0, 0, 10).line(-5, 13, 5, 13).circle(-3, 9, 1, 3, 3).build();
    RecordedRun run = RecordedRun.play(Methods.CAROM, scene, 2);

    assertThat(run.x(2, 0)).isEqualTo(3);
    assertThat(run.y(2, 0)).isEqualTo(9);
    assertThat(value(new Solidity(scene, run).rows(trial()), "tunnelled", "circles")).isZero();
  }

  private static Trial trial() {
    return new Trial("a scene", Methods.CAROM);
  }

  @Test
  void whoLeavesTheBoundsHasEscaped() {
    SceneBuilder setup =
        Scene.builder().collide(false).bounds(0, 0, 100, 100).circle(50, 50, 5, 3, 0);
    Scene scene = setup.circle(50, 50, 5, 1, 0).build();

    List<Row> rows = rows(scene, Drunkard.astray(0));

    assertThat(value(rows, "escaped", "circles")).isEqualTo(1);
    assertThat(value(rows, "outside_at_end", "circles")).isEqualTo(1);
    // At 98 of 100 the circle of radius 5 is 3 deep; beyond the wall it is none of its concern.
    assertThat(value(rows, "penetration", "max")).isEqualTo(0.6);
    assertThat(value(rows(scene, Methods.CAROM), "escaped", "circles")).isZero();
  }

  @Test
  void workIsPerFrame() {
    List<Row> rows = rows(FREE, Drunkard.astray(0));

    assertThat(value(rows, "pair_tests", "mean")).isEqualTo((FRAMES + 1) / 2.0);
    assertThat(value(rows, "wall_impacts", "mean")).isEqualTo(3);
    assertThat(value(rows, "impacts", "mean")).as("it does not tell").isNaN();
  }

  @Test
  void aFailureIsTold() {
    List<Row> rows = rows(FREE, Drunkard.falling(12));

    assertThat(reason(rows)).isEqualTo("frame 13: it fell");
    assertThat(value(rows, "horizon", "any")).isEqualTo(13);
    assertThat(value(rows, "energy_drift", "max")).isNaN();
    assertThat(value(rows, "penetration", "max")).isNaN();
    assertThat(value(rows, "tunnelled", "circles")).isNaN();
    assertThat(value(rows, "reversal_error", "max")).isNaN();
    assertThat(value(rows, "drift_trajectory", "median@10")).isZero();
    assertThat(value(rows, "drift_trajectory", "median@20")).isNaN();
    assertThat(value(rows(FREE, Drunkard.falling(0)), "frame_error", "max")).isNaN();
  }

  @Test
  void whoCannotRunSaysWhy() {
    Contender absent = Drunkard.absent("no natives for this machine");

    List<Row> rows = new ScenePart("base-1", absent).run();

    assertThat(reason(rows)).isEqualTo("no natives for this machine");
    assertThat(value(rows, "frame_error", "max")).isNaN();
  }
}
