// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.oracle.Distance;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Dyadic;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.Query;
import dev.carom.oracle.SegmentQuery;
import dev.carom.oracle.WallQuery;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** More queries, and others: {@code -Dcarom.queries=10000000 -Dcarom.seed=2}. */
class SeparationTest {
  private static final long QUERIES = Long.getLong("carom.queries", 46_000) / 39;
  private static final long SEED = Long.getLong("carom.seed", 1);
  private static final double LARGEST = 0x1p1022;

  static Stream<Family<Query>> families() {
    return Families.all().stream();
  }

  /** The circles, lines and bounds of all kinds of queries, each radius made larger at random. */
  @ParameterizedTest
  @MethodSource("families")
  void movesOutAndNoFurther(Family<Query> family) {
    Draw draw = Draw.of(SEED, family.name());
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
      } else if (query instanceof WallQuery q) {
        Circle circle = new Circle(q.px(), q.py(), q.r());
        Bounds bounds = new Bounds(q.xmin(), q.ymin(), q.xmax(), q.ymax());
        moved += movesOut(circle, bounds, exponent, q) ? 1 : 0;
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
    boolean overlaps = overlaps(circle, obstacle);
    assertThat(circle.overlaps(obstacle)).as(q.hex()).isEqualTo(overlaps);
    if (!overlaps) {
      assertThat(circle.separation(obstacle)).as(q.hex()).isEqualTo(Vec2.ZERO);
      return false;
    }
    if (obstacle instanceof Bounds bounds && room(circle, bounds) < 32 * Math.ulp(size)) {
      return false;
    }
    Vec2 t = circle.separation(obstacle);
    Circle moved = new Circle(circle.x() + t.x(), circle.y() + t.y(), circle.radius());
    assertThat(overlaps(moved, obstacle)).as("still overlaps: %s", q.hex()).isFalse();
    assertThat(excess(circle, obstacle, t))
        .as("ulps beyond the least: %s", q.hex())
        .isLessThan(8 * Math.ulp(size));
    return true;
  }

  // The truth.

  private static boolean overlaps(Circle c, Obstacle obstacle) {
    return obstacle instanceof Bounds b
        ? depths(c, b).stream().anyMatch(depth -> depth.signum() > 0)
        : distance(c, obstacle).isLess();
  }

  /** By how much a translation is longer than the least one; of bounds, on one axis. */
  private static double excess(Circle c, Obstacle obstacle, Vec2 t) {
    if (!(obstacle instanceof Bounds b)) {
      return distance(c, obstacle).excess(t.x(), t.y());
    }
    List<Dyadic> depths = depths(c, b);
    Dyadic ofX = Dyadic.of(t.x()).minus(inward(depths.get(0), depths.get(1)));
    Dyadic ofY = Dyadic.of(t.y()).minus(inward(depths.get(2), depths.get(3)));
    return Math.max(ofX.abs().near(), ofY.abs().near());
  }

  /** The least translation on one axis, of the depths at its two walls. */
  private static Dyadic inward(Dyadic low, Dyadic high) {
    return low.signum() > 0 ? low : high.signum() > 0 ? high.negate() : Dyadic.ZERO;
  }

  /** How deep a circle is in each of the walls; negative if it is apart. */
  private static List<Dyadic> depths(Circle c, Bounds b) {
    return List.of(
        depth(c.x(), b.xmin(), c.radius()),
        depth(b.xmax(), c.x(), c.radius()),
        depth(c.y(), b.ymin(), c.radius()),
        depth(b.ymax(), c.y(), c.radius()));
  }

  private static Dyadic depth(double above, double below, double r) {
    return Dyadic.of(r).minus(Dyadic.of(above).minus(Dyadic.of(below)));
  }

  /** How much wider and higher bounds are than a circle, about. */
  private static double room(Circle c, Bounds b) {
    return Math.min(b.xmax() - b.xmin(), b.ymax() - b.ymin()) - 2 * c.radius();
  }

