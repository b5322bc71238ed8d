// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ResolverWayTest {
  private static final Bounds ROOM = new Bounds(0, 0, 100, 100);
  private static final Line LINE = new Line(20, 0, 20, 60);
  private static final Circle PEG = new Circle(80, 80, 10);
  private static final Circle END = new Circle(60, 20, 0);
  private static final Circle CIRCLE = new Circle(50, 50, 5);
  private static final List<Obstacle> ALL = List.of(LINE, END, ROOM, PEG);
  private static final Resolver RESOLVER = Resolver.of(ALL);

  @Test
  void aTraceEndsAtItsTime() {
    Trajectory path =
        Resolver.of(List.of(ROOM)).trace(new SweptCircle(CIRCLE, new Vec2(3, 0)), 0.5, 45, 9);
    assertThat(path.impacts()).extracting(Impact::time).containsExactly(15.0);
    assertThat(path.velocityAt(45)).isEqualTo(new Vec2(-1.5, 0));
    assertThat(path.duration()).isEqualTo(45);
    assertThat(path.complete()).isTrue();
    assertThat(path.end()).isEqualTo(new Vec2(50, 50));
  }

  private static Obstacle hit(Vec2 v, double maxTime) {
    return SweptCircleAnswers.thing(
        ALL, RESOLVER.cast(new SweptCircle(CIRCLE, v), maxTime).orElseThrow());
  }

  @Test
  void theFirstImpactWithAnyKind() {
    assertThat(hit(new Vec2(-5, 0), 9)).isEqualTo(LINE);
    assertThat(hit(new Vec2(1, 1), 99)).isEqualTo(PEG);
    assertThat(hit(new Vec2(1, -3), 99)).isEqualTo(END);
    assertThat(hit(new Vec2(0, 1), 99)).isEqualTo(ROOM);
    assertThat(RESOLVER.cast(new SweptCircle(CIRCLE, new Vec2(0, 1)), 44)).isEmpty();
    assertThat(RESOLVER.cast(new SweptCircle(CIRCLE, new Vec2(1, -3)), 99).orElseThrow().id())
        .isZero();
    assertThat(RESOLVER.cast(new SweptCircle(CIRCLE, new Vec2(1, 1)), 99).orElseThrow().id())
        .isEqualTo(1);
  }

  private static Nearest nearest(double x, double y, Kind... kinds) {
    return RESOLVER.nearest(x, y, kinds).orElseThrow();
  }

  @Test
  void whatIsNearestAndWhatOverlaps() {
    assertThat(nearest(30, 30)).isEqualTo(new Nearest(Kind.LINE, 0, 10, 20, 30));
    assertThat(nearest(63, 24)).isEqualTo(new Nearest(Kind.PEG, 0, 5, 60, 20));
    assertThat(nearest(30, 30, Kind.WALL, Kind.PEG))
        .isEqualTo(new Nearest(Kind.WALL, 0, 30, 0, 30));
    assertThat(nearest(68, 64, Kind.PEG)).isEqualTo(new Nearest(Kind.PEG, 1, 10, 74, 72));
    assertThat(nearest(80, 81)).as("inside").isEqualTo(new Nearest(Kind.PEG, 1, 0, 80, 81));
    assertThat(RESOLVER.nearest(1, 2, Kind.CIRCLE)).isEmpty();
    assertThat(RESOLVER.overlapping(Kind.PEG, new Circle(75, 75, 4))).containsExactly(1);
    assertThat(RESOLVER.overlapping(Kind.WALL, new Circle(40, 10, 30))).containsExactly(2);
    assertThat(RESOLVER.overlapping(Kind.LINE, new Circle(40, 10, 30))).containsExactly(0);
    assertThat(RESOLVER.overlapping(Kind.PEG, new Bounds(59, 19, 61, 21))).containsExactly(0);
    assertThat(RESOLVER.overlapping(Kind.LINE, new Bounds(10, 10, 30, 30))).containsExactly(0);
    assertThat(RESOLVER.overlapping(Kind.CIRCLE, new Bounds(0, 0, 99, 99))).isEmpty();
  }

  @Test
  void equalObstaclesAreToldEach() {
    Line line = new Line(10, 10, 30, 10);
    Line same = new Line(10, 10, 30, 10);
    Circle peg = new Circle(20, 12, 1);
    Resolver resolver = Resolver.of(List.of(new Bounds(0, 0, 40, 40), peg, line, same, peg));
    assertThat(resolver.overlapping(Kind.LINE, new Circle(20, 10, 3))).containsExactly(0, 1);
    assertThat(resolver.overlapping(Kind.PEG, new Circle(20, 10, 3))).containsExactly(0, 1);
    assertThat(resolver.overlapping(Kind.WALL, new Bounds(-1, -1, 41, 41))).hasSize(4);
  }

  /** Thrown at 20 to the right and 30 up under g = 10, over a floor at y = 0. */
  @Test
  void questionsFallAsTheCircleDoes() {
    Resolver resolver = Resolver.of(List.of(new Line(-99, 0, 999, 0), new Line(100, 0, 100, 99)));
    SweptCircle ball = new SweptCircle(0, 5, 5, 20, 30, 0, -10);
    Impact hit = resolver.cast(ball, 10).orElseThrow();
    assertThat(hit.time()).isEqualTo(4.75);
    assertThat(hit.kind()).isEqualTo(Kind.LINE);
    assertThat(hit.id()).isEqualTo(1);
    assertThat(hit.point()).isEqualTo(new Vec2(100, ball.at(4.75).y()));
    assertThat(resolver.cast(ball, Math.nextDown(4.75))).isEmpty();
    assertThat(resolver.trace(ball, 1, 10, 1).impacts().get(0).time()).isEqualTo(4.75);
    assertThat(resolver.cast(ball.withVelocity(1, 30), 10).orElseThrow().time()).isEqualTo(6);
    SweptCircle straight = ball.withVelocity(20, 3).withAcceleration(0, 0);
    assertThat(resolver.cast(straight, 10).orElseThrow().id()).isOne();
  }

  @Test
  void sensorsArePassed() {
    Scene scene =
        Scene.builder().line(60, 0, 60, 100).response(Response.SENSOR).line(80, 0, 80, 100).build();
    Resolver resolver = scene.resolver();
    assertThat(resolver.cast(new SweptCircle(CIRCLE, new Vec2(1, 0)), 99).map(Impact::id))
        .contains(1);
    Trajectory path =
        resolver.trace(new SweptCircle(CIRCLE, new Vec2(1, 0)), 1, 99, Integer.MAX_VALUE);
    assertThat(path.impacts()).extracting(Impact::time).containsExactly(5.0, 25.0, 35.0);
    assertThat(path.impacts())
        .extracting(Impact::outcome)
        .containsExactly(Outcome.SENSED, Outcome.BOUNCED, Outcome.SENSED);
    assertThat(path.points()).hasSize(3);
  }

  /** The normal is that of the side where it came along the line; else it is turned back. */
  @ParameterizedTest
  @CsvSource({
    "5, 5, -1, -1, -1, 1",
    "5, -5, -1, 1, -1, -1",
    "5, 5, 1, -1, 1, 1",
    "5, -5, 1, 1, 1, -1",
    "-5, 5, 1, -1, -1, 1",
    "15, -5, -1, 1, 1, -1",
    "0, 5, 0, -1, 0, 1"
  })
  void aPointThatHitsTheVeryEnd(double x, double y, double vx, double vy, double ux, double uy) {
    for (Line line : List.of(new Line(0, 0, 10, 0), new Line(10, 0, 0, 0))) {
      Trajectory way =
          Resolver.of(List.of(line))
              .trace(
                  new SweptCircle(new Circle(x, y, 0), new Vec2(vx, vy)), 1, 6, Integer.MAX_VALUE);
      assertThat(way.impacts()).extracting(Impact::time).containsExactly(5.0);
      assertThat(way.velocityAt(6)).isEqualTo(new Vec2(ux, uy));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1, Double.NaN, Double.POSITIVE_INFINITY})
  void refusesWhatIsOutOfRange(double bad) {
    refused(
        () -> RESOLVER.trace(new SweptCircle(CIRCLE, Vec2.ZERO), bad, 1, 1),
        "restitution is " + bad);
    refused(
        () -> RESOLVER.trace(new SweptCircle(CIRCLE, Vec2.ZERO), 1, bad, 1), "duration is " + bad);
    refused(
        () -> RESOLVER.trace(new SweptCircle(CIRCLE, Vec2.ZERO), 1, bad, Integer.MAX_VALUE),
        "duration is " + bad);
    refused(() -> Vec2.ZERO.reflect(new Vec2(1, 0), bad), "restitution is " + bad);
  }

  @Test
  void refusesWhatMakesNoSense() {
    refused(
        () -> RESOLVER.trace(new SweptCircle(CIRCLE, Vec2.ZERO), 1, 1, -1),
        "impacts is -1: expected at least 0");
    refused(() -> RESOLVER.cast(new SweptCircle(CIRCLE, Vec2.ZERO), -1), "maxTime is -1");
    refused(() -> RESOLVER.nearest(Double.NaN, 0), "x is NaN");
    refused(() -> RESOLVER.nearest(0, Double.NaN), "y is NaN");
    refused(() -> Resolver.of(List.of(ROOM, new Bounds(1, 2, 3, 4))), "a second Bounds");
  }

  private static void refused(Runnable call, String message) {
    assertThatIllegalArgumentException().isThrownBy(call::run).withMessageContaining(message);
  }
}
