// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GasTest {

  /** Hash of the bits of a gas, on every machine and for ever. */
  private static final long HASH = -7068357480412015196L;

  @Test
  void theSameSeedGivesTheSameBitsEverywhere() throws CannotPlaceException {
    Scene scene = new Gas(100, 0.2, 2, true, 1).scene();
    long hash = 17;
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      Circle c = (Circle) scene.shape(Kind.CIRCLE, i);
      for (double value :
          new double[] {
            c.x(),
            c.y(),
            c.radius(),
            scene.velocity(Kind.CIRCLE, i).x(),
            scene.velocity(Kind.CIRCLE, i).y(),
            scene.traits(Kind.CIRCLE, i).mass()
          }) {
        hash = 31 * hash + Double.doubleToRawLongBits(value);
      }
    }
    assertThat(hash).isEqualTo(HASH);
    assertThat(new Gas(100, 0.2, 2, true, 1).scene()).isEqualTo(scene);
    assertThat(new Gas(100, 0.2, 2, true, 2).scene()).isNotEqualTo(scene);
  }

  @ParameterizedTest
  @CsvSource({"1, 0.5, 1", "10, 0.3, 1", "1000, 0.7, 1", "1000, 0.2, 2", "500, 0.01, 10"})
  void circlesCoverWhatWasAskedAndOverlapNothing(int n, double packing, double spread)
      throws CannotPlaceException {
    Scene scene = new Gas(n, packing, spread, false, 3).scene();

    assertGas(scene, n, packing, spread, 1e-9);
    assertThat(IntStream.range(0, n).mapToDouble(i -> scene.traits(Kind.CIRCLE, i).mass()))
        .containsOnly(1.0);
  }

  /** So many circles in a box, which cover a part of it and, but for a margin, no other circle. */
  static void assertGas(Scene scene, int n, double packing, double spread, double margin) {
    assertThat(scene.collide()).isTrue();
    assertThat(scene.count(Kind.CIRCLE)).isEqualTo(n);
    Bounds bounds = scene.bounds().orElseThrow();
    double covered = 0;
    for (int i = 0; i < n; i++) {
      Circle c = (Circle) scene.shape(Kind.CIRCLE, i);
      double r = c.radius();
      assertThat(r).isBetween(1.0, spread);
      covered += Math.PI * r * r;
      assertThat(c.x()).isBetween(r - margin, bounds.xmax() - r + margin);
      assertThat(c.y()).isBetween(r - margin, bounds.ymax() - r + margin);
      for (int j = 0; j < i; j++) {
        Circle d = (Circle) scene.shape(Kind.CIRCLE, j);
        assertThat(Math.hypot(c.x() - d.x(), c.y() - d.y())).isGreaterThan(r + d.radius() - margin);
      }
    }
    assertThat(covered / (bounds.xmax() * bounds.ymax())).isCloseTo(packing, within(1e-12));
  }

  @Test
  void saysSoWhereThereIsNoRoom() {
    assertThatThrownBy(() -> new Gas(100, 0.8, 1, false, 1).scene())
        .isInstanceOf(CannotPlaceException.class)
        .hasMessageStartingWith("no room for circle 1 of 100:");
  }

  @Test
  void refusesWhatIsNoGas() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Gas(0, 0.2, 1, false, 1))
        .withMessage("circles is 0: expected at least 1");
    assertThatIllegalArgumentException().isThrownBy(() -> new Gas(1, 0, 1, false, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Gas(1, Double.NaN, 1, false, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Gas(1, 0.2, 0.5, false, 1));
  }
}