  private static Distance distance(Circle c, Obstacle obstacle) {
    if (obstacle instanceof Line l) {
      return Distance.ofLine(c.x(), c.y(), c.radius(), l.ax(), l.ay(), l.bx(), l.by());
    }
    Circle other = (Circle) obstacle;
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
    if (obstacle instanceof Bounds b) {
      for (double x : PublicRecords.walls(b)) {
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
    assertThat(new Circle(3, 4, 1).separation(new Circle(3, 4, 2))).isEqualTo(new Vec2(3, 0));
  }

  @Test
  void circlesPartAlongTheLineOfCentres() {
    assertThat(new Circle(0, 1, 2).separation(new Circle(0, 0, 2))).isEqualTo(new Vec2(0, 3));
    assertThat(new Circle(4, 0, 2).separation(new Circle(0, 0, 2))).isEqualTo(Vec2.ZERO);
  }

  @Test
  void aCentreOnALineGoesToItsLeft() {
    Line line = new Line(0, 0, 8, 0);
    assertThat(new Circle(3, 0, 2).separation(line)).isEqualTo(new Vec2(0, 2));
    assertThat(new Circle(8, 0, 2).separation(line)).isEqualTo(new Vec2(0, 2));
    assertThat(new Circle(3, -1, 2).separation(line)).isEqualTo(new Vec2(0, -1));
    assertThat(new Circle(9, 0, 2).separation(line)).isEqualTo(new Vec2(1, 0));
    assertThat(new Circle(5, 5, 2).separation(new Line(5, 5, 5, 5))).isEqualTo(new Vec2(2, 0));
  }

  @Test
  void touchingIsNotOverlapping() {
    Circle circle = new Circle(0, 0, 2);
    assertThat(circle.overlaps(new Circle(3, 4, 3))).isFalse();
    assertThat(circle.overlaps(new Circle(3, 4, Math.nextUp(3.0)))).isTrue();
    assertThat(circle.overlaps(new Line(2, -9, 2, 9))).isFalse();
    assertThat(circle.overlaps(new Line(Math.nextDown(2.0), -9, 2, 9))).isTrue();
    assertThat(circle.overlaps(new Bounds(-2, -2, 2, 2))).isFalse();
    assertThat(circle.overlaps(new Bounds(-2, -2, 2, Math.nextDown(2.0)))).isTrue();
  }

  @Test
  void aPointOverlapsWhatHoldsIt() {
    Circle point = new Circle(1, 0, 0);
    assertThat(point.overlaps(point)).isFalse();
    assertThat(point.overlaps(new Circle(0, 0, 2))).isTrue();
    assertThat(point.overlaps(new Circle(0, 0, 1))).as("on the rim").isFalse();
    assertThat(point.overlaps(new Line(0, 0, 2, 0))).isFalse();
    assertThat(point.overlaps(new Bounds(1, -1, 2, 1))).as("on a wall").isFalse();
    assertThat(point.overlaps(new Bounds(2, -1, 3, 1))).as("beyond a wall").isTrue();
    assertThat(point.separation(new Bounds(2, -1, 3, 1))).isEqualTo(new Vec2(1, 0));
  }

  @Test
  void boundsPushInwardsFromEachWall() {
    Bounds box = new Bounds(0, 0, 10, 20);
    assertThat(new Circle(1, 19, 3).separation(box)).isEqualTo(new Vec2(2, -2));
    assertThat(new Circle(12, -5, 3).separation(box)).isEqualTo(new Vec2(-5, 8));
    assertThat(new Circle(5, 1, 5).separation(box)).as("as wide as they").isEqualTo(new Vec2(0, 4));
    for (double x : new double[] {4, 5, 6}) {
      assertThatThrownBy(() -> new Circle(x, 10, Math.nextUp(5.0)).separation(box))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("radius is 5.000000000000001: expected one that fits");
    }
  }

  @Test
  void movesOutOfWhatIsAsLargeAsAllowed() {
    Circle half = new Circle(0, 0, 0x1p1022);
    assertThat(half.separation(half)).isEqualTo(new Vec2(0x1p1023, 0));
    Circle more = new Circle(0, 0, Math.nextUp(0x1p1022));
    refusesTheSumOf(more, more);
  }

  private static void refusesTheSumOf(Circle circle, Obstacle obstacle) {
    assertThatThrownBy(() -> circle.separation(obstacle))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("coordinate and radius together")
        .hasMessageContaining("2^1023");
  }

  @Test
  void refusesWhatIsOutOfRange() {
    refusesTheSumOf(new Circle(0, 0, Double.MAX_VALUE), new Circle(0, 0, 1));
    refusesTheSumOf(new Circle(0, Double.MAX_VALUE, 1), new Circle(0, Double.MAX_VALUE, 1));
    refusesTheSumOf(new Circle(Double.MAX_VALUE, 0, 1), new Circle(Double.MAX_VALUE, 0, 1));
    refusesTheSumOf(new Circle(0, 0, Double.MAX_VALUE), new Line(0, 1, 2, 3));
    refusesTheSumOf(new Circle(0, 0, 1), new Line(-Double.MAX_VALUE, 0, Double.MAX_VALUE, 0));
    Circle large = new Circle(0, 0, Double.MAX_VALUE);
    refusesTheSumOf(large, large);
  }
}
