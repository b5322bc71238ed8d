// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.StringReader;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Bounds of which a side at infinity has no wall. */
class OpenSidesTest {

  private static final double INF = Double.POSITIVE_INFINITY;
  private static final int FRAMES = 200;

  /** The sides of the bounds, by the bits of a number: 0 to 15 of them are closed. */
  private static SceneBuilder box(int closed, double away) {
    return Scene.builder()
        .bounds(
            (closed & 1) != 0 ? 0 : -away,
            (closed & 2) != 0 ? 0 : -away,
            (closed & 4) != 0 ? 100 : away,
            (closed & 8) != 0 ? 80 : away);
  }

  /** The same scene with a wall that is too far to be met moves in the same way, to the bit. */
  @ParameterizedTest
  @ValueSource(doubles = {0, -0x1p-4})
  void anOpenSideIsAsAWallThatIsNeverMet(double g) {
    int impacts = 0;
    for (int closed = 0; closed < 16; closed++) {
      SplittableRandom random = new SplittableRandom(closed);
      SceneBuilder open = box(closed, INF).gravity(0, g);
      SceneBuilder far = box(closed, 0x1p22).gravity(0, g);
      for (int i = 0; i < 40; i++) {
        double x = random.nextDouble(5, 95);
        double y = random.nextDouble(5, 75);
        double vx = random.nextDouble(-3, 3);
        double vy = random.nextDouble(-3, 3);
        for (SceneBuilder scene : new SceneBuilder[] {open, far}) {
          if (i < 20) {
            scene.line(x, y, x + vx, y + vy);
          } else {
            scene.circle(x, y, 1, vx, vy).restitution(0.9);
          }
        }
      }
      World a = new World(open.build());
      World b = new World(far.build());
      for (int frame = 0; frame < FRAMES; frame++) {
        a.step(1);
        b.step(1);
        impacts += a.impacts().size();
      }
      for (int id = 0; id < 20; id++) {
        assertThat(a.x(id)).as("sides %s, circle %s", closed, id).isEqualTo(b.x(id));
        assertThat(a.y(id)).isEqualTo(b.y(id));
      }
    }
    assertThat(impacts).isGreaterThan(1_000);
  }

  @Test
  void aBoxWithoutALid() {
    World world =
        new World(
            box(1 + 2 + 4, INF)
                .gravity(0, -1)
                .circle(50, 1, 1, 0, 40)
                .circle(20, 1, 1, 0, 0)
                .restitution(0)
                .build());
    world.advanceTo(40);
    assertThat(world.y(0)).as("far above").isEqualTo(1 + 40 * 40 - 800.0);
    assertThat(world.isResting(1)).isTrue();
    assertThat(world.contacts(1)).singleElement().extracting(Contact::kind).isEqualTo(Kind.WALL);
    world.advanceTo(200);
    assertThat(world.y(0)).as("back in the box").isBetween(1.0, 801.0);
  }

  @Test
  void onlyWallsThatAreThereHaveIds() {
    World world = new World(box(2, INF).build());
    assertThat(world.count(Kind.WALL)).isOne();
    assertThat(world.scene().count(Kind.WALL)).isOne();
    assertThat(world.ids(Kind.WALL)).containsExactly(2);
    assertThat(world.contains(Kind.WALL, 0)).isFalse();
    assertThat(world.record(INF).contains(Kind.WALL, 0, 0)).isFalse();
    assertThat(world.shape(Kind.WALL, 2)).isEqualTo(new Bounds(-INF, 0, INF, INF));
    assertThat(world.scene().traits(Kind.WALL, 2)).isEqualTo(Traits.DEFAULT);
    assertThatThrownBy(() -> world.traits(Kind.WALL, 0))
        .hasMessage("wall 0 does not exist: the bounds are open there");
    assertThatThrownBy(() -> world.scene().traits(Kind.WALL, 0))
        .hasMessage("wall 0 does not exist: the scene has 1 of them, from 0");
  }

  @Test
  void questionsPassThroughAnOpenSide() {
    World world = new World(box(2, INF).circle(50, 50, 1, 0, 0).build());
    SweptCircle down = new SweptCircle(10, 10, 1, 3, -1);
    assertThat(world.cast(down, INF).orElseThrow().id()).isEqualTo(2);
    assertThat(world.cast(down.withVelocity(3, 1), INF)).isEmpty();
    assertThat(world.cast(down.withVelocity(3, 1).withAcceleration(0.5, 0), INF)).isEmpty();
    assertThat(world.nearest(10, 7, Kind.WALL).orElseThrow().distance()).isEqualTo(7);
    assertThat(world.overlapping(Kind.WALL, new Circle(0, 0, 5))).containsExactly(2);
    assertThat(world.overlapping(Kind.WALL, new Bounds(-INF, -INF, INF, INF))).containsExactly(2);
    assertThat(world.overlapping(Kind.CIRCLE, new Bounds(-INF, 49, INF, INF))).containsExactly(0);
    assertThat(world.overlapping(Kind.CIRCLE, new Bounds(-INF, 51, INF, INF))).isEmpty();
    Bounds bounds = new Bounds(-INF, 0, INF, INF);
    assertThat(down.cast(bounds, INF).orElseThrow().time()).isEqualTo(9);
    assertThat(down.timeToBounds(-INF, 0, INF, INF, INF)).isEqualTo(9);
    assertThat(down.withVelocity(1, 1).timeToBounds(-INF, 0, INF, INF, INF)).isInfinite();
    assertThat(new Circle(0, 0.5, 1).overlaps(bounds)).isTrue();
    assertThat(new Circle(0, 0.5, 1).separation(bounds)).isEqualTo(new Vec2(0, 0.5));
    assertThat(new Circle(0, 1, 1).overlaps(bounds)).isFalse();
  }

  @Test
  void filesAndSnapshotsKnowThem() throws IOException {
    Scene scene =
        Scene.read(new StringReader("wall,-inf, 0 ,Infinity,inf\ncircle,1,5,1,1,-2"), "it");
    assertThat(scene.bounds()).contains(new Bounds(-INF, 0, INF, INF));
    assertThat(scene.warnings()).isEmpty();
    StringBuilder text = new StringBuilder();
    scene.write(text);
    assertThat(Scene.read(new StringReader(text.toString()), "it")).isEqualTo(scene);
    assertThatThrownBy(() -> Scene.read(new StringReader("wall,-inf,0,nan,9"), "it"))
        .hasMessageContaining("xmax");
    World world = new World(scene);
    Snapshot start = world.snapshot();
    world.advanceTo(7);
    double y = world.y(0);
    world.restore(start);
    world.advanceTo(7);
    assertThat(world.y(0)).isEqualTo(y).isEqualTo(1 + 2 * 5.0);
  }
}
