// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SweptSphere;
import dev.carom.World;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Velocities after an impact, against 100 decimal digits: they are rounded once, however much
 * cancels. Offsets have few bits, so that the response is given them exactly.
 */
class ImpulseTest {
  private static final MathContext DIGITS = new MathContext(100);
  private static final int IMPACTS = 2_000;

  /** The part of the largest velocity that two doubles cannot hold. */
  private static final double TAIL = 0x1p-98;

  private final Random random = new Random(5);

  private double number() {
    return Math.scalb(random.nextDouble() - 0.5, random.nextInt(8));
  }

  /** Often a whole number, and not 0. */
  private double offset() {
    int whole = random.nextInt(2_000) - 1_000;
    return whole == 0 ? 1 : Math.scalb(whole, -random.nextInt(12));
  }

  private static BigDecimal big(double x) {
    return new BigDecimal(x);
  }

  private static BigDecimal dot(double[] a, double[] b) {
    BigDecimal sum = BigDecimal.ZERO;
    for (int i = 0; i < a.length; i++) {
      sum = sum.add(big(a[i]).multiply(big(b[i])));
    }
    return sum;
  }

  /** v + share f (u.n) / (n.n) n on one axis. */
  private static BigDecimal truth(
      double v, BigDecimal share, double f, double[] u, double[] n, int axis) {
    BigDecimal j = big(f).multiply(dot(u, n)).divide(dot(n, n), DIGITS);
    return big(v).add(share.multiply(j).multiply(big(n[axis])));
  }

  private static BigDecimal share(double other, double own) {
    return big(other).divide(big(other).add(big(own)), DIGITS);
  }

  private static void near(double actual, BigDecimal truth, double size) {
    double error = truth.subtract(big(actual)).abs().doubleValue();
    assertThat(error).isLessThanOrEqualTo(0.5 * Math.ulp(actual) + TAIL * size);
  }

  private static double size(double... v) {
    double size = 0;
    for (double x : v) {
      size = Math.max(size, Math.abs(x));
    }
    return size;
  }

  @Test
  void ofOneCircle() {
    Impulse impulse = new Impulse();
    for (int i = 0; i < IMPACTS; i++) {
      double[] v = {number(), number()};
      double[] n = i % 2 == 0 ? new double[] {offset(), offset()} : new double[] {v[0], v[1] / 3};
      double f = 1 + i % 5 / 4.0;
      impulse.of(f, v[0], v[1], n[0], n[1]);
      BigDecimal share = BigDecimal.ONE.negate();
      near(impulse.less(v[0], n[0]), truth(v[0], share, f, v, n, 0), size(v));
      near(impulse.less(v[1], n[1]), truth(v[1], share, f, v, n, 1), size(v));
      assertThat(impulse.less(v[0], n[0])).isEqualTo(impulse.change(v[0], -1, 0, n[0]));
    }
  }

  @Test
  void ofTwoCircles() {
    int met = 0;
    for (int i = 0; i < IMPACTS; i++) {
      double[] n = {offset(), offset()};
      double[] v = {number(), number(), number(), number()};
      double m1 = 1 + random.nextDouble() * 9;
      double m2 = i % 3 == 0 ? m1 : 1e-3 + random.nextDouble();
      SceneBuilder scene = Scene.builder().circle(n[0], n[1], 600, v[0], v[1]).mass(m1);
      World world = new World(scene.circle(0, 0, 900, v[2], v[3]).mass(m2).collide(true).build());
      world.step(0);
      met += world.impacts().size();
      if (world.impacts().size() == 1) {
        // The differences of velocities are rounded; the test is of what follows.
        double[] u = {v[0] - v[2], v[1] - v[3]};
        for (int axis = 0; axis < 2; axis++) {
          double after1 = axis == 0 ? world.vx(0) : world.vy(0);
          double after2 = axis == 0 ? world.vx(1) : world.vy(1);
          near(after1, truth(v[axis], share(m2, m1).negate(), 2, u, n, axis), 2 * size(v));
          near(after2, truth(v[axis + 2], share(m1, m2), 2, u, n, axis), 2 * size(v));
        }
      }
    }
    assertThat(met).isGreaterThan(IMPACTS / 4);
  }

  @Test
  void ofTwoSpheres() {
    int met = 0;
    for (int i = 0; i < IMPACTS; i++) {
      double[] n = {offset(), offset(), offset()};
      double[] v = {number(), number(), number(), number(), number(), number()};
      double m1 = 1 + random.nextDouble() * 9;
      double m2 = i % 3 == 0 ? m1 : 1e-3 + random.nextDouble();
      double e = i % 5 / 4.0;
      double[] after = v.clone();
      SweptSphere.respond(
          new SweptSphere(n[0], n[1], n[2], 0, after[0], after[1], after[2]),
          m1,
          new SweptSphere(0, 0, 0, 0, after[3], after[4], after[5]),
          m2,
          e,
          after);
      double[] u = {v[0] - v[3], v[1] - v[4], v[2] - v[5]};
      if (dot(u, n).signum() < 0) {
        met++;
        for (int axis = 0; axis < 3; axis++) {
          BigDecimal first = truth(v[axis], share(m2, m1).negate(), 1 + e, u, n, axis);
          near(after[axis], first, 2 * size(v));
          near(after[axis + 3], truth(v[axis + 3], share(m1, m2), 1 + e, u, n, axis), 2 * size(v));
        }
      }
    }
    assertThat(met).isGreaterThan(IMPACTS / 4);
  }

  @Test
  void ofAnyRestitution() {
    Impulse impulse = new Impulse();
    impulse.of(0x1p500, -3, 5, 2, 0);
    assertThat(impulse.less(-3, 2)).isEqualTo(0x1.8p501);
    assertThat(impulse.less(5, 0)).isEqualTo(5);
  }

  /** Twice 2^700, times a component of 2^280, would be beyond the doubles. */
  @Test
  void ofAnyRestitutionAlongLongNormals() {
    Impulse impulse = new Impulse();
    impulse.of(0x1p700, -3, 5, 0x1p280, 0);
    assertThat(impulse.less(-3, 0x1p280)).isEqualTo(0x1.8p701);
    impulse.of(0x1p800, -3, 0, 0x1p280, 0);
    assertThat(impulse.less(-3, 0x1p280)).isEqualTo(0x1.8p801);
  }
}
