// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Circle;
import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Snapshot;
import dev.carom.SweptCircle;
import dev.carom.Timeline;
import dev.carom.Traits;
import dev.carom.Vec2;
import dev.carom.World;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Scenes, steps and edits of any finite doubles: each is taken or refused, no place is NaN, no step
 * goes on without end, and the world goes on after each refusal. {@code -Dcarom.worlds=3000} plays
 * more of them.
 */
class ExtremeWorldsTest {

  private static final int WORLDS = Integer.getInteger("carom.worlds", 300);

  /** Only some worlds may use all their budget: it is spent in exact arithmetic of huge numbers. */
  private static final int SEEDS_OF_FULL_BUDGET = 15;

  @Test
  @Tag("long")
  @Timeout(value = 600, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void worldsGoOn() {
    int refused = 0;
    int impacts = 0;
    for (int seed = 0; seed < WORLDS; seed++) {
      Extremes e = new Extremes(seed);
      World world = new World(scene(e));
      int ofEach = seed % SEEDS_OF_FULL_BUDGET == 0 ? 1_000 : 10;
      Timeline timeline = world.record(10);
      double pace = fastest(world);
      for (int frame = 0; frame < 4; frame++) {
        double dt = e.random.nextDouble() * 50 / pace;
        world.advanceTo(world.now() + Math.min(dt, 1e300), Run.work(world, ofEach));
        check(world);
        impacts += world.impacts().size();
        refused += edit(world, e) ? 0 : 1;
        check(world);
        pace = fastest(world);
        assertThat(timeline.x(0, world.now())).isNotNaN();
      }
    }
    assertThat(refused).isPositive();
    assertThat(impacts).isPositive();
  }

  /** A scene of size 10, with any speeds. */
  private static Scene scene(Extremes e) {
    SceneBuilder builder = Scene.builder().collide(e.random.nextBoolean());
    if (e.random.nextBoolean()) {
      builder.bounds(-10, -10, 10, 10);
    }
    for (int i = 0; i < 4; i++) {
      builder.line(place(e), place(e), place(e), place(e)).restitution(e.random.nextInt(3) / 2.0);
    }
    builder.peg(place(e), place(e), e.size());
    for (int i = 0; i < 3; i++) {
      builder.circle(place(e), place(e), 0.1 + e.random.nextDouble(), e.any(), e.any());
      builder.mass(e.mass());
    }
    return builder.build();
  }

  private static double place(Extremes e) {
    double any = e.any();
    return Math.abs(any) <= 10 ? any : 10 * e.random.nextDouble();
  }

  private static double fastest(World world) {
    double fastest = Double.MIN_NORMAL;
    for (int id = 0; id < world.idLimit(Kind.CIRCLE); id++) {
      fastest = Math.max(fastest, Math.max(Math.abs(world.vx(id)), Math.abs(world.vy(id))));
    }
    return fastest;
  }

  /** One edit; false if it is refused. */
  private static boolean edit(World world, Extremes e) {
    try {
      switch (e.random.nextInt(8)) {
        case 0 -> world.setVelocity(0, e.any(), e.any());
        case 1 -> world.setPosition(1, e.any(), e.any());
        case 2 -> world.setShape(Kind.CIRCLE, 2, new Circle(world.x(2), world.y(2), e.any()));
        case 3 -> world.addLine(e.any(), e.any(), e.any(), e.any(), Traits.DEFAULT);
        case 4 -> world.addPeg(e.any(), e.any(), e.any(), Traits.DEFAULT);
        case 5 -> world.addCircle(e.any(), e.any(), e.size(), e.any(), e.any(), Traits.DEFAULT);
        case 6 -> {
          Snapshot snapshot = world.snapshot();
          world.advanceTo(world.now(), Run.WORK); // done or not
          world.restore(snapshot);
        }
        default -> {
          Circle circle = new Circle(e.any(), e.any(), e.size());
          assertThat(world.cast(new SweptCircle(circle, new Vec2(e.any(), e.any())), e.window()))
              .isNotNull();
          assertThat(world.overlapping(Kind.LINE, circle)).isNotNull();
        }
      }
      return true;
    } catch (IllegalArgumentException refused) {
      assertThat(refused).hasMessageContaining("expected").hasMessageNotContaining("NaN");
      return false;
    }
  }

  private static void check(World world) {
    assertThat(world.now()).isFinite();
    for (Run.State state : Run.states(world)) {
      assertThat(state.x()).isNotNaN();
      assertThat(state.y()).isNotNaN();
      assertThat(state.vx()).isFinite();
      assertThat(state.vy()).isFinite();
    }
    ImpactLog log = world.impacts();
    for (int row = 0; row < Math.min(log.size(), 100); row++) {
      assertThat(log.x(row)).isFinite();
      assertThat(log.y(row)).isFinite();
      assertThat(log.approachSpeed(row)).isNotNaN();
      assertThat(Math.hypot(log.nx(row), log.ny(row))).isCloseTo(1, within(1e-15));
    }
  }
}
