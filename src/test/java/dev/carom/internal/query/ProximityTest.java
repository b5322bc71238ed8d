// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Nearest;
import dev.carom.Resolver;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.internal.state.Codes;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Near or not, overlapping or not, where a side is easily mistaken for another. */
class ProximityTest {

  /** A room whose centre is not the origin, in any direction from it. */
  @ParameterizedTest
  @CsvSource({
    "-50, -60",
    "-50, 10",
    "20, -60",
    "20, 10",
  })
  void eachWallIsNearestToWhatIsBesideIt(double x, double y) {
    World world = new World(Scene.builder().bounds(x, y, x + 30, y + 40).build());
    assertThat(world.nearest(x + 2, y + 20, Kind.WALL).map(Nearest::id).orElse(-1))
        .isEqualTo(Codes.LEFT);
    assertThat(world.nearest(x + 28, y + 20, Kind.WALL).map(Nearest::id).orElse(-1))
        .isEqualTo(Codes.RIGHT);
    assertThat(world.nearest(x + 15, y + 2, Kind.WALL).map(Nearest::id).orElse(-1))
        .isEqualTo(Codes.BOTTOM);
    assertThat(world.nearest(x + 15, y + 38, Kind.WALL).map(Nearest::id).orElse(-1))
        .isEqualTo(Codes.TOP);
    assertThat(world.nearest(x - 2, y + 20, Kind.WALL).map(Nearest::id).orElse(-1))
        .isEqualTo(Codes.LEFT);
    assertThat(world.nearest(x + 15, y + 43, Kind.WALL).map(Nearest::id).orElse(-1))
        .isEqualTo(Codes.TOP);
  }

  @ParameterizedTest
  @CsvSource({
    "3, 4, true",
    "0, 4, false",
    "10, 4, false",
    "3, 0, false",
    "3, 8, false",
    "0, 0, false",
    "-1, 4, false",
    "11, 4, false",
    "3, -1, false",
    "3, 9, false"
  })
  void aPointOverlapsABoxFromInside(double x, double y, boolean overlaps) {
    Bounds box = new Bounds(0, 0, 10, 8);
    int expected = overlaps ? 1 : 0;
    assertThat(Resolver.of(List.of(new Circle(x, y, 0))).overlapping(Kind.PEG, box))
        .hasSize(expected);
    assertThat(Resolver.of(List.of(new Line(x, y, x, y))).overlapping(Kind.LINE, box))
        .hasSize(expected);
  }

  /** Disks that touch a line along x: beside it, and beyond each end. */
  @ParameterizedTest
  @CsvSource({"3, 5", "0, 5", "10, 5", "-3, 4", "13, 4", "-5, 0", "15, 0"})
  void whatTouchesALineDoesNotOverlapIt(double x, double y) {
    for (Line line : List.of(new Line(0, 0, 10, 0), new Line(10, 0, 0, 0))) {
      Resolver resolver = Resolver.of(List.of(line));
      assertThat(resolver.overlapping(Kind.LINE, new Circle(x, y, 5))).isEmpty();
      assertThat(resolver.overlapping(Kind.LINE, new Circle(x, y, Math.nextUp(5.0))))
          .containsExactly(0);
    }
  }

  @Test
  void aBoxThatEndsAtAWallDoesNotOverlapIt() {
    World world = new World(Scene.builder().bounds(-10, -10, 10, 10).build());
    assertThat(world.overlapping(Kind.WALL, new Bounds(-10, -10, 10, 10))).isEmpty();
    assertThat(world.overlapping(Kind.WALL, new Bounds(-11, -11, 11, 11)))
        .containsExactly(Codes.LEFT, Codes.RIGHT, Codes.BOTTOM, Codes.TOP);
  }

  @Test
  void circlesAreNearWhereTheyAre() {
    SceneBuilder scene =
        Scene.builder().collide(false).circle(0, 0, 1, 1e308, 0).circle(10, 0, 1, 0, 0);
    World world = new World(scene.circle(-10, 0, 1, 0, 0).circle(0, 3, 1, 0, 1e308).build());
    Bounds all = new Bounds(-99, -99, 99, 99);
    assertThat(world.overlapping(Kind.CIRCLE, all)).containsExactly(0, 1, 2, 3);
    assertThat(world.overlapping(Kind.CIRCLE, new Bounds(-99, -99, 5, 99)))
        .containsExactly(0, 2, 3);
    assertThat(world.nearest(1, 0, Kind.CIRCLE).map(Nearest::id).orElse(-1)).isZero();
    world.step(10);
    assertThat(world.overlapping(Kind.CIRCLE, all)).containsExactly(1, 2);
    assertThat(world.nearest(0, 0, Kind.CIRCLE).map(Nearest::id).orElse(-1))
        .as("as near as 2")
        .isOne();
    world.remove(Kind.CIRCLE, 1);
    assertThat(world.overlapping(Kind.CIRCLE, all)).containsExactly(2);
    assertThat(world.nearest(9, 0, Kind.CIRCLE).map(Nearest::id).orElse(-1)).isEqualTo(2);
  }
}
