// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.io.StringReader;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Two things whose categories and masks have no bit in common do not exist for each other. */
class MasksTest {

  private static final int A = 2;
  private static final int B = 4;
  private static final int BOTH = A | B;

  // Walls.

  private static SceneBuilder box() {
    return Scene.builder().bounds(0, 0, 100, 100).filter(new Filter(1, ~A));
  }

  @CollidingOrNot
  void aCircleLeavesWallsThatItCannotMeet(boolean collide) {
    SceneBuilder scene = box().collide(collide).circle(50, 50, 10, 8, 0).filter(new Filter(A, -1));
    scene
        .circle(50, 20, 10, 8, 0)
        .line(120, 0, 120, 100)
        .line(300, 0, 400, 0)
        .filter(new Filter(B, B));
    World world = new World(scene.build());
    Timeline past = world.record(100);
    world.step(7);
    assertThat(world.x(0)).isEqualTo(106);
    assertThat(world.x(1)).isEqualTo(74); // 90 - 2 * 8
    assertThat(world.impacts().size()).isEqualTo(1);
    world.step(1);
    assertThat(Run.rows(world.impacts()))
        .extracting(Impact::time, Impact::circle, Impact::kind)
        .containsExactly(tuple(7.5, 0, Kind.LINE));
    world.step(20);
    assertThat(world.x(0)).isEqualTo(110 - 8 * 20.5);
    assertThat(past.x(0, 7)).isEqualTo(106);
    assertThat(past.x(0, 28)).isEqualTo(-54);
    assertThat(((Circle) past.shape(Kind.CIRCLE, 0, 28)).radius()).isEqualTo(10);
  }

  // Questions.

  private static World asked() {
    return new World(
        box()
            .collide(true)
            .line(50, 0, 50, 100)
            .filter(new Filter(A, -1))
            .peg(70, 50, 5)
            .filter(new Filter(1, ~B))
            .circle(30, 50, 5, 0, 0)
            .filter(new Filter(B, -1))
            .build());
  }

  @Test
  void castMeetsWhatTheAskerMeets() {
    World world = asked();
    assertThat(first(world)).isEqualTo("CIRCLE 10.0");
    assertThat(first(world.withFilter(new Filter(1, ~B)))).isEqualTo("LINE 35.0");
    assertThat(first(world.withFilter(new Filter(1, ~BOTH)))).isEqualTo("PEG 50.0");
    assertThat(first(world.withFilter(new Filter(B, ~BOTH)))).isEqualTo("WALL 85.0");
    assertThat(first(world.withFilter(new Filter(BOTH & ~B, ~BOTH & ~1)))).isEqualTo("none");
    assertThat(first(world.withFilter(new Filter(0, -1)))).isEqualTo("none");
  }

  private static String first(Resolver world) {
    Optional<Impact> impact = world.cast(new SweptCircle(10, 50, 5, 1, 0), 1000);
    return impact.map(i -> i.kind() + " " + i.time()).orElse("none");
  }

  private static Kind firstOfPath(Resolver world, Filter filter) {
    SweptCircle circle = new SweptCircle(10, 50, 5, 1, 0);
    return world.withFilter(filter).trace(circle, 1, 100, 1).impacts().get(0).kind();
  }

  @Test
  void traceMeetsWhatTheAskerMeets() {
    World world = asked();
    SweptCircle circle = new SweptCircle(10, 50, 5, 1, 0);
    assertThat(world.trace(circle, 1, 100, 1).impacts().get(0).kind()).isEqualTo(Kind.CIRCLE);
    assertThat(firstOfPath(world, new Filter(1, ~B))).isEqualTo(Kind.LINE);
    assertThat(firstOfPath(world, new Filter(1, ~BOTH))).isEqualTo(Kind.PEG);
    Filter none = new Filter(A, ~BOTH & ~1);
    assertThat(world.withFilter(none).trace(circle, 1, 100, 1).impacts()).isEmpty();
    assertThat(firstOfPath(world.scene().resolver(), Filter.DEFAULT)).isEqualTo(Kind.LINE);
  }

  /** The id of the nearest thing; -1 for none. */
  private static int nearest(Resolver world, Kind kind) {
    return world.nearest(0, 50, kind).map(Nearest::id).orElse(-1);
  }

  @Test
  void nearestAndOverlappingWithoutAFilterSeeWhatACastSees() {
    for (Kind kind : Kind.values()) {
      World world = hidden(kind);
      Circle disk = new Circle(50, 50, 60);
      Bounds box = new Bounds(-5, -5, 105, 105);
      assertThat(nearest(world, kind)).as("%s", kind).isEqualTo(-1);
      assertThat(nearest(world.withFilter(Filter.ALL), kind)).as("%s", kind).isZero();
      assertThat(world.overlapping(kind, disk)).as("%s", kind).isEmpty();
      assertThat(world.overlapping(kind, box)).as("%s", kind).isEmpty();
      assertThat(world.withFilter(Filter.ALL).overlapping(kind, disk)).as("%s", kind).isNotEmpty();
      assertThat(world.withFilter(Filter.ALL).overlapping(kind, box)).as("%s", kind).isNotEmpty();
      Resolver resolver = world.scene().resolver();
      assertThat(resolver.nearest(0, 50)).as("%s", kind).isEmpty();
      assertThat(resolver.overlapping(kind, disk)).as("%s", kind).isEmpty();
      assertThat(resolver.overlapping(kind, box)).as("%s", kind).isEmpty();
      assertThat(world.cast(new SweptCircle(new Circle(10, 50, 5), new Vec2(1, 0)), 1000))
          .as("%s", kind)
          .isEmpty();
    }
  }

