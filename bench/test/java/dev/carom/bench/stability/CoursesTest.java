// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.reference.Truth;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Courses known in closed form agree with those computed in arbitrary precision. */
class CoursesTest {

  private static void agree(Reference course, Reference truth) {
    for (int frame = 0; frame <= truth.frames(); frame++) {
      assertThat(course.x(frame, 0)).isCloseTo(truth.x(frame, 0), within(1e-13));
      assertThat(course.y(frame, 0)).isCloseTo(truth.y(frame, 0), within(1e-13));
      assertThat(course.vx(frame, 0)).isCloseTo(truth.vx(frame, 0), within(1e-13));
      assertThat(course.vy(frame, 0)).isCloseTo(truth.vy(frame, 0), within(1e-13));
      assertThat(course.log10Conditioning(frame, 0))
          .as("conditioning of frame %d", frame)
          .isCloseTo(truth.log10Conditioning(frame, 0), within(0.5));
    }
  }

  @Test
  void aBoxUnfolds() {
    SceneBuilder setup = Scene.builder().line(0, 0, 70, 0).line(70, 0, 70, 50).line(70, 50, 0, 50);
    Scene scene = setup.line(0, 50, 0, 0).circle(31, 17, 5, -23.7, 41.3).build();

    agree(new BoxCourse(scene, 70, 50, 30), Truth.of(scene, 30, () -> {}));
  }

  private static Scene corner(double restitution) {
    SceneBuilder builder = Scene.builder().line(3, 4, 103, 14).restitution(restitution);
    return builder.line(3, 4, 83, 74).restitution(restitution).circle(60, 28, 5, -4, -1.7).build();
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 0.9, 0.5})
  void aCornerIsAWedge(double restitution) {
    WedgeCourse course = new WedgeCourse(corner(restitution), 25);

    assertThat(course.pilesUp()).isFalse();
    assertThat(course.vx(25, 0)).isGreaterThan(0);
    agree(course, Truth.of(corner(restitution), 25, () -> {}));
  }

  /** It ends a radius away from both lines, at rest. */
  @Test
  void impactsThatPileUpEndInTheCorner() {
    WedgeCourse course = new WedgeCourse(corner(0.05), 60);

    assertThat(course.pilesUp()).isTrue();
    assertThat(course.vx(60, 0)).isZero();
    assertThat(course.vy(60, 0)).isZero();
    double x = course.x(60, 0) - 3;
    double y = course.y(60, 0) - 4;
    assertThat((100 * y - 10 * x) / Math.hypot(100, 10)).isCloseTo(5, within(1e-8));
    assertThat((70 * x - 80 * y) / Math.hypot(80, 70)).isCloseTo(5, within(1e-8));
  }
}
