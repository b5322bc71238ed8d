// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import java.util.List;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class MethodsTest {

  private static final List<Contender> IN_DOUBLES =
      List.of(
          Methods.CAROM,
          Methods.POSTER_DOUBLE,
          Methods.TEXTBOOK_DOUBLE,
          Methods.TEXTBOOK_GRID,
          Methods.PLAIN_GRID,
          Methods.advancement(-12));

  private static final List<Contender> IN_FLOATS = List.of(Methods.POSTER, Methods.TEXTBOOK_FLOAT);

  static Stream<Contender> eventDriven() {
    return Stream.concat(IN_DOUBLES.stream(), IN_FLOATS.stream());
  }

  static Stream<Contender> plain() {
    return Methods.all().stream()
        .filter(c -> !List.of("carom", "poster", "poster-double").contains(c.method()));
  }

  private static Offset<Double> offset(Contender contender) {
    return within(IN_FLOATS.contains(contender) ? 1e-3 : 1e-10);
  }

  private static Method after(int frames, Contender contender, Scene scene) {
    Method method = contender.start(scene);
    for (int i = 0; i < frames; i++) {
      method.frame();
    }
    return method;
  }

  /** Where a point is that flies to and fro between 0 and a width: the unfolded path folded. */
  private static double folded(double unfolded, double width) {
    double u = unfolded - 2 * width * Math.floor(unfolded / (2 * width));
    return u <= width ? u : 2 * width - u;
  }

  @ParameterizedTest
  @MethodSource("eventDriven")
  void aBoxUnfolds(Contender contender) {
    Scene scene = Scene.builder().bounds(0, 0, 100, 60).circle(20, 30, 10, 1.5, -0.75).build();

    Method method = after(500, contender, scene);

    assertThat(method.x(0)).isCloseTo(10 + folded(10 + 500 * 1.5, 80), offset(contender));
    assertThat(method.y(0)).isCloseTo(10 + folded(20 - 500 * 0.75, 40), offset(contender));
  }

  /** Contact at x = 45, after half of the frame; then the wall's twin, a line, throws it back. */
  @ParameterizedTest
  @MethodSource("eventDriven")
  void aSideReflects(Contender contender) {
    Scene scene = Scene.builder().line(50, 0, 50, 100).circle(40, 40, 5, 10, 1).build();

    Method method = after(1, contender, scene);

    assertThat(method.x(0)).isCloseTo(40, offset(contender));
    assertThat(method.y(0)).isCloseTo(41, offset(contender));
    assertThat(method.vx(0)).isCloseTo(-10, offset(contender));
    assertThat(method.vy(0)).isCloseTo(1, offset(contender));
    assertThat(method.impacts()).isEqualTo(1);
    assertThat(method.wallImpacts()).isZero();
  }

  /** Offset (3, 4) of the end at contact, after 0.4 of the frame: (-10, 0) turns to (-2.8, 9.6). */
  @ParameterizedTest
  @MethodSource("eventDriven")
  void anEndReflectsAlongTheOffset(Contender contender) {
    Scene scene = Scene.builder().line(50, 0, 50, 100).circle(57, 104, 5, -10, 0).build();

    Method method = after(1, contender, scene);

    assertThat(method.x(0)).isCloseTo(53 - 0.6 * 2.8, offset(contender));
    assertThat(method.y(0)).isCloseTo(104 + 0.6 * 9.6, offset(contender));
    assertThat(method.vx(0)).isCloseTo(-2.8, offset(contender));
    assertThat(method.vy(0)).isCloseTo(9.6, offset(contender));
  }

  /** Between lines 20 apart with a diameter of 10, at 75 a frame: 7.5 crossings. */
  @ParameterizedTest
  @FieldSource("IN_DOUBLES")
  void onlyThePublishedAlgorithmStopsAtOneImpactOfAFrame(Contender contender) {
    Scene scene =
        Scene.builder().line(0, -50, 0, 50).line(20, -50, 20, 50).circle(5, 0, 5, 75, 0).build();

    Method method = after(1, contender, scene);

    if (contender.equals(Methods.POSTER_DOUBLE)) {
      assertThat(method.impacts()).isEqualTo(1);
      assertThat(method.x(0)).isCloseTo(15 - 65, within(1e-12));
    } else {
      assertThat(method.impacts()).isEqualTo(7);
      assertThat(method.x(0)).isCloseTo(10, within(1e-12));
    }
  }

  /** Seen only at the end of a part of 1/k of the frame, and then set on the line's surface. */
  @Test
  void substepsNoticeContactLateAndPushOut() {
    Scene scene = Scene.builder().line(50, 0, 50, 100).circle(38, 40, 5, 10, 0).build();

    assertThat(after(1, Methods.OVERLAP, scene).x(0)).isEqualTo(45);
    assertThat(after(1, Methods.substeps(2), scene).x(0)).isEqualTo(45);
    assertThat(after(1, Methods.substeps(4), scene).x(0)).isEqualTo(42.5);
    assertThat(after(1, Methods.CAROM, scene).x(0)).isEqualTo(42);
    assertThat(after(1, Methods.substeps(4), scene).vx(0)).isEqualTo(-10);
  }

  @Test
  void theOverlapTestLetsFastCirclesThrough() {
    Scene scene = Scene.builder().line(50, 0, 50, 100).circle(31, 40, 5, 40, 0).build();

    assertThat(after(1, Methods.OVERLAP, scene).x(0)).isEqualTo(71);
    assertThat(after(1, Methods.substeps(8), scene).vx(0)).isEqualTo(-40);
  }

  /** The gap at contact is the tolerance, as far as one more step would close it. */
  @Test
  void advancementStopsWithinItsTolerance() {
    AdvancementDetector coarse = new AdvancementDetector(0.5);
    AdvancementDetector fine = new AdvancementDetector(1e-12);
    // Past the start of a line at an offset of 3, radius 5: contact at x = -4, time 16 of 1 px.
    double exact = 16;

    double early = coarse.time(-20, 3, 5, 1, 0, 0, 0, 0, -50, 100);

    assertThat(fine.time(-20, 3, 5, 1, 0, 0, 0, 0, -50, 100)).isCloseTo(exact, within(1e-11));
    assertThat(early).isLessThan(exact);
    assertThat(Math.hypot(-20 + early, 3) - 5).isBetween(0.0, 0.5);
    assertThat(fine.time(-20, 3, 5, 1, 0, 0, 0, 0, -50, 15.9)).isInfinite();
    assertThat(fine.time(-20, 7, 5, 1, 0, 0, 0, 0, -50, 100)).isInfinite();
    assertThat(fine.time(-5, 3, 5, -1, 0, 0, 0, 0, -50, 100)).isInfinite();
  }

  @Test
  void everyCircleAsksEveryLineOfThePublishedAlgorithm() {
    SceneBuilder setup = Scene.builder().collide(false).line(50, 0, 50, 100).line(60, 0, 60, 100);
    Scene scene = setup.circle(38, 40, 5, 1, 0).circle(38, 60, 5, 1, 0).build();

    assertThat(after(1, Methods.POSTER, scene).pairTests()).isEqualTo(4);
    assertThat(after(1, Methods.POSTER_DOUBLE, scene).pairTests()).isEqualTo(4);
    assertThat(after(1, Methods.substeps(8), scene).pairTests()).isEqualTo(32);
    assertThat(after(1, Methods.TEXTBOOK_DOUBLE, scene).pairTests()).isZero();
    assertThat(after(7, Methods.TEXTBOOK_DOUBLE, scene).pairTests()).isEqualTo(4);
    assertThat(after(7, Methods.PLAIN_GRID, scene).pairTests()).isBetween(2L, 8L);
    assertThat(after(1, Methods.CAROM, scene).pairTests()).isBetween(0L, 4L);
    assertThat(after(1, Methods.CAROM, scene).fallbacks()).isZero();
  }

  @ParameterizedTest
  @MethodSource("plain")
  void whatAMethodHasNoCodeForIsRefused(Contender contender) {
    Scene pegs = Scene.builder().peg(50, 50, 5).circle(10, 10, 5, 1, 1).build();

    assertThatThrownBy(() -> contender.start(pegs)).hasMessageContaining("it has pegs");
  }

  static Stream<Contender> others() {
    return Methods.all().stream().filter(contender -> !contender.equals(Methods.CAROM));
  }

  @ParameterizedTest
  @MethodSource("others")
  void gravityIsRefused(Contender contender) {
    Scene scene = Scene.builder().gravity(0, -1).circle(10, 10, 5, 1, 1).build();

    assertThatThrownBy(() -> contender.start(scene))
        .isInstanceOf(UnsupportedOperationException.class)
        .hasMessage(
            "this scene is not for this method: it has gravity; expected circles that fly"
                + " straight");
  }

  /** Contact after half of the frame: half of the speed is left to the side that is not at rest. */
  @ParameterizedTest
  @MethodSource("eventDriven")
  void whatIsNotElasticTakesSpeedAlongTheNormal(Contender contender) {
    SceneBuilder setup = Scene.builder().line(50, 0, 50, 100).restitution(0.8);
    Scene scene = setup.circle(40, 40, 5, 10, 1).restitution(0.5).build();

    Method method = after(1, contender, scene);

    assertThat(method.x(0)).isCloseTo(45 - 0.5 * 4, offset(contender));
    assertThat(method.vx(0)).isCloseTo(-4, offset(contender));
    assertThat(method.vy(0)).isCloseTo(1, offset(contender));
  }

  @ParameterizedTest
  @MethodSource("all")
  void wallsAndPartsOfAFrameKeepTheirRestitution(Contender contender) {
    SceneBuilder setup = Scene.builder().bounds(0, 0, 100, 100).restitution(0.5);
    Scene scene = setup.line(20, 0, 20, 100).restitution(0.25).circle(80, 50, 10, 8, 0).build();

    assertThat(after(4, contender, scene).vx(0)).isCloseTo(-4, within(1e-5));
    assertThat(after(20, contender, scene).vx(0)).isCloseTo(1, within(1e-5));
  }

  static Stream<Contender> all() {
    return Methods.all().stream();
  }

  @ParameterizedTest
  @MethodSource("all")
  void circlesThatCollideAreForMethodsThatKnowPairs(Contender contender) {
    SceneBuilder setup = Scene.builder().circle(0, 0, 5, 2, 0).mass(3);
    Scene scene = setup.circle(20, 0, 5, -1, 0).restitution(0.5).build();

    if (!List.of("carom", "overlap", "substeps").contains(contender.method())) {
      assertThatThrownBy(() -> contender.start(scene))
          .isInstanceOf(UnsupportedOperationException.class)
          .hasMessageContaining("its circles collide");
      return;
    }
    Method method = after(10, contender, scene);
    // The centre of mass moves at 5/4, each circle relative to it half as fast as before.
    assertThat(method.vx(0)).isCloseTo(1.25 - 0.5 * 0.75, within(1e-12));
    assertThat(method.vx(1)).isCloseTo(1.25 + 0.5 * 2.25, within(1e-12));
    assertThat(3 * method.x(0) + method.x(1)).isCloseTo(20 + 10 * 5, within(1e-12));
  }

  /** A corridor of one diameter: no time goes by between two impacts. */
  @Test
  void impactsWithoutEndAreToldAndDoNotHang() {
    Scene scene =
        Scene.builder().line(0, 0, 100, 0).line(0, 10, 100, 10).circle(50, 5, 5, 1, 1).build();

    assertThatThrownBy(() -> after(1, Methods.TEXTBOOK_DOUBLE, scene))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("circle 0 makes impacts without end");
    assertThatThrownBy(() -> after(1, Methods.TEXTBOOK_FLOAT, scene))
        .hasMessage("circle 0 makes impacts without end");
  }

  /** A control for the grid must differ in nothing but the grid. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void theGridChangesNoBitAndSparesWork(long seed) throws CannotPlaceException {
    Scene scene = new Crosses(40, 30, 10, 1, 30, seed).scene();
    Method all = Methods.TEXTBOOK_DOUBLE.start(scene);
    Method cells = Methods.TEXTBOOK_GRID.start(scene);
    long pairsOfAll = 0;
    long pairsOfCells = 0;

    for (int frame = 0; frame < 200; frame++) {
      all.frame();
      cells.frame();
      pairsOfAll += all.pairTests();
      pairsOfCells += cells.pairTests();
      for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
        assertThat(cells.x(i)).isEqualTo(all.x(i));
        assertThat(cells.y(i)).isEqualTo(all.y(i));
      }
    }

    assertThat(pairsOfCells).isLessThan(pairsOfAll / 4);
  }

  /** From outside, along the grid, away from it, and past it. */
  @Test
  void aCircleMayComeFromOutsideTheGrid() {
    SceneBuilder setup = Scene.builder().collide(false).line(0, 0, 10, 0).line(0, 40, 10, 40);
    setup.circle(5, -1000, 1, 0, 100).circle(-1000, 20, 1, 100, 0).circle(5, -1000, 1, 0, -100);
    Scene scene = setup.circle(2000, -1000, 1, 1, 100).build();

    Method cells = after(20, Methods.TEXTBOOK_GRID, scene);
    Method all = after(20, Methods.TEXTBOOK_DOUBLE, scene);

    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      assertThat(cells.y(i)).isEqualTo(all.y(i));
    }
    assertThat(cells.vy(0)).isEqualTo(-100);
  }

  @Test
  void idsAreUnique() {
    assertThat(Methods.all()).extracting(Contender::id).doesNotHaveDuplicates().hasSize(22);
  }
}
