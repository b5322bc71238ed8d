// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Impact;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Obstacle;
import dev.carom.Resolver;
import dev.carom.SweptCircle;
import dev.carom.SweptSphere;
import dev.carom.Trajectory;
import dev.carom.Vec2;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Any finite doubles into every function of detector and resolver: nothing throws from inside,
 * nothing hangs, and no answer is NaN.
 */
@Timeout(value = 600, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ExtremeQuestionsTest {

  /** At least as many as hold a product that is NaN. */
  private static final int QUERIES =
      (int) Math.max(1000, Long.getLong("carom.queries", 250_000) / 50);

  private static Circle circle(Extremes e) {
    return new Circle(e.any(), e.any(), e.size());
  }

  private static Vec2 vector(Extremes e) {
    return new Vec2(e.any(), e.any());
  }

  private static Line line(Extremes e) {
    return new Line(e.any(), e.any(), e.any(), e.any());
  }

  private static Bounds bounds(Extremes e) {
    double x = e.any();
    double y = e.any();
    double u = e.any();
    double v = e.any();
    return x == u || y == v
        ? new Bounds(0, 0, 1, 1)
        : new Bounds(Math.min(x, u), Math.min(y, v), Math.max(x, u), Math.max(y, v));
  }

  private static Obstacle obstacle(Extremes e) {
    return switch (e.random.nextInt(3)) {
      case 0 -> line(e);
      case 1 -> circle(e);
      default -> new Circle(e.any(), e.any(), 0);
    };
  }

  private static void checkTime(double t, double window) {
    assertThat(t >= 0 && (t <= window || t == Double.POSITIVE_INFINITY)).as("%s", t).isTrue();
  }

  private static void check(Optional<Impact> impact, double window) {
    impact.ifPresent(
        hit -> {
          checkTime(hit.time(), window);
          assertThat(hit.approachSpeed()).isNotNaN().isNotNegative();
          assertThat(hit.normal().length()).isCloseTo(1, within(1e-15));
        });
  }

  @Test
  void theDetectorAnswers() {
    // The textbook's answers to the same questions: NaN, or an exception from inside.
    int nan = 0;
    for (int seed = 0; seed < QUERIES; seed++) {
      Extremes e = new Extremes(seed);
      Circle c = circle(e);
      Vec2 v = vector(e);
      Circle other = circle(e);
      Vec2 u = vector(e);
      Line line = line(e);
      double window = e.window();
      double b = (c.x() - other.x()) * (v.x() - u.x()) + (c.y() - other.y()) * (v.y() - u.y());
      nan += Double.isNaN(b) ? 1 : 0;
      check(new SweptCircle(c, v).cast(line, window), window);
      check(new SweptCircle(c, v).cast(other, window), window);
      check(new SweptCircle(c, v).cast(bounds(e), window), window);
      check(new SweptCircle(c, v).cast(new SweptCircle(other, u), window), window);
      double t =
          new SweptCircle(c.x(), c.y(), c.radius(), v.x(), v.y())
              .timeToLine(line.ax(), line.ay(), line.bx(), line.by(), window);
      checkTime(t, window);
      assertThat(line.closestPoint(v)).isNotNull();
      separate(c, other);
      separate(c, line);
      separate(c, bounds(e));
    }
    assertThat(nan).as("naive products that are NaN").isPositive();
  }

  private static void separate(Circle c, Obstacle other) {
    try {
      Vec2 s = c.separation(other);
      assertThat(new Circle(c.x() + s.x(), c.y() + s.y(), c.radius()).overlaps(other)).isFalse();
    } catch (IllegalArgumentException refused) {
      assertThat(refused.getMessage())
          .matches(".* together is .* at most 2\\^1023|radius .* fits .*");
    }
  }

  @Test
  void spheresAnswerAndRespond() {
    for (int seed = 0; seed < QUERIES; seed++) {
      Extremes e = new Extremes(seed);
      double[] p = {e.any(), e.any(), e.any(), e.any(), e.any(), e.any()};
      double[] v = {e.any(), e.any(), e.any(), e.any(), e.any(), e.any()};
      double r1 = e.size();
      double r2 = e.size();
      double window = e.window();
      double t =
          new SweptSphere(p[0], p[1], p[2], r1, v[0], v[1], v[2])
              .timeToSphere(new SweptSphere(p[3], p[4], p[5], r2, v[3], v[4], v[5]), window);
      checkTime(t, window);
      double m1 = e.mass();
      SweptSphere.respond(
          new SweptSphere(p[0], p[1], p[2], 0, v[0], v[1], v[2]),
          m1,
          new SweptSphere(p[3], p[4], p[5], 0, v[3], v[4], v[5]),
          e.mass(),
          e.size(),
          v);
      assertThat(v).doesNotContain(Double.NaN);
    }
  }

  @Test
  void theResolverAnswers() {
    for (int seed = 0; seed < QUERIES / 4; seed++) {
      Extremes e = new Extremes(seed);
      List<Obstacle> obstacles = new ArrayList<>();
      for (int i = e.random.nextInt(5); i > 0; i--) {
        obstacles.add(obstacle(e));
      }
      if (e.random.nextBoolean()) {
        obstacles.add(bounds(e));
      }
      Resolver resolver = Resolver.of(obstacles);
      Circle c = circle(e);
      Vec2 v = vector(e);
      double window = e.window();
      check(resolver.cast(new SweptCircle(c, v), window), window);
      Trajectory way = resolver.trace(new SweptCircle(c, v), e.size(), e.size(), 20);
      way.impacts().forEach(impact -> check(Optional.of(impact), way.duration()));
      assertThat(way.points()).hasSize(way.impacts().size() + 2);
      for (Kind kind : Kind.values()) {
        assertThat(resolver.overlapping(kind, c).length).isLessThanOrEqualTo(4 * obstacles.size());
      }
      assertThat(resolver.nearest(v.x(), v.y()).isPresent()).isEqualTo(!obstacles.isEmpty());
    }
  }

  @Test
  void reflectionsAreFiniteOrRefused() {
    int finite = 0;
    for (int seed = 0; seed < QUERIES; seed++) {
      Extremes e = new Extremes(seed);
      Vec2 v = vector(e);
      Vec2 n = vector(e);
      double restitution = e.size();
      try {
        v.reflect(n, restitution);
        finite++;
      } catch (IllegalArgumentException refused) {
        assertThat(refused.getMessage()).matches("(normal|restitution) is .*: expected .*");
      }
    }
    assertThat(finite).isGreaterThan(QUERIES / 2);
  }
}
