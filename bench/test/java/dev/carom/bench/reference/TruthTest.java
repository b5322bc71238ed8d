// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Feature;
import dev.carom.Filter;
import dev.carom.Kind;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import java.io.IOException;
import java.math.BigDecimal;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TruthTest {

  private static Truth truth(Scene scene, int frames) {
    return Truth.of(scene, frames, () -> {});
  }

  /** In a box the unfolded motion is straight: a place is a zigzag of {@code x + v t}. */
  private static double zigzag(double x, double v, int t, double r, double width) {
    BigDecimal radius = new BigDecimal(r);
    BigDecimal room = new BigDecimal(width).subtract(radius).subtract(radius);
    BigDecimal period = room.add(room);
    BigDecimal way = new BigDecimal(v).multiply(new BigDecimal(t));
    BigDecimal unfolded = new BigDecimal(x).subtract(radius).add(way);
    BigDecimal rest = unfolded.remainder(period).add(period).remainder(period);
    return rest.min(period.subtract(rest)).add(radius).doubleValue();
  }

  @Test
  void squareBilliardIsTheClosedForm() {
    SceneBuilder setup =
        Scene.builder().collide(false).bounds(0, 0, 10, 10).circle(1.3, 4.1, 0.7, 3.7, -2.3);
    Scene scene = setup.circle(9.1, 0.4, 0.3, -0.1, 17.9).build();
    Truth truth = truth(scene, 300);
    for (int frame = 0; frame <= 300; frame++) {
      assertThat(truth.x(frame, 0)).isEqualTo(zigzag(1.3, 3.7, frame, 0.7, 10));
      assertThat(truth.y(frame, 0)).isEqualTo(zigzag(4.1, -2.3, frame, 0.7, 10));
      assertThat(truth.x(frame, 1)).isEqualTo(zigzag(9.1, -0.1, frame, 0.3, 10));
      assertThat(truth.y(frame, 1)).isEqualTo(zigzag(0.4, 17.9, frame, 0.3, 10));
      assertThat(Math.abs(truth.vx(frame, 0))).isEqualTo(3.7);
    }
  }

  /** 4 / 0.3 has no end, and is the same for both walls. */
  @Test
  void cornerIsHitByTwoWallsInTheirOrder() {
    Scene scene = Scene.builder().bounds(0, 0, 10, 10).circle(5, 5, 1, 0.3, 0.3).build();
    Truth truth = truth(scene, 20);
    assertThat(truth.proofs().get(0).hits())
        .containsExactly(
            new Hit(0, Kind.WALL, 1, Feature.SIDE), new Hit(0, Kind.WALL, 3, Feature.SIDE));
    assertThat(truth.vx(20, 0)).isEqualTo(-0.3);
    assertThat(truth.vy(20, 0)).isEqualTo(-0.3);
  }

  /** An impact whose time equals the end of a frame belongs to that frame. */
  @Test
  void impactAtTheEndOfAFrameBelongsToIt() {
    Truth truth = truth(Scene.builder().line(10, -5, 10, 5).circle(3, 0, 1, 2, 0).build(), 4);
    assertThat(truth.x(3, 0)).isEqualTo(9);
    assertThat(truth.vx(2, 0)).isEqualTo(2);
    assertThat(truth.vx(3, 0)).isEqualTo(-2);
  }

  /**
   * Which part is hit, and which way it goes then, of circles that come from the left by (1, 0).
   */
  @ParameterizedTest
  @CsvSource({
    "0, SIDE, -1, 0",
    "5, END, -1, 0",
    "5.6, END, -0.28, 0.96",
    "-5.6, START, -0.28, -0.96",
    "6, NONE, 1, 0",
    "-6.5, NONE, 1, 0"
  })
  void partsOfALine(double y, String feature, double vx, double vy) {
    Scene scene = Scene.builder().line(0, -5, 0, 5).circle(-9, y, 1, 1, 0).build();
    Truth truth = truth(scene, 20);
    List<Hit> hits = truth.proofs().get(0).hits();
    assertThat(hits.stream().map(hit -> hit.feature().name()).findFirst().orElse("NONE"))
        .isEqualTo(feature);
    assertThat(truth.vx(20, 0)).isCloseTo(vx, within(1e-15));
    assertThat(truth.vy(20, 0)).isCloseTo(vy, within(1e-15));
  }

  @Test
  void overlapIsAnImpactIfItGetsDeeper() {
    SceneBuilder setup =
        Scene.builder().collide(false).peg(0, 0, 1).line(10, 0, 20, 0).circle(1.5, 0, 1, -1, 0);
    setup.circle(1.5, 0, 1, 1, 0).circle(15, 0.5, 1, 0, -0.25).circle(15, 0.5, 1, 0, 0.25);
    Scene scene = setup.circle(15, 0, 1, 0, -0.25).build();
    Truth truth = truth(scene, 2);
    assertThat(truth.vx(0, 0)).isEqualTo(1);
    assertThat(truth.vx(2, 1)).isEqualTo(1);
    assertThat(truth.y(2, 2)).isEqualTo(1);
    assertThat(truth.y(2, 3)).isEqualTo(1);
    assertThat(truth.y(2, 4)).as("a centre on the line comes no nearer").isEqualTo(-0.5);
    assertThat(truth.impacts()).isEqualTo(2);
  }

  /** Dropped from 8 above the floor it is back after 2 sqrt(2 h / g) = 8: g is 1. */
  @Test
  void aBallThatBouncesIsTheClosedForm() {
    SceneBuilder setup = Scene.builder().collide(false).bounds(0, 0, 100, 1000).gravity(0, -1);
    Scene scene = setup.circle(30, 10, 2, 0.1, 0).circle(60, 10, 2, 0, 0).build();
    Truth truth = truth(scene, 300);
    for (int frame = 0; frame <= 300; frame++) {
      double t = (frame + 4) % 8 - 4; // since the top
      assertThat(truth.y(frame, 1)).isEqualTo(10 - t * t / 2);
      assertThat(truth.y(frame, 0)).isEqualTo(truth.y(frame, 1));
      assertThat(truth.x(frame, 0)).isEqualTo(zigzag(30, 0.1, frame, 2, 100));
      if (t != -4) {
        assertThat(truth.vy(frame, 1)).isEqualTo(-t);
      }
    }
    assertThat(truth.impacts(1)).isEqualTo(38);
  }

  /**
   * A ball over a slope of 45 degrees, 4 above it. Its distance from the slope falls from {@code 4
   * sin 45 - 1}, as on a level floor; along the slope it falls freely until the end.
   */
  @Test
  void aSlopeIsHitAgainUntilItsEnd() {
    Scene scene =
        Scene.builder().line(0, 0, 30, -30).gravity(0, -1).circle(10, -6, 1, 0, 0).build();
    List<Hit> hits = truth(scene, 20).proofs().get(0).hits();
    double sine = Math.sqrt(0.5);
    double first = Math.sqrt(2 * (4 * sine - 1) / sine);
    int expected = 0;
    for (double t = first; 16 * sine + sine * t * t / 2 < 30 / sine; t += 2 * first) {
      expected++;
    }
    assertThat(expected).isGreaterThan(1);
    assertThat(hits).hasSize(expected).allMatch(hit -> hit.feature() == Feature.SIDE);
  }

  /** The derivatives with gravity, against differences of two runs. */
  @Test
  void conditioningWithGravityIsTheDerivative() {
    Scene scene =
        Differences.moved(
            Scene.builder()
                .bounds(0, 0, 100, 100)
                .line(20, 30, 60, 20)
                .restitution(0.75)
                .peg(70, 40, 9)
                .gravity(0.01, -0.125)
                .circle(45, 70, 3, 0.5, 0.25)
                .build(),
            -1,
            0);
    int frame = 200;
    Truth truth = truth(scene, frame);
    assertThat(truth.impacts()).isGreaterThan(5);
    double sum = 0;
    for (int q = 0; q < 4; q++) {
      sum += Differences.derivative(scene, q, frame, 0);
    }
    assertThat(truth.log10Conditioning(frame, 0)).isCloseTo(Math.log10(sum), within(1e-6));
  }

  /**
   * The check that Truth makes at the end of each search for digits, here with digits of our own.
   */
  @Test
  void runsWithMoreDigitsAgree() throws IOException {
    Scene scene = References.scene("base-1");
    Truth truth = truth(scene, 150);
    for (int i = 0; i < 100; i += 7) {
      Run run = new Run(scene, new int[] {i}, new Lookout(scene, 3000), 150, 3000);
      assertThat(run.play()).isEqualTo(truth.proofs().get(i).hits());
      assertThat(run.courses().get(0).distance(truth.course(i))).isLessThan(1e-30);
    }
  }

  @Test
  void tooFewDigitsAreNoticed() throws IOException {
    Scene scene = References.scene("base-1");
    Truth truth = truth(scene, 600);
    assertThat(truth.neededBits()).startsWith(128).endsWith(512);
    int doubted = 0;
    for (int i = 0; i < 100; i++) {
      if (truth.proofs().get(i).needed() > 128) {
        Run run = new Run(scene, new int[] {i}, new Lookout(scene, 128), 600, 128);
        assertThatThrownBy(run::play).isInstanceOf(DoubtException.class);
        doubted++;
      }
    }
    assertThat(doubted).isGreaterThan(50);
  }

  @Test
  void refusesWhatItDoesNotKnow() {
    Scene sensor =
        Scene.builder().peg(0, 0, 1).response(Response.SENSOR).circle(5, 0, 1, 0, 0).build();
    assertThatThrownBy(() -> truth(sensor, 1))
        .hasMessage("peg 0 has the response SENSOR: a reference expects BOUNCE");
    Scene lift = Scene.builder().line(0, 0, 9, 0).velocity(0, 1).circle(5, 9, 1, 0, 0).build();
    assertThatThrownBy(() -> truth(lift, 1))
        .hasMessage("line 0 has the velocity (0.0, 1.0): a reference expects obstacles at rest");
    Scene gas =
        Scene.builder().gravity(0, -0.5).circle(5, 9, 1, 0, 0).circle(9, 9, 1, 0, 0).build();
    assertThatThrownBy(() -> truth(gas, 1))
        .hasMessage(
            "circles collide: with gravity, a reference expects ones that ignore each other");
    SceneBuilder setup = Scene.builder().gravity(0, -0.5);
    Scene floating = setup.circle(5, 9, 1, 0, 0).mass(Double.POSITIVE_INFINITY).build();
    assertThatThrownBy(() -> truth(floating, 1))
        .hasMessage(
            "circle 0 has infinite mass: with gravity, a reference expects circles that fall");
    Scene gate = Scene.builder().line(0, 0, 1, 0).oneWay().circle(5, 0, 1, 0, 0).build();
    assertThatThrownBy(() -> truth(gate, 1)).hasMessageStartingWith("line 0 is one-way");
    Scene ghost =
        Scene.builder().peg(0, 0, 1).circle(5, 0, 1, 0, 0).filter(new Filter(2, -1)).build();
    assertThatThrownBy(() -> truth(ghost, 1))
        .hasMessage("circle 0 has a filter: a reference expects category 1 and mask -1");
    Scene mask =
        Scene.builder().peg(0, 0, 1).filter(new Filter(1, 2)).circle(5, 0, 1, 0, 0).build();
    assertThatThrownBy(() -> truth(mask, 1)).hasMessageStartingWith("peg 0 has a filter");
    assertThatThrownBy(() -> truth(gate, 0)).hasMessage("frames is 0: expected at least 1");
  }
}
