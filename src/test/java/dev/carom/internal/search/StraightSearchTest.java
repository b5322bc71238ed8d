// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Impact;
import dev.carom.ImpactLog;
import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Resolver;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SweptCircle;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.sweep.WallSweep;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The search finds the first impact and misses none, at the limits for which it was made. */
class StraightSearchTest {

  private static ImpactLog step(World world, double dt) {
    world.step(dt);
    return world.impacts();
  }

  // One-way lines, from left to right: open from below, and for whom they are not above.

  private static int impacts(double y, double vy) {
    World world =
        new World(Scene.builder().line(0, 0, 10, 0).oneWay().circle(-5, y, 1, 1, vy).build());
    return step(world, 9).size();
  }

  @Test
  void aOneWayLineIsThereForWhomItIsStrictlyRightOf() {
    assertThat(impacts(0x1p-40, -0.01)).isOne();
    assertThat(impacts(0, -0.01)).isZero();
  }

  @Test
  void aOneWayLineIsThereForWhomItIsApproachedByStrictly() {
    assertThat(impacts(0.5, -0x1p-40)).isOne();
    assertThat(impacts(0.5, 0)).isZero();
  }

  // Places.

  @ParameterizedTest
  @CsvSource({"1, 0", "-1, 0", "0, 1", "0, -1"})
  void theLargestDoubleIsAPlaceToComeFrom(double x, double y) {
    double most = Double.MAX_VALUE;
    Resolver resolver = Resolver.of(List.of(new Circle(0, 0, 0x1p980)));
    Circle circle = new Circle(x * most, y * most, 0x1p980);
    Vec2 velocity = new Vec2(-x * most / 4, -y * most / 4);
    assertThat(resolver.trace(new SweptCircle(circle, velocity), 1, 5, Integer.MAX_VALUE).impacts())
        .hasSize(1);
  }

  /** The distance to the wall is beyond the doubles, the way to it is not. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aWallIsHitFromTheOtherEndOfTheDoubles(boolean collide) {
    double far = 0.9 * Double.MAX_VALUE;
    SceneBuilder setup = Scene.builder().bounds(-far, -far, far, far);
    setup.circle(0.8 * far, 0, far / 8, -far, 0);
    Scene scene = setup.circle(far / 2, 0.8 * far, far / 8, 0, -far).collide(collide).build();
    ImpactLog log = step(new World(scene), 1.7);
    assertThat(log.size()).isEqualTo(2);
    assertThat(log.kind(0)).isEqualTo(Kind.WALL);
    assertThat(log.time(0)).isEqualTo(WallSweep.time(0.8 * far, far / 8, -far, -far));
  }

  /**
   * Lines that the path touches by next to nothing: from far away on both axes, among lines that
   * are as far on the other side, and by a circle as large as all that.
   */
  @ParameterizedTest
  @CsvSource({"1, 1, 0, 0, 0x1p-26", "0.5, 0.5, -1, -0.9, 0x1p-26", "0.01, 0.3, 0.3, -0.7, 1"})
  void aLineThatIsHardlyTouchedIsNotPassedOver(
      double x, double y, double towardsX, double towardsY, double radius) {
    Random random = new Random(8);
    int hits = 0;
    for (int i = 0; i < 3_000; i++) {
      double unit = 0x1p26 * (1 + random.nextDouble());
      double r = unit * radius * (radius < 1 ? 1 + random.nextDouble() : 1);
      double px = unit * x;
      double py = unit * y;
      boolean level = radius == 1;
      double vx = level ? unit : unit * (towardsX - x);
      double vy = level ? 0 : unit * (towardsY - y) + random.nextDouble();
      double speed = Math.hypot(vx, vy);
      double reach = r * (1 - Math.scalb(random.nextDouble(), -25 - random.nextInt(28))) / speed;
      double way = level ? 0.3 : 1;
      double ax = px + way * vx + vy * reach;
      double ay = py + way * vy - vx * reach;
      double bx = ax + vy / speed;
      double by = ay - vx / speed;
      boolean hit = new SweptCircle(px, py, r, vx, vy).timeToLine(ax, ay, bx, by, 9) <= 9;
      hits += hit ? 1 : 0;
      World world =
          new World(Scene.builder().line(ax, ay, bx, by).circle(px, py, r, vx, vy).build());
      assertThat(step(world, 9).size() > 0).isEqualTo(hit);
    }
    assertThat(hits).isPositive();
  }

