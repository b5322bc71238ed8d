// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class SceneBuilderTest {

  private static final double INFINITY = Double.POSITIVE_INFINITY;

  private static SceneBuilder two() {
    SceneBuilder builder =
        Scene.builder().collide(false).line(1, 2, 3, 4).line(5, 6, 7, 8).peg(1, 2, 3);
    return builder.circle(1, 2, 3, 4, 5).circle(1, 2, 3, 4, 5).circle(1, 2, 3, 4, 5);
  }

  static Stream<Arguments> refusals() {
    double nan = Double.NaN;
    return Stream.of(
        refusal(b -> b.line(nan, 0, 0, 0), "line 2: ax is NaN: expected a finite number"),
        refusal(b -> b.line(0, nan, 0, 0), "line 2: ay is NaN: expected a finite number"),
        refusal(b -> b.line(0, 0, nan, 0), "line 2: bx is NaN: expected a finite number"),
        refusal(b -> b.line(0, 0, 0, INFINITY), "line 2: by is Infinity: expected a finite number"),
        refusal(b -> b.peg(nan, 0, 0), "peg 1: x is NaN: expected a finite number"),
        refusal(b -> b.peg(0, nan, 0), "peg 1: y is NaN: expected a finite number"),
        refusal(
            b -> b.peg(0, 0, -1), "peg 1: radius is -1.0: expected a finite number, at least 0"),
        refusal(b -> b.circle(nan, 0, 1, 0, 0), "circle 3: x is NaN: expected a finite number"),
        refusal(b -> b.circle(0, nan, 1, 0, 0), "circle 3: y is NaN: expected a finite number"),
        refusal(
            b -> b.circle(0, 0, -1, 0, 0),
            "circle 3: radius is -1.0: expected a finite number, at least 0"),
        refusal(
            b -> b.circle(0, 0, nan, 0, 0),
            "circle 3: radius is NaN: expected a finite number, at least 0"),
        refusal(
            b -> b.circle(0, 0, INFINITY, 0, 0),
            "circle 3: radius is Infinity: expected a finite number, at least 0"),
        refusal(b -> b.circle(0, 0, 1, nan, 0), "circle 3: vx is NaN: expected a finite number"),
        refusal(
            b -> b.circle(0, 0, 1, 0, -INFINITY),
            "circle 3: vy is -Infinity: expected a finite number"),
        refusal(
            b -> b.bounds(0, nan, 1, 1),
            "bounds: ymin is NaN: expected a number, or infinity for an open side"),
        refusal(b -> b.bounds(0, 0, 0, 1), "bounds: xmax is 0.0: expected more than xmin, 0.0"),
        refusal(
            b -> b.restitution(-0.5),
            "circle 2: restitution is -0.5: expected a finite number, at least 0"),
        refusal(
            b -> b.restitution(nan),
            "circle 2: restitution is NaN: expected a finite number, at least 0"),
        refusal(
            b -> b.bounds(0, 0, 1, 1).restitution(INFINITY),
            "bounds: restitution is Infinity: expected a finite number, at least 0"),
        refusal(
            b -> b.line(0, 0, 1, 1).restitution(-1),
            "line 2: restitution is -1.0: expected a finite number, at least 0"),
        refusal(b -> b.gravity(nan, 0), "gravity: gx is NaN: expected a finite number"),
        refusal(b -> b.gravity(INFINITY, nan), "gravity: gx is Infinity: expected a finite number"),
        refusal(
            b -> b.gravity(0, -INFINITY), "gravity: gy is -Infinity: expected a finite number"));
  }

  private static Arguments refusal(Consumer<SceneBuilder> call, String message) {
    return Arguments.of(call, message);
  }

  @ParameterizedTest
  @MethodSource("refusals")
  void namesThingNumberValueAndExpectation(Consumer<SceneBuilder> call, String message) {
    assertThatIllegalArgumentException().isThrownBy(() -> call.accept(two())).withMessage(message);
  }

  @Test
  void aRefusalLeavesTheBuilderAsItWas() {
    SceneBuilder builder = two();
    assertThatIllegalArgumentException().isThrownBy(() -> builder.line(0, 0, INFINITY, 0));
    assertThatIllegalArgumentException().isThrownBy(() -> builder.circle(0, 0, -1, 0, 0));
    assertThatIllegalArgumentException().isThrownBy(() -> builder.bounds(0, 0, 0, 0));
    assertThatIllegalArgumentException().isThrownBy(() -> builder.restitution(-1));
    assertThatIllegalArgumentException().isThrownBy(() -> builder.mass(0));
    assertThatIllegalArgumentException().isThrownBy(() -> builder.gravity(1, INFINITY));
    assertThat(builder.build()).isEqualTo(two().build());
    assertThat(builder.restitution(0.5).build().traits(Kind.CIRCLE, 2).restitution())
        .isEqualTo(0.5);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0x1p-500, 1, 12.5, 0x1p500, Double.POSITIVE_INFINITY})
  void takesMassesWithinTheirLimits(double mass) {
    assertThat(two().mass(mass).build().traits(Kind.CIRCLE, 2).mass()).isEqualTo(mass);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN, 0x1.fffffffffffffp-501, 0x1.0000000000001p500})
  void refusesOtherMasses(double mass) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> two().mass(mass))
        .withMessage(
            "circle 2: mass is " + mass + ": expected a number from 2^-500 to 2^500, or infinity");
  }

  @Test
  void aPropertyNeedsAThing() {
    assertThatIllegalStateException()
        .isThrownBy(() -> Scene.builder().restitution(1))
        .withMessage("restitution belongs to the thing added last: add one first");
    assertThatIllegalStateException()
        .isThrownBy(() -> Scene.builder().mass(1))
        .withMessage("mass belongs to the circle just added: add one first");
    assertThatIllegalStateException().isThrownBy(() -> two().line(0, 0, 1, 1).mass(1));
  }

  @Test
  void aSceneHasOneBounds() {
    assertThatIllegalStateException()
        .isThrownBy(() -> Scene.builder().bounds(0, 0, 1, 1).bounds(0, 0, 1, 1))
        .withMessage("the scene has bounds already: expected one only");
  }

  @Test
  void theBuilderCanBeUsedFurther() {
    SceneBuilder builder = two();
    Scene first = builder.build();
    Scene second = builder.circle(9, 9, 1, 0, 0).restitution(0.5).build();
    assertThat(first).isEqualTo(two().build());
    assertThat(second.count(Kind.CIRCLE)).isEqualTo(4);
  }

  /** 2^10 ulps of 1024 are 2^10 2^-42. Whichever thing has the largest coordinate, it counts. */
  static Stream<Consumer<SceneBuilder>> thingsThatReachTo1024() {
    return Stream.of(
        b -> b.line(1024, 0, 0, 0),
        b -> b.line(0, -1024, 0, 0),
        b -> b.line(0, 0, -1024, 0),
        b -> b.line(0, 0, 0, 1024),
        b -> b.peg(1024, 0, 1e9),
        b -> b.peg(0, -1024, 1e9),
        b -> b.bounds(-1024, 0, 1, 1),
        b -> b.bounds(0, -1024, 1, 1),
        b -> b.bounds(0, 0, 1024, 1),
        b -> b.bounds(0, 0, 1, 1024),
        b -> b.circle(-1024, 0, 1e9, 1e9, 0),
        b -> b.circle(0, 1024, 1e9, 0, 1e9));
  }

  @ParameterizedTest
  @MethodSource("thingsThatReachTo1024")
  void refusesCirclesThatRoundingCouldCarryThroughALine(Consumer<SceneBuilder> thing) {
    double least = 0x1p-32;
    SceneBuilder enough = Scene.builder().collide(false).circle(0, 0, least, 1, 0);
    thing.accept(enough);
    assertThat(((Circle) enough.build().shape(Kind.CIRCLE, 0)).radius()).isEqualTo(least);

    double less = Math.nextDown(least);
    SceneBuilder tooSmall =
        Scene.builder().collide(false).circle(0, 0, 1, 0, 0).circle(0, 0, less, 1, 0);
    thing.accept(tooSmall);
    assertThatIllegalArgumentException()
        .isThrownBy(tooSmall::build)
        .withMessage(
            "circle 1: radius is %s: expected at least %s, 2^10 ulps of the largest coordinate,"
                + " 1024.0",
            less, least);
  }

  @Test
  void namesTheFirstCircleThatIsTooSmall() {
    SceneBuilder builder =
        Scene.builder()
            .collide(false)
            .circle(1024, 0, 1e-30, 0, 0)
            .circle(0, 0, 1e-30, 0, 0)
            .line(0, 0, 1, 1);
    assertThatIllegalArgumentException()
        .isThrownBy(builder::build)
        .withMessageStartingWith("circle 0: radius is 1.0E-30: expected at least ");
  }
}
