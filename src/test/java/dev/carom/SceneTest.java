// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class SceneTest {

  /** Two of each kind, every number of its own. */
  private static SceneBuilder full() {
    SceneBuilder builder = Scene.builder().collide(false).bounds(-1, -2, 801, 602).restitution(0.5);
    builder.line(11, 12, 13, 14).line(21, 22, 23, 24).restitution(0.25);
    builder.peg(31, 32, 33).restitution(1.5).peg(41, 42, 0);
    builder.circle(51, 52, 53, 54, 55).mass(56).restitution(0);
    return builder.circle(61, 62, 63, 64, 65).gravity(71, -72);
  }

  @Test
  void givesBackWhatWasAdded() {
    Scene scene = full().build();
    assertThat(scene.bounds()).contains(new Bounds(-1, -2, 801, 602));
    assertThat(scene.count(Kind.LINE)).isEqualTo(2);
    assertThat(scene.shape(Kind.LINE, 0)).isEqualTo(new Line(11, 12, 13, 14));
    assertThat(scene.shape(Kind.LINE, 1)).isEqualTo(new Line(21, 22, 23, 24));
    assertThat(scene.count(Kind.PEG)).isEqualTo(2);
    assertThat(scene.shape(Kind.PEG, 0)).isEqualTo(new Circle(31, 32, 33));
    assertThat(scene.shape(Kind.PEG, 1)).isEqualTo(new Circle(41, 42, 0));
    assertThat(scene.count(Kind.CIRCLE)).isEqualTo(2);
    assertThat(scene.shape(Kind.CIRCLE, 0)).isEqualTo(new Circle(51, 52, 53));
    assertThat(scene.shape(Kind.CIRCLE, 1)).isEqualTo(new Circle(61, 62, 63));
    assertThat(scene.velocity(Kind.CIRCLE, 0)).isEqualTo(new Vec2(54, 55));
    assertThat(scene.velocity(Kind.CIRCLE, 1)).isEqualTo(new Vec2(64, 65));
    assertThat(scene.gravity()).isEqualTo(new Vec2(71, -72));
  }

  @Test
  void withoutGravityItIsZeroOfPositiveSign() {
    Scene none = Scene.builder().build();
    assertThat(none.gravity()).isEqualTo(Vec2.ZERO);
    for (SceneBuilder zero :
        new SceneBuilder[] {
          Scene.builder().gravity(0, 0),
          Scene.builder().gravity(-0.0, -0.0),
          Scene.builder().gravity(3, 4).gravity(0, -0.0)
        }) {
      assertThat(zero.build()).isEqualTo(none).hasSameHashCodeAs(none);
      assertThat(zero.build().gravity()).isEqualTo(Vec2.ZERO);
    }
    assertThat(Scene.builder().gravity(-0.0, -2).build().gravity()).isEqualTo(new Vec2(0, -2));
  }

  /** A property of the scene: the thing added last stays the one that is spoken of. */
  @Test
  void gravityIsNoThing() {
    Scene scene = Scene.builder().peg(1, 2, 3).gravity(0, 1).restitution(0.5).build();
    assertThat(scene.traits(Kind.PEG, 0).restitution()).isEqualTo(0.5);
    assertThat(scene)
        .hasToString("Scene[circles=0, lines=0, pegs=1, bounds=none, gravity=Vec2[x=0.0, y=1.0]]");
  }

  @Test
  void restitutionAndMassBelongToTheThingAddedLast() {
    Scene scene = full().build();
    assertThat(scene.traits(Kind.WALL, 0).restitution()).isEqualTo(0.5);
    assertThat(scene.traits(Kind.LINE, 0).restitution()).isEqualTo(1);
    assertThat(scene.traits(Kind.LINE, 1).restitution()).isEqualTo(0.25);
    assertThat(scene.traits(Kind.PEG, 0).restitution()).isEqualTo(1.5);
    assertThat(scene.traits(Kind.PEG, 1).restitution()).isEqualTo(1);
    assertThat(scene.traits(Kind.CIRCLE, 0).restitution()).isZero();
    assertThat(scene.traits(Kind.CIRCLE, 1).restitution()).isEqualTo(1);
    assertThat(scene.traits(Kind.CIRCLE, 0).mass()).isEqualTo(56);
    assertThat(scene.traits(Kind.CIRCLE, 1).mass()).isEqualTo(1);
  }

  @Test
  void anEmptySceneIsOpen() {
    Scene scene = Scene.builder().build();
    assertThat(scene.bounds()).isEmpty();
    assertThatExceptionOfType(IndexOutOfBoundsException.class)
        .isThrownBy(() -> scene.traits(Kind.WALL, 0).restitution())
        .withMessage("wall 0 does not exist: the scene has none of them");
    assertThat(scene.count(Kind.CIRCLE) + scene.count(Kind.LINE) + scene.count(Kind.PEG)).isZero();
    assertThat(scene).hasToString("Scene[circles=0, lines=0, pegs=0, bounds=none]");
  }

  @Test
  void theExampleOfTheJavadoc() {
    SceneBuilder setup = Scene.builder().bounds(0, 0, 800, 600);
    setup.line(300, 200, 500, 400).restitution(0.9).circle(100, 100, 10, 4, 3);
    Scene scene = setup.build();
    assertThat(scene)
        .hasToString(
            "Scene[circles=1, lines=1, pegs=0,"
                + " bounds=Bounds[xmin=0.0, ymin=0.0, xmax=800.0, ymax=600.0]]");
    assertThat(scene.traits(Kind.LINE, 0).restitution()).isEqualTo(0.9);
  }

  static Stream<Arguments> lookups() {
    Scene scene = full().build();
    return Stream.of(
        lookup("circle", i -> scene.shape(Kind.CIRCLE, i)),
        lookup("circle", i -> scene.velocity(Kind.CIRCLE, i)),
        lookup("circle", i -> scene.traits(Kind.CIRCLE, i)),
        lookup("line", i -> scene.shape(Kind.LINE, i)),
        lookup("line", i -> scene.traits(Kind.LINE, i)),
        lookup("peg", i -> scene.shape(Kind.PEG, i)),
        lookup("peg", i -> scene.traits(Kind.PEG, i)));
  }

  private static Arguments lookup(String kind, IntFunction<?> get) {
    return Arguments.of(kind, get);
  }

  @ParameterizedTest
  @MethodSource("lookups")
  void namesWhatDoesNotExist(String kind, IntFunction<?> get) {
    for (int i : new int[] {2, -1, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
      assertThatExceptionOfType(IndexOutOfBoundsException.class)
          .isThrownBy(() -> get.apply(i))
          .withMessage(kind + " " + i + " does not exist: the scene has 2 of them, from 0");
    }
  }

  @Test
  void equalScenesHoldTheSameThings() {
    Scene scene = full().build();
    assertThat(full().build()).isEqualTo(scene).hasSameHashCodeAs(scene);
    assertThat(full().line(1, 2, 3, 4).build()).doesNotHaveSameHashCodeAs(scene);
    assertThat(scene).isNotEqualTo(null).isNotEqualTo("scene");
  }

  static Stream<SceneBuilder> changed() {
    return Stream.of(
        full().mass(2),
        full().restitution(0.5),
        full().line(1, 2, 3, 4),
        full().peg(1, 2, 3),
        full().circle(1, 2, 3, 4, 5),
        full().gravity(0, -72),
        full().gravity(71, 72));
  }

  @ParameterizedTest
  @MethodSource("changed")
  void anyDifferenceMakesScenesUnequal(SceneBuilder changed) {
    assertThat(changed.build()).isNotEqualTo(full().build());
  }

  @Test
  void boundsAndTheirRestitutionCountForEquality() {
    Scene open = Scene.builder().build();
    Scene closed = Scene.builder().bounds(0, 0, 1, 1).build();
    Scene wider = Scene.builder().bounds(0, 0, 2, 1).build();
    Scene soft = Scene.builder().bounds(0, 0, 1, 1).restitution(0.5).build();
    assertThat(closed).isNotEqualTo(open).isNotEqualTo(wider).isNotEqualTo(soft);
    assertThat(open).isNotEqualTo(closed);
  }

  @Test
  void zerosOfEitherSignAreNotTheSameBits() {
    Scene plus = Scene.builder().line(0.0, 1, 2, 3).build();
    Scene minus = Scene.builder().line(-0.0, 1, 2, 3).build();
    assertThat(plus).isNotEqualTo(minus);
  }
}
