// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.Circle;
import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Warning;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.KindNumber;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a scene warns of: circles that are where a user hardly wants them. */
class WarningsTest {

  private static SceneBuilder box() {
    return Scene.builder().collide(false).bounds(0, 0, 100, 80);
  }

  private static List<String> of(SceneBuilder scene) {
    return texts(scene.build());
  }

  private static List<String> texts(Scene scene) {
    return scene.warnings().stream().map(Warning::toString).toList();
  }

  @Test
  void aSceneInOrderHasNone() {
    assertThat(of(Scene.builder())).isEmpty();
    assertThat(of(box())).isEmpty();
    assertThat(of(box().line(1, 2, 3, 4).peg(9, 9, 3))).isEmpty();
    assertThat(of(box().line(50, 0, 50, 80).peg(20, 40, 5).circle(35, 40, 10, 1, 1))).isEmpty();
  }

  @Test
  void theyNameThingValueAndWhatWasExpectedInOrder() {
    SceneBuilder scene =
        box()
            .collide(true)
            .line(50, 0, 50, 80)
            .line(52, 0, 52, 80)
            .peg(44, 40, 2)
            .circle(48, 40, 4, 1, 1)
            .circle(1, 79, 2, 0, 0)
            .circle(46, 40, 1, 0, 0)
            .circle(104, -3, 5, 0, 0);
    assertThat(of(scene))
        .containsExactly(
            "circle 0: distance from line 0 is 2.0: expected at least 4.0, its radius",
            "circle 0: distance from peg 0 is 4.0: expected at least 6.0, the sum of both radii",
            "circle 0: distance from circle 2 is 2.0: expected at least 5.0, the sum of both"
                + " radii",
            "circle 1: distance from the left wall is 1.0: expected at least 2.0, its radius",
            "circle 1: distance from the top wall is 1.0: expected at least 2.0, its radius",
            "circle 2: distance from peg 0 is 2.0: expected at least 3.0, the sum of both radii",
            "circle 3: distance from the right wall is -4.0: expected at least 5.0, its radius",
            "circle 3: distance from the bottom wall is -3.0: expected at least 5.0, its radius");
    assertThatThrownBy(() -> of(scene).remove(0)).isInstanceOf(UnsupportedOperationException.class);
  }

  @Test
  void theDistanceFromAWallIsThatFromItsPlace() {
    assertThat(of(Scene.builder().bounds(2, -3, 9, 7).circle(3, -2.5, 4, 0, 0)))
        .containsExactly(
            "circle 0: distance from the left wall is 1.0: expected at least 4.0, its radius",
            "circle 0: distance from the bottom wall is 0.5: expected at least 4.0, its radius");
  }

  @Test
  void circlesThatIgnoreEachOtherMayOverlap() {
    SceneBuilder scene = box().circle(40, 40, 4, 1, 1).circle(41, 40, 4, 1, 1);
    assertThat(of(scene)).isEmpty();
    assertThat(of(scene.collide(true))).hasSize(1);
  }

  /** Sensors report and change nothing; circles of infinite mass pass through each other. */
  @Test
  void whatChangesNothingMayBeOverlapped() {
    assertThat(
            of(
                box()
                    .line(40, 0, 40, 80)
                    .response(Response.SENSOR)
                    .peg(41, 40, 2)
                    .response(Response.SENSOR)
                    .circle(40, 40, 4, 1, 1)))
        .isEmpty();
    Consumer<SceneBuilder> none = scene -> {};
    Consumer<SceneBuilder> sensor = scene -> scene.response(Response.SENSOR);
    Consumer<SceneBuilder> heavy = scene -> scene.mass(Double.POSITIVE_INFINITY);
    assertThat(overlapping(none, none)).hasSize(1);
    assertThat(overlapping(heavy, none)).hasSize(1);
    assertThat(overlapping(none, heavy)).hasSize(1);
    assertThat(overlapping(heavy, heavy)).isEmpty();
    assertThat(overlapping(sensor, none)).isEmpty();
    assertThat(overlapping(none, sensor)).isEmpty();
  }

