// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.ImpactLog;
import dev.carom.Internals;
import dev.carom.Outcome;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The effect of a collision on two velocities: the laws of the literature, and what they conserve.
 */
class PairResponseTest {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private final ImpactRows rows = new ImpactRows(16);
  private final ImpactLog log = Internals.log(rows);
  private final MovingCircle a = new MovingCircle();
  private final MovingCircle b = new MovingCircle();

  private static PairResponse masses(double... masses) {
    SceneBuilder scene = Scene.builder().collide(false);
    for (double mass : masses) {
      scene.circle(0, 0, 1, 0, 0).mass(mass);
    }
    return pairs(scene.build());
  }

  /** The first circle at the origin, the second where the angle says, both of radius 1. */
  private void collide(
      PairResponse response, double angle, double vx1, double vy1, double vx2, double vy2) {
    a.start(0, 0, 0, 1, vx1, vy1, 1);
    b.start(1, 2 * Math.cos(angle), 2 * Math.sin(angle), 1, vx2, vy2, 1);
    rows.clear();
    response.resolve(a, 0, b, 0, 0, true, rows);
  }

  /** In no time, after so many impacts of each. */
  private int jam(int stuck, double vx, double vy) {
    a.start(0, 0, 0, 1, vx, vy, 1);
    b.start(1, 7, 7, 1, 1, 1, 1);
    for (MovingCircle m : new MovingCircle[] {a, b}) {
      m.stuck = stuck;
    }
    rows.clear();
    return masses(1, 1).resolve(a, 0, b, 0, 0, true, rows);
  }

  @Test
  void whoIsStuckDoesNotBounce() {
    int nearly = 24 * 64 - 1;
    assertThat(jam(nearly, 3, 3)).isEqualTo(ObstacleResponse.NEW_FLIGHT);
    assertThat(log.outcome(0)).isEqualTo(Outcome.BOUNCED);
    assertThat(a.vx).isOne();
    assertThat(b.vx).isEqualTo(3);
    assertThat(jam(nearly + 1, 3, 3)).isEqualTo(ObstacleResponse.STUCK);
    assertThat(log.outcome(0)).isEqualTo(Outcome.JAMMED);
    assertThat(a.vx).isEqualTo(2);
    assertThat(b.vx).isEqualTo(2);
    assertThat(a.jam).isNull();
  }

  /** Only two of which each ignores the other one. */
  @Test
  void whoIgnoresEachOtherIsInert() {
    PairResponse response = masses(1, 1);
    IgnoreList ofA = IgnoreList.with(null, Codes.circle(1));
    IgnoreList ofB = IgnoreList.with(null, Codes.circle(0));
    assertThat(response.isInert(0, ofA, 1, ofB)).isTrue();
    assertThat(response.isInert(0, null, 1, ofB)).isFalse();
    assertThat(response.isInert(0, ofA, 1, null)).isFalse();
  }

  @Test
  void anInfiniteMassPassesOverWhatItCrushed() {
    PairResponse response = masses(1, INFINITE);
    IgnoreList jam = IgnoreList.crushedBy(null, Codes.circle(1));
    assertThat(response.isInert(0, jam, 1, null)).isTrue();
    assertThat(response.isInert(1, null, 0, jam)).isTrue();
    assertThat(response.isInert(0, null, 1, null)).isFalse();
    assertThat(response.isInert(0, null, 1, IgnoreList.with(null, Codes.circle(0)))).isFalse();
  }

  /** A crushed circle stands like a rock. */
  @Test
  void aCrushedCircleIsNotMoved() {
    a.start(0, 0, 0, 1, 1, 0, 1);
    b.start(1, 2, 0, 1, 0, 0, 1);
    b.jam = IgnoreList.crushedBy(null, Codes.circle(7));
    masses(1, 1).resolve(a, 0, b, 0, 0, true, rows);
    assertThat(a.vx).isEqualTo(-1);
    assertThat(b.vx).isZero();
  }

  /** By an infinite mass that moves towards it, not by one that it runs into. */
  @ParameterizedTest
  @CsvSource({"-0.5, true", "0, false", "0.5, false"})
  void whoIsPushedIsNoted(double v, boolean pushed) {
    a.start(0, 0, 0, 1, 1, 0, 1);
    b.start(1, 2, 0, 1, v, 0, 1);
    masses(1, INFINITE).resolve(a, 0, b, 0, 0, true, rows);
    assertThat(a.pushed).isEqualTo(pushed);
    assertThat(b.pushed).isFalse();
  }

  @Test
  void whoCameFromFurtherOffIsNotStuck() {
    a.start(0, 0, 0, 1, 1, -1, 1);
    b.start(1, 2, 0, 1, 0, 0, 1);
    a.stuck = 5;
    b.stuck = 5;
    masses(1, 1).resolve(a, 0, b, 1, 0, true, rows);
    assertThat(a.stuck).isEqualTo(6);
    assertThat(b.stuck).isZero();
  }

