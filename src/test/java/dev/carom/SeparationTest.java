// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.oracle.Distance;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.Query;
import dev.carom.oracle.SegmentQuery;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** More queries, and others: {@code -Dcarom.queries=10000000 -Dcarom.seed=2}. */
class SeparationTest {
  private static final long QUERIES = Long.getLong("carom.queries", 46_000) / 39;
  private static final long SEED = Long.getLong("carom.seed", 1);
  private static final double LARGEST = 0x1p1022;

  static Stream<Family> families() {
    return Families.all().stream().filter(family -> !family.name().startsWith("wall_"));
  }

  /** The circles and lines of all kinds of queries, each radius made larger at random. */
  @ParameterizedTest
  @MethodSource("families")
  void movesOutAndNoFurther(Family family) {
    Draw draw = new Draw(SEED * 0x9E3779B97F4A7C15L ^ family.name().hashCode());
    int moved = 0;
    for (int i = 0; i < QUERIES; i++) {
      Query query = family.next(draw);
      int exponent = i % 3 == 0 ? Integer.MIN_VALUE : -(i % 60);
      if (query instanceof PairQuery q) {
        Circle circle = new Circle(q.x1(), q.y1(), q.r1());
        moved += movesOut(circle, new Circle(q.x2(), q.y2(), q.r2()), exponent, q) ? 1 : 0;
      } else if (query instanceof SegmentQuery q) {
        Circle circle = new Circle(q.px(), q.py(), q.r());
        moved += movesOut(circle, new Line(q.ax(), q.ay(), q.bx(), q.by()), exponent, q) ? 1 : 0;
      }
    }
    assertThat(moved).isGreaterThan((int) (QUERIES / 100));
  }

  /** Enlarges the circle first, by a power of two of the size of it all. */
  private static boolean movesOut(Circle circle, Obstacle obstacle, int exponent, Query q) {
    double size = size(circle, obstacle);
    return size <= LARGEST
        && movesOut(
            new Circle(circle.x(), circle.y(), circle.radius() + Math.scalb(4 * size, exponent)),
            obstacle,
            q);
  }

  /** Returns false where there is nothing to move out of, or no room to do so. */
  private static boolean movesOut(Circle circle, Obstacle obstacle, Query q) {
    double size = size(circle, obstacle);
    if (size > LARGEST) {
      return false;
    }
    Distance distance = distance(circle, obstacle);
    Vec2 t =
        obstacle instanceof Line line
            ? SweptCircle.separation(circle, line)
            : SweptCircle.separation(circle, (Circle) obstacle);
    if (obstacle instanceof Circle other) {
      assertThat(
              SweptCircle.overlaps(
                  circle.x(), circle.y(), circle.radius(), other.x(), other.y(), other.radius()))
          .as(q.hex())
          .isEqualTo(distance.isLess());
    }
    if (!distance.isLess()) {
      assertThat(t).as(q.hex()).isEqualTo(Vec2.ZERO);
      return false;
    }
    Circle moved = new Circle(circle.x() + t.x(), circle.y() + t.y(), circle.radius());
    assertThat(distance(moved, obstacle).isLess()).as("still overlaps: %s", q.hex()).isFalse();
    assertThat(distance.excess(t.x(), t.y()))
        .as("ulps beyond the least: %s", q.hex())
        .isLessThan(8 * Math.ulp(size));
    return true;
  }

  private static Distance distance(Circle c, Obstacle obstacle) {
    return obstacle instanceof Line line
        ? Distance.ofLine(c.x(), c.y(), c.radius(), line.ax(), line.ay(), line.bx(), line.by())
        : of(c, (Circle) obstacle);
  }

  private static Distance of(Circle c, Circle other) {
    return Distance.ofPoint(c.x(), c.y(), other.x(), other.y(), c.radius(), other.radius());
  }