  private static List<String> overlapping(
      Consumer<SceneBuilder> first, Consumer<SceneBuilder> second) {
    SceneBuilder scene = box().collide(true).circle(40, 40, 4, 1, 1);
    first.accept(scene);
    scene.circle(41, 40, 4, 1, 1);
    second.accept(scene);
    return of(scene);
  }

  /** It is there only for a centre strictly left of it. */
  @ParameterizedTest
  @CsvSource({"38, 1", "40, 0", "42, 0"})
  void aOneWayLineMayBeOverlappedFromItsRight(double x, int warnings) {
    assertThat(of(box().line(40, 0, 40, 80).oneWay().circle(x, 40, 4, 1, 1))).hasSize(warnings);
    assertThat(of(box().line(40, 40, 40, 40).oneWay().circle(x, 40, 4, 1, 1))).isEmpty();
  }

  // Exactness.

  /** Touching is none, and an ulp nearer is one, whose distance is below what was expected. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 0.1, 1e-100, 1e100})
  void anUlpCounts(double unit) {
    double r = 5 * unit;
    Consumer<SceneBuilder> line = s -> s.line(-9 * unit, 0, 9 * unit, 0);
    Consumer<SceneBuilder> point = s -> s.line(0, 0, 0, 0);
    Consumer<SceneBuilder> peg = s -> s.peg(0, 0, 0);
    Consumer<SceneBuilder> wall = s -> s.bounds(-99 * unit, 0, 99 * unit, 99 * unit);
    for (Consumer<SceneBuilder> thing : List.of(line, point, peg, wall)) {
      assertThat(at(thing, r, r)).isEmpty();
      assertThat(at(thing, Math.nextUp(r), r)).isEmpty();
      assertThat(at(thing, Math.nextDown(r), r))
          .singleElement()
          .asString()
          .contains(" is " + Math.nextDown(r) + ": expected at least " + r);
    }
  }

  private static List<String> at(Consumer<SceneBuilder> thing, double y, double r) {
    SceneBuilder scene = Scene.builder();
    thing.accept(scene);
    return of(scene.circle(0, y, r, 0, 0));
  }

  /** By less than doubles tell: the distance that is named is the next one below. */
  @Test
  void whatOverlapsByLessThanAnUlpIsNamedTruly() {
    double far = 0x1p52;
    assertThat(of(Scene.builder().bounds(-0x1p-60, -1, 9, 9).circle(1, 1, Math.nextUp(1.0), 0, 0)))
        .singleElement()
        .asString()
        .contains("left wall is 1.0: expected at least 1.0000000000000002");
    assertThat(of(Scene.builder().bounds(0x1p-60, -1, 9, 9).circle(1, 1, 1, 0, 0)))
        .singleElement()
        .asString()
        .contains("left wall is 0.9999999999999999: expected at least 1.0");
    assertThat(of(Scene.builder().bounds(-far, -1, far, 9).circle(0, 1, far, 0, 0))).hasSize(2);
  }

  // Against asking for each pair.

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void theyAreThoseOfEachPair(long seed) {
    Random random = new Random(seed);
    int all = 0;
    for (int i = 0; i < 30; i++) {
      Scene scene = scene(random, seed % 2 == 0);
      List<String> expected = ofEachPair(scene);
      assertThat(texts(scene)).isEqualTo(expected);
      all += expected.size();
    }
    assertThat(all).isGreaterThan(100);
  }

  /** Some lie far off, some are as large as the scene, and some are on a lattice. */
  private static Scene scene(Random random, boolean collide) {
    SceneBuilder scene = Scene.builder().collide(collide);
    double unit = Math.scalb(1.0, random.nextInt(600) - 300);
    if (random.nextBoolean()) {
      scene.bounds(0, 0, 100 * unit, 80 * unit);
    }
    for (int i = random.nextInt(60); i > 0; i--) {
      scene.line(
          place(random, unit), place(random, unit), place(random, unit), place(random, unit));
      if (random.nextInt(5) == 0) {
        scene.oneWay();
      }
    }
    for (int i = random.nextInt(60); i > 0; i--) {
      scene.peg(place(random, unit), place(random, unit), random.nextInt(4) * unit);
    }
    for (int i = random.nextInt(300); i > 0; i--) {
      double r = random.nextInt(30) == 0 ? 40 : 1 + random.nextInt(2);
      scene.circle(place(random, unit), place(random, unit), r * unit, 0, 0);
      if (random.nextInt(9) == 0) {
        scene.response(Response.SENSOR);
      }
    }
    return scene.build();
  }

