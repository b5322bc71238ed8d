// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static dev.carom.Kind.CIRCLE;
import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Impact;
import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.Nearest;
import dev.carom.Response;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SweptCircle;
import dev.carom.Timeline;
import dev.carom.Traits;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.internal.state.EngineOptions;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Circles that come and go: those that went cost nothing any more, and nothing else tells of it. A
 * world beside keeps the room of all that ever were there.
 */
class TurnoverTest {

  private static final int LIVE = 30;
  private static final int STEPS = 1000;

  private final Random random = new Random(1);
  private final Deque<Integer> live = new ArrayDeque<>();
  private World world;
  private World beside;

  private void begin(boolean collide, double slack) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 200, 200).collide(collide);
    for (int i = 0; i < 20; i++) {
      scene.line(10 * i, 90 + i, 10 * i + 5, 100).peg(10 * i, 40, 1);
      if (i % 5 == 0) {
        scene.response(Response.SENSOR);
      }
    }
    world = Internals.world(scene.build(), new EngineOptions(true, 0, 1, slack));
    beside = Internals.world(scene.build(), new EngineOptions(true, 0, 1, Double.MAX_VALUE));
    for (int i = 0; i < LIVE; i++) {
      come();
    }
  }

  private void come() {
    double x = 10 + 180 * random.nextDouble();
    double y = 10 + 180 * random.nextDouble();
    double r = 1 + 4 * random.nextDouble();
    double vx = 20 * random.nextDouble() - 10;
    double vy = 20 * random.nextDouble() - 10;
    double mass = 1 + random.nextInt(3);
    Response response = random.nextInt(4) == 0 ? Response.SENSOR : Response.BOUNCE;
    Traits traits = Traits.DEFAULT.withMass(mass).withResponse(response);
    int id = world.addCircle(x, y, r, vx, vy, traits);
    assertThat(beside.addCircle(x, y, r, vx, vy, traits)).isEqualTo(id);
    live.add(id);
  }

  private void go() {
    while (random.nextInt(10) == 0) {
      live.add(live.remove()); // some stay for long
    }
    int id = live.remove();
    world.remove(CIRCLE, id);
    beside.remove(CIRCLE, id);
    assertThat(world.contains(CIRCLE, id)).isFalse();
  }

  @ParameterizedTest
  @CsvSource({"false, 0", "false, 1", "true, 0", "true, 1"})
  void whoWentIsForgottenAndNothingElse(boolean collide, double slack) {
    begin(collide, slack);
    Timeline past = world.record(1000);
    Timeline pastBeside = beside.record(1000);
    int impacts = 0;
    for (int i = 0; i < STEPS; i++) {
      for (int k = random.nextInt(6); k > 0; k--) {
        go();
        come();
      }
      double dt = 0.3 * random.nextDouble();
      world.step(dt);
      beside.step(dt);
      assertThat(Run.rows(world.impacts())).isEqualTo(Run.rows(beside.impacts()));
      assertThat(world.ids(CIRCLE)).isEqualTo(beside.ids(CIRCLE)).hasSize(world.count(Kind.CIRCLE));
      compareQuestions();
      if (i % 20 == 0) {
        assertThat(world.snapshot()).isEqualTo(beside.snapshot());
      }
      impacts += world.impacts().size();
    }
    assertThat(impacts).isGreaterThan(STEPS / 2);
    assertThat(world.idLimit(CIRCLE)).isEqualTo(beside.idLimit(CIRCLE)).isGreaterThan(2200);
    int slots = (int) (slack * (LIVE + 1024)) + LIVE + 6; // 6: those of a step
    assertThat(Internals.circles(world).capacity()).isLessThanOrEqualTo(2 * slots + 4);
    assertThat(Internals.circles(beside).capacity()).isGreaterThan(2 * slots + 4);
    int recorded = 0;
    for (int id = 0; id < world.idLimit(CIRCLE); id++) {
      double t = world.now() * random.nextDouble();
      assertThat(past.contains(CIRCLE, id, t)).isEqualTo(pastBeside.contains(CIRCLE, id, t));
      if (past.contains(CIRCLE, id, t)) {
        assertThat(past.x(id, t)).isEqualTo(pastBeside.x(id, t));
        recorded++;
      }
    }
    assertThat(recorded).isPositive();
  }

  private void compareQuestions() {
    double x = 200 * random.nextDouble();
    double y = 200 * random.nextDouble();
    Circle disk = new Circle(x, y, 30);
    Bounds box = new Bounds(x, y, x + 50, y + 50);
    assertThat(world.nearest(x, y, CIRCLE).map(Nearest::id).orElse(-1))
        .isEqualTo(beside.nearest(x, y, CIRCLE).map(Nearest::id).orElse(-1));
    assertThat(world.overlapping(CIRCLE, disk)).isEqualTo(beside.overlapping(CIRCLE, disk));
    assertThat(world.overlapping(CIRCLE, box)).isEqualTo(beside.overlapping(CIRCLE, box));
    Optional<Impact> hit = world.cast(new SweptCircle(new Circle(x, y, 0), new Vec2(1, 2)), 1e9);
    assertThat(hit)
        .isEqualTo(beside.cast(new SweptCircle(new Circle(x, y, 0), new Vec2(1, 2)), 1e9));
    int id = live.peek();
    assertThat(world.x(id)).isEqualTo(beside.x(id));
    assertThat(world.vy(id)).isEqualTo(beside.vy(id));
    assertThat(world.traits(CIRCLE, id)).isEqualTo(beside.traits(CIRCLE, id));
  }
}
