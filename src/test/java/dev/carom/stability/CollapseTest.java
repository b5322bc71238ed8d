// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Outcome;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Infinitely many impacts in finite time, since each leaves less to be done: time goes on. More of
 * it: EndsTest, InelasticTest.
 */
class CollapseTest {

  /** A ball that bounces: with restitution e it stops after 2 v / g (1 + e + e^2 ...). */
  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.5, 0.9})
  void aWedgeBringsACircleToRest(double e) {
    // The sum of an event loop's times stands still long before the flights are over.
    double time = 0;
    double flight = 1;
    int events = 0;
    while (time + flight != time) {
      time += flight;
      flight *= e;
      events++;
    }
    assertThat(time).as("a naive event loop never gets past").isLessThanOrEqualTo(1 / (1 - e));
    assertThat(events).isLessThan(1000);

    World world =
        world(
            Scene.builder()
                .line(0, 0, 100, 1)
                .restitution(e)
                .line(0, 0, 100, -1)
                .restitution(e)
                .circle(50, 0, 0.1, -1, 0.01));
    List<Run.Row> hits = Play.finish(world, 1e6, 3);
    assertThat(world.now()).isEqualTo(1e6);
    assertThat(hits.get(hits.size() - 1).outcome()).isEqualTo(Outcome.JAMMED);
    assertThat(Play.speed(world, 0)).isZero();
    // It touches both lines, up to 64 ulps.
    double gap = world.x(0) / Math.hypot(100, 1) - 0.1;
    assertThat(gap).isCloseTo(0, within(64 * Math.ulp(10.0)));
  }

  /** The first and the last one move inwards; all end as one piece, or part slowly. */
  @ParameterizedTest
  @CsvSource({"3, 0.05", "8, 0", "8, 0.3", "20, 0.5"})
  void aChainCollapsesAndGoesOn(int count, double e) {
    SceneBuilder builder = Scene.builder();
    for (int i = 0; i < count; i++) {
      builder
          .circle(3 * i, 0, 1, i == 0 ? 1 : i == count - 1 ? -1 : 0, 0)
          .restitution(Math.sqrt(e));
    }
    World world = world(builder);
    Play.finish(world, 1e4, 20);
    assertThat(world.now()).isEqualTo(1e4);
    double momentum = 0;
    for (int i = 0; i < count; i++) {
      momentum += world.vx(i);
      assertThat(world.vy(i)).isZero();
    }
    assertThat(momentum).isCloseTo(0, within(1e-12));
  }
}
