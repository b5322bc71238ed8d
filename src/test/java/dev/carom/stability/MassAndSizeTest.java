// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.advance;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SweptCircle;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Very different masses and sizes. More of it: GalperinTest, PairResponseTest. */
class MassAndSizeTest {

  /** After: (m - M) / (m + M) and 2 m / (m + M) of the velocity of what comes. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-150, 1e-20, 1e-3, 1, 1e3, 1e20, 1e150})
  void aMassOfAnySizeHitsOneAtRest(double m) {
    World world = world(Scene.builder().circle(0, 0, 1, 1, 0).mass(m).circle(5, 0, 1, 0, 0));
    assertThat(advance(world, 6)).hasSize(1);
    assertThat(world.vx(0)).isCloseTo((m - 1) / (m + 1), within(1e-15));
    double after = 2 * m / (m + 1);
    assertThat(world.vx(1)).isCloseTo(after, within(2 * Math.ulp(after)));
  }

  /** A heavy one at rest, a light one that comes: 2^-1000 of its speed is what it gets. */
  @ParameterizedTest
  @ValueSource(doubles = {0x1p500, Double.POSITIVE_INFINITY})
  void aWallOfMassSendsBack(double mass) {
    double m = 0x1p-500;
    double naive = (m - mass) / (m + mass);
    assertThat(naive == -1 && mass > 1e300).as("infinity over infinity is no velocity").isFalse();

    World world =
        world(Scene.builder().circle(0, 0, 1, 1, 0).mass(m).circle(5, 0, 1, 0, 0).mass(mass));
    assertThat(advance(world, 6)).hasSize(1);
    assertThat(world.vx(0)).isEqualTo(-1);
    assertThat(world.vx(1)).isEqualTo(2 * (m / mass));
  }

  /** A grain that comes down on a giant: the textbook's time is that of another gap. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6, 1e-9})
  void aGrainHitsAGiantWhenItTouchesIt(double gap) {
    double giant = 1e8 / 3;
    double grain = 1.0 / 3;
    double x = giant / 7;
    double y = Math.sqrt((giant + grain) * (giant + grain) - x * x) + gap;
    double textbook = Naive.pointTime(x, y, giant + grain, new Vec2(0, -1));
    double exact =
        new SweptCircle(x, y, grain, 0, -1).timeToCircle(new SweptCircle(0, 0, giant, 0, 0), 9);
    assertThat(Math.abs(textbook - exact)).as("the textbook's error").isGreaterThan(1e-10);

    World world =
        world(Scene.builder().circle(0, 0, giant, 0, 0).mass(1e30).circle(x, y, grain, 0, -1));
    List<Run.Row> hits = advance(world, 1);
    assertThat(hits).hasSize(1);
    assertThat(hits.get(0).time()).isEqualTo(exact);
    assertThat(Play.speed(world, 1)).isCloseTo(1, within(1e-15));
  }
}
