// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Kind.CIRCLE;
import static dev.carom.Kind.LINE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Circles that something squeezed while they fell, and what happens when they are free again. */
class JammedUnderGravityTest {

  private static final int CEILING = 0;
  private static final int LIFT = 1;

  /** A lift rises one unit in each unit of time, and presses a ball against a ceiling at 6. */
  @Test
  void aLiftCarriesTheBallThatItSqueezedWhenTheCeilingGoes() {
    double depth = 0x1p-10;
    SceneBuilder scene = Scene.builder().collide(false).gravity(0, -8).line(-10, 10, 10, 10);
    scene.line(-10, 2, 10, 2).velocity(0, 1).circle(0, 4, 1, 0, 0).restitution(0.5);
    World world = new World(scene.build());
    world.advanceTo(6 + depth);
    assertThat(world.isResting(0)).isTrue();
    assertThat(world.y(0)).isEqualTo(9);
    world.remove(LINE, CEILING);
    world.advanceTo(12);

    assertThat(world.y(0)).isCloseTo(world.line(LIFT).ay() + 1, within(2 * depth));
  }

  /** A press sinks one unit in each unit of time; it jams a ball on a floor, and passes over it. */
  @Test
  void aFreedBallFallsUntilItReachesTheLineThatHasLeftIt() {
    SceneBuilder scene = Scene.builder().gravity(0, -8).line(-10, 0, 10, 0);
    scene.line(-10, 10, 10, 10).velocity(0, -1).circle(0, 1, 1, 0, 0).restitution(0);
    World world = new World(scene.build());
    world.advanceTo(14);
    assertThat(world.y(0)).isEqualTo(1);
    world.remove(LINE, 0); // the press is at -4
    world.advanceTo(15);
    assertThat(world.y(0)).isEqualTo(1 - 4);
    world.advanceTo(20);
    assertThat(world.y(0)).isCloseTo(world.line(1).ay() + 1, within(1e-12));
  }

  /** A mass rises one unit in each unit of time; it jams a ball under a ceiling, and passes it. */
  @ParameterizedTest
  @ValueSource(strings = {"remove", "setMass", "setVelocity", "setPosition"})
  void aBallFallsWhenTheMassThatPressedItIsGone(String edit) {
    SceneBuilder scene = Scene.builder().gravity(0, -1).line(-10, 10, 10, 10);
    scene.circle(0, 5, 1, 0, 0).restitution(0.5);
    scene.circle(0, 0, 1, 0, 1).mass(Double.POSITIVE_INFINITY);
    World world = new World(scene.build());
    world.advanceTo(8);
    assertThat(world.isResting(0)).isTrue();
    assertThat(world.y(0)).as("a contact may hover").isBetween(9 - 0x1p-7, 9 + 1e-9);
    switch (edit) {
      case "remove" -> world.remove(CIRCLE, 1);
      case "setMass" -> world.setTraits(Kind.CIRCLE, 1, world.traits(Kind.CIRCLE, 1).withMass(1));
      case "setVelocity" -> world.setVelocity(1, 0, -20);
      default -> world.setPosition(1, 50, 0);
    }
    world.advanceTo(20);
    assertThat(world.y(0)).isLessThan(-20);
  }

  /** A save gives circles other slots: balls between lines that close jam at the same times. */
  @Test
  void aBallThatIgnoresOthersJamsAlikeAfterARestore() {
    Random random = new Random(1);
    int jams = 0;
    for (int play = 0; play < 40; play++) {
      Scene scene =
          Scene.builder()
              .collide(false)
              .gravity(0, -10)
              .bounds(0, 0, 100, 80)
              .circle(90, 70, 1, 0, 0)
              .circle(50, 20, 3, random.nextDouble(), 0)
              .restitution(0.7)
              .line(20, 8 + 4 * random.nextDouble(), 80, 6 + 8 * random.nextDouble())
              .velocity(random.nextDouble(), 1 + random.nextDouble())
              .line(30, 30 * random.nextDouble() + 8, 52, 40)
              .velocity(3, 0)
              .line(48, 40, 70, 30 * random.nextDouble() + 8)
              .velocity(-3, -random.nextDouble())
              .build();
      World world = new World(scene);
      world.remove(CIRCLE, 0);
      World restored = new World(scene);
      restored.restore(world.snapshot());
      for (int frame = 1; frame <= 400; frame++) {
        world.advanceTo(frame / 60.0);
        restored.advanceTo(frame / 60.0);
        for (Impact row : world.impacts()) {
          jams += row.outcome() == Outcome.JAMMED ? 1 : 0;
        }
      }
      assertThat(restored.snapshot()).as("play %d", play).isEqualTo(world.snapshot());
    }
    assertThat(jams).isGreaterThan(5);
  }
}
