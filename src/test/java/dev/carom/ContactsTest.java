// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

/** What a circle stands on. */
class ContactsTest {

  private static List<String> names(World world, int circle) {
    return world.contacts(circle).stream().map(c -> c.kind() + " " + c.id()).toList();
  }

  private static void assertNormal(Contact contact, double nx, double ny) {
    assertThat(contact.nx()).isCloseTo(nx, within(1e-2));
    assertThat(contact.ny()).isCloseTo(ny, within(1e-2));
    assertThat(Math.hypot(contact.nx(), contact.ny())).isCloseTo(1, within(1e-15));
    assertThat(contact.part()).isZero();
  }

  /** A ball on the ground: in flight none, then the ground, also at rest, and none after a jump. */
  @Test
  void ofABallOnTheGround() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .bounds(0, 0, 99, 99)
                .circle(50, 3, 1, 0, 0)
                .restitution(0.4)
                .build());
    assertThat(world.contacts(0)).isEmpty();
    world.step(0.5);
    assertThat(world.contacts(0)).as("it bounces").isEmpty();
    world.step(20);
    assertThat(world.isResting(0)).isTrue();
    assertThat(names(world, 0)).containsExactly("WALL 2");
    assertNormal(world.contacts(0).get(0), 0, 1);
    world.setVelocity(0, 0, 5);
    assertThat(world.contacts(0)).isEmpty();
    world.step(0.1);
    assertThat(world.contacts(0)).isEmpty();
    world.step(20);
    assertThat(names(world, 0)).containsExactly("WALL 2");
    world.setGravity(0, 0);
    assertThat(world.contacts(0)).isEmpty();
  }

  /** Two balls in a corner, one upon both: each knows all that it touches, and no sensor. */
  @Test
  void ofAHeap() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .bounds(0, 0, 4, 99)
                .line(0, 1, 4, 1)
                .response(Response.SENSOR)
                .circle(1, 1.1, 1, 0, 0)
                .restitution(0)
                .circle(3, 1.1, 1, 0, 0)
                .restitution(0)
                .circle(2, 3, 1, 0, 0)
                .restitution(0)
                .build());
    world.step(20);
    assertThat(world.isResting(2)).isTrue();
    assertThat(names(world, 0)).contains("WALL 0", "WALL 2", "CIRCLE 2").doesNotContain("LINE 0");
    assertThat(names(world, 1)).contains("WALL 1", "WALL 2", "CIRCLE 2");
    assertThat(names(world, 2)).containsExactly("CIRCLE 0", "CIRCLE 1");
    double half = Math.sqrt(3) / 2;
    assertNormal(world.contacts(2).get(0), 0.5, half);
    assertNormal(world.contacts(2).get(1), -0.5, half);
  }

  /** It slides down a slope 3 : 4, past a ball of another team, and off the end. */
  @Test
  void ofABallThatSlides() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 30, 40, 0)
                .circle(3.6, 28.55, 1, 0, 0)
                .restitution(0)
                .build());
    world.step(2);
    assertThat(names(world, 0)).containsExactly("LINE 0");
    assertNormal(world.contacts(0).get(0), 0.6, 0.8);
    world.step(10);
    assertThat(world.contacts(0)).as("beyond the end").isEmpty();
  }

  /** It lies on a one-way line, under another one that it came through. */
  @Test
  void ofABallOnAOneWayLine() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(10, 0, -10, 0)
                .oneWay()
                .line(-10, 0, 10, 0)
                .oneWay()
                .circle(0, 2, 1, 0, 0)
                .restitution(0)
                .build());
    world.step(10);
    assertThat(names(world, 0)).containsExactly("LINE 1");
  }

  @Test
  void ofNoCircleTheyAreRefused() {
    World world = new World(Scene.builder().build());
    assertThatThrownBy(() -> world.contacts(0))
        .isInstanceOf(IndexOutOfBoundsException.class)
        .hasMessageContaining("circle 0");
  }
}