  /** Products of such places and speeds underflow: none may tell that a line is passed. */
  @ParameterizedTest
  @ValueSource(ints = {-480, -505, -520, -530})
  void nothingIsPassedOverWhereNumbersUnderflow(int exponent) {
    double unit = Math.scalb(1.0, exponent);
    Random random = new Random(4);
    int hits = 0;
    for (int i = 0; i < 500; i++) {
      double r = 0.5 + random.nextDouble();
      Line line = line(random, unit);
      Circle circle = new Circle(-5 * unit, random.nextDouble() * unit, r * unit);
      Vec2 v = new Vec2(unit * (0.5 + random.nextDouble()), unit * (random.nextDouble() - 0.5));
      double t =
          new SweptCircle(circle.x(), circle.y(), circle.radius(), v.x(), v.y())
              .timeToLine(line.ax(), line.ay(), line.bx(), line.by(), 20);
      boolean hit = t <= 20;
      hits += hit ? 1 : 0;
      SceneBuilder scene = Scene.builder().line(line.ax(), line.ay(), line.bx(), line.by());
      scene.circle(circle.x(), circle.y(), circle.radius(), v.x(), v.y());
      World world = new World(scene.build());
      assertThat(step(world, 20).size() > 0).as("%s, %s, %s", circle, v, line).isEqualTo(hit);
    }
    assertThat(hits).isBetween(50, 450);
  }

  private static Line line(Random random, double unit) {
    double x = random.nextDouble() * 4 - 2;
    double y = random.nextDouble() * 6 - 3;
    return new Line(
        x * unit, y * unit, (x + random.nextDouble()) * unit, (y + random.nextDouble()) * unit);
  }

  /** The square of the radius underflows beside that of the length, or the other way round. */
  @Test
  void tinyAndHugeThingsMeetAtAnEnd() {
    Resolver huge = Resolver.of(List.of(new Line(0, 0, 0x1p500, 0)));
    Circle tiny = new Circle(-0x1p-539, 0x1p-690, 0x1p-540);
    assertThat(
            huge.trace(new SweptCircle(tiny, new Vec2(1, 0x1p-10)), 1, 1, Integer.MAX_VALUE)
                .impacts())
        .hasSize(1);
    SceneBuilder setup = Scene.builder().line(0, 0, 0x1p-540, 0);
    Scene scene = setup.circle(-0x1p501, 0x1p400, 0x1p500, 0x1p152, 0x1p142).build();
    assertThat(step(new World(scene), 0x1p400).size()).isOne();
  }

  // Order.

  /** Along a line that lies in the wall the two are hit at one time: the wall comes first. */
  @Test
  void aWallComesBeforeALineThatIsHitAtTheSameTime() {
    Random random = new Random(6);
    for (int i = 0; i < 500; i++) {
      double wall = random.nextDouble() - 0.5;
      double r = Math.scalb(1 + random.nextDouble(), random.nextInt(20));
      double x = wall + r + Math.scalb(random.nextDouble(), -random.nextInt(20));
      double y = random.nextDouble();
      SceneBuilder scene = Scene.builder().bounds(wall, -1e9, 1e9, 1e9).line(wall, -5, wall, 5);
      World world = new World(scene.circle(x, y, r, -0.5 - random.nextDouble(), 0).build());
      ImpactLog log = step(world, 5);
      assertThat(log.size()).isPositive();
      assertThat(log.kind(0)).isEqualTo(Kind.WALL);
    }
  }

