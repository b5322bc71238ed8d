// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.advance;
import static dev.carom.stability.Play.among;
import static dev.carom.stability.Play.assertState;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Through a line of zero thickness, at any speed: at both ends of the frame it is far away. */
class TunnellingTest {

  private static final Line FLOOR = new Line(-100, 0, 100, 0);
  private static final Circle CIRCLE = new Circle(0, 10, 1);

  @ParameterizedTest
  @ValueSource(doubles = {0x1p10, 0x1p20, 0x1p40, 0x1p300, 1e150})
  void aFastCircleBounces(double speed) {
    Naive naive = new Naive(CIRCLE, new Vec2(0, -speed), FLOOR);
    naive.overlapTest(1);
    assertThat(naive.y).as("tunnels").isNegative();
    Naive fine = new Naive(CIRCLE, new Vec2(0, -speed), FLOOR);
    fine.substeps(1, 8);
    assertThat(fine.y).as("tunnels in substeps too").isNegative();

    World world = world(among(FLOOR).circle(0, 10, 1, 0, -speed));
    assertThat(advance(world, 1)).singleElement().matches(hit -> hit.time() == 9 / speed);
    // 9 down to the contact at y = 1, and up again what is left of the speed.
    assertState(world, 0, 0, Math.fma(speed, 1 - 9 / speed, 1), 0, speed);
  }

  /** Two circles pass through each other as lines do. */
  @ParameterizedTest
  @ValueSource(doubles = {0x1p10, 0x1p40, 0x1p300})
  void twoFastCirclesCollide(double speed) {
    // Frame ends are all that a discrete test sees: here they have changed sides.
    assertThat(0 + speed).isGreaterThan(10 - speed);

    World world = world(Scene.builder().circle(0, 0, 1, speed, 0).circle(10, 0, 1, -speed, 0));
    assertThat(advance(world, 8 / speed)).singleElement().matches(hit -> hit.time() == 4 / speed);
    assertThat(world.vx(0)).isEqualTo(-speed);
    assertThat(world.vx(1)).isEqualTo(speed);
  }

  /** A room of four lines, from which the naive circle is gone after its first frame. */
  @ParameterizedTest
  @ValueSource(doubles = {1e3, 1e4, 1e5})
  void aRoomKeepsAFastCircle(double speed) {
    Line[] room = {
      new Line(0, 0, 20, 0), new Line(20, 0, 20, 20), new Line(20, 20, 0, 20), new Line(0, 20, 0, 0)
    };
    Naive naive = new Naive(new Circle(10, 7, 1), new Vec2(speed, speed / 3), room);
    naive.overlapTest(1);
    assertThat(naive.x).as("is outside").isGreaterThan(20);

    World world = world(among(room).circle(10, 7, 1, speed, speed / 3));
    for (int frame = 1; frame <= 20; frame++) {
      advance(world, frame);
      assertThat(world.x(0)).isBetween(1 - 1e-9, 19 + 1e-9);
      assertThat(world.y(0)).isBetween(1 - 1e-9, 19 + 1e-9);
    }
  }
}
