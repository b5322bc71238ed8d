// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.oracle.Draw;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.SphereFamilies;
import dev.carom.oracle.SphereQuery;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** More queries, and others: {@code -Dcarom.queries=10000000 -Dcarom.seed=2}. */
class SweptSphereTest {
  /** The queries of each family; in some families few are hits. */
  private static final int QUERIES =
      (int) Math.max(500, Long.getLong("carom.queries", 46_000) / SphereFamilies.NAMES.size());

  private static final long SEED = Long.getLong("carom.seed", 1);

  static Stream<String> families() {
    return SphereFamilies.NAMES.stream();
  }

  static Stream<Family> pairs() {
    return Families.all().stream().filter(family -> family.name().startsWith("circ_"));
  }

  private static double time(double... n) {
    return SweptSphere.pair(
        n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10], n[11], n[12], n[13],
        n[14]);
  }

  @ParameterizedTest
  @MethodSource("families")
  void everyTimeIsTheCorrectlyRoundedOne(String family) {
    Draw draw = new Draw(SEED * 0x9E3779B97F4A7C15L ^ family.hashCode());
    int hits = 0;
    // In some families a hit is rare: a short run goes on until it has seen one.
    for (int i = 0; i < QUERIES || (hits == 0 && i < 10 * QUERIES); i++) {
      SphereQuery q = SphereFamilies.next(family, draw);
      double truth = q.truth();
      hits += truth < Double.POSITIVE_INFINITY ? 1 : 0;
      assertThat(time(q.numbers())).as("%s", (Object) q.numbers()).isEqualTo(truth);
      double[] n = q.numbers();
      assertThat(SweptSphere.overlaps(n[0], n[1], n[2], n[3], n[7], n[8], n[9], n[10]))
          .as("%s", (Object) n)
          .isEqualTo(q.overlaps());
    }
    assertThat(hits).isPositive();
  }

  /** Differences of these places, or of these velocities, are beyond the doubles. */
  @Test
  void alsoWhereDifferencesAreBeyondTheDoubles() {
    double[] v = {3, 5, 7, -2, 1, 4};
    SweptSphere.respond(-1.5e308, 0, 0, 2, 1.5e308, 0, 0, 2, 1, v);
    assertThat(v).containsExactly(-2, 5, 7, 3, 1, 4);
    double[] fast = {1.5e308, 5, 7, -1.25e308, 1, 4};
    SweptSphere.respond(0, 0, 0, 2, 10, 0, 0, 2, 1, fast);
    assertThat(fast).containsExactly(-1.25e308, 5, 7, 1.5e308, 1, 4);
  }

  @Test
  void energyAndMomentumAreKept() {
    Draw draw = new Draw(SEED);
    for (int i = 0; i < 20_000; i++) {
      double[] n = SphereFamilies.next("uniform", draw).numbers();
      double m1 = 1 + n[3];
      double m2 = 1 + n[10];
      double[] v = {n[4], n[5], n[6], n[11], n[12], n[13]};
      double[] before = v.clone();
      SweptSphere.respond(n[0], n[1], n[2], m1, n[7], n[8], n[9], m2, 1, v);
      double scale = energy(m1, m2, before);
      assertThat(Math.abs(energy(m1, m2, v) - scale)).isLessThan(16 * 0x1p-53 * scale);
      double momentum = Math.sqrt(2 * scale * (m1 + m2));
      for (int axis = 0; axis < 3; axis++) {
        double change = m1 * (v[axis] - before[axis]) + m2 * (v[axis + 3] - before[axis + 3]);
        assertThat(Math.abs(change)).isLessThan(16 * 0x1p-53 * momentum);
      }
    }
  }

  private static double energy(double m1, double m2, double... v) {
    return (m1 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
            + m2 * (v[3] * v[3] + v[4] * v[4] + v[5] * v[5]))
        / 2;
  }

  @Test
  void whoCannotBeDeflectedGoesOn() {
    double infinite = Double.POSITIVE_INFINITY;
    double[] wall = {3, 5, 7, -2, 1, 4};
    SweptSphere.respond(0, 0, 0, 1, 1e-300, 0, 0, infinite, 0, wall);
    assertThat(wall).containsExactly(-2, 5, 7, -2, 1, 4);
    double[] both = {3, 5, 7, -2, 1, 4};
    SweptSphere.respond(0, 0, 0, infinite, 10, 0, 0, infinite, 1, both);
    assertThat(both).containsExactly(3, 5, 7, -2, 1, 4);
    double[] parting = {-3, 5, 7, 2, 1, 4};
    SweptSphere.respond(0, 0, 0, 1, 10, 0, 0, 1, 1, parting);
    assertThat(parting).containsExactly(-3, 5, 7, 2, 1, 4);
    double[] concentric = {-3, 5, 7, 2, 1, 4};
    SweptSphere.respond(1, 2, 3, 1, 1, 2, 3, 1, 1, concentric);
    assertThat(concentric).containsExactly(-3, 5, 7, 2, 1, 4);
  }

  @ParameterizedTest
  @CsvSource({
    "0, x1",
    "1, y1",
    "2, z1",
    "3, r1",
    "4, vx1",
    "5, vy1",
    "6, vz1",
    "7, x2",
    "8, y2",
    "9, z2",
    "10, r2",
    "11, vx2",
    "12, vy2",
    "13, vz2",
    "14, maxTime"
  })
  void refusesWhatIsNoNumber(int at, String name) {
    double[] n = {0, 0, 0, 1, 1, 1, 1, 9, 9, 9, 1, 1, 1, 1, 1};
    n[at] = Double.NaN;
    assertThatThrownBy(() -> time(n))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith(name + " is NaN");
    if (name.length() == 2) {
      assertThatThrownBy(
              () -> SweptSphere.overlaps(n[0], n[1], n[2], n[3], n[7], n[8], n[9], n[10]))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageStartingWith(name + " is NaN");
    }
  }

  @ParameterizedTest
  @CsvSource({
    "0, x1", "1, y1", "2, z1", "3, m1", "4, x2", "5, y2", "6, z2", "7, m2", "8, e", "9, vx1",
    "10, vy1", "11, vz1", "12, vx2", "13, vy2", "14, vz2"
  })
  void refusesToRespondToWhatIsNoNumber(int at, String name) {
    double[] n = {0, 0, 0, 1, 9, 9, 9, 1, 1, 1, 1, 1, 1, 1, 1};
    n[at] = Double.NaN;
    double[] v = Arrays.copyOfRange(n, 9, 15);
    assertThatThrownBy(
            () -> SweptSphere.respond(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], v))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith(name + " is NaN");
  }

  @Test
  void refusesWhatIsOutOfRange() {
    assertThatThrownBy(() -> time(0, 0, 0, -1, 0, 0, 0, 9, 0, 0, 1, 0, 0, 0, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("r1")
        .hasMessageContaining("-1.0");
    assertThatThrownBy(() -> time(0, 0, 0, 1, 0, 0, Double.NaN, 9, 0, 0, 1, 0, 0, 0, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("vz1");
    assertThatThrownBy(() -> time(0, 0, 0, 1, 0, 0, 0, 9, 0, 0, 1, 0, 0, 0, -1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("maxTime");
    assertThatThrownBy(() -> SweptSphere.respond(0, 0, 0, 0, 1, 1, 1, 1, 1, new double[6]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("m1");
    assertThatThrownBy(() -> SweptSphere.respond(0, 0, 0, 1, 1, 1, 1, 1, 1, new double[5]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("velocities");
  }
}
