// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.advance;
import static dev.carom.stability.Play.among;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Vec2;
import dev.carom.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Corners down to a hundredth of a degree. Unfolded, the way in and out is a straight line through
 * pi / angle copies of the corner: so many reflections, or one less. More of it: WedgeTest.
 */
class CornerTest {

  private static final double LENGTH = 0x1p20;

  @ParameterizedTest
  @ValueSource(doubles = {90, 30, 10, 1, 0.1, 0.01})
  void aCircleComesOutOfACorner(double degrees) {
    double angle = Math.toRadians(degrees);
    Line floor = new Line(0, 0, LENGTH, 0);
    Line roof = new Line(0, 0, LENGTH * Math.cos(angle), LENGTH * Math.sin(angle));
    // Along the bisector, from where there is room for eight of its diameters.
    double distance = 16 / Math.sin(angle);
    double x = distance * Math.cos(angle / 2);
    double y = distance * Math.sin(angle / 2);
    double vx = -x / distance;
    double vy = -y / distance + 1e-3 * angle;
    double t = 3 * distance;

    Naive naive = new Naive(new Circle(x, y, 1), new Vec2(vx, vy), floor, roof);
    naive.impactsPerFrame(t, 2);
    double still = (naive.x - x) * vx + (naive.y - y) * vy;

    World world = world(among(floor, roof).circle(x, y, 1, vx, vy));
    int count = advance(world, t).size();
    int most = (int) Math.ceil(Math.PI / angle - 1e-9);
    assertThat(count).isBetween(most - 1, most);
    assertThat(Play.speed(world, 0)).isCloseTo(Math.hypot(vx, vy), within(1e-13));
    // 3 distances of way: in to the tip, but for the radius, and back out.
    assertThat(Math.hypot(world.x(0), world.y(0))).isGreaterThan(distance);
    if (most > 3) {
      assertThat(still).as("two impacts a frame do not lead out").isPositive();
    }
  }
}
