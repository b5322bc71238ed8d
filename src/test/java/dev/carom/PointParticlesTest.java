// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Circles of radius 0, in worlds that have no lines. */
class PointParticlesTest {

  private static SceneBuilder room() {
    return Scene.builder().collide(false).bounds(0, 0, 100, 100);
  }

  @Test
  void twoPointsNeverMeet() {
    SceneBuilder scene = room().collide(true).circle(20, 50, 0, 10, 0).circle(80, 50, 0, -10, 0);
    World world = new World(scene.circle(50, 20, 0, 0, 10).build());
    world.step(4);
    assertThat(world.impacts().size()).isZero();
    assertThat(world.x(0)).isEqualTo(60);
    assertThat(world.cast(new SweptCircle(new Circle(0, 50, 0), new Vec2(1, 0)), 30)).isEmpty();
    assertThat(
            world
                .cast(new SweptCircle(new Circle(20, 50, 1), new Vec2(10, 0)), 30)
                .orElseThrow()
                .kind())
        .isEqualTo(Kind.CIRCLE);
  }

  /** Points among circles: energy stays, and the steps change no bit. */
  @Test
  void aGasOfPointsAndCircles() {
    Random random = new Random(2);
    SceneBuilder builder = room().collide(true);
    for (int i = 0; i < 200; i++) {
      double radius = i % 4 == 0 ? 1.5 : 0;
      builder.circle(
          4 + 6.5 * (i % 15),
          4 + 6.5 * Math.floor(i / 15.0),
          radius,
          random.nextGaussian(),
          random.nextGaussian());
    }
    World world = new World(builder.build());
    World inOne = new World(builder.build());
    double before = Energy.of(world);
    int impacts = 0;
    int pairs = 0;
    for (int frame = 1; frame <= 100; frame++) {
      world.advanceTo(frame);
      ImpactLog log = world.impacts();
      impacts += log.size();
      for (int row = 0; row < log.size(); row++) {
        if (log.kind(row) == Kind.CIRCLE) {
          pairs++;
          double sum = world.radius(log.circle(row)) + world.radius(log.id(row));
          assertThat(sum).isPositive();
        }
      }
    }
    assertThat(pairs).isGreaterThan(200);
    // Velocities round by a few ulps, so an impact changes the energy of its circles by 8 u or
    // less.
    assertThat(Energy.of(world)).isCloseTo(before, within(8 * 0x1p-53 * impacts * before));
    inOne.advanceTo(100);
    assertThat(world.snapshot()).isEqualTo(inOne.snapshot());
  }

  /** No area, no diameter: the cells of such points must still have a size. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 500})
  void pointsInLineWithoutBounds(int count) {
    SceneBuilder scene = Scene.builder();
    for (int i = 0; i < count; i++) {
      scene.circle(1000.0 + i, 7, 0, 1, i % 5);
    }
    World world = new World(scene.build());
    world.step(100);
    assertThat(world.impacts().size()).isZero();
    assertThat(world.x(0)).isEqualTo(1100);
  }

  @Test
  void savesKeepPoints() throws IOException {
    Scene scene = room().collide(true).circle(20, 50, 0, 10, 1).circle(60, 50, 5, 0, 0).build();
    StringWriter text = new StringWriter();
    scene.write(text);
    assertThat(Scene.read(new StringReader(text.toString()), "points")).isEqualTo(scene);
    World world = new World(scene);
    world.step(3);
    World other = new World(scene);
    other.restore(SnapshotBytes.copy(world.snapshot()));
    assertThat(other.snapshot()).isEqualTo(world.snapshot());
    world.step(30);
    other.step(30);
    assertThat(other.snapshot()).isEqualTo(world.snapshot());
  }

  @Test
  void linesAndPointsRefuseEachOther() {
    SceneBuilder both = room().line(0, 0, 9, 9).circle(20, 50, 0, 10, 0);
    assertThatIllegalArgumentException()
        .isThrownBy(both::build)
        .withMessage("circle 0: radius is 0.0: expected more than 0, as there are lines");
    assertThatThrownBy(() -> Scene.read(new StringReader("line,0,0,9,9\ncircle,1,2,0,4,5\n"), "s"))
        .hasMessageContaining("radius is 0.0: expected more than 0, as there are lines");
    World lines = new World(room().line(0, 0, 9, 9).circle(20, 50, 1, 10, 0).build());
    assertThatIllegalArgumentException()
        .isThrownBy(() -> lines.addCircle(5, 5, 0, 0, 0, Traits.DEFAULT))
        .withMessage("circle 1: radius is 0.0: expected more than 0, as there are lines");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> lines.setShape(Kind.CIRCLE, 0, new Circle(lines.x(0), lines.y(0), 0)))
        .withMessage("circle 0: radius is 0.0: expected more than 0, as there are lines");
    lines.remove(Kind.LINE, 0);
    lines.setShape(Kind.CIRCLE, 0, new Circle(lines.x(0), lines.y(0), 0));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> lines.addLine(0, 0, 1, 1, Traits.DEFAULT))
        .withMessage(
            "line 1: radius of circle 0 is 0.0: expected more than 0, for a line to be added");
    assertThat(lines.ids(Kind.LINE)).isEmpty();
    lines.step(1);
    lines.setShape(Kind.CIRCLE, 0, new Circle(lines.x(0), lines.y(0), 2));
    assertThat(lines.addLine(0, 0, 1, 1, Traits.DEFAULT)).isEqualTo(1);
    lines.setShape(Kind.CIRCLE, 0, new Circle(lines.x(0), lines.y(0), 1e-3));
  }

  /** The smallest radius above 0 limits coordinates; points do not. */
  @Test
  void pointsLimitNoCoordinate() {
    World world = new World(Scene.builder().collide(false).circle(0, 0, 0, 1, 1).build());
    world.setPosition(0, 1e300, 1);
    assertThat(world.addPeg(-1e305, 0, 1, Traits.DEFAULT)).isZero();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> world.addCircle(0, 0, 1, 0, 0, Traits.DEFAULT));
  }
}