  @Test
  void whoWouldBeFasterThanDoublesCanTellStops() {
    collide(masses(1e150, 1), 0, 1.5e308, 0, 0, 0);
    assertThat(a.vx).isEqualTo(1.5e308);
    assertThat(b.vx).isZero();
    assertThat(b.vy).isZero();
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1, 1, 0",
    "1, 1, 3, -2",
    "1, 2, 1, 0",
    "5, 3, 2, -1",
    "1, 1e6, 0, -1",
    "1e12, 1, 1, 0.5",
    "0.001, 7, 3, 1"
  })
  void headOnTheOneAxisFormulasHold(double m1, double m2, double v1, double v2) {
    collide(masses(m1, m2), 0, v1, 0, v2, 0);
    double w1 = (v1 * (m1 - m2) + 2 * m2 * v2) / (m1 + m2);
    double w2 = (v2 * (m2 - m1) + 2 * m1 * v1) / (m1 + m2);
    double size = Math.abs(v1) + Math.abs(v2);
    assertThat(a.vx).isCloseTo(w1, within(1e-15 * size));
    assertThat(b.vx).isCloseTo(w2, within(1e-15 * size));
    assertThat(a.vy).isZero();
    assertThat(b.vy).isZero();
  }

  /** Along the normal the formulas hold, across it nothing changes. */
  @ParameterizedTest
  @CsvSource({"1, 1", "1, 2", "5, 3", "1, 1e6", "1e12, 1"})
  void obliquelyTheyHoldAlongTheNormal(double m1, double m2) {
    Random random = new Random(1);
    PairResponse response = masses(m1, m2);
    for (int k = 0; k < 1000; k++) {
      double angle = random.nextDouble() * 2 * Math.PI;
      double nx = Math.cos(angle);
      double ny = Math.sin(angle);
      double along1 = 1 + random.nextDouble();
      double along2 = -random.nextDouble();
      double across1 = random.nextGaussian();
      double across2 = random.nextGaussian();
      collide(
          response,
          angle,
          along1 * nx - across1 * ny,
          along1 * ny + across1 * nx,
          along2 * nx - across2 * ny,
          along2 * ny + across2 * nx);
      double w1 = (along1 * (m1 - m2) + 2 * m2 * along2) / (m1 + m2);
      double w2 = (along2 * (m2 - m1) + 2 * m1 * along1) / (m1 + m2);
      assertThat(a.vx * nx + a.vy * ny).isCloseTo(w1, within(1e-14));
      assertThat(b.vx * nx + b.vy * ny).isCloseTo(w2, within(1e-14));
      assertThat(a.vy * nx - a.vx * ny).isCloseTo(across1, within(1e-14));
      assertThat(b.vy * nx - b.vx * ny).isCloseTo(across2, within(1e-14));
    }
  }

  @Test
  void equalMassesSwapHeadOnToTheBit() {
    Random random = new Random(2);
    for (int k = 0; k < 1000; k++) {
      double m = Math.exp(random.nextGaussian());
      double v1 = Math.rint(random.nextDouble() * 1e6) / 1024;
      double v2 = -Math.rint(random.nextDouble() * 1e6) / 1024;
      collide(masses(m, m), 0, v1, 0, v2, 0);
      assertThat(a.vx).isEqualTo(v2);
      assertThat(b.vx).isEqualTo(v1);
    }
  }

  /** Restitution of the pair is the product; the relative speed along the normal shrinks by it. */
  @ParameterizedTest
  @CsvSource({"1, 0.5", "0.5, 0.5", "0, 1", "1, 0", "1.5, 1", "0.1, 0.9"})
  void restitutionScalesTheRelativeSpeed(double e1, double e2) {
    PairResponse response = masses(2, 3);
    a.start(0, 0, 0, 1, 2, 1, e1);
    b.start(1, 1.2, 1.6, 1, -1, 0.5, e2);
    double before = (a.vx - b.vx) * 0.6 + (a.vy - b.vy) * 0.8;
    response.resolve(a, 0, b, 0, 0, true, rows);
    double after = (a.vx - b.vx) * 0.6 + (a.vy - b.vy) * 0.8;
    assertThat(after).isCloseTo(-e1 * e2 * before, within(1e-15));
    assertThat(2 * a.vx + 3 * b.vx).isCloseTo(2 * 2 - 3, within(4e-15));
    assertThat(2 * a.vy + 3 * b.vy).isCloseTo(2 + 1.5, within(4e-15));
  }

  @Test
  void anInfiniteMassIsNotDeflected() {
    collide(masses(INFINITE, 1), 0, 1, 0.25, -2, 0.5);
    assertThat(a.vx).isEqualTo(1);
    assertThat(a.vy).isEqualTo(0.25);
    assertThat(b.vx).isEqualTo(4);
    assertThat(b.vy).isEqualTo(0.5);
  }

  @Test
  void twoInfiniteMassesPassThroughEachOther() {
    a.start(0, 0, 0, 1, 1, 0, 1);
    b.start(1, 2, 0, 1, -2, 0, 1);
    assertThat(masses(INFINITE, INFINITE).resolve(a, 0, b, 0, 0, true, rows))
        .isEqualTo(ObstacleResponse.SENSED);
    assertThat(log.outcome(0)).isEqualTo(Outcome.PASSED);
    assertThat(a.last).isEqualTo(MovingCircle.NOTHING);
    assertThat(a.vx).isEqualTo(1);
    assertThat(b.vx).isEqualTo(-2);
    assertThat(log.size()).isEqualTo(1);
    assertThat(log.approachSpeed(0)).isEqualTo(3);
  }

  /** Momentum and energy over a million collisions among 64 circles, in all directions. */
  @Tag("long")
  @ParameterizedTest
  @ValueSource(doubles = {1, 4, 1e3, 1e6, 1e12})
  void momentumAndEnergyOverAMillionCollisions(double ratio) {
    int n = 64;
    Random random = new Random(3);
    double[] m = new double[n];
    double[] vx = new double[n];
    double[] vy = new double[n];
    for (int i = 0; i < n; i++) {
      m[i] = i % 2 == 0 ? 1 : ratio;
      vx[i] = random.nextGaussian() / Math.sqrt(m[i]);
      vy[i] = random.nextGaussian() / Math.sqrt(m[i]);
    }
    PairResponse response = masses(m);
    double energy = sum(m, vx, vx) + sum(m, vy, vy);
    double px = sum(m, vx, null);
    double py = sum(m, vy, null);
    double size = Math.sqrt(energy * (n / 2.0) * (1 + ratio));
    for (int k = 0; k < 1_000_000; k++) {
      int i = random.nextInt(n - 1);
      int j = i + 1 + random.nextInt(n - 1 - i);
      double nx = random.nextDouble() - 0.5;
      double ny = random.nextDouble() - 0.5;
      boolean towards = (vx[i] - vx[j]) * nx + (vy[i] - vy[j]) * ny < 0;
      a.start(i, towards ? nx : -nx, towards ? ny : -ny, 1, vx[i], vy[i], 1);
      b.start(j, 0, 0, 1, vx[j], vy[j], 1);
      rows.clear();
      response.resolve(a, 0, b, 0, 0, true, rows);
      vx[i] = a.vx;
      vy[i] = a.vy;
      vx[j] = b.vx;
      vy[j] = b.vy;
    }
    assertThat(sum(m, vx, vx) + sum(m, vy, vy)).isCloseTo(energy, within(1e-12 * energy));
    assertThat(sum(m, vx, null)).isCloseTo(px, within(1e-12 * size));
    assertThat(sum(m, vy, null)).isCloseTo(py, within(1e-12 * size));
  }

  private static double sum(double[] m, double[] v, double[] w) {
    double sum = 0;
    for (int i = 0; i < m.length; i++) {
      sum += m[i] * v[i] * (w == null ? 1 : w[i]);
    }
    return sum;
  }

  /** The clock's tail counts: at its speed of 2^60 the second one is 64 further by then. */
  @Test
  void whetherTwoPartIsSeenWhereBothAreAtTheSameTime() {
    a.start(0, 0, -64, 1, 0x1p61, 0x1p60, 1);
    b.start(1, 0, 0, 1, 0x1p60, 0, 1);
    a.t = 1;
    b.t = 1;
    b.tl = 0x1p-54;
    assertThat(PairResponse.part(a, b)).isFalse();
    b.tl = -0x1p-54;
    assertThat(PairResponse.part(a, b)).isTrue();
  }

  @Test
  void twoDoNotPartByRoundingOfTheirSpeeds() {
    a.start(0, 1, -1, 1, 1 + 0x1p-49, 1, 1);
    b.start(1, 0, 0, 1, 0, 0, 1);
    assertThat(PairResponse.part(a, b)).isFalse();
    a.vx = 1 + 0x1p-45;
    assertThat(PairResponse.part(a, b)).isTrue();
  }

  @Test
  void whoHaltsGoesOnAlongsideWhatItDoesNotApproach() {
    Scene scene =
        Scene.builder()
            .collide(false)
            .circle(0, 0, 1, 0, 0)
            .response(Response.HALT)
            .circle(2, 0, 1, 0, 0)
            .build();
    collide(pairs(scene), 0, 3, 1, 3, 0);
    assertThat(a.vx).isEqualTo(3);
    assertThat(b.vx).isEqualTo(3);
  }

  private static PairResponse pairs(Scene scene) {
    SceneData data = Internals.data(scene);
    ObstacleTable obstacles = ObstacleTable.of(data);
    Gravity none = new Gravity(0, 0);
    ObstacleResponse response =
        new ObstacleResponse(obstacles, null, none, (m, reach, now, into) -> {});
    return new PairResponse(new CircleRegistry(data, 1), response);
  }
}