  /**
   * In a corner, where all numbers but the bounds are small: how far the walls are is computed from
   * the middle, with errors above the distance from the wall to the line behind it.
   */
  @Test
  void aWallComesBeforeALineBehindItByLessThanRounding() {
    Random random = new Random(11);
    for (int i = 0; i < 2_000; i++) {
      double x = 1e-3 * (1 + random.nextDouble());
      double y = 1e-3 * random.nextDouble();
      double behind = -Math.scalb(1 + random.nextDouble(), -52 + random.nextInt(4));
      double r = 1e-3 * random.nextDouble();
      double v = -0.5 - random.nextDouble();
      SceneBuilder scene = Scene.builder();
      if (i % 2 == 0) {
        scene.bounds(0, -1, 100, 0.5).line(behind, -1, behind, 1).circle(x, y, r, v, 0);
      } else {
        scene.bounds(-1, 0, 0.5, 100).line(-1, behind, 1, behind).circle(y, x, r, 0, v);
      }
      World world = new World(scene.build());
      ImpactLog log = step(world, 1);
      assertThat(log.kind(0)).isEqualTo(Kind.WALL);
    }
  }

  /** Into corners, or within some ulps of them: of equal times the vertical wall comes first. */
  @ParameterizedTest
  @CsvSource({
    "1, 1, 100",
    "0x1p500, 0x1p490, 1",
    "1, 0x1p-30, 0",
    "0x1p-20, 1, 0",
    "0x1p-60, 1, 0"
  })
  void theFirstOfTwoWallsIsFound(double vx, double vy, int leastTies) {
    Random random = new Random(9);
    int ties = 0;
    for (int i = 0; i < 2_000; i++) {
      double x = Math.scalb(1 + random.nextDouble(), -random.nextInt(30)) * vx;
      double y = (x / vx) * vy * (1 + (random.nextInt(5) - 2) * 0x1p-52);
      double sx = random.nextBoolean() ? 1 : -1;
      double sy = random.nextBoolean() ? 1 : -1;
      double r = Math.max(vx, vy) * (0.5 + random.nextDouble());
      double high = 8 * Math.max(vx, vy);
      double px = sx < 0 ? r + x : high - r - x;
      double py = sy < 0 ? r + y : high - r - y;
      Scene scene =
          Scene.builder().bounds(0, 0, high, high).circle(px, py, r, sx * vx, sy * vy).build();
      double tx = WallSweep.time(px, r, sx * vx, sx < 0 ? 0 : high);
      double ty = WallSweep.time(py, r, sy * vy, sy < 0 ? 0 : high);
      ImpactLog log = step(new World(scene), 3);
      ties += tx == ty ? 1 : 0;
      assertThat(log.time(0)).isEqualTo(Math.min(tx, ty));
      int wall = tx <= ty ? (sx < 0 ? 0 : 1) : (sy < 0 ? 2 : 3);
      assertThat(log.id(0)).isEqualTo(wall);
    }
    assertThat(ties).isGreaterThanOrEqualTo(leastTies);
  }

