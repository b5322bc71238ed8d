// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** All contacts at once: no approach is left, momentum is kept, energy is the least possible. */
class InelasticShockTest {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  /** A row along x, each touching the next one, with the given velocities. */
  private static InelasticShock row(double[] masses, double... v) {
    InelasticShock shock = new InelasticShock(v.length, v.length);
    for (int i = 0; i < v.length; i++) {
      shock.setCircle(i, v[i], 0, masses[i]);
    }
    for (int i = 1; i < v.length; i++) {
      shock.addContact(i, i - 1, 1, 0);
    }
    return shock;
  }

  @Test
  void twoGoOnWithTheVelocityOfTheirMomentum() {
    InelasticShock shock = row(new double[] {1, 3}, 4, 0);
    assertThat(shock.resolve()).isTrue();
    assertThat(shock.vx(0)).isCloseTo(1, within(1e-15));
    assertThat(shock.vx(1)).isCloseTo(1, within(1e-15));
    assertThat(shock.acted(0)).isTrue();
  }

  @Test
  void whatPartsIsLeftAlone() {
    InelasticShock shock = row(new double[] {1, 1, 1}, -1, 0, 2);
    assertThat(shock.resolve()).isTrue();
    assertThat(shock.vx(0)).isEqualTo(-1);
    assertThat(shock.vx(1)).isZero();
    assertThat(shock.vx(2)).isEqualTo(2);
    assertThat(shock.acted(0)).isFalse();
    assertThat(shock.acted(1)).isFalse();
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 10, 100})
  void aRowThatIsHitGoesOnAsOne(int count) {
    double[] masses = new double[count];
    java.util.Arrays.fill(masses, 2);
    double[] v = new double[count];
    v[0] = count;
    InelasticShock shock = row(masses, v);
    assertThat(shock.resolve()).isTrue();
    for (int i = 0; i < count; i++) {
      assertThat(shock.vx(i)).isCloseTo(1, within(1e-13 * count));
    }
  }

  /** A column that falls on the floor comes to rest, to the bit. */
  @ParameterizedTest
  @CsvSource({"1, 1", "10, 0.05", "30, 1e-200", "10, 1e200"})
  void aColumnOnTheFloorStops(int count, double speed) {
    InelasticShock shock = new InelasticShock(count, count);
    for (int i = 0; i < count; i++) {
      shock.setCircle(i, 0, -speed, 1);
      shock.addContact(i, i == 0 ? InelasticShock.OBSTACLE : i - 1, 0, 1);
    }
    assertThat(shock.resolve()).isTrue();
    for (int i = 0; i < count; i++) {
      assertThat(shock.vy(i)).isZero();
      assertThat(shock.acted(i)).isTrue();
      assertThat(shock.isFaint(i)).as("at rest").isFalse();
    }
  }

  @Test
  void anInfiniteMassTakesARowAlong() {
    InelasticShock shock = row(new double[] {INFINITE, 1, 1}, 3, 0, 0);
    assertThat(shock.resolve()).isTrue();
    assertThat(shock.vx(0)).isEqualTo(3);
    assertThat(shock.vx(1)).isCloseTo(3, within(1e-15));
    assertThat(shock.vx(2)).isCloseTo(3, within(1e-15));
    assertThat(shock.isFaint(0) || shock.vx(1) == 3).as("inert, or exactly alike").isTrue();
  }

  @Test
  void betweenTwoInfiniteMassesThereIsNoAnswer() {
    assertThat(row(new double[] {INFINITE, 1, INFINITE}, 1, 0, -1).resolve()).isFalse();
  }

  /** Two contacts turn the velocity to and fro; in the end nothing is left of it. */
  @Test
  void whatFallsIntoAWedgeStops() {
    InelasticShock shock = new InelasticShock(1, 2);
    shock.setCircle(0, 0.1, -1, 1);
    shock.addContact(0, InelasticShock.OBSTACLE, 0.8, 0.6);
    shock.addContact(0, InelasticShock.OBSTACLE, -0.8, 0.6);
    assertThat(shock.resolve()).isTrue();
    assertThat(shock.vx(0)).isZero();
    assertThat(shock.vy(0)).isZero();
  }

  /**
   * Random heaps. The answer is the one of Moreau if no contact approaches, and the velocities
   * changed by pushes only at contacts that do not part: then energy is lost, momentum kept.
   */
  @Test
  void nothingApproachesAndOnlyContactsThatTouchPush() {
    Random random = new Random(1);
    for (int run = 0; run < 200; run++) {
      int count = 2 + random.nextInt(30);
      InelasticShock shock = new InelasticShock(count, 2 * count);
      double[] masses = new double[count];
      double[][] v = new double[count][2];
      for (int i = 0; i < count; i++) {
        masses[i] = 0.5 + random.nextDouble();
        v[i][0] = random.nextGaussian();
        v[i][1] = random.nextGaussian();
        shock.setCircle(i, v[i][0], v[i][1], masses[i]);
      }
      double[][] contacts = new double[2 * count][];
      for (int k = 0; k < contacts.length; k++) {
        int a = random.nextInt(count);
        int b = (a + 1 + random.nextInt(count - 1)) % count;
        double angle = random.nextDouble() * 2 * Math.PI;
        contacts[k] = new double[] {a, b, Math.cos(angle), Math.sin(angle)};
        shock.addContact(a, b, contacts[k][2], contacts[k][3]);
      }
      assertThat(shock.resolve()).as("run %s", run).isTrue();
      double energy = 0;
      double px = 0;
      double before = 0;
      double pxBefore = 0;
      for (int i = 0; i < count; i++) {
        energy += masses[i] * (shock.vx(i) * shock.vx(i) + shock.vy(i) * shock.vy(i));
        before += masses[i] * (v[i][0] * v[i][0] + v[i][1] * v[i][1]);
        px += masses[i] * shock.vx(i);
        pxBefore += masses[i] * v[i][0];
      }
      assertThat(energy).as("run %s", run).isLessThanOrEqualTo(before * (1 + 1e-14));
      assertThat(px).isCloseTo(pxBefore, within(1e-12 * count));
      for (int k = 0; k < contacts.length; k++) {
        int a = (int) contacts[k][0];
        int b = (int) contacts[k][1];
        double parts =
            (shock.vx(a) - shock.vx(b)) * contacts[k][2]
                + (shock.vy(a) - shock.vy(b)) * contacts[k][3];
        assertThat(parts).as("run %s", run).isGreaterThan(-1e-13);
        assertThat(shock.acted(k) && parts > 1e-13).as("pushes what parts").isFalse();
      }
    }
  }
}
