// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Kind.CIRCLE;
import static dev.carom.Kind.LINE;
import static dev.carom.Kind.PEG;
import static dev.carom.Kind.WALL;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import dev.carom.internal.state.MovingCircle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class TraitsTest {

  private static final Filter TEAM = new Filter(2, ~4);
  private static final Traits HALF = Traits.DEFAULT.withRestitution(0.5);
  private static final Traits HEAVY = HALF.withMass(3).withFilter(TEAM);

  private static Scene scene() {
    return Scene.builder()
        .bounds(0, 0, 100, 100)
        .traits(HALF.withResponse(Response.HALT))
        .line(50, 50, 60, 60)
        .traits(HALF.withOneWay(true).withFilter(TEAM))
        .peg(70, 20, 3)
        .traits(HALF.withResponse(Response.SENSOR))
        .circle(20, 20, 2, 3, 1)
        .traits(HEAVY)
        .build();
  }

  /** Whether circles of a category and a mask meet those of another; as in Box2D, both must. */
  @ParameterizedTest
  @CsvSource({"1, -1, 1, -1, true", "2, 1, 1, 1, false", "2, 1, 1, 2, true", "6, 8, 9, 4, true"})
  void filtersMeetIfEachMaskHasTheOther(int c, int m, int otherC, int otherM, boolean meet) {
    Filter one = new Filter(c, m);
    Filter other = new Filter(otherC, otherM);

    assertThat(one.meets(other)).isEqualTo(meet);
    assertThat(other.meets(one)).isEqualTo(meet);
  }

  @Test
  void theFilterAllMeetsWhateverAnythingMeets() {
    assertThat(Filter.ALL.meets(TEAM)).isTrue();
    assertThat(Filter.ALL.meets(new Filter(0, -1))).isFalse();
  }

  @Test
  void eachCopyDiffersInOneTrait() {
    Traits all = new Traits(0.5, 3, Response.HALT, TEAM, true);

    assertThat(
            Traits.DEFAULT
                .withRestitution(0.5)
                .withMass(3)
                .withResponse(Response.HALT)
                .withFilter(TEAM)
                .withOneWay(true))
        .isEqualTo(all);
    assertThat(Traits.DEFAULT)
        .isEqualTo(new Traits(1, 1, Response.BOUNCE, new Filter(1, -1), false));
  }

  @Test
  void restitutionAndMassAreChecked() {
    for (double bad : new double[] {-1, Double.NaN, Double.POSITIVE_INFINITY}) {
      refused(
          "restitution is " + bad + ": expected a finite number, at least 0",
          () -> HALF.withRestitution(bad));
    }
    for (double bad : new double[] {0, -1, Double.NaN}) {
      refused(
          "mass is " + bad + ": expected a number from 2^-500 to 2^500, or infinity",
          () -> HALF.withMass(bad));
    }
  }

  @Test
  void aWorldBeginsWithThoseOfItsScene() {
    Scene scene = scene();
    World world = new World(scene);

    assertThat(scene.traits(WALL, 3)).isEqualTo(HALF.withResponse(Response.HALT));
    assertThat(scene.traits(LINE, 0)).isEqualTo(HALF.withOneWay(true).withFilter(TEAM));
    assertThat(scene.traits(PEG, 0)).isEqualTo(HALF.withResponse(Response.SENSOR));
    assertThat(scene.traits(CIRCLE, 0)).isEqualTo(HEAVY);
    for (Kind kind : Kind.values()) {
      assertThat(world.traits(kind, 0)).isEqualTo(scene.traits(kind, 0));
    }
  }

  @Test
  void thingsAreAddedWithTheirs() {
    World world = new World(scene());
    Traits gate = HALF.withOneWay(true).withResponse(Response.HALT);

    assertThat(world.traits(LINE, world.addLine(1, 80, 9, 80, gate))).isEqualTo(gate);
    assertThat(world.traits(PEG, world.addPeg(5, 90, 1, HALF))).isEqualTo(HALF);
    assertThat(world.traits(CIRCLE, world.addCircle(80, 80, 2, 0, 0, HEAVY))).isEqualTo(HEAVY);
    assertThat(world.snapshot().hash64()).isEqualTo(copy(world).snapshot().hash64());
  }

  private static World copy(World world) {
    World copy = new World(world.scene());
    copy.restore(world.snapshot());
    return copy;
  }

  /** Added with traits is the same, to the bit, as added and then given them. */
  @ParameterizedTest
  @EnumSource(Response.class)
  void toAddWithTraitsIsOneEdit(Response response) {
    Traits traits = HEAVY.withResponse(response).withMass(Double.POSITIVE_INFINITY);
    World one = new World(scene());
    World two = new World(scene());
    one.advanceTo(1.7);
    two.advanceTo(1.7);

    one.addCircle(40, 40, 3, 1, 2, traits);
    two.setTraits(CIRCLE, two.addCircle(40, 40, 3, 1, 2, Traits.DEFAULT), traits);

    one.advanceTo(60);
    two.advanceTo(60);
    assertThat(one.snapshot().hash64()).isEqualTo(two.snapshot().hash64());
  }

  @ParameterizedTest
  @EnumSource(Kind.class)
  void whatDoesNotDifferIsNoEdit(Kind kind) {
    World world = new World(scene());
    world.advanceTo(1.7);
    Snapshot before = world.snapshot();

    world.setTraits(kind, 0, world.traits(kind, 0));

    assertThat(world.snapshot()).isEqualTo(before);
  }

  @ParameterizedTest
  @CsvSource({"0.3, 3, false", "0.5, 7, false", "0.5, Infinity, true"})
  void aNewRestitutionOrFiniteMassBeginsNoFlight(double e, double mass, boolean begins) {
    World world = new World(scene());
    world.advanceTo(1.7);
    world.setTraits(CIRCLE, 0, HEAVY.withRestitution(e).withMass(mass));

    assertThat(world.traits(CIRCLE, 0)).isEqualTo(HEAVY.withRestitution(e).withMass(mass));
    assertThat(flightStart(world)).isEqualTo(begins ? 1.7 : 0);
  }

  private static double flightStart(World world) {
    MovingCircle circle = new MovingCircle();
    world.circles.load(0, circle);
    return circle.t;
  }

  @Test
  void aResponseAndAFilterCountAtOnce() {
    World world = new World(Scene.builder().line(9, 0, 9, 9).circle(1, 5, 1, 1, 0).build());
    world.advanceTo(3);

    world.setTraits(LINE, 0, Traits.DEFAULT.withResponse(Response.SENSOR));
    world.advanceTo(8);
    assertThat(world.impacts().outcome(0)).isEqualTo(Outcome.SENSED);

    world.setTraits(CIRCLE, 0, Traits.DEFAULT.withFilter(new Filter(0, 0)));
    world.setVelocity(0, -4, 0);
    world.advanceTo(12);
    assertThat(world.impacts().size()).isZero();
  }

  @Test
  void whatAKindCannotHaveIsRefused() {
    World world = new World(scene());
    Snapshot before = world.snapshot();

    refused("line 0: mass is 3.0: expected 1", () -> world.setTraits(LINE, 0, HEAVY));
    refused("peg 0: oneWay is true", () -> world.setTraits(PEG, 0, HALF.withOneWay(true)));
    refused("circle 0: oneWay is true", () -> world.setTraits(CIRCLE, 0, HALF.withOneWay(true)));
    refused("bounds: response is sensor", () -> world.setTraits(WALL, 0, sensor()));
    refused("line 1: mass is 3.0: expected 1", () -> world.addLine(0, 0, 1, 1, HEAVY));
    refused("peg 1: mass is 3.0: expected 1", () -> world.addPeg(0, 0, 1, HEAVY));
    refused(
        "circle 1: oneWay is true", () -> world.addCircle(9, 9, 1, 1, 1, HALF.withOneWay(true)));
    assertThat(world.snapshot()).isEqualTo(before);
    SceneBuilder builder = Scene.builder().bounds(0, 0, 9, 9);
    refused("bounds: response is sensor", () -> builder.traits(sensor()));
    refused("peg 0: mass is 3.0", () -> builder.peg(5, 5, 1).traits(HEAVY));
    assertThatIllegalStateException()
        .isThrownBy(() -> Scene.builder().traits(HALF))
        .withMessage("traits belongs to the thing added last: add one first");
  }

  private static Traits sensor() {
    return HALF.withResponse(Response.SENSOR);
  }

  private static void refused(String message, Runnable edit) {
    assertThatIllegalArgumentException().isThrownBy(edit::run).withMessageStartingWith(message);
  }
}
