// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Kind;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Timeline;
import dev.carom.World;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A crowd whose impacts make it ever faster, until its flights are too short for the clock: nobody
 * is told to be outside the bounds, in steps that finish and in others.
 */
class BumpersTest {

  private static final double SIZE = 100;

  private static final double RADIUS = 4;

  private static final double ROUNDING = 4 * Math.ulp(SIZE);

  private static World crowd(double e, boolean collide) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, SIZE, SIZE).restitution(e).collide(collide);
    Random random = new Random(3);
    for (int i = 0; i < 100; i++) {
      double vx = random.nextDouble() - 0.5;
      double vy = random.nextDouble() - 0.5;
      scene.circle(5 + 9 * (i % 10), 5 + 9 * (i / 10), RADIUS, vx, vy).restitution(e);
    }
    return new World(scene.build());
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({
    "1.2, true, true",
    "1.5, true, true",
    "1.5, false, false",
    "3, true, false",
    "3, false, false"
  })
  void nobodyLeavesTheBounds(double e, boolean collide, boolean outruns) {
    World world = crowd(e, collide);
    Timeline past = world.record(2);
    boolean unfinished = false;
    double fastest = 0;
    for (int frame = 0; frame < 12; frame++) {
      unfinished |= !world.advanceTo(world.now() + 1, Run.WORK);
      for (int row = 0; row < world.impacts().size(); row++) {
        double speed = world.impacts().approachSpeed(row);
        fastest = speed > fastest ? speed : fastest; // beyond the range of doubles it is NaN
      }
      for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
        assertInside(world.x(i), frame, i);
        assertInside(world.y(i), frame, i);
        assertThat(past.x(i, world.now())).isEqualTo(world.x(i));
        assertThat(past.y(i, world.now())).isEqualTo(world.y(i));
      }
      world.setVelocity(frame, world.vx(frame), world.vy(frame)); // begins a new flight there
    }
    assertThat(unfinished).as("circles that outrun the clock").isEqualTo(outruns);
    if (collide) {
      assertThat(fastest).isGreaterThan(1e20);
    }
  }

  private static void assertInside(double p, int frame, int i) {
    assertThat(p)
        .as("frame %s, circle %s", frame, i)
        .isBetween(RADIUS - ROUNDING, SIZE - RADIUS + ROUNDING);
  }
}
