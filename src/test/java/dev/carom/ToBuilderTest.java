// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.IOException;
import org.junit.jupiter.api.Test;

class ToBuilderTest {

  private static Scene full() {
    return Scene.builder()
        .bounds(0, 0, 100, 100)
        .traits(Traits.DEFAULT.withRestitution(0.5).withFilter(new Filter(3, 5)))
        .line(10, 80, 20, 90)
        .oneWay()
        .line(50, 0, 50, 10)
        .velocity(2, 0)
        .peg(70, 20, 3)
        .response(Response.SENSOR)
        .velocity(0, -1)
        .circle(20, 20, 2, 3, 1)
        .mass(4)
        .circle(30, 20, 2, 3, 1)
        .filter(new Filter(2, 1))
        .gravity(0, -0.5)
        .build();
  }

  @Test
  void itHoldsAllThatIsInTheScene() throws IOException {
    Scene scene = full();
    StringBuilder text = new StringBuilder();
    StringBuilder copied = new StringBuilder();

    Scene copy = scene.toBuilder().build();
    scene.write(text);
    copy.write(copied);

    assertThat(copy).isEqualTo(scene);
    assertThat(copied).hasToString(text.toString());
  }

  @Test
  void whatIsAddedIsNotInTheOldScene() {
    Scene scene = full();
    SceneBuilder builder = scene.toBuilder();
    int line = builder.count(Kind.LINE);

    Scene more =
        builder.line(1, 2, 3, 4).restitution(0.25).peg(5, 5, 1).circle(40, 40, 1, 0, 0).build();

    assertThat(line).isEqualTo(2);
    assertThat(more.traits(Kind.LINE, line).restitution()).isEqualTo(0.25);
    assertThat(more.shape(Kind.PEG, 1)).isEqualTo(new Circle(5, 5, 1));
    assertThat(more.velocity(Kind.LINE, 1)).isEqualTo(new Vec2(2, 0));
    assertThat(scene).isEqualTo(full());
  }

  @Test
  void nothingWasAddedLast() {
    assertThatIllegalStateException()
        .isThrownBy(() -> full().toBuilder().restitution(0.5))
        .withMessage("restitution belongs to the thing added last: add one first");
  }

  @Test
  void aWarningHasTheNumbersOfBothThings() {
    Scene scene = Scene.builder().bounds(0, 0, 9, 9).peg(5, 5, 1).circle(8.5, 5, 1, 0, 0).build();

    Warning warning = scene.warnings().get(0);

    assertThat(scene.warnings()).hasSize(1);
    assertThat(warning).isEqualTo(new Warning(0, Kind.WALL, 1, 0.5, 1));
    assertThat(warning)
        .hasToString(
            "circle 0: distance from the right wall is 0.5: expected at least 1.0, its radius");
  }
}
