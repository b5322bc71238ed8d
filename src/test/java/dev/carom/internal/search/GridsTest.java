// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.ObstacleTable;
import org.junit.jupiter.api.Test;

/** Which grids there are, whom they serve, and when they are made anew. */
class GridsTest {

  private static final int MANY = 16;

  /** So much may be loose beside the grids: 8 and the root of {@link #MANY}. */
  private static final int LOOSE = 12;

  private static Scene scene(int pegs) {
    SceneBuilder scene = Scene.builder().circle(0, 50, 3, 0, 0);
    for (int i = 0; i < pegs; i++) {
      scene.peg(10 * i, 0, 1);
    }
    return scene.build();
  }

  private static Grids grids(Scene scene) {
    return new Grids(
        Internals.data(scene), ObstacleTable.of(Internals.data(scene)), EngineOptions.CHOSEN);
  }

  @Test
  void aFewPegsNeedNoGrid() {
    assertThat(grids(scene(8)).of(3)).isNull();
    assertThat(grids(scene(9)).of(3)).isNotNull();
    assertThat(grids(scene(8)).ofNew(3)).isNull();
  }

  @Test
  void norDoThoseThatAreTooFarAway() {
    SceneBuilder scene = Scene.builder().circle(0, 0, 0x1p390, 0, 0);
    for (int i = 0; i < MANY; i++) {
      scene.peg(i * 0x1p395, 0, 0);
    }
    assertThat(grids(scene.peg(0x1p399, 0, 0).build()).of(0x1p390)).isNotNull();
    assertThat(grids(scene.peg(0x1p400, 0, 0).build()).of(0x1p390)).isNull();
  }

  @Test
  void aGridServesRadiiOfItsClassUpToItsOwn() {
    Grids grids = grids(scene(MANY));
    Grid grid = grids.of(3);
    assertThat(grids.serve(grid, 3)).isTrue();
    assertThat(grids.serve(grid, 2)).isTrue();
    assertThat(grids.serve(grid, 3.5)).isFalse();
    assertThat(grids.serve(grid, 1.5)).isFalse();
    assertThat(grids.serve(null, 3)).isFalse();
    grids.forget();
    assertThat(grids.serve(grid, 3)).isFalse();
    assertThat(grids.serve(null, 3)).isFalse();
    assertThat(grids(scene(8)).serve(null, 3)).isTrue();
  }

  @Test
  void aNewRadiusHasItsGridMade() {
    Grids grids = grids(scene(MANY));
    Grid grid = grids.of(3);
    assertThat(grids.ofNew(3)).isSameAs(grid);
    assertThat(grids.ofNew(2.5)).isSameAs(grid);
    assertThat(grids.ofNew(5).radius).isEqualTo(8);
    assertThat(grids.of(7)).isSameAs(grids.ofNew(6));
    assertThat(grids.ofNew(3.5)).isNotSameAs(grid).isSameAs(grids.of(3));
    assertThat(grids.of(3).radius).isEqualTo(4);
  }

  /** Notes changes of pegs from the first one on. */
  private static void change(Grids grids, int pegs) {
    for (int i = 0; i < pegs; i++) {
      grids.changed(Codes.peg(i));
    }
  }

  @Test
  void gridsAreMadeAnewWhenTooMuchIsLoose() {
    Grids grids = grids(scene(MANY));
    assertThat(grids.areStale()).isFalse();
    change(grids, LOOSE);
    assertThat(grids.loose().size).isEqualTo(LOOSE);
    assertThat(grids.areStale()).isFalse();
    change(grids, LOOSE + 1);
    assertThat(grids.areStale()).isTrue();
    assertThat(grids.areStale()).as("since then nothing changed").isFalse();
  }

  /** The last two are not kept any more. */
  @Test
  void andWhenSomethingIsNotEvenAmongWhatIsLoose() {
    Grids grids = grids(scene(MANY));
    change(grids, LOOSE + 3);
    assertThat(grids.loose().size).isEqualTo(LOOSE + 1);
    assertThat(grids.areStale()).isTrue();
  }

  @Test
  void gridsThatWereForgottenAreMadeAnewWhereTheyAreWanted() {
    Grids many = grids(scene(MANY));
    many.forget();
    assertThat(many.areStale()).isTrue();
    Grids few = grids(scene(8));
    few.forget();
    assertThat(few.areStale()).isFalse();
  }

  /** One circle got its grid at once; the others still need theirs. */
  @Test
  void aGridForOneCircleDoesNotMakeUpForThoseForgotten() {
    Grids grids = grids(scene(MANY));
    grids.forget();
    assertThat(grids.ofNew(50)).isNotNull();
    assertThat(grids.areStale()).isTrue();
  }

  @Test
  void theyAreMadeForTheRadiiThatThereAre() {
    Scene scene = scene(MANY);
    Grids grids = grids(scene);
    change(grids, LOOSE + 1);
    Grid old = grids.of(3);
    CircleTable circles = new CircleTable(1);
    circles.start(Internals.data(scene), 0);
    circles.storeAndSetDue(0);
    grids.remake(circles, new int[] {0});
    assertThat(grids.of(3)).isNotNull().isNotSameAs(old);
    assertThat(grids.of(8)).isNull();
    assertThat(grids.loose().size).isZero();
    assertThat(grids.areStale()).isFalse();
  }
}
