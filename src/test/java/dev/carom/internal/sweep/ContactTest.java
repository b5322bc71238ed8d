// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Impact;
import dev.carom.ImpactLog;
import dev.carom.Line;
import dev.carom.Obstacle;
import dev.carom.Resolver;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SweptCircle;
import dev.carom.Trajectory;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The first impact of a resolver is that of the detector: the same time and feature, and to
 * rounding the same point, normal and speed, also where they overlap at the start.
 */
class ContactTest {
  private static final int QUERIES = 1_500;

  private final Random random = new Random(11);

  private double whole(int most) {
    return random.nextInt(2 * most + 1) - most;
  }

  private double any(double most) {
    return most * (2 * random.nextDouble() - 1);
  }

  private Vec2 place(double scale) {
    return random.nextInt(3) == 0
        ? new Vec2(whole(9) * scale, whole(9) * scale)
        : new Vec2(any(9) * scale, any(9) * scale);
  }

  private Obstacle obstacle(double scale) {
    Vec2 a = place(scale);
    Vec2 b = place(scale);
    return switch (random.nextInt(3)) {
      case 0 -> new Circle(a.x(), a.y(), random.nextInt(3) * scale);
      case 1 -> new Bounds(-20 * scale, -21 * scale, 22 * scale, 23 * scale);
      default -> new Line(a.x(), a.y(), b.x(), b.y());
    };
  }

  /** A slow one besides, from where it is to the obstacle's neighbourhood. */
  private Vec2 aimed(Vec2 from, double scale) {
    Vec2 to = place(scale);
    double share = random.nextBoolean() ? 0.25 : 0.1;
    return new Vec2((to.x() - from.x()) * share, (to.y() - from.y()) * share);
  }

  /** Scales at which the squares of lengths leave the range of doubles, too. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 0x1p-400, 0x1p400})
  void ofTheDetectorAndOfAResolver(double scale) {
    int hits = 0;
    for (int i = 0; i < QUERIES; i++) {
      Obstacle obstacle = obstacle(scale);
      Vec2 at = place(scale);
      Circle circle = new Circle(at.x(), at.y(), random.nextInt(4) * 0.5 * scale);
      Vec2 v = aimed(at, scale);
      Optional<Impact> impact = new SweptCircle(circle, v).cast(obstacle, 20);
      Trajectory path =
          Resolver.of(List.of(obstacle))
              .trace(new SweptCircle(circle, v), 1, 20, Integer.MAX_VALUE);
      assertThat(path.impacts().isEmpty())
          .as("%s %s %s", circle, v, obstacle)
          .isEqualTo(impact.isEmpty());
      if (impact.isPresent()) {
        hits++;
        same(path.impacts().get(0), impact.get(), scale);
        Vec2 after = path.impacts().size() > 1 ? null : path.velocityAt(20);
        if (after != null) {
          near(after, v.reflect(impact.get().normal(), 1), scale);
        }
      }
    }
    assertThat(hits).isGreaterThan(QUERIES / 4);
  }

  /** In a world, too, of which each impact at time 0 is one of what overlaps. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void ofTheDetectorAndOfAWorldWhereThingsOverlap(boolean pair) {
    int hits = 0;
    for (int i = 0; i < QUERIES; i++) {
      Circle first = new Circle(any(9), any(9), 1 + any(0.5));
      Circle second = new Circle(any(9), any(9), 8 + any(7));
      Vec2 v = new Vec2(any(1), any(1));
      Vec2 u = pair ? new Vec2(any(1), any(1)) : Vec2.ZERO;
      SceneBuilder scene = Scene.builder().collide(pair);
      scene.circle(first.x(), first.y(), first.radius(), v.x(), v.y());
      if (pair) {
        scene.circle(second.x(), second.y(), second.radius(), u.x(), u.y());
      } else {
        scene.peg(second.x(), second.y(), second.radius());
      }
      World world = new World(scene.build());
      world.step(0);
      ImpactLog log = world.impacts();
      Optional<Impact> impact = new SweptCircle(first, v).cast(new SweptCircle(second, u), 0);
      assertThat(log.size()).isEqualTo(impact.isPresent() ? 1 : 0);
      if (impact.isPresent()) {
        hits++;
        near(new Vec2(log.x(0), log.y(0)), impact.get().point(), 1);
        near(new Vec2(log.nx(0), log.ny(0)), impact.get().normal(), 1);
        double toFirst = distance(log, first) / first.radius();
        assertThat(toFirst).isCloseTo(distance(log, second) / second.radius(), within(1e-13));
        assertThat(toFirst).isLessThan(1);
      }
    }
    assertThat(hits).isGreaterThan(QUERIES / 9);
  }

  private static double distance(ImpactLog log, Circle circle) {
    return Math.hypot(log.x(0) - circle.x(), log.y(0) - circle.y());
  }

  private static void same(Impact actual, Impact expected, double scale) {
    assertThat(actual.time()).isEqualTo(expected.time());
    assertThat(actual.kind()).isEqualTo(expected.kind());
    assertThat(actual.feature()).isEqualTo(expected.feature());
    near(actual.point(), expected.point(), scale);
    near(actual.normal(), expected.normal(), 1);
    assertThat(actual.approachSpeed() / scale)
        .isCloseTo(expected.approachSpeed() / scale, within(1e-13));
  }

  private static void near(Vec2 actual, Vec2 expected, double scale) {
    assertThat(actual.x() / scale).isCloseTo(expected.x() / scale, within(1e-13));
    assertThat(actual.y() / scale).isCloseTo(expected.y() / scale, within(1e-13));
  }
}
