// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.peers;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class PeersTest {

  static List<Contender> all() {
    return Peers.all();
  }

  static List<Contender> best() {
    return Peers.all().stream().filter(peer -> peer.id().endsWith("-best")).toList();
  }

  private static void play(Method method, int frames) {
    for (int frame = 0; frame < frames; frame++) {
      method.frame();
    }
  }

  @ParameterizedTest
  @MethodSource("all")
  void aCircleFliesStraightAtItsSpeed(Contender peer) {
    Scene scene = Scene.builder().bounds(0, 0, 800, 600).circle(100, 200, 10, 6, -4).build();

    try (Method method = peer.start(scene)) {
      assertThat(method.x(0)).isCloseTo(100, within(1e-4));
      play(method, 10);
      assertThat(method.x(0)).isCloseTo(160, within(1e-3));
      assertThat(method.y(0)).isCloseTo(160, within(1e-3));
      assertThat(method.vx(0)).isCloseTo(6, within(1e-5));
      assertThat(method.vy(0)).isCloseTo(-4, within(1e-5));
      assertThat(method.pairTests()).isEqualTo(Method.UNKNOWN);
    }
  }

  /**
   * A step of length h changes the velocity before the place: after a time t the fall is ahead by g
   * t h / 2.
   */
  @ParameterizedTest
  @MethodSource("all")
  void aCircleFallsByTheIntegratorOfItsEngine(Contender peer) {
    for (boolean collide : new boolean[] {false, true}) {
      Scene scene =
          Scene.builder()
              .bounds(0, 0, 800, 600)
              .circle(100, 500, 10, 3, 2)
              .circle(400, 500, 10, 0, 0)
              .mass(Double.POSITIVE_INFINITY)
              .collide(collide)
              .gravity(0.05, -0.1)
              .build();
      int t = 40;

      try (Method method = peer.start(scene)) {
        play(method, t);
        assertThat(method.vx(0)).isCloseTo(3 + 0.05 * t, within(1e-4));
        assertThat(method.vy(0)).isCloseTo(2 - 0.1 * t, within(1e-4));
        assertThat(method.x(0)).isCloseTo(100 + 3 * t + 0.05 * t * (t + 1) / 2, within(5e-3));
        assertThat(method.y(0)).isCloseTo(500 + 2 * t - 0.1 * t * (t + 1) / 2, within(5e-3));
        assertThat(method.x(1)).as("an infinite mass does not fall").isCloseTo(400, within(1e-4));
        assertThat(method.y(1)).isCloseTo(500, within(1e-4));
      }
    }
  }

  /** The cap of 2 m on the motion of a step is out of reach for a fall, too. */
  @ParameterizedTest
  @MethodSource("best")
  void atItsBestALongFallIsNotCapped(Contender peer) {
    Scene scene =
        Scene.builder().bounds(0, 0, 100, 6000).circle(50, 5900, 10, 0, 0).gravity(0, -2).build();

    try (Method method = peer.start(scene)) {
      play(method, 70);
      assertThat(method.vy(0)).isCloseTo(-140, within(1e-2));
      assertThat(method.y(0)).isCloseTo(5900 - 70 * 71, within(1.0));
    }
  }

  @ParameterizedTest
  @MethodSource("all")
  void theExperimentPlaysTenFramesWithinItsBounds(Contender peer) throws CannotPlaceException {
    try (Method method = peer.start(Crosses.canonical(1).scene())) {
      play(method, 10);
      for (int i = 0; i < 100; i++) {
        assertThat(method.x(i)).isBetween(0.0, 800.0);
        assertThat(method.y(i)).isBetween(0.0, 600.0);
      }
    }
  }

  /** Even at 0.02 px a frame, where the engines as they come let the bounce die. */
  @ParameterizedTest
  @MethodSource("best")
  void atItsBestABounceKeepsItsSpeed(Contender peer) {
    for (double speed : new double[] {0.02, 9}) {
      Scene scene = Scene.builder().line(50, 0, 50, 100).circle(39.9, 50, 10, speed, 0).build();
      try (Method method = peer.start(scene)) {
        play(method, 20);
        assertThat(method.vx(0)).as("from %s", speed).isCloseTo(-speed, within(1e-4 * speed));
      }
    }
  }

  @ParameterizedTest
  @MethodSource("all")
  void circlesIgnoreEachOther(Contender peer) {
    Scene scene =
        Scene.builder().collide(false).circle(100, 50, 10, 3, 0).circle(150, 50, 10, -3, 0).build();

    try (Method method = peer.start(scene)) {
      play(method, 20);
      assertThat(method.x(0)).isCloseTo(160, within(1e-3));
    }
  }

  @ParameterizedTest
  @MethodSource("all")
  void whatIsNotElasticTakesSpeed(Contender peer) {
    SceneBuilder setup = Scene.builder().line(50, 0, 50, 100).restitution(0.8);
    Scene scene = setup.circle(30, 50, 10, 3, 0).restitution(0.5).build();

    try (Method method = peer.start(scene)) {
      play(method, 10);
      assertThat(method.vx(0)).isCloseTo(-3 * 0.4, within(1e-4));
    }
  }

  @ParameterizedTest
  @MethodSource("all")
  void circlesThatCollideHaveTheirMasses(Contender peer) {
    SceneBuilder setup = Scene.builder().circle(0, 0, 10, 2, 0).mass(3);
    Scene scene = setup.circle(40, 0, 10, -1, 0).build();

    try (Method method = peer.start(scene)) {
      play(method, 20);
      assertThat(method.vx(0)).isCloseTo(1.25 - 0.75, within(1e-4));
      assertThat(method.vx(1)).isCloseTo(1.25 + 2.25, within(1e-4));
    }
  }

  @ParameterizedTest
  @MethodSource("all")
  void noCircleDeflectsAnInfiniteMass(Contender peer) {
    SceneBuilder setup = Scene.builder();
    setup.circle(0, 0, 10, 2, 0).mass(Double.POSITIVE_INFINITY).circle(40, 0, 10, -1, 0);
    Scene scene = setup.build();

    try (Method method = peer.start(scene)) {
      play(method, 20);
      assertThat(method.vx(0)).isCloseTo(2, within(1e-4));
      assertThat(method.vx(1)).isCloseTo(2 * 2 + 1, within(1e-4));
    }
  }

  @ParameterizedTest
  @MethodSource("all")
  void restitutionsThatTheGreaterOneDoesNotGiveAreRefused(Contender peer) {
    Scene circles =
        Scene.builder()
            .collide(false)
            .circle(0, 0, 1, 1, 1)
            .restitution(0.5)
            .circle(9, 9, 1, 1, 1)
            .build();
    SceneBuilder setup = Scene.builder().line(50, 0, 50, 9).restitution(0.5);
    Scene line = setup.circle(0, 0, 1, 1, 1).build();

    for (Scene scene : List.of(circles, line)) {
      assertThatThrownBy(() -> peer.start(scene))
          .isInstanceOf(UnsupportedOperationException.class)
          .hasMessageContaining("the greater of two restitutions");
    }
  }

  @ParameterizedTest
  @MethodSource("all")
  void whatPeersWereNotSetUpForIsRefused(Contender peer) {
    Scene scene = Scene.builder().peg(50, 50, 5).circle(10, 10, 5, 1, 1).build();

    assertThatThrownBy(() -> peer.start(scene)).isInstanceOf(UnsupportedOperationException.class);
  }

  @Test
  void contendersAreFoundById() {
    for (Contender contender : Contenders.all()) {
      assertThat(Contenders.byId(contender.id()).toString()).isEqualTo(contender.toString());
    }
    assertThatThrownBy(() -> Contenders.byId("nobody")).hasMessageContaining("nobody is no method");
  }
}
