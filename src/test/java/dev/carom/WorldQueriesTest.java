// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.carom.internal.state.Codes;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Queries of a world, or of a resolver, that move nothing. */
class WorldQueriesTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private static SceneBuilder room() {
    return Scene.builder().collide(false).bounds(0, 0, 100, 100);
  }

  // First impacts.

  /** One of two lines is later than the end of the window, by less than rounding shows. */
  @Test
  void ofTwoAtTheEndOfTheWindowTheOneWithinIsFound() {
    Circle circle = new Circle(0, 0, 1);
    Vec2 v = new Vec2(24, 0);
    Line later = new Line(29.8, -5, 29.8, 5);
    Line within = new Line(Math.nextDown(29.8), -5, Math.nextDown(29.8), 5);
    assertThat(new SweptCircle(circle, v).cast(later, 1.2)).isEmpty();
    Impact impact = new SweptCircle(circle, v).cast(within, 1.2).orElseThrow();
    assertThat(impact.time()).isEqualTo(1.2);
    for (List<Obstacle> both :
        List.of(List.<Obstacle>of(later, within), List.<Obstacle>of(within, later))) {
      assertThat(Resolver.of(both).cast(new SweptCircle(circle, v), 1.2))
          .map(hit -> SweptCircleAnswers.thing(both, hit))
          .contains(within);
    }
    World world =
        new World(
            Scene.builder().line(29.8, -5, 29.8, 5).line(within.ax(), -5, within.bx(), 5).build());
    assertThat(world.cast(new SweptCircle(circle, v), 1.2).orElseThrow().id()).isEqualTo(1);
    assertThat(world.cast(new SweptCircle(circle, v), Math.nextUp(1.2)).orElseThrow().id())
        .isEqualTo(1);
    assertThat(world.cast(new SweptCircle(circle, v), Math.nextDown(1.2))).isEmpty();
  }

  /**
   * Rays that hit a falling circle and one at rest at times that round to 4. They pass both centres
   * by so little that the times exceed 4 by the square of that, halved.
   */
  @Test
  void whichOfAFallingCircleAndAnotherIsHitFirstIsDecidedExactly() {
    assertThat(firstBesideFalling(0, 1e-9, true)).isEqualTo(1);
    assertThat(firstBesideFalling(0, 1e-9, false)).isEqualTo(0);
    assertThat(firstBesideFalling(2e-9, 1e-9, true)).isEqualTo(0);
    assertThat(firstBesideFalling(2e-9, 1e-9, false)).isEqualTo(1);
    assertThat(firstBesideFalling(0, 0, true)).as("at once: the first id").isEqualTo(0);
    assertThat(firstBesideFalling(0, 0, false)).as("at once: the first id").isEqualTo(0);
  }

  private static int firstBesideFalling(double resting, double falling, boolean isFallingFirst) {
    World world = new World(Scene.builder().gravity(0, -1).build());
    double fallen = 0.5 * 4 * 4;
    for (int i = 0; i < 2; i++) {
      boolean falls = (i == 0) == isFallingFirst;
      int id = world.addCircle(5, falls ? falling + fallen : resting, 1, 0, 0, Traits.DEFAULT);
      world.setTraits(Kind.CIRCLE, id, world.traits(Kind.CIRCLE, id).withMass(falls ? 1 : NEVER));
    }
    Impact impact =
        world.cast(new SweptCircle(new Circle(0, 0, 0), new Vec2(1, 0)), NEVER).orElseThrow();
    assertThat(impact.time()).isEqualTo(4);
    return impact.id();
  }

  /** Into a corner: the wall that is named is the one whose point and normal are told. */
  @Test
  void theWallThatIsNamedIsTheOneThatIsHit() {
    World world = new World(room().build());
    Random random = new Random(1);
    int others = 0;
    for (int i = 0; i < 20_000; i++) {
      double vx = 1 + random.nextDouble();
      double vy = vx * (0.5 + random.nextDouble());
      double t = 1 + random.nextDouble();
      Circle circle = new Circle(99 - vx * t, 99 - vy * t, 1);
      BigDecimal tx = timeOf99(circle.x(), vx);
      BigDecimal ty = timeOf99(circle.y(), vy);
      double end = Math.min(tx.doubleValue(), ty.doubleValue());
      BigDecimal least = tx.min(ty);
      Optional<Impact> impact = world.cast(new SweptCircle(circle, new Vec2(vx, vy)), end);
      assertThat(impact.isPresent()).isEqualTo(least.compareTo(new BigDecimal(end)) <= 0);
      if (impact.isPresent()) {
        Vec2 normal = tx.compareTo(ty) <= 0 ? new Vec2(-1, 0) : new Vec2(0, -1);
        assertThat(impact.get().normal()).isEqualTo(normal);
        assertThat(impact.get().id()).isEqualTo(normal.x() != 0 ? 1 : 3);
        others += tx.doubleValue() == ty.doubleValue() && normal.x() == 0 ? 1 : 0;
      }
    }
    assertThat(others).isPositive();
  }

  /** When a coordinate is 99, to 100 digits. */
  private static BigDecimal timeOf99(double x, double v) {
    BigDecimal way = new BigDecimal(99).subtract(new BigDecimal(x));
    return way.divide(new BigDecimal(v), new MathContext(100));
  }

  @Test
  void theFirstImpactIsTheEarliestOfTheDetectorsAnswers() {
    Random random = new Random(1);
    Scene scene = RandomScenes.crowd(random, 40).build();
    World world = new World(scene);
    world.step(7);
    int circles = 0;
    for (int i = 0; i < 2000; i++) {
      Circle circle =
          new Circle(800 * random.nextDouble(), 600 * random.nextDouble(), i % 7 * i % 40);
      Vec2 v = new Vec2(random.nextGaussian(), random.nextGaussian());
      double T = i % 2 == 0 ? NEVER : 200 * random.nextDouble();
      Optional<Impact> first = world.cast(new SweptCircle(circle, v), T);
      assertThat(first).isEqualTo(earliest(world, scene, circle, v, T));
      circles += first.filter(hit -> hit.kind() == Kind.CIRCLE).isPresent() ? 1 : 0;
    }
    assertThat(circles).isGreaterThan(200);
    assertThat(world.now()).isEqualTo(7);
  }

  /** Asks each thing, in the order in which simultaneous impacts are taken. */
  private static Optional<Impact> earliest(
      World world, Scene scene, Circle circle, Vec2 v, double T) {
    List<Impact> all = new ArrayList<>();
    scene.bounds().flatMap(b -> new SweptCircle(circle, v).cast(b, T)).ifPresent(all::add);
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      add(all, new SweptCircle(circle, v).cast(scene.shape(Kind.LINE, i), T), Kind.LINE, i);
    }
    for (int i = 0; i < scene.count(Kind.PEG); i++) {
      add(all, new SweptCircle(circle, v).cast(scene.shape(Kind.PEG, i), T), Kind.PEG, i);
    }
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      Circle other = new Circle(world.x(i), world.y(i), world.radius(i));
      Vec2 u = new Vec2(world.vx(i), world.vy(i));
      add(all, new SweptCircle(circle, v).cast(new SweptCircle(other, u), T), Kind.CIRCLE, i);
    }
    Impact first = null;
    for (Impact impact : all) {
      first = first == null || impact.time() < first.time() ? impact : first;
    }
    return Optional.ofNullable(first);
  }

  private static void add(List<Impact> all, Optional<Impact> impact, Kind kind, int id) {
    impact.map(hit -> named(hit, kind, id)).ifPresent(all::add);
  }

  /** The same impact with a thing under its id. */
  static Impact named(Impact hit, Kind kind, int id) {
    return SweptCircleAnswers.impact(
        hit.time(), kind, id, hit.feature(), hit.point(), hit.normal(), hit.approachSpeed());
  }

  @Test
  void circlesAreAskedOnlyWhereTheyCollide() {
    SceneBuilder scene = room().circle(50, 50, 5, 0, 0);
    Circle asked = new Circle(20, 50, 5);
    Vec2 v = new Vec2(1, 0);
    assertThat(new World(scene.build()).cast(new SweptCircle(asked, v), 50)).isEmpty();
    Impact hit =
        new World(scene.collide(true).build()).cast(new SweptCircle(asked, v), 50).orElseThrow();
    assertThat(hit.kind()).isEqualTo(Kind.CIRCLE);
    assertThat(hit.time()).isEqualTo(20);
  }

  @Test
  void aCircleOfTheWorldCanBeAskedFor() {
    World world = new World(room().collide(true).circle(20, 50, 5, 1, 0).build());
    assertThat(
            world
                .cast(new SweptCircle(new Circle(20, 50, 5), new Vec2(1, 0)), NEVER)
                .orElseThrow()
                .kind())
        .isEqualTo(Kind.WALL);
  }

  // Paths.

  @Test
  void theAimingLineIsTheWayThatTheCircleThenGoes() {
    for (int seed = 0; seed < 10; seed++) {
      Scene scene = RandomScenes.mixed(new Random(seed)).build();
      World world = new World(scene);
      for (int id = 0; id < 20; id++) {
        Circle circle = (Circle) scene.shape(Kind.CIRCLE, id);
        SweptCircle asked = new SweptCircle(circle, scene.velocity(Kind.CIRCLE, id));
        Trajectory path = world.trace(asked, 1, 60, 1000);
        assertThat(path.complete()).isTrue();
        assertThat(path.duration()).isEqualTo(60);
        World run = new World(scene);
        run.step(60);
        // A flight keeps the double nearest to its start, where the world keeps twice the digits.
        assertThat(path.end().x()).isCloseTo(run.x(id), within(1e-12));
        assertThat(path.end().y()).isCloseTo(run.y(id), within(1e-12));
      }
    }
  }

  @Test
  void kindAndFeatureOfAMissAreRefused() {
    Casts casts = new Casts();
    casts.add(0, 0, 1, 1, 0);
    for (boolean isAsked : new boolean[] {false, true}) {
      if (isAsked) {
        new World(Scene.builder().build()).cast(casts, 9);
      }
      assertThat(casts.time(0)).isEqualTo(NEVER);
      assertThatThrownBy(() -> casts.kind(0))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("cast 0 is a miss: expected one that hits something");
      assertThatThrownBy(() -> casts.feature(0))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("cast 0 is a miss: expected one that hits something");
    }
  }

  @Test
  void aPathEndsAtItsImpactOfAGivenNumber() {
    World world = new World(room().build());
    SweptCircle circle = new SweptCircle(50, 50, 5, 3, 0);
    Trajectory path = world.trace(circle, 1, 1000, 3);
    assertThat(path.impacts()).extracting(Impact::time).containsExactly(15.0, 45.0, 75.0);
    assertThat(path.impacts()).extracting(Impact::id).containsExactly(1, 0, 1);
    assertThat(path.duration()).isEqualTo(75);
    assertThat(path.complete()).isTrue();
    assertThat(path.end()).isEqualTo(new Vec2(95, 50));
    Trajectory none = world.trace(circle, 1, 1000, 0);
    assertThat(none.impacts()).isEmpty();
    assertThat(none.duration()).isZero();
    Trajectory one = world.trace(circle, 1, 1000, 1);
    Impact hit = one.impacts().get(0);
    assertThat(world.cast(circle, 1000)).hasValue(named(hit, Kind.WALL, hit.id()));
    assertThat(hit.impulse()).as("of mass 1").isEqualTo(6);
    assertThat(one.duration()).isEqualTo(15);
    assertThat(one.velocityAt(15)).isEqualTo(new Vec2(-3, 0));
    assertThat(world.trace(circle, 1, 15, 9)).isEqualTo(one);
    assertThat(world.trace(circle, 1, 10, 5).duration()).isEqualTo(10);
  }

  /** Circle 1 flies at circle 0, which rests: their row is one of circle 0. */
  @Test
  void aRowOfTwoCirclesNamesTheSmallerIdFirst() {
    World world =
        new World(Scene.builder().circle(50, 50, 5, 0, 0).circle(80, 50, 5, -1, 0).build());
    world.step(21);
    ImpactLog log = world.impacts();
    assertThat(log.size()).isOne();
    assertThat(log.circle(0)).isZero();
    assertThat(log.kind(0)).isEqualTo(Kind.CIRCLE);
    assertThat(log.id(0)).isOne();
  }

  // Nearest.

  private static int nearest(World world, double x, double y, Kind kind) {
    return world.nearest(x, y, kind).map(Nearest::id).orElse(-1);
  }

  @Test
  void theNearestThingOfEachKind() {
    SceneBuilder scene = room().line(10, 10, 20, 10).line(10, 30, 20, 30).peg(50, 50, 10);
    scene.peg(80, 50, 2).circle(30, 80, 5, 1, 0).circle(60, 80, 5, 0, 0);
    World world = new World(scene.build());
    world.step(10);
    assertThat(nearest(world, 15, 19, Kind.LINE)).isZero();
    assertThat(nearest(world, 15, 20, Kind.LINE)).as("equally near").isZero();
    assertThat(nearest(world, 15, 21, Kind.LINE)).isEqualTo(1);
    assertThat(nearest(world, 68, 50, Kind.PEG)).isZero();
    assertThat(nearest(world, 70, 50, Kind.PEG)).isEqualTo(1);
    assertThat(nearest(world, 49, 80, Kind.CIRCLE)).isZero();
    assertThat(nearest(world, 51, 80, Kind.CIRCLE)).isEqualTo(1);
    assertThat(nearest(world, 50, 90, Kind.WALL)).isEqualTo(Codes.TOP);
    assertThat(nearest(world, 3, 90, Kind.WALL)).isEqualTo(Codes.LEFT);
    World empty = new World(Scene.builder().build());
    for (Kind kind : Kind.values()) {
      assertThat(nearest(empty, 0, 0, kind)).isEqualTo(-1);
    }
  }

  // The index.

  /** So many questions that later ones use an index. */
  private static void askOften(World world) {
    for (int i = 0; i < 1_000; i++) {
      world.nearest(i % 100, 50, Kind.PEG);
      world.cast(new SweptCircle(new Circle(i % 100, 50, 0.5), new Vec2(0, 1)), 1);
    }
  }

  private static int hit(World world, double x) {
    return world
        .cast(new SweptCircle(new Circle(x, -50, 0.5), new Vec2(0, 1)), 200)
        .map(Impact::id)
        .orElse(-1);
  }

  @Test
  void editsReachTheIndex() {
    SceneBuilder scene = Scene.builder();
    for (int i = 0; i < 100; i++) {
      scene.peg(10 * (i % 10), 10 * (i / 10), 1);
    }
    World world = new World(scene.build());
    askOften(world);
    assertThat(nearest(world, 4, 4, Kind.PEG)).isZero();
    assertThat(hit(world, 5)).isEqualTo(-1);
    int added = world.addPeg(5, 5, 2, Traits.DEFAULT);
    assertThat(nearest(world, 4, 4, Kind.PEG)).isEqualTo(added);
    assertThat(hit(world, 5)).isEqualTo(added);
    world.setShape(Kind.PEG, added, new Circle(15, 5, 2));
    assertThat(nearest(world, 4, 4, Kind.PEG)).isZero();
    assertThat(hit(world, 5)).isEqualTo(-1);
    assertThat(hit(world, 15)).isEqualTo(added);
    world.remove(Kind.PEG, added);
    assertThat(hit(world, 15)).isEqualTo(-1);
    askOften(world);
    world.setVelocity(Kind.PEG, 0, 1, 0);
    world.step(5);
    assertThat(nearest(world, 4, 4, Kind.PEG)).isZero();
    assertThat(hit(world, 0)).as("the peg above it").isEqualTo(10);
  }
}
