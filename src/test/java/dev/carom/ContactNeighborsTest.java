// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What circles in contact under gravity take for their neighbours, and what not. */
class ContactNeighborsTest {

  /** A ball leans on a line and on a sensor, which rests beside it: it comes down to the floor. */
  @ParameterizedTest
  @ValueSource(doubles = {11.9, 12})
  void aSensorHoldsNoCircle(double height) {
    Scene scene =
        Scene.builder()
            .bounds(0, 0, 100, 80)
            .restitution(0.9)
            .gravity(0.23, -1)
            .line(65.65, 10, 60, 59)
            .circle(61.13, 5.68, 5.68, 0, 0)
            .restitution(0.5)
            .circle(92.496, 7.504, 7.5, 0, 0)
            .restitution(0.5)
            .response(Response.SENSOR)
            .circle(75.4, height, 10, 0, 0)
            .build();
    World world = new World(scene);
    world.advanceTo(100);
    assertThat(world.y(2)).isCloseTo(10, within(0.01));
    assertThat(world.contacts(2)).noneMatch(it -> it.kind() == Kind.CIRCLE && it.id() == 1);
  }

  /** A ball of infinite mass drives into a small heap, and on to a line, off which it bounces. */
  @Test
  void anInfiniteMassGoesOnToItsNextImpact() {
    Scene scene =
        Scene.builder()
            .bounds(0, 0, 60, 40)
            .gravity(0, -10)
            .line(30, 0, 30, 40)
            .circle(4, 6, 2, 3, 0)
            .mass(Double.POSITIVE_INFINITY)
            .circle(14.388556844308042, 2, 2, 0, 0)
            .restitution(0.5)
            .circle(17.25800883828545, 2, 2, 0, 0)
            .restitution(0.5)
            .circle(13.12252441659502, 6, 2, 0, 0)
            .restitution(0)
            .build();
    World world = new World(scene);
    world.advanceTo(40 / 3.0);
    assertThat(world.x(0)).isCloseTo(12, within(1e-9));
    assertThat(world.vx(0)).isEqualTo(-3);
  }

  /** After a restore, before a step, too, a ball wakes when what it leans on is taken away. */
  @Test
  void whatARestoredBallLeansOnCanBeTakenAway() {
    Scene scene =
        Scene.builder()
            .bounds(0, 0, 40, 40)
            .gravity(1, -10)
            .circle(38, 2, 2, 0, 0)
            .restitution(0)
            .circle(34, 2, 2, 0, 0)
            .restitution(0)
            .build();
    World world = new World(scene);
    world.advanceTo(20);
    assertThat(world.isResting(1)).isTrue();
    World restored = new World(Scene.builder().bounds(0, 0, 40, 40).build());
    restored.restore(world.snapshot());
    for (World each : new World[] {world, restored}) {
      each.remove(Kind.CIRCLE, 0);
      assertThat(each.isResting(1)).isFalse();
      each.advanceTo(30);
      assertThat(each.x(1)).isCloseTo(38, within(0.01));
    }
    assertThat(restored.snapshot()).isEqualTo(world.snapshot());
  }
}
