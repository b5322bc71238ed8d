// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The derivative of an impact against differences of impacts that are computed in full. */
class ImpactMapTest {

  /** Differences of this size err by about its square, and by 2^-52 over it. */
  private static final double STEP = 0x1p-17;

  private static final double ERROR = 1e-6;

  private Random random;

  // The centre is at 0 when it touches; the centre of curvature is at -R n.
  private double vx;
  private double vy;
  private double gx;
  private double gy;
  private double nx;
  private double ny;
  private double radius;
  private double e;
  private ImpactMap map;

  private void draw(long seed) {
    random = new Random(seed);
    double turn = 7 * random.nextDouble();
    nx = Math.cos(turn);
    ny = Math.sin(turn);
    double speed = 1 + random.nextDouble();
    double along = random.nextDouble() - 0.5;
    vx = -speed * nx - along * ny;
    vy = -speed * ny + along * nx;
    boolean falls = random.nextBoolean();
    gx = falls ? random.nextDouble() - 0.5 : 0;
    gy = falls ? random.nextDouble() - 0.5 : 0;
    radius = random.nextInt(3) == 0 ? Double.POSITIVE_INFINITY : 1 + random.nextDouble();
    e = random.nextInt(4) * 0.5;
    map = new ImpactMap(vx, vy, gx, gy, nx, ny, radius, e);
  }

  /** The state after the impact and back at time 0, for one that bounces at a time. */
  private double[] after(double x, double y, double ux, double uy, double time, double turn) {
    double px = x + (ux + 0.5 * gx * time) * time;
    double py = y + (uy + 0.5 * gy * time) * time;
    double wx = ux + gx * time;
    double wy = uy + gy * time;
    double mx = radius == Double.POSITIVE_INFINITY ? nx : px / radius + nx;
    double my = radius == Double.POSITIVE_INFINITY ? ny : py / radius + ny;
    double length = Math.hypot(mx, my);
    double kx = (mx * Math.cos(turn) - my * Math.sin(turn)) / length;
    double ky = (my * Math.cos(turn) + mx * Math.sin(turn)) / length;
    double push = (1 + e) * (wx * kx + wy * ky);
    double bx = wx - push * kx;
    double by = wy - push * ky;
    return new double[] {
      px - (bx - 0.5 * gx * time) * time,
      py - (by - 0.5 * gy * time) * time,
      bx - gx * time,
      by - gy * time
    };
  }

  /** When the centre touches, by Newton's method. */
  private double contact(double x, double y, double ux, double uy) {
    double t = 0;
    for (int i = 0; i < 20; i++) {
      double px = x + (ux + 0.5 * gx * t) * t;
      double py = y + (uy + 0.5 * gy * t) * t;
      double height = px * nx + py * ny;
      double rise = (ux + gx * t) * nx + (uy + gy * t) * ny;
      if (radius < Double.POSITIVE_INFINITY) {
        double cx = px + radius * nx;
        double cy = py + radius * ny;
        height = Math.hypot(cx, cy) - radius;
        rise = ((ux + gx * t) * cx + (uy + gy * t) * cy) / Math.hypot(cx, cy);
      }
      t -= height / rise;
    }
    return t;
  }

  private void assertDifference(double[] actual, double[] plus, double[] minus) {
    for (int i = 0; i < ImpactMap.SIZE; i++) {
      assertThat(actual[i]).isCloseTo((plus[i] - minus[i]) / (2 * STEP), within(ERROR));
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void anOffsetBecomesThatOfTheNearbyPath(long seed) {
    draw(seed);
    double[] d = random.doubles(ImpactMap.SIZE, -1, 1).toArray();
    double[][] ends = new double[2][];
    double[] contacts = new double[2];
    for (int k = 0; k < 2; k++) {
      double s = k == 0 ? STEP : -STEP;
      double ux = vx + s * d[2];
      double uy = vy + s * d[3];
      contacts[k] = contact(s * d[0], s * d[1], ux, uy);
      ends[k] = after(s * d[0], s * d[1], ux, uy, contacts[k], 0);
    }
    double delay = (contacts[0] - contacts[1]) / (2 * STEP);
    assertThat(map.delay(d, 0)).isCloseTo(delay, within(ERROR));
    map.apply(d, 0);
    assertDifference(d, ends[0], ends[1]);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void aLateImpactIsOneAfterALongerFlight(long seed) {
    draw(seed);
    double[] late = new double[ImpactMap.SIZE];
    map.late(late, 0, 1);
    assertDifference(late, after(0, 0, vx, vy, STEP, 0), after(0, 0, vx, vy, -STEP, 0));
    double[] delayed = {1, 2, 3, 4};
    map.delay(delayed, 0, 1);
    assertThat(delayed)
        .containsExactly(new double[] {1, 2, 3 + late[2], 4 + late[3]}, within(1e-15));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void aTurnedNormalTurnsTheVelocity(long seed) {
    draw(seed);
    double[] turned = new double[ImpactMap.SIZE];
    map.turn(turned, 0, 1);
    assertDifference(turned, after(0, 0, vx, vy, 0, STEP), after(0, 0, vx, vy, 0, -STEP));
  }
}
