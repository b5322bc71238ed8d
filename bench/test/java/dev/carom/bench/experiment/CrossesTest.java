// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CrossesTest {

  /** Hash of the bits of the canonical scene of seed 1, on every machine and for ever. */
  private static final long HASH_OF_SEED_1 = -5386099251326330745L;

  private static double distance(Vec2 p, Vec2 q) {
    return new Vec2(q.x() - p.x(), q.y() - p.y()).length();
  }

  private static Vec2 middle(Line line) {
    return new Vec2((line.ax() + line.bx()) / 2, (line.ay() + line.by()) / 2);
  }

  @Test
  void theSameSeedGivesTheSameBitsEverywhere() throws CannotPlaceException {
    Scene scene = Crosses.canonical(1).scene();
    long hash = 17;
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      Line line = (Line) scene.shape(Kind.LINE, i);
      hash = mix(hash, line.ax(), line.ay(), line.bx(), line.by());
    }
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      Circle circle = (Circle) scene.shape(Kind.CIRCLE, i);
      Vec2 velocity = scene.velocity(Kind.CIRCLE, i);
      hash = mix(hash, circle.x(), circle.y(), circle.radius(), velocity.x(), velocity.y());
    }
    assertThat(hash).isEqualTo(HASH_OF_SEED_1);
    assertThat(Crosses.canonical(1).scene()).isEqualTo(scene);
  }

  private static long mix(long hash, double... values) {
    long mixed = hash;
    for (double value : values) {
      mixed = 31 * mixed + Double.doubleToRawLongBits(value);
    }
    return mixed;
  }

  @Test
  void anotherSeedGivesAnotherScene() throws CannotPlaceException {
    Set<Vec2> first = new HashSet<>();
    for (long seed = 1; seed <= 20; seed++) {
      first.add(((Circle) Crosses.canonical(seed).scene().shape(Kind.CIRCLE, 0)).center());
    }
    assertThat(first).hasSize(20);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, -1, Long.MAX_VALUE})
  void crossesAreSquareAndKeepTheirDistances(long seed) throws CannotPlaceException {
    Scene scene = Crosses.canonical(seed).scene();

    assertThat(scene.bounds()).contains(new Bounds(0, 0, 800, 600));
    assertThat(scene.count(Kind.LINE)).isEqualTo(100);
    for (int i = 0; i < 100; i += 2) {
      Line one = (Line) scene.shape(Kind.LINE, i);
      Line other = (Line) scene.shape(Kind.LINE, i + 1);
      assertThat(one.length()).isCloseTo(20, within(1e-12));
      assertThat(other.length()).isCloseTo(20, within(1e-12));
      assertThat(distance(middle(one), middle(other))).isLessThan(1e-12);
      double dot =
          (one.bx() - one.ax()) * (other.bx() - other.ax())
              + (one.by() - one.ay()) * (other.by() - other.ay());
      assertThat(dot).isCloseTo(0, within(1e-10));
      assertThat(middle(one).x()).isBetween(30 - 1e-12, 770 + 1e-12);
      assertThat(middle(one).y()).isBetween(30 - 1e-12, 570 + 1e-12);
      for (int j = 0; j < i; j += 2) {
        assertThat(distance(middle(one), middle((Line) scene.shape(Kind.LINE, j))))
            .isGreaterThan(45 - 1e-12);
      }
    }
  }

  @Test
  void saysSoWhereThereIsNoRoom() {
    assertThatThrownBy(() -> new Crosses(1, 500, 10, 1, 10, 1).scene())
        .isInstanceOf(CannotPlaceException.class)
        .hasMessageMatching("no room for cross \\d+ of 500: none of 100,000 places fits.*");
    assertThatThrownBy(() -> new Crosses(2, 50, 290, 1, 10, 1).scene())
        .isInstanceOf(CannotPlaceException.class)
        .hasMessageStartingWith("no room for circle 1 of 2:");
  }

  @Test
  void refusesWhatIsNoScene() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Crosses(0, 50, 10, 1, 10, 1))
        .withMessage("circles is 0: expected at least 1");
    assertThatIllegalArgumentException().isThrownBy(() -> new Crosses(1, -1, 10, 1, 10, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Crosses(1, 50, 0, 1, 10, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Crosses(1, 50, 301, 1, 10, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Crosses(1, 50, 10, Double.NaN, 1, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Crosses(1, 50, 10, 2, 1, 1));
  }
}