  private static double place(Random random, double unit) {
    double place = random.nextBoolean() ? random.nextInt(100) : 100 * random.nextDouble();
    return (random.nextInt(100) == 0 ? 1e6 * place : place) * unit;
  }

  private static String text(Scene scene, int i, int code) {
    return Internals.warning(scene, Warnings.overlap(Internals.data(scene), i, code)).toString();
  }

  /** The rule in its own words, without an index. */
  private static List<String> ofEachPair(Scene scene) {
    List<String> warnings = new ArrayList<>();
    ObstacleTable obstacles = ObstacleTable.of(Internals.data(scene));
    Proximity proximity = new Proximity(new ObstacleIndex(obstacles), () -> 0);
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      Circle circle = (Circle) scene.shape(Kind.CIRCLE, i);
      Region disk = Region.disk(circle.x(), circle.y(), circle.radius());
      int[] codes =
          IntStream.range(KindNumber.WALL, KindNumber.CIRCLE)
              .flatMap(kind -> IntStream.of(proximity.overlapping(kind, disk, any -> true)))
              .toArray();
      for (int code : codes) {
        boolean isLeft = !obstacles.isOneWay(code);
        if (!isLeft) {
          Line l = (Line) Internals.record(obstacles, code);
          isLeft =
              Predicates.cross(
                      l.bx(), l.by(), l.ax(), l.ay(), circle.x(), circle.y(), l.ax(), l.ay())
                  > 0;
        }
        if (isLeft) {
          warnings.add(text(scene, i, code));
        }
      }
      for (int j = i + 1; j < scene.count(Kind.CIRCLE) && scene.collide(); j++) {
        boolean sensor =
            scene.traits(Kind.CIRCLE, i).response() == Response.SENSOR
                || scene.traits(Kind.CIRCLE, j).response() == Response.SENSOR;
        Circle o = (Circle) scene.shape(Kind.CIRCLE, j);
        if (!sensor && circle.overlaps(o)) {
          warnings.add(text(scene, i, Codes.circle(j)));
        }
      }
    }
    return warnings.subList(0, Math.min(10_000, warnings.size()));
  }

  // Large scenes.

  @Test
  void noMoreThanTenThousandAreListed() {
    SceneBuilder scene = Scene.builder();
    for (int i = 0; i < 20_000; i++) {
      scene.circle(0, 0, 1, 0, 0);
    }
    List<String> warnings = of(scene);
    assertThat(warnings).hasSize(10_000);
    assertThat(warnings.get(9_999)).startsWith("circle 0: distance from circle 10000 is 0.0");
  }

  /** A hundred thousand of both: short lines, and lines right across, level and sloping. */
  @Tag("long")
  @ParameterizedTest
  @CsvSource({"1, 1", "1000, 1"})
  void aLargeSceneTakesSeconds(double length, int slope) {
    Random random = new Random(7);
    SceneBuilder scene = Scene.builder().bounds(0, 0, 1000, 1000);
    int side = 320;
    for (int i = 0; i < 100_000; i++) {
      double x = 2 + 3 * (i % side);
      double y = 2 + 3 * (i / side);
      scene.circle(x, y, 0.5, 1, 1);
      // Between the rows, and on one circle in a thousand.
      double shift = i % 1000 == 0 ? 0.25 : 1.5;
      double reach = i % 1000 == 0 ? 0.25 : length * random.nextDouble();
      double rise = slope * reach;
      scene.line(x - reach, y + shift - rise, x + reach, y + shift + rise);
    }
    Scene built = scene.circle(1e9, 5, 1, 0, 0).circle(-3, -1e9, 1000, 0, 0).build();
    List<Warning> warnings = Assertions.assertTimeout(Duration.ofSeconds(60), built::warnings);
    assertThat(warnings).hasSize(103);
  }
}
