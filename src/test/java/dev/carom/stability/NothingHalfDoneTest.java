// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Response;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Snapshot;
import dev.carom.Traits;
import dev.carom.World;
import java.io.StringReader;
import java.util.List;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

/**
 * A refused call leaves builder, world and file as they were. See also RefusedEditTest,
 * SceneBuilderTest, SceneFormatExceptionTest, SnapshotStreamTest.
 */
class NothingHalfDoneTest {

  private static final double NAN = Double.NaN;

  private static SceneBuilder scene() {
    return Scene.builder()
        .collide(false)
        .bounds(0, 0, 9, 9)
        .line(2, 2, 7, 3)
        .peg(5, 6, 1)
        .circle(1, 1, 0.5, 3, 2);
  }

  /** A naive edit sets x before it looks at y. */
  @Test
  void aWorldGoesOnAfterEveryExceptionAsIfNothingHadBeen() {
    double[] place = {1, 2};
    place[0] = 8;
    assertThat(place[1]).as("a naive edit, refused at y, has moved x").isEqualTo(2);

    World world = new World(scene().build());
    World undisturbed = new World(scene().build());
    Snapshot other = new World(Scene.builder().bounds(0, 0, 8, 8).build()).snapshot();
    List<ThrowingCallable> refused =
        List.of(
            () -> world.step(NAN),
            () -> world.advanceTo(-1),
            () -> world.setPosition(0, 8, NAN),
            () -> world.setVelocity(0, 8, NAN),
            () -> world.setShape(Kind.CIRCLE, 0, new Circle(world.x(0), world.y(0), 0)),
            () -> world.setTraits(Kind.CIRCLE, 0, world.traits(Kind.CIRCLE, 0).withMass(0)),
            () -> world.setTraits(Kind.LINE, 0, world.traits(Kind.LINE, 0).withRestitution(-1)),
            () ->
                world.setTraits(
                    Kind.WALL, 0, world.traits(Kind.WALL, 0).withResponse(Response.SENSOR)),
            () -> world.setShape(Kind.LINE, 0, new Line(1, 1, 2, NAN)),
            () -> world.setShape(Kind.PEG, 0, new Circle(1, 1, -1)),
            () -> world.addLine(1, 1, 2, 1e300, Traits.DEFAULT),
            () -> world.addPeg(1, NAN, 1, Traits.DEFAULT),
            () -> world.addCircle(1, 1, 1e-20, 1, 1, Traits.DEFAULT),
            () -> world.remove(Kind.WALL, 0),
            () -> world.remove(Kind.LINE, 7),
            () -> world.record(-1),
            () -> world.restore(other),
            () -> world.x(7));
    for (ThrowingCallable call : refused) {
      assertThatThrownBy(call)
          .isInstanceOf(RuntimeException.class)
          .hasMessageContaining("expected");
      assertThat(world.snapshot()).isEqualTo(undisturbed.snapshot());
      world.step(0.7);
      undisturbed.step(0.7);
      assertThat(Run.rows(world.impacts())).isEqualTo(Run.rows(undisturbed.impacts()));
      assertThat(Run.states(world)).isEqualTo(Run.states(undisturbed));
    }
  }

  @Test
  void aFileWithABadRowGivesNoScene() {
    String text = "wall,0,0,9,9\ncircle,1,1,0.5,3\n";
    assertThatThrownBy(() -> Scene.read(new StringReader(text), "bad.csv"))
        .hasMessageContaining("bad.csv:2");
  }

  @Test
  void aBuilderGoesOnAfterARefusal() {
    SceneBuilder builder = scene();
    assertThatThrownBy(() -> builder.circle(1, 1, -1, 0, 0)).hasMessageContaining("radius is -1");
    assertThatThrownBy(() -> builder.restitution(NAN)).hasMessageContaining("restitution is NaN");
    assertThat(builder.build()).isEqualTo(scene().build());
  }
}
