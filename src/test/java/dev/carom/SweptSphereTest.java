// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.oracle.Draw;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.Query;
import dev.carom.oracle.SphereFamilies;
import dev.carom.oracle.SphereQuery;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
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

  static Stream<Family<Query>> pairs() {
    return Families.all().stream().filter(family -> family.name().startsWith("circ_"));
  }

  private static SweptSphere first(double... n) {
    return new SweptSphere(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
  }

  private static SweptSphere second(double... n) {
    return new SweptSphere(n[7], n[8], n[9], n[10], n[11], n[12], n[13]);
  }

  private static double time(double... n) {
    return first(n).timeToSphere(second(n), n[14]);
  }

  @ParameterizedTest
  @MethodSource("families")
  void everyTimeIsTheCorrectlyRoundedOne(String family) {
    Draw draw = Draw.of(SEED, family);
    int hits = 0;
    // In some families a hit is rare: a short run goes on until it has seen one.
    for (int i = 0; i < QUERIES || (hits == 0 && i < 10 * QUERIES); i++) {
      SphereQuery q = SphereFamilies.next(family, draw);
      double truth = q.truth();
      hits += truth < Double.POSITIVE_INFINITY ? 1 : 0;
      assertThat(time(q.numbers())).as("%s", (Object) q.numbers()).isEqualTo(truth);
      double[] n = q.numbers();
      assertThat(first(n).overlaps(second(n))).as("%s", (Object) n).isEqualTo(q.overlaps());
    }
    assertThat(hits).isPositive();
  }

  /** Two spheres on the x axis, or at one place. */
  private static void respond(
      double x1, double m1, double x2, double m2, double restitution, double[] v) {
    SweptSphere first = new SweptSphere(x1, 0, 0, 0, v[0], v[1], v[2]);
    SweptSphere second = new SweptSphere(x2, 0, 0, 0, v[3], v[4], v[5]);
    SweptSphere.respond(first, m1, second, m2, restitution, v);
  }

  /** Differences of these places, or of these velocities, are beyond the doubles. */
  @Test
  void alsoWhereDifferencesAreBeyondTheDoubles() {
    double[] v = {3, 5, 7, -2, 1, 4};
    respond(-1.5e308, 2, 1.5e308, 2, 1, v);
    assertThat(v).containsExactly(-2, 5, 7, 3, 1, 4);
    double[] fast = {1.5e308, 5, 7, -1.25e308, 1, 4};
    respond(0, 2, 10, 2, 1, fast);
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
      SweptSphere.respond(first(n), m1, second(n), m2, 1, v);
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
    respond(0, 1, 1e-300, infinite, 0, wall);
    assertThat(wall).containsExactly(-2, 5, 7, -2, 1, 4);
    double[] both = {3, 5, 7, -2, 1, 4};
    respond(0, infinite, 10, infinite, 1, both);
    assertThat(both).containsExactly(3, 5, 7, -2, 1, 4);
    double[] parting = {-3, 5, 7, 2, 1, 4};
    respond(0, 1, 10, 1, 1, parting);
    assertThat(parting).containsExactly(-3, 5, 7, 2, 1, 4);
    double[] concentric = {-3, 5, 7, 2, 1, 4};
    respond(1, 1, 1, 1, 1, concentric);
    assertThat(concentric).containsExactly(-3, 5, 7, 2, 1, 4);
  }

  @ParameterizedTest
  @CsvSource({"0, x", "1, y", "2, z", "3, radius", "4, vx", "5, vy", "6, vz"})
  void refusesWhatIsNoNumber(int at, String name) {
    double[] n = {0, 0, 0, 1, 1, 1, 1};
    n[at] = Double.NaN;
    assertRefused(name + " is NaN", () -> first(n));
  }

  @Test
  void refusesWhatIsOutOfRange() {
    SweptSphere sphere = new SweptSphere(1, 2, 3, 1, 0, 0, 0);
    double[] v = new double[6];
    assertRefused("radius is -1.0", () -> new SweptSphere(0, 0, 0, -1, 0, 0, 0));
    assertRefused("maxTime is -1.0", () -> sphere.timeToSphere(sphere, -1));
    assertRefused("maxTime is NaN", () -> sphere.timeToSphere(sphere, Double.NaN));
    for (double bad : new double[] {0, Double.NaN}) {
      assertRefused("m1 is " + bad, () -> SweptSphere.respond(sphere, bad, sphere, 1, 1, v));
      assertRefused("m2 is " + bad, () -> SweptSphere.respond(sphere, 1, sphere, bad, 1, v));
    }
    for (double bad : new double[] {-1, Double.NaN}) {
      assertRefused(
          "restitution is " + bad, () -> SweptSphere.respond(sphere, 1, sphere, 1, bad, v));
    }
    assertRefused(
        "velocities.length is 5",
        () -> SweptSphere.respond(sphere, 1, sphere, 1, 1, new double[5]));
  }

  private static void assertRefused(String message, ThrowingCallable call) {
    assertThatThrownBy(call)
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith(message);
  }
}