  private static double size(Circle c, Obstacle obstacle) {
    double size = Math.max(Math.abs(c.x()), Math.abs(c.y()));
    if (obstacle instanceof Line l) {
      for (double x : new double[] {l.ax(), l.ay(), l.bx(), l.by()}) {
        size = Math.max(size, Math.abs(x));
      }
      return size + c.radius();
    }
    Circle other = (Circle) obstacle;
    return Math.max(size, Math.max(Math.abs(other.x()), Math.abs(other.y())))
        + (c.radius() + other.radius());
  }

  @Test
  void concentricCirclesPartAlongX() {
    assertThat(SweptCircle.separation(new Circle(3, 4, 1), new Circle(3, 4, 2)))
        .isEqualTo(new Vec2(3, 0));
  }

  @Test
  void circlesPartAlongTheLineOfCentres() {
    assertThat(SweptCircle.separation(new Circle(0, 1, 2), new Circle(0, 0, 2)))
        .isEqualTo(new Vec2(0, 3));
    assertThat(SweptCircle.separation(new Circle(4, 0, 2), new Circle(0, 0, 2)))
        .isEqualTo(Vec2.ZERO);
  }

  @Test
  void aCentreOnALineGoesToItsLeft() {
    Line line = new Line(0, 0, 8, 0);
    assertThat(SweptCircle.separation(new Circle(3, 0, 2), line)).isEqualTo(new Vec2(0, 2));
    assertThat(SweptCircle.separation(new Circle(8, 0, 2), line)).isEqualTo(new Vec2(0, 2));
    assertThat(SweptCircle.separation(new Circle(3, -1, 2), line)).isEqualTo(new Vec2(0, -1));
    assertThat(SweptCircle.separation(new Circle(9, 0, 2), line)).isEqualTo(new Vec2(1, 0));
    assertThat(SweptCircle.separation(new Circle(5, 5, 2), new Line(5, 5, 5, 5)))
        .isEqualTo(new Vec2(2, 0));
  }

  @Test
  void touchingIsNotOverlapping() {
    assertThat(SweptCircle.overlaps(0, 0, 2, 3, 4, 3)).isFalse();
    assertThat(SweptCircle.overlaps(0, 0, 2, 3, 4, Math.nextUp(3.0))).isTrue();
    assertThat(SweptCircle.overlaps(0, 0, 0, 0, 0, 0)).isFalse();
  }

  @Test
  void movesOutOfWhatIsAsLargeAsAllowed() {
    Circle half = new Circle(0, 0, 0x1p1022);
    assertThat(SweptCircle.separation(half, half)).isEqualTo(new Vec2(0x1p1023, 0));
    Circle more = new Circle(0, 0, Math.nextUp(0x1p1022));
    refusesTheSumOf(more, more);
  }

  private static void refusesTheSumOf(Circle circle, Obstacle obstacle) {
    assertThatThrownBy(
            () -> {
              if (obstacle instanceof Line line) {
                SweptCircle.separation(circle, line);
              } else {
                SweptCircle.separation(circle, (Circle) obstacle);
              }
            })
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("coordinate and radius together");
  }

  @Test
  void refusesWhatIsOutOfRange() {
    assertThatThrownBy(() -> SweptCircle.overlaps(0, 0, -1, 3, 4, 3))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-1.0");
    assertThatThrownBy(() -> SweptCircle.overlaps(0, 0, 1, Double.NaN, 4, 3))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("NaN");
    refusesTheSumOf(new Circle(0, 0, Double.MAX_VALUE), new Circle(0, 0, 1));
    refusesTheSumOf(new Circle(0, Double.MAX_VALUE, 1), new Circle(0, Double.MAX_VALUE, 1));
    refusesTheSumOf(new Circle(Double.MAX_VALUE, 0, 1), new Circle(Double.MAX_VALUE, 0, 1));
    refusesTheSumOf(new Circle(0, 0, Double.MAX_VALUE), new Line(0, 1, 2, 3));
    refusesTheSumOf(new Circle(0, 0, 1), new Line(-Double.MAX_VALUE, 0, Double.MAX_VALUE, 0));
    Circle large = new Circle(0, 0, Double.MAX_VALUE);
    assertThatThrownBy(() -> SweptCircle.separation(large, large))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("2^1023");
  }
}
