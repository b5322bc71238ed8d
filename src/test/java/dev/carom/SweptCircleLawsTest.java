// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Laws of the detector. Decisions are those of real arithmetic and times the correctly rounded
 * ones, so where a motion of the plane maps doubles to doubles exactly, the answer does not change
 * by a bit. Queries stand on a grid of 2^-10, with coordinates below 2^7: a third of them hits,
 * many graze, touch or tie within some steps of the grid.
 */
@Tag("long")
class SweptCircleLawsTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final int QUERIES = 4_000;
  private static final double STEP = 0x1p-10;

  /** Two normals that are each within 1e-15 of the same one. */
  private static final double NORMAL = 2e-15;

  /** A circle against a line. */
  private record Query(Circle circle, Vec2 v, Line line, double T) {

    Optional<Impact> cast() {
      return new SweptCircle(circle, v).cast(line, T);
    }

    double time() {
      return new SweptCircle(circle.x(), circle.y(), circle.radius(), v.x(), v.y())
          .timeToLine(line.ax(), line.ay(), line.bx(), line.by(), T);
    }

    /** The query with all places mapped by one function, vectors by a linear one. */
    Query map(UnaryOperator<Vec2> place, UnaryOperator<Vec2> vector, double radiusFactor) {
      Vec2 a = place.apply(new Vec2(line.ax(), line.ay()));
      Vec2 b = place.apply(new Vec2(line.bx(), line.by()));
      return new Query(
          new Circle(place.apply(circle.center()), circle.radius() * radiusFactor),
          vector.apply(v),
          new Line(a, b),
          T);
    }
  }

  /** Draws numbers of few bits. */
  private static final class Source {
    private final Random random = new Random(20240607);

    double number(double range) {
      long steps = (long) (range / STEP);
      return (random.nextLong() % (steps + 1)) * STEP;
    }

    Vec2 vector(double range) {
      return new Vec2(number(range), number(range));
    }

    /** Near (0, 0) by preference, so that many queries are close to a tie. */
    Query query() {
      double range = random.nextInt(3) == 0 ? 4 * STEP : 64;
      Line line = new Line(vector(range), vector(64));
      double radius = random.nextInt(8) == 0 ? 0 : Math.abs(number(16));
      Vec2 centre = random.nextInt(4) == 0 ? vector(2 * STEP) : vector(64);
      Vec2 v = random.nextInt(4) == 0 ? vector(16) : aimed(centre, line, radius);
      double T = random.nextInt(4) == 0 ? Math.abs(number(40)) : NEVER;
      return new Query(new Circle(centre, radius), v, line, T);
    }

    /** A velocity that leads near one of the ends, or the middle, of a line. */
    private Vec2 aimed(Vec2 centre, Line line, double radius) {
      double share = random.nextInt(3) * 0.5;
      double x = line.ax() + share * (line.bx() - line.ax()) + number(radius);
      double y = line.ay() + share * (line.by() - line.ay()) + number(radius);
      return new Vec2((x - centre.x()) / 8, (y - centre.y()) / 8);
    }
  }

  /** Applies a law to many queries, and makes sure that hits of all features were among them. */
  private static void forAll(Consumer<Query> law) {
    Source source = new Source();
    int[] seen = new int[Feature.values().length];
    for (int i = 0; i < QUERIES; i++) {
      Query query = source.query();
      query.cast().ifPresent(impact -> seen[impact.feature().ordinal()]++);
      law.accept(query);
    }
    for (Feature feature : List.of(Feature.SIDE, Feature.START, Feature.END)) {
      assertThat(seen[feature.ordinal()]).as("hits of %s", feature).isGreaterThan(200);
    }
  }

  /** The image of a query has the same answer; its normal is the image of the normal. */
  private static void sameAnswer(
      Query query, Query image, Function<Feature, Feature> feature, UnaryOperator<Vec2> turn) {
    Optional<Impact> before = query.cast();
    Optional<Impact> after = image.cast();
    assertThat(image.time()).as("%s -> %s", query, image).isEqualTo(query.time());
    assertThat(after.isPresent()).isEqualTo(before.isPresent());
    if (before.isPresent()) {
      Impact x = before.get();
      Impact y = after.get();
      assertThat(y.time()).isEqualTo(x.time());
      assertThat(y.feature()).as("%s -> %s", query, image).isEqualTo(feature.apply(x.feature()));
      near(y.normal(), turn.apply(x.normal()));
    }
  }

  private static void near(Vec2 actual, Vec2 expected) {
    assertThat(actual.x()).isCloseTo(expected.x(), within(NORMAL));
    assertThat(actual.y()).isCloseTo(expected.y(), within(NORMAL));
  }

  private static void invariant(UnaryOperator<Vec2> place, UnaryOperator<Vec2> vector) {
    forAll(q -> sameAnswer(q, q.map(place, vector, 1), f -> f, vector));
  }

  private static void invariant(UnaryOperator<Vec2> linear) {
    invariant(linear, linear);
  }

  @Test
  void mirrored() {
    invariant(p -> new Vec2(-p.x(), p.y()));
    invariant(p -> new Vec2(p.x(), -p.y()));
    invariant(p -> new Vec2(p.y(), p.x()));
  }

  @Test
  void turnedByRightAngles() {
    invariant(p -> new Vec2(-p.y(), p.x()));
    invariant(p -> new Vec2(-p.x(), -p.y()));
    invariant(p -> new Vec2(p.y(), -p.x()));
  }

  /**
   * (x, y) -> (m x - n y, n x + m y) turns by the angle of a Pythagorean triangle and enlarges by
   * its hypotenuse, exactly on numbers of few bits. Radius and speed grow likewise: the time stays.
   */
  @ParameterizedTest
  @CsvSource({"3,4,5", "4,-3,5", "5,12,13", "-15,8,17", "20,-21,29", "119,120,169"})
  void turnedByPythagoreanAngles(int m, int n, int hypotenuse) {
    UnaryOperator<Vec2> turn = p -> new Vec2(m * p.x() - n * p.y(), n * p.x() + m * p.y());
    UnaryOperator<Vec2> unit =
        p -> {
          Vec2 turned = turn.apply(p);
          return new Vec2(turned.x() / hypotenuse, turned.y() / hypotenuse);
        };
    forAll(q -> sameAnswer(q, q.map(turn, turn, hypotenuse), f -> f, unit));
  }

  @ParameterizedTest
  @CsvSource({"1,1", "-1000,0.0009765625", "1048576,-3", "-1099511627776,1099511627776"})
  void movedElsewhere(double dx, double dy) {
    invariant(p -> new Vec2(p.x() + dx, p.y() + dy), p -> p);
  }

  /** Seen from a moving frame the obstacle moves, which only a pair can: a peg becomes a circle. */
  @Test
  void seenFromAMovingFrame() {
    Source source = new Source();
    for (int i = 0; i < QUERIES; i++) {
      Query q = source.query();
      Vec2 u = source.vector(16);
      Circle c = q.circle();
      double R = Math.abs(source.number(8));
      double still =
          new SweptCircle(c.x(), c.y(), c.radius(), q.v().x(), q.v().y())
              .timeToPeg(q.line().ax(), q.line().ay(), R, q.T());
      double moving =
          new SweptCircle(c.x(), c.y(), c.radius(), q.v().x() + u.x(), q.v().y() + u.y())
              .timeToCircle(new SweptCircle(q.line().ax(), q.line().ay(), R, u.x(), u.y()), q.T());
      assertThat(moving).isEqualTo(still);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {-500, -40, -1, 1, 40, 500})
  void enlargedByPowersOfTwo(int exponent) {
    double s = Math.scalb(1.0, exponent);
    UnaryOperator<Vec2> grow = p -> new Vec2(s * p.x(), s * p.y());
    forAll(q -> sameAnswer(q, q.map(grow, grow, s), f -> f, n -> n));
  }

  /** All speeds times 2^k: all times by 2^k shorter. */
  @ParameterizedTest
  @ValueSource(ints = {-300, -1, 1, 300})
  void speededUpByPowersOfTwo(int exponent) {
    double s = Math.scalb(1.0, exponent);
    forAll(
        q -> {
          Vec2 fast = new Vec2(s * q.v().x(), s * q.v().y());
          Query image = new Query(q.circle(), fast, q.line(), q.T() / s);
          assertThat(image.time()).as("%s", q).isEqualTo(q.time() / s);
          assertThat(image.cast().map(Impact::feature)).isEqualTo(q.cast().map(Impact::feature));
        });
  }

  @Test
  void withTheLinesEndsSwapped() {
    forAll(
        q -> {
          Line line = q.line();
          if (line.ax() != line.bx() || line.ay() != line.by()) {
            Line swapped = new Line(line.bx(), line.by(), line.ax(), line.ay());
            Query image = new Query(q.circle(), q.v(), swapped, q.T());
            sameAnswer(q, image, SweptCircleLawsTest::otherEnd, n -> n);
          }
        });
  }

  private static Feature otherEnd(Feature feature) {
    return switch (feature) {
      case START -> Feature.END;
      case END -> Feature.START;
      default -> feature;
    };
  }

  /** The two circles of a pair change places: same time, same point, opposite normal. */
  @Test
  void withTheTwoCirclesSwapped() {
    Source source = new Source();
    int hits = 0;
    for (int i = 0; i < QUERIES; i++) {
      Query one = source.query();
      Query two = source.query();
      Optional<Impact> before =
          new SweptCircle(one.circle(), one.v())
              .cast(new SweptCircle(two.circle(), two.v()), one.T());
      Optional<Impact> after =
          new SweptCircle(two.circle(), two.v())
              .cast(new SweptCircle(one.circle(), one.v()), one.T());
      assertThat(after.map(Impact::time)).isEqualTo(before.map(Impact::time));
      if (before.isPresent()) {
        hits++;
        Vec2 n = after.get().normal();
        near(before.get().normal(), new Vec2(-n.x(), -n.y()));
      }
    }
    assertThat(hits).isGreaterThan(200);
  }

  /** A circle against a segment is the first of: the circle against each of its two halves. */
  @Test
  void aLineCutInTwo() {
    int[] compared = new int[1];
    forAll(
        q -> {
          Line l = q.line();
          Vec2 middle = new Vec2((l.ax() + l.bx()) / 2, (l.ay() + l.by()) / 2);
          Query first =
              new Query(q.circle(), q.v(), new Line(l.ax(), l.ay(), middle.x(), middle.y()), q.T());
          Query second =
              new Query(q.circle(), q.v(), new Line(middle.x(), middle.y(), l.bx(), l.by()), q.T());
          if (apart(q.circle(), l)) {
            assertThat(Math.min(first.time(), second.time())).as("%s", q).isEqualTo(q.time());
            compared[0]++;
          }
        });
    assertThat(compared[0]).isGreaterThan(QUERIES / 2);
  }

  private static boolean apart(Circle c, Line line) {
    Vec2 closest = line.closestPoint(c.center());
    return Math.hypot(c.x() - closest.x(), c.y() - closest.y()) > c.radius() + 1e-9;
  }

  /** A radius put from the circle to the peg changes nothing. */
  @Test
  void aRadiusMovedToThePeg() {
    forAll(
        q -> {
          Circle c = q.circle();
          double whole =
              new SweptCircle(c.x(), c.y(), c.radius(), q.v().x(), q.v().y())
                  .timeToPeg(0, 0, 0, q.T());
          double none =
              new SweptCircle(c.x(), c.y(), 0, q.v().x(), q.v().y())
                  .timeToPeg(0, 0, c.radius(), q.T());
          assertThat(none).isEqualTo(whole);
        });
  }

  /** Started an exact while later on the same path, the circle hits that while sooner. */
  @Test
  void startedLaterOnTheSamePath() {
    forAll(
        q -> {
          double t = q.time();
          if (t > 0.5 && t < NEVER) {
            double later = 0.5;
            Circle c = q.circle();
            Circle ahead =
                new Circle(c.x() + later * q.v().x(), c.y() + later * q.v().y(), c.radius());
            double rest = new Query(ahead, q.v(), q.line(), q.T() - later).time();
            assertThat(rest).as("%s", q).isCloseTo(t - later, within(Math.ulp(t)));
          }
        });
  }

  /**
   * Time reversal of a flight, there and back on whole numbers. The circle falls on a slope along
   * (4, 3), hits it after 1 and flies on for 3; sent back from there it hits the same point after 3
   * and comes home.
   */
  @Test
  void reversedInTime() {
    Resolver resolver = Resolver.of(List.of(new Line(-16, -12, -8, -6)));
    Trajectory there =
        resolver.trace(
            new SweptCircle(new Circle(-15, 20, 5), new Vec2(0, -25)), 1, 4, Integer.MAX_VALUE);
    assertThat(there.impacts()).extracting(Impact::time).containsExactly(1.0);
    assertThat(there.end()).isEqualTo(new Vec2(-87, 16));
    assertThat(there.velocityAt(4)).isEqualTo(new Vec2(-24, 7));

    Trajectory back =
        resolver.trace(
            new SweptCircle(new Circle(-87, 16, 5), new Vec2(24, -7)), 1, 4, Integer.MAX_VALUE);
    assertThat(back.impacts()).extracting(Impact::time).containsExactly(3.0);
    assertThat(back.end()).isEqualTo(new Vec2(-15, 20));
    assertThat(back.velocityAt(4)).isEqualTo(new Vec2(0, 25));
    assertThat(back.impacts().get(0).point()).isEqualTo(there.impacts().get(0).point());
    assertThat(back.impacts().get(0).normal()).isEqualTo(there.impacts().get(0).normal());
  }
}
