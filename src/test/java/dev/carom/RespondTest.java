// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Two circles that a loop of the caller's own moves: what an impact does to their velocities. */
class RespondTest {

  private static final double INFINITE = Double.POSITIVE_INFINITY;
  private static final int IMPACTS = 5_000;

  private final Random random = new Random(20260101);

  @Test
  void itIsWhatAWorldDoesToTheBit() {
    int met = 0;
    for (int i = 0; i < IMPACTS; i++) {
      double[] n = random.doubles(4, -10, 10).toArray();
      double[] v = random.doubles(4, -5, 5).toArray();
      double m1 = i % 7 == 0 ? INFINITE : 1e-3 + random.nextDouble();
      double m2 = i % 3 == 0 ? 1 : 9 * random.nextDouble() + 1e-3;
      double e = i % 5 / 4.0;
      // So large that they overlap: the impact is at 0, and the places are as given.
      SceneBuilder setup = Scene.builder();
      setup.circle(n[0], n[1], 15, v[0], v[1]).mass(m1);
      Scene scene = setup.circle(n[2], n[3], 15, v[2], v[3]).mass(m2).restitution(e).build();
      World world = new World(scene);
      world.step(0);
      met += world.impacts().size();
      Resolver.respond(n[0], n[1], m1, n[2], n[3], m2, e, v);
      assertThat(v).containsExactly(world.vx(0), world.vy(0), world.vx(1), world.vy(1));
    }
    assertThat(met).isBetween(IMPACTS / 3, IMPACTS * 2 / 3);
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "1e-200, 1", "1e200, 1e-200", "1e307, 1e307", "1, 1e-310", "1e-310, 1"})
  void itIsThatOfSpheresInAPlane(double length, double speed) {
    int changed = 0;
    for (int i = 0; i < 1_000; i++) {
      double[] n = random.doubles(4, -length, length).toArray();
      double[] v = random.doubles(4, -speed, speed).toArray();
      double[] before = v.clone();
      double[] w = {v[0], v[1], 0, v[2], v[3], 0};
      Resolver.respond(n[0], n[1], 2, n[2], n[3], 3, 0.5, v);
      SweptSphere.respond(
          new SweptSphere(n[0], n[1], 0, 0, w[0], w[1], w[2]),
          2,
          new SweptSphere(n[2], n[3], 0, 0, w[3], w[4], w[5]),
          3,
          0.5,
          w);
      assertThat(v).containsExactly(w[0], w[1], w[3], w[4]);
      changed += Arrays.equals(v, before) ? 0 : 1;
    }
    assertThat(changed).isBetween(300, 700);
  }

  @Test
  void whoPartsOrCannotBeDeflectedGoesOn() {
    assertThat(after(0, 0, 1, 10, 0, 1, -3, 5, 2, 1)).containsExactly(-3, 5, 2, 1);
    assertThat(after(1, 2, 1, 1, 2, 1, -3, 5, 2, 1)).containsExactly(-3, 5, 2, 1);
    assertThat(after(0, 0, INFINITE, 10, 0, INFINITE, 3, 5, -2, 1)).containsExactly(3, 5, -2, 1);
    assertThat(after(0, 0, 1, 10, 0, INFINITE, 3, 5, -2, 1)).containsExactly(-7, 5, -2, 1);
    assertThat(after(0, 0, 2, 0, 10, 2, 3, 5, -2, 1)).containsExactly(3, 1, -2, 5);
  }

  private static double[] after(
      double x1, double y1, double m1, double x2, double y2, double m2, double... v) {
    Resolver.respond(x1, y1, m1, x2, y2, m2, 1, v);
    return v;
  }

  @ParameterizedTest
  @CsvSource({
    "0, x1", "1, y1", "2, m1", "3, x2", "4, y2", "5, m2", "6, e", "7, vx1", "8, vy1", "9, vx2",
    "10, vy2"
  })
  void refusesWhatIsNoNumber(int at, String name) {
    double[] n = {0, 0, 1, 9, 9, 1, 1, 1, 1, -1, -1};
    n[at] = Double.NaN;
    double[] v = Arrays.copyOfRange(n, 7, 11);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Resolver.respond(n[0], n[1], n[2], n[3], n[4], n[5], n[6], v))
        .withMessageStartingWith(name + " is NaN");
  }

  @Test
  void refusesWhatIsOutOfRange() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Resolver.respond(0, 0, 0, 1, 1, 1, 1, new double[4]))
        .withMessageStartingWith("m1 is 0.0: expected a number from 2^-500");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Resolver.respond(0, 0, 1, 1, 1, 1, -1, new double[4]))
        .withMessageStartingWith("e is -1.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Resolver.respond(0, 0, 1, 1, 1, 1, 1, new double[6]))
        .withMessageStartingWith("velocities.length is 6: expected 4");
  }
}
