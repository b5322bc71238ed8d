// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;

/** Checks of the answers of the detector. */
final class SweptCircleAnswers {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private SweptCircleAnswers() {}

  /** Casts in both forms, which must agree on the time; the impact must be there. */
  static Impact hit(Circle c, Vec2 v, Line line, double T) {
    Impact impact = new SweptCircle(c, v).cast(line, T).orElseThrow();
    assertThat(time(c, v, line, T)).isEqualTo(impact.time());
    assertThat(impact.kind()).isEqualTo(Kind.LINE);
    return impact;
  }

  static Impact hit(Circle c, Vec2 v, Line line) {
    return hit(c, v, line, NEVER);
  }

  static double time(Circle c, Vec2 v, Line l, double T) {
    double t =
        new SweptCircle(c.x(), c.y(), c.radius(), v.x(), v.y())
            .timeToLine(l.ax(), l.ay(), l.bx(), l.by(), T);
    assertThat(new SweptCircle(c, v).cast(l, T).isPresent()).isEqualTo(t < NEVER);
    return t;
  }

  static double time(Circle c, Vec2 v, Line l) {
    return time(c, v, l, NEVER);
  }

  /**
   * Compares an impact: its time and parts exactly, the numbers that the contract allows to be
   * rounded within some ulps.
   */
  static void assertImpact(Impact actual, Impact expected) {
    assertThat(actual.time()).isEqualTo(expected.time());
    assertThat(actual.kind()).isEqualTo(expected.kind());
    assertThat(actual.id()).isEqualTo(expected.id());
    assertThat(actual.circle()).isEqualTo(expected.circle());
    assertThat(actual.part()).isEqualTo(expected.part());
    assertThat(actual.impulse()).isEqualTo(expected.impulse());
    assertThat(actual.outcome()).isEqualTo(expected.outcome());
    assertThat(actual.feature()).isEqualTo(expected.feature());
    assertVector(actual.normal(), expected.normal(), 1e-15);
    assertVector(actual.point(), expected.point(), 1e-14);
    assertThat(actual.approachSpeed())
        .isCloseTo(expected.approachSpeed(), within(1e-15 * (1 + expected.approachSpeed())));
  }

  /** The one of the obstacles of a resolver that an impact is with. */
  static Obstacle thing(List<? extends Obstacle> all, Impact hit) {
    int id = hit.kind() == Kind.WALL ? 0 : hit.id();
    return all.stream().filter(o -> kind(o) == hit.kind()).skip(id).findFirst().orElseThrow();
  }

  private static Kind kind(Obstacle o) {
    return o instanceof Bounds ? Kind.WALL : o instanceof Line ? Kind.LINE : Kind.PEG;
  }

  /** The answer of a cast. */
  static Impact impact(
      double t, Kind kind, int id, Feature feature, Vec2 at, Vec2 n, double speed) {
    return new Impact(
        t, -1, kind, id, 0, feature, at.x(), at.y(), n.x(), n.y(), speed, 0, Outcome.BOUNCED);
  }

  static void assertVector(Vec2 actual, Vec2 expected, double error) {
    assertThat(actual.x()).isCloseTo(expected.x(), within(error));
    assertThat(actual.y()).isCloseTo(expected.y(), within(error));
  }
}
