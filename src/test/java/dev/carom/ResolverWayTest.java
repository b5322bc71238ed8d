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

  /** At 95, 5, 95 and so on, after 15 and each 30 more. */
  @Test
  void aTraceEndsAtItsImpactOfAGivenNumber() {
    Trajectory path = Resolver.of(List.of(ROOM)).trace(CIRCLE, new Vec2(3, 0), 1, 1000, 3);
    assertThat(path.impacts()).extracting(Impact::time).containsExactly(15.0, 45.0, 75.0);
    assertThat(path.impacts()).extracting(Impact::id).containsExactly(1, 0, 1);
    assertThat(path.duration()).isEqualTo(75);
    assertThat(path.complete()).isTrue();
    assertThat(path.end()).isEqualTo(new Vec2(95, 50));
  }

  @Test
  void aTraceEndsAtItsTime() {
    Trajectory path = Resolver.of(List.of(ROOM)).trace(CIRCLE, new Vec2(3, 0), 0.5, 45, 9);
    assertThat(path.impacts()).extracting(Impact::time).containsExactly(15.0);
    assertThat(path.velocityAt(45)).isEqualTo(new Vec2(-1.5, 0));
    assertThat(path.duration()).isEqualTo(45);
    assertThat(path.complete()).isTrue();
    assertThat(path.end()).isEqualTo(new Vec2(50, 50));
  }

  /** A millionth of room: an impact every millionth of a time. */
  @Test
  void aTraceOfTooManyImpactsIsNotComplete() {
    Resolver narrow = Resolver.of(List.of(new Bounds(0, 0, 2 + 0x1p-20, 9)));
    Trajectory path = narrow.trace(new Circle(1, 4, 1), new Vec2(1, 0), 1);
    assertThat(path.complete()).isFalse();
    assertThat(path.impacts()).hasSize(Resolver.IMPACTS_PER_TRACE);
    assertThat(path.duration()).isEqualTo(Resolver.IMPACTS_PER_TRACE * 0x1p-20);
    assertThat(narrow.trace(new Circle(1, 4, 1), new Vec2(1, 0), 0.01).complete()).isTrue();
  }

  private static Obstacle hit(Vec2 v, double maxTime) {
    return SweptCircleAnswers.thing(ALL, RESOLVER.cast(CIRCLE, v, maxTime).orElseThrow());
  }

  @Test
  void theFirstImpactWithAnyKind() {
    assertThat(hit(new Vec2(-5, 0), 9)).isEqualTo(LINE);
    assertThat(hit(new Vec2(1, 1), 99)).isEqualTo(PEG);
    assertThat(hit(new Vec2(1, -3), 99)).isEqualTo(END);
    assertThat(hit(new Vec2(0, 1), 99)).isEqualTo(ROOM);
    assertThat(RESOLVER.cast(CIRCLE, new Vec2(0, 1), 44)).isEmpty();
    assertThat(RESOLVER.cast(CIRCLE, new Vec2(1, -3), 99).orElseThrow().id()).isZero();
    assertThat(RESOLVER.cast(CIRCLE, new Vec2(1, 1), 99).orElseThrow().id()).isEqualTo(1);
  }

  @Test
  void whatIsNearestAndWhatOverlaps() {
    assertThat(RESOLVER.nearest(new Vec2(30, 30))).contains(LINE);
    assertThat(RESOLVER.nearest(new Vec2(65, 25))).contains(END);
    assertThat(RESOLVER.overlapping(new Circle(75, 75, 4))).containsExactly(PEG);
    assertThat(RESOLVER.overlapping(new Circle(40, 10, 30)))
        .containsExactlyInAnyOrder(ROOM, LINE, END);
    assertThat(RESOLVER.overlapping(new Bounds(59, 19, 61, 21))).containsExactly(END);
    assertThat(RESOLVER.overlapping(new Bounds(10, 10, 30, 30))).containsExactly(LINE);
  }

  @Test
  void equalObstaclesAreToldEach() {
    Line line = new Line(10, 10, 30, 10);
    Line same = new Line(10, 10, 30, 10);
    Circle peg = new Circle(20, 12, 1);
    Resolver resolver = Resolver.of(List.of(new Bounds(0, 0, 40, 40), peg, line, same, peg));
    assertThat(resolver.overlapping(new Circle(20, 10, 3))).containsExactly(line, same, peg, peg);
    assertThat(resolver.overlapping(new Circle(20, 10, 50)))
        .as("of four walls one bounds")
        .containsExactly(new Bounds(0, 0, 40, 40), line, same, peg, peg);
    assertThat(resolver.overlapping(new Bounds(-1, -1, 41, 41))).hasSize(5);
  }

  @Test
  void sensorsArePassed() {
    Scene scene =
        Scene.builder().line(60, 0, 60, 100).response(Response.SENSOR).line(80, 0, 80, 100).build();
    Resolver resolver = scene.resolver();
    assertThat(resolver.cast(CIRCLE, new Vec2(1, 0), 99).map(Impact::id)).contains(1);
    Trajectory path = resolver.trace(CIRCLE, new Vec2(1, 0), 99);
    assertThat(path.impacts()).extracting(Impact::time).containsExactly(25.0);
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
      Trajectory way = Resolver.of(List.of(line)).trace(new Circle(x, y, 0), new Vec2(vx, vy), 6);
      assertThat(way.impacts()).extracting(Impact::time).containsExactly(5.0);
      assertThat(way.velocityAt(6)).isEqualTo(new Vec2(ux, uy));
    }
  }

  @Test
  void reflects() {
    assertThat(new Vec2(3, -4).reflect(new Vec2(0, 2), 0.5)).isEqualTo(new Vec2(3, 2));
    assertThat(new Vec2(3, -4).reflect(new Vec2(-1, 1), 1)).isEqualTo(new Vec2(-4, 3));
    assertThat(new Vec2(3, 4).reflect(new Vec2(0, 2), 0.5)).isEqualTo(new Vec2(3, 4));
    assertThat(new Vec2(3, 0).reflect(new Vec2(0, 2), 0.5)).isEqualTo(new Vec2(3, 0));
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1, Double.NaN, Double.POSITIVE_INFINITY})
  void refusesWhatIsOutOfRange(double bad) {
    refused(() -> RESOLVER.trace(CIRCLE, Vec2.ZERO, bad, 1, 1), "restitution is " + bad);
    refused(() -> RESOLVER.trace(CIRCLE, Vec2.ZERO, 1, bad, 1), "duration is " + bad);
    refused(() -> RESOLVER.trace(CIRCLE, Vec2.ZERO, bad), "duration is " + bad);
    refused(() -> Vec2.ZERO.reflect(new Vec2(1, 0), bad), "restitution is " + bad);
  }

  @Test
  void refusesWhatMakesNoSense() {
    refused(
        () -> RESOLVER.trace(CIRCLE, Vec2.ZERO, 1, 1, -1), "impacts is -1: expected at least 0");
    refused(() -> RESOLVER.cast(CIRCLE, Vec2.ZERO, -1), "maxTime is -1");
    refused(() -> new Vec2(1, 0).reflect(Vec2.ZERO, 1), "normal");
    refused(() -> Resolver.of(List.of(ROOM, new Bounds(1, 2, 3, 4))), "second");
  }

  private static void refused(Runnable call, String message) {
    assertThatIllegalArgumentException().isThrownBy(call::run).withMessageContaining(message);
  }
}
