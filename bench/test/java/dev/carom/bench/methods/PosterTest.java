// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PosterTest {

  private static final Offset<Double> FLOAT = within(1e-4);

  private static Method after(int frames, Scene scene) {
    Method method = Methods.POSTER.start(scene);
    for (int i = 0; i < frames; i++) {
      method.frame();
    }
    return method;
  }

  /** One circle of radius 5 and a line from (50, 0) to (50, 100). */
  private static Scene lineAnd(double x, double y, double vx, double vy) {
    return Scene.builder().line(50, 0, 50, 100).circle(x, y, 5, vx, vy).build();
  }

  @ParameterizedTest(name = "{0}")
  @CsvSource({
    "side: contact at x = 45 and the rest of the travel back,   40, 40,  10,   0, 40,   40, 1, 0",
    "side: from the right,                                      60, 40, -10,   0, 60,   40, 1, 0",
    "side: a leap over the line,                                20, 40,  60,   0, 10,   40, 1, 0",
    "side: at a shallow angle,                                  44, 20,   2,  40, 44,   60, 1, 0",
    "end: met head-on,                                          50, 110,  0, -10, 50,  110, 1, 1",
    "start: met head-on,                                        50, -10,  0,  10, 50,  -10, 1, 1",
    "end: the way misses the line but the circle meets its end, 57, 104,-10,   0, 60,  104, 1, 1",
    "miss: it flies away,                                       44, 40, -10,   0, 34,   40, 0, 0",
    "miss: it passes beyond the end,                            30, 106, 40,   0, 70,  106, 0, 0",
    "miss: it passes beside the line,                           40, 40,   0,  30, 40,   70, 0, 0",
    "overlapping and approaching: reflected at once,            47, 40,   1,   0, 46,   40, 1, 0",
    "overlapping and leaving: left alone,                       47, 40,  -1,   0, 46,   40, 0, 0"
  })
  void oneFrameAgainstOneLine(
      String story,
      double x,
      double y,
      double vx,
      double vy,
      double newX,
      double newY,
      int impacts,
      int roots) {
    Method method = after(1, lineAnd(x, y, vx, vy));

    assertThat(method.impacts()).isEqualTo(impacts);
    assertThat(method.squareRoots()).isEqualTo(roots);
    if (!story.startsWith("end: the way misses")) {
      assertThat(method.x(0)).isCloseTo(newX, FLOAT);
      assertThat(method.y(0)).isCloseTo(newY, FLOAT);
    }
  }

  @Test
  void anEndpointReflectsAlongTheOffset() {
    // Offset at contact (3, 4): v' = v - 2 (v.n) n with n = (0.6, 0.8) turns (-10, 0) to
    // (-2.8, 9.6); contact after 4 of 10 px, 0.6 of the frame remain.
    Method method = after(1, lineAnd(57, 104, -10, 0));

    assertThat(method.x(0)).isCloseTo(53 - 0.6 * 2.8, FLOAT);
    assertThat(method.y(0)).isCloseTo(104 + 0.6 * 9.6, FLOAT);
  }

  @Test
  void wallsTurnOneComponentAndAreCountedApart() {
    Scene scene = Scene.builder().bounds(0, 0, 100, 100).circle(90, 50, 5, 10, 2).build();

    Method method = after(1, scene);

    assertThat(method.x(0)).isCloseTo(90, FLOAT);
    assertThat(method.y(0)).isCloseTo(52, FLOAT);
    assertThat(method.wallImpacts()).isEqualTo(1);
    assertThat(method.impacts()).isZero();
  }

  /**
   * As exact as we are until rounding has grown: it is the published algorithm, and no straw man.
   */
  @Test
  void staysWithCaromForTheFirstFrames() throws CannotPlaceException {
    Scene scene = Crosses.canonical(1).scene();
    Method carom = Methods.CAROM.start(scene);
    Method poster = Methods.POSTER.start(scene);
    int impacts = 0;
    for (int frame = 0; frame < 20; frame++) {
      carom.frame();
      poster.frame();
      impacts += carom.impacts();
    }
    int close = 0;
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      double dx = carom.x(i) - poster.x(i);
      double dy = carom.y(i) - poster.y(i);
      close += Math.hypot(dx, dy) < 0.01 ? 1 : 0;
    }
    assertThat(impacts).isGreaterThan(30);
    assertThat(close).isGreaterThanOrEqualTo(90);
  }
}