  /** A world of one thing, which a circle of category 1 cannot meet. */
  private static World hidden(Kind kind) {
    SceneBuilder scene = Scene.builder();
    scene =
        switch (kind) {
          case WALL -> scene.bounds(0, 0, 100, 100);
          case LINE -> scene.line(50, 0, 50, 100);
          case PEG -> scene.peg(70, 50, 5);
          case CIRCLE -> scene.circle(30, 50, 5, 0, 0);
        };
    return new World(scene.filter(new Filter(A, B)).build());
  }

  @Test
  void nearestAndOverlappingSeeWhatTheAskerMeets() {
    World world = asked();
    Circle disk = new Circle(50, 50, 60);
    Bounds box = new Bounds(-5, -5, 105, 105);
    Kind[] kinds = Kind.values();
    int[] seen = {0, 0, 0, 0};
    int[] seenByB = {0, 0, -1, 0};
    int[] seenByA = {-1, 0, 0, 0};
    for (int k = 1; k < kinds.length; k++) {
      assertThat(nearest(world, kinds[k])).isEqualTo(seen[k]);
      assertThat(nearest(world.withFilter(new Filter(B, -1)), kinds[k])).isEqualTo(seenByB[k]);
      assertThat(nearest(world.withFilter(new Filter(A, -1)), kinds[k])).isEqualTo(seenByA[k]);
      assertThat(world.overlapping(kinds[k], disk)).hasSize(1);
      assertThat(world.overlapping(kinds[k], box)).hasSize(1);
      assertThat(world.withFilter(new Filter(B, -1)).overlapping(kinds[k], disk))
          .hasSize(1 + seenByB[k]);
      assertThat(world.withFilter(new Filter(B, -1)).overlapping(kinds[k], box))
          .hasSize(1 + seenByB[k]);
      assertThat(world.withFilter(new Filter(A, 0)).overlapping(kinds[k], disk)).isEmpty();
    }
    assertThat(nearest(world, Kind.WALL)).isZero();
    assertThat(nearest(world.withFilter(new Filter(A, -1)), Kind.WALL)).isEqualTo(-1);
    assertThat(world.overlapping(Kind.WALL, disk)).hasSize(4);
    assertThat(world.withFilter(new Filter(A, -1)).overlapping(Kind.WALL, disk)).isEmpty();
  }

  // Scenes.

  @Test
  void aSceneTellsTheFilters() {
    Scene scene = asked().scene();
    assertThat(scene.traits(Kind.WALL, 3).filter()).isEqualTo(new Filter(1, ~A));
    assertThat(scene.traits(Kind.LINE, 0).filter()).isEqualTo(new Filter(A, -1));
    assertThat(scene.traits(Kind.PEG, 0).filter()).isEqualTo(new Filter(1, ~B));
    assertThat(scene.traits(Kind.CIRCLE, 0).filter()).isEqualTo(new Filter(B, -1));
    assertThatThrownBy(() -> scene.traits(Kind.CIRCLE, 1).filter().mask())
        .isInstanceOf(IndexOutOfBoundsException.class)
        .hasMessage("circle 1 does not exist: the scene has 1 of them, from 0");
    assertThatThrownBy(() -> Scene.builder().filter(new Filter(1, 1)))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("filter belongs to the thing added last: add one first");
  }

  @Test
  void aFileHoldsTheFilters() throws IOException {
    StringBuilder text = new StringBuilder();
    asked().scene().write(text);
    assertThat(text.toString())
        .isEqualTo(
            """
            wall,0.0,0.0,100.0,100.0,mask=-3
            line,50.0,0.0,50.0,100.0,category=2
            peg,70.0,50.0,5.0,mask=-5
            circle,30.0,50.0,5.0,0.0,0.0,category=4
            """);
    Scene read = Scene.read(new StringReader(text.toString()), "it");
    assertThat(read).isEqualTo(asked().scene()).hasSameHashCodeAs(asked().scene());
    for (String row : text.toString().lines().toList()) {
      String without = text.toString().replace(row, row.replaceAll(",(category|mask)=.*", ""));
      assertThat(Scene.read(new StringReader(without), "it")).as(row).isNotEqualTo(read);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "1.5, 'it:1:14: mask is \"1.5\": expected a whole number from -2147483648 to 2147483647'",
    "4294967295, 'it:1:14: mask is \"4294967295\": expected a whole number from -2147483648 to"
        + " 2147483647'"
  })
  void aMaskIsAnInt(String mask, String message) {
    assertThatThrownBy(() -> Scene.read(new StringReader("peg,1,2,3.00,mask=" + mask), "it"))
        .isInstanceOf(SceneFormatException.class)
        .hasMessage(message);
  }

  @Test
  void warningsAreSilentAboutWhatIsKeptApart() {
    SceneBuilder builder =
        box()
            .collide(true)
            .line(0, 0, 9, 0)
            .filter(new Filter(1, ~A))
            .peg(0, 5, 1)
            .filter(new Filter(1, ~A))
            .circle(0, 0, 10, 0, 0)
            .filter(new Filter(A, 1))
            .circle(1, 1, 10, 0, 0)
            .filter(new Filter(B, -1));
    assertThat(builder.build().warnings())
        .extracting(w -> w.toString().substring(0, w.toString().indexOf(" is ")))
        .containsExactly(
            "circle 1: distance from the left wall",
            "circle 1: distance from the bottom wall",
            "circle 1: distance from line 0",
            "circle 1: distance from peg 0");
  }
}
