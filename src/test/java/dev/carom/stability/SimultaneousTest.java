// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.advance;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Circle;
import dev.carom.Energy;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Three and more impacts at one moment, in a fixed order. */
class SimultaneousTest {

  /** A wall, a line and a peg at once: by kind, and after each response the world looks afresh. */
  @Test
  void wallLineAndPegAreTakenInThisOrder() {
    Line line = new Line(-5, 0, 5, 0);
    Naive naive = new Naive(new Circle(3, 3, 1), new Vec2(-2, -2), line, new Line(0, 0, 0, 9));
    naive.oneImpactPerFrame(1);
    assertThat(naive.speed() > 0 && (naive.vx < 0 || naive.vy < 0))
        .as("one impact a frame leaves it moving into the other line")
        .isTrue();

    // At time 2 it touches the left wall at x = 0, the line below, and the peg on its left.
    World world =
        world(
            Scene.builder()
                .bounds(0, -9, 20, 20)
                .line(-5, 0, 5, 0)
                .peg(-1, 1, 1)
                .circle(5, 5, 1, -2, -2));
    List<Run.Row> hits = advance(world, 4);
    assertThat(hits).extracting(Run.Row::time).containsOnly(2.0);
    assertThat(hits)
        .extracting(Run.Row::kind)
        .as("no approach to the peg is left")
        .containsExactly(Kind.WALL, Kind.LINE);
    Play.assertState(world, 0, 5, 5, 2, 2);
  }

  /** A ring of circles closes in on the one in the middle, all of them at once. */
  @ParameterizedTest
  @ValueSource(ints = {3, 4, 6, 12})
  void manyMeetOneAtOnce(int count) {
    Scene scene = ring(count, 10).build();
    World world = new World(scene);
    World again = new World(scene);
    List<Run.Row> hits = Play.finish(world, 100, 5);
    assertThat(Play.finish(again, 100, 5)).as("the same order").isEqualTo(hits);
    assertThat(hits).hasSizeGreaterThanOrEqualTo(count);
    assertThat(Energy.of(world)).isCloseTo(0.5 * count, within(1e-12));
    assertThat(momentum(world)).isCloseTo(0, within(1e-12));
  }

  /** A circle at rest, and others around it that move towards it. */
  private static SceneBuilder ring(int count, double distance) {
    SceneBuilder builder = Scene.builder().circle(0, 0, 1, 0, 0);
    double size = count > 6 ? 0.25 : 0.9;
    for (int i = 0; i < count; i++) {
      double x = Math.cos(2 * Math.PI * i / count);
      double y = Math.sin(2 * Math.PI * i / count);
      builder.circle(distance * x, distance * y, size, -x, -y);
    }
    return builder;
  }

  private static double momentum(World world) {
    double px = Run.states(world).stream().mapToDouble(Run.State::vx).sum();
    double py = Run.states(world).stream().mapToDouble(Run.State::vy).sum();
    return Math.hypot(px, py);
  }
}
