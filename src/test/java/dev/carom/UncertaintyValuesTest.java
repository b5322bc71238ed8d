// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The bounds of some paths, in numbers. Those of this theory were compared with true courses in
 * arbitrary precision ({@code UncertaintyBoundTest} of the harness). A change of the theory shows
 * here, and needs that comparison again.
 */
class UncertaintyValuesTest {

  private static final double LENGTH = 3e-14;

  private static SceneBuilder room(double gx, double gy) {
    return Scene.builder().bounds(0, 0, 30, 20).gravity(gx, gy);
  }

  private static Scene scene(String name) {
    SceneBuilder room = room(0, 0);
    return switch (name) {
      case "free" -> room.circle(4, 7, 1, 0.13, 0.21).build();
      case "walls" -> room.circle(4, 7, 1, 1.3, 2.1).build();
      case "inelastic walls" -> room.restitution(0.9).circle(4, 7, 1, 1.3, 2.1).build();
      case "bumpers" -> room.restitution(1.125).circle(4, 7, 1, 1.3, 2.1).build();
      case "line" -> room.line(3, 3, 27, 9).circle(4, 7, 1, 1.3, 2.1).build();
      case "inelastic line" ->
          room.line(3, 3, 27, 9).restitution(0.75).circle(4, 12, 1, 1.3, 2.1).build();
      case "peg" -> room.peg(15, 10, 5).circle(4, 7, 1, 1.3, 2.1).build();
      case "soft peg" -> room.peg(15, 10, 5).restitution(0.5).circle(4, 7, 1, 1.3, 2.1).build();
      case "corner" -> room.circle(4, 4, 1, 1.5, 1.5).build();
      case "end" -> room.line(9, 15, 12, 15).circle(4, 7, 1, 1.3, 2.1).build();
      case "floor" -> room(0, -0.25).circle(4, 7, 1, 1.3, 2.1).build();
      case "inelastic floor" -> room(0, -0.25).restitution(0.96).circle(4, 7, 1, 1.3, 2.1).build();
      case "slanted gravity" ->
          room(0.05, -0.25).line(3, 3, 27, 5).circle(4, 7, 1, 1.3, 2.1).build();
      case "peg under gravity" -> room(0, -0.25).peg(15, 5, 8).circle(4, 14, 1, 1.3, 1.1).build();
      case "soft peg under gravity" ->
          room(0, -0.25).peg(15, 5, 8).restitution(0.8).circle(4, 14, 1, 1.3, 1.1).build();
      default -> throw new IllegalArgumentException(name);
    };
  }

  /** Steps of a half to a time, and the bound then. */
  private static double follow(World world, Uncertainty uncertainty, double end) {
    while (world.now() < end) {
      world.step(0.5);
    }
    return uncertainty.bound(0);
  }

  private static double[] values(String name) {
    World world = new World(scene(name));
    Uncertainty uncertainty = world.uncertainty(LENGTH);
    double early = follow(world, uncertainty, 12.5);
    double late = follow(world, uncertainty, 25);
    double lostAt = uncertainty.lostAt(0);
    double exponent = uncertainty.lyapunovExponent(0);
    uncertainty.restart(0);
    double start = uncertainty.bound(0);
    return new double[] {early, late, lostAt, exponent, start, follow(world, uncertainty, 30)};
  }

  /**
   * The bound at two times, the time at which it passed a length, and the exponent; then the bound
   * after a second start, and a while later.
   */
  @ParameterizedTest
  @CsvSource({
    "free, 2.2495136e-15, 3.2777818e-15, Infinity, 0, 5.2735594e-15, 5.6848667e-15",
    "walls, 1.5003063e-14, 3.1632625e-14, 23.015322, 0, 1.7430501e-14, 2.1543574e-14",
    "inelastic walls, 2.2887399e-14, 6.9416840e-14, 15.238095, -0.0054736696, 1.6818213e-14, 2.7901834e-14",
    "bumpers, 2.5165033e-14, 1.2856139e-13, 13.333333, 0.0069095997, 1.7893564e-14, 3.3715058e-14",
    "line, 1.9620009e-14, 9.4487285e-14, 15.537355, 0, 1.6377286e-14, 2.0490359e-14",
    "inelastic line, 2.3793464e-14, 9.9923979e-14, 14.561558, -0.0015094463, 1.1990193e-14, 1.7830852e-14",
    "peg, 1.2576352e-13, 5.2174421e-13, 8.5450360, 0.16207593, 1.3345348e-14, 3.4452492e-14",
    "soft peg, 5.6466741e-14, 2.8991916e-13, 9.6649826, 0.13348542, 1.0436439e-14, 1.1711571e-14",
    "corner, 1.3534718e-14, 2.2769773e-14, Infinity, 0, 1.3211654e-14, 1.6744362e-14",
    "end, 3.2343916e-14, 1.0345835e-13, 12.035097, 0.18717731, 1.6792908e-14, 2.5734345e-14",
    "floor, 3.2278723e-14, 3.1839993e-14, 11.901266, -0.0064698269, 8.1186087e-14, 9.5692241e-14",
    "inelastic floor, 3.2278723e-14, 4.6332435e-14, 11.901266, -0.0080826308, 7.9774973e-14, 9.3969334e-14",
    "slanted gravity, 3.2622266e-14, 7.1006054e-14, 11.818933, -0.020187476, 8.3021955e-14, 9.8126867e-14",
    "peg under gravity, 1.9733691e-14, 1.9334812e-13, 15.262399, 0.082626330, 9.0610885e-14, 1.1162453e-13",
    "soft peg under gravity, 2.0217669e-14, 1.4610553e-13, 15.022156, 0.057772817, 8.2547489e-14, 1.6920479e-13"
  })
  void theBoundsAreAsBefore(
      String name,
      double early,
      double late,
      double lostAt,
      double exponent,
      double start,
      double again) {
    double[] expected = {early, late, lostAt, exponent, start, again};
    double[] actual = values(name);
    for (int i = 0; i < expected.length; i++) {
      if (Double.isInfinite(expected[i])) {
        assertThat(actual[i]).as("value %d", i).isEqualTo(expected[i]);
      } else {
        assertThat(actual[i])
            .as("value %d", i)
            .isCloseTo(expected[i], within(1e-6 * Math.abs(expected[i]) + 1e-30));
      }
    }
  }
}