  /** The wall is an ulp away, and the floor of many lines is touched. */
  @Test
  void whatIsTouchedComesBeforeAWallThatIsNearlySo() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 100, 100);
    for (int i = 0; i < 20; i++) {
      scene.line(5 * i, 4, 5 * i + 5, 4);
    }
    World world = new World(scene.circle(1 + 0x1p-52, 5, 1, -1, -1).build());
    ImpactLog log = step(world, 0.5);
    assertThat(log.kind(0)).isEqualTo(Kind.LINE);
    assertThat(log.time(0)).isZero();
    assertThat(log.kind(1)).isEqualTo(Kind.WALL);
    assertThat(log.time(1)).isEqualTo(0x1p-52);
  }

  /**
   * The circle is within rounding of the left wall and drifts to it so slowly that it comes there
   * long after it has met a line below: the wall ahead does not end the search.
   */
  @ParameterizedTest
  @CsvSource({"0, 0", "0, 30", "-30, 0", "30, -30"})
  void aSlowDriftToAWallThatIsNearlyTouchedHidesNoLine(int length, int speed) {
    double unit = Math.scalb(1.0, length);
    double fast = Math.scalb(1.0, length + speed);
    double never = Double.POSITIVE_INFINITY;
    SceneBuilder scene = Scene.builder().bounds(0, 0, 100 * unit, 100 * unit);
    for (int i = 0; i < 20; i++) {
      scene.line(i * unit, 20 * unit, (i + 1) * unit, 20 * unit);
    }
    World world = new World(scene.circle(50 * unit, 50 * unit, 2 * unit, 0, 0).build());
    assertThat(world.toString()).contains("grid");
    Circle circle = new Circle(Math.nextUp(2 * unit), 97 * unit, 2 * unit);
    for (double drift : new double[] {0, -0x1p-60, -0x1p-58}) {
      Impact impact =
          world.cast(new SweptCircle(circle, new Vec2(drift * fast, -fast)), never).orElseThrow();
      assertThat(impact.kind()).as("%s", drift).isEqualTo(Kind.LINE);
    }
    Impact wall =
        world.cast(new SweptCircle(circle, new Vec2(-0x1p-54 * fast, -fast)), never).orElseThrow();
    assertThat(wall.kind()).isEqualTo(Kind.WALL);
    assertThat(wall.time()).isEqualTo(8 * unit / fast);
    Circle free = new Circle(Math.nextDown(98 * unit), 50 * unit, 2 * unit);
    Impact bottom =
        world.cast(new SweptCircle(free, new Vec2(0x1p-60 * fast, -fast)), never).orElseThrow();
    assertThat(bottom.time()).isEqualTo(48 * unit / fast);
  }

  /** The first of two lines that stand in one place, an ulp before a wall, is taken away. */
  @Test
  void aLineBehindOneThatIsGoneComesBeforeAWallThatIsNearlyThere() {
    double x = Math.nextDown(100.0);
    SceneBuilder builder = Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 1, 1, 0);
    builder.line(x, 40, x, 60).line(x, 40, x, 60);
    World world = Internals.world(builder.build(), EngineOptions.cells(10));
    world.step(1);
    world.remove(Kind.LINE, 0);
    ImpactLog log = step(world, 50);
    assertThat(log.kind(0)).isEqualTo(Kind.LINE);
    assertThat(log.id(0)).isOne();
  }

  /**
   * Lines that are met within some ulps of time, of which the first two are met with an end at the
   * edge of the way: those are told exactly, the others first by a look.
   */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 5})
  void theFirstOfLinesThatAreMetAtNearlyOneTimeIsFound(int tilted) {
    Random random = new Random(tilted);
    for (int i = 0; i < 2_000; i++) {
      double x = 2 + 10 * random.nextDouble();
      List<Line> lines = new ArrayList<>();
      lines.add(new Line(x, 0, x, 3));
      for (int k = 0; k < tilted; k++) {
        double angle = 1.2 * (random.nextDouble() - 0.5);
        double c = Math.cos(angle);
        double s = Math.sin(angle);
        double qx = x - 1 + c + (random.nextInt(9) - 4) * Math.ulp(x);
        double length = 1 + random.nextDouble();
        lines.add(new Line(qx - length * s, s + length * c, qx + length * s, s - length * c));
      }
      double first = Double.POSITIVE_INFINITY;
      int id = -1;
      SceneBuilder scene = Scene.builder().circle(0, 0, 1, 1, 0);
      for (Line l : lines) {
        scene.line(l.ax(), l.ay(), l.bx(), l.by());
        double t = new SweptCircle(0, 0, 1, 1, 0).timeToLine(l.ax(), l.ay(), l.bx(), l.by(), 99);
        if (t < first) {
          first = t;
          id = lines.indexOf(l);
        }
      }
      ImpactLog log = step(new World(scene.build()), x);
      assertThat(log.id(0)).as("%s", lines).isEqualTo(id);
      assertThat(log.time(0)).isEqualTo(first);
    }
  }

  // Where a search ends, for it looks no further than it may.

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.125, 0.5})
  void whatStandsWhereASearchEndsIsHit(double from) {
    double r = 0x1p-6;
    for (double t = 0.25; t < 100; t += 0.25) {
      double x = from + r + t;
      Scene scene =
          Scene.builder().line(-1, -9, 150, -9).line(x, -1, x, 1).circle(from, 0, r, 1, 0).build();
      World first = Internals.world(scene, EngineOptions.cells(1));
      World edited = Internals.world(scene, EngineOptions.cells(1));
      edited.setVelocity(0, 1, 0);
      for (World world : List.of(first, edited)) {
        ImpactLog log = step(world, 200);
        assertThat(log.size()).as("at %s", t).isOne();
        assertThat(log.time(0)).isEqualTo(t);
      }
    }
  }

  /** The cross products are beyond the doubles, infinity less infinity: no line is passed then. */
  @Test
  void aLineIsMetWhereCrossProductsOverflow() {
    double far = 1e200;
    SceneBuilder setup = Scene.builder().circle(-far, -far, far / 8, 1e150, 1e150);
    Scene scene = setup.line(far / 4, -far / 4, -far / 4, far / 4).build();
    World world = new World(scene);
    world.advanceTo(1e50);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.impacts().kind(0)).isEqualTo(Kind.LINE);
    assertThat(world.impacts().time(0))
        .isEqualTo(
            new SweptCircle(-far, -far, far / 8, 1e150, 1e150)
                .timeToLine(far / 4, -far / 4, -far / 4, far / 4, 1e51));
  }

  /** Among others, so that a grid lists them; the square of their length underflows. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-161, 1e-163, 1e-200, 0x1p-1074, 0})
  void aLineOfNextToNoLengthIsMet(double length) {
    Random random = new Random(12);
    for (int i = 0; i < 500; i++) {
      double angle = 7 * random.nextDouble();
      SceneBuilder scene =
          Scene.builder().line(0, 0, length * Math.cos(angle), length * Math.sin(angle));
      for (int k = 0; k < 8; k++) {
        double x = random.nextInt(100) - 50;
        scene.line(x, -60, x + 1, -60);
      }
      double y = 9 * random.nextDouble();
      World world = new World(scene.circle(-30, y, 10, 1, 0).build());
      ImpactLog log = step(world, 100);
      assertThat(log.size()).isPositive();
      assertThat(log.time(0))
          .isEqualTo(
              new SweptCircle(-30, y, 10, 1, 0)
                  .timeToLine(0, 0, world.line(0).bx(), world.line(0).by(), 100));
    }
  }

  /** In units in which areas, or the inverse of a length, are no numbers any more. */
  @ParameterizedTest
  @ValueSource(ints = {0, -390, -540, -550, -1000, -1030})
  void aSceneIsTheSameInAnyUnit(int exponent) {
    double unit = Math.scalb(1.0, exponent);
    double speed = Math.scalb(1.0, exponent / 2);
    Random random = new Random(13);
    for (int i = 0; i < 300; i++) {
      SceneBuilder scene = Scene.builder();
      double first = Double.POSITIVE_INFINITY;
      double x = random.nextInt(101) * unit;
      double y = -Math.scalb(unit, 5 + random.nextInt(34));
      double v = speed * (1 + random.nextDouble());
      for (int k = 0; k < 12; k++) {
        int ax = random.nextInt(101);
        int ay = random.nextInt(101);
        int bx = ax + random.nextInt(7) - 3;
        int by = ay + random.nextInt(7) - 3;
        scene.line(ax * unit, ay * unit, bx * unit, by * unit);
        double time =
            new SweptCircle(x, y, unit, 0, v)
                .timeToLine(ax * unit, ay * unit, bx * unit, by * unit, 1e300);
        first = Math.min(first, time);
      }
      World world = new World(scene.circle(x, y, unit, 0, v).build());
      assertThat(world.toString())
          .contains(Math.abs(exponent) < 400 ? "1 grid" : "12 lines and pegs without a grid");
      world.advanceTo((200 * unit - y) / v);
      double told =
          world.impacts().size() == 0 ? Double.POSITIVE_INFINITY : world.impacts().time(0);
      assertThat(told).isEqualTo(first);
    }
  }
}
