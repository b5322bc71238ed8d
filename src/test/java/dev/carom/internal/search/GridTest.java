// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.KindNumber;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Cells of size 8, over (-12, -12) to (92, 52) but where the tests say otherwise. */
class GridTest {

  /** The obstacles span (0, 0) to (80, 40); the grid has the radius and a ring of cells more. */
  private static Grid grid() {
    return new Grid(
        ObstacleTable.of(
            Internals.data(Scene.builder().line(0, 0, 80, 0).line(0, 40, 80, 40).build())),
        4,
        8,
        Grid.MARGIN);
  }

  private static Grid gridOf(SceneBuilder scene) {
    return new Grid(ObstacleTable.of(Internals.data(scene.build())), 4, 8, Grid.MARGIN);
  }

  @Test
  void itSurroundsAllThatCanBeTouched() {
    assertThat(grid().columns).isEqualTo(13);
    assertThat(grid().rows).isEqualTo(8);
    assertThat(grid().cells()).isEqualTo(104);
    Grid pegs = gridOf(Scene.builder().peg(0, 0, 10).peg(40, 0, 10));
    assertThat(pegs.columns).isEqualTo(11);
    assertThat(pegs.rows).isEqualTo(6);
  }

  @ParameterizedTest
  @CsvSource({
    "20, 20, true",
    "-12, -12, true",
    "92, 52, true",
    "-12.5, 20, false",
    "92.5, 20, false",
    "20, -12.5, false",
    "20, 52.5, false"
  })
  void itContainsWhatLiesWithinOrOnItsEdge(double x, double y, boolean contains) {
    assertThat(grid().contains(x, y)).isEqualTo(contains);
  }

  /** A path is inside as long as its place on both axes is. */
  @ParameterizedTest
  @CsvSource({
    "-112, 20, 2, 0, 0, 50",
    "192, 20, -2, 0, 0, 50",
    "20, -112, 0, 2, 0, 50",
    "20, 152, 0, -2, 0, 50",
    "-112, 20, 2, 0, 60, 60",
    "-112, 20, 2, 0, 102, 102",
    "-112, 20, 2, 0, 103, Infinity",
    "20, -112, 0, 2, 82, 82",
    "20, -112, 0, 2, 83, Infinity",
    "192, 20, -2, 0, 103, Infinity",
    "20, 152, 0, -2, 83, Infinity",
    "-112, 152, 1, -1, 0, 100",
    "-112, 252, 1, -1, 0, 200",
    "-112, 352, 1, -1, 0, Infinity",
    "-112, 52, 2, 0, 0, 50",
    "-112, -12, 2, 0, 0, 50",
    "-112, 53, 2, 0, 0, Infinity",
    "-112, -13, 2, 0, 0, Infinity",
    "92, -112, 0, 2, 0, 50",
    "93, -112, 0, 2, 0, Infinity"
  })
  void aPathComesInWhereItsLastAxisDoes(
      double x, double y, double vx, double vy, double from, double entry) {
    assertThat(grid().entry(x, y, vx, vy, from)).isEqualTo(entry);
  }

  /** Sizes below 2^40 cells, |xmin| + |ymin| = 24 included. */
  @Test
  void itResolvesPlacesThatAreNotTooFarAway() {
    Grid grid = grid();
    assertThat(grid.resolves(0x1p43 - 25, 0, 1)).isTrue();
    assertThat(grid.resolves(0x1p43 - 24, 0, 1)).isFalse();
    assertThat(grid.resolves(-0x1p42, -0x1p42, 1)).isFalse();
  }

  /** Between 2^-500 and 2^500 cells a unit of time. */
  @Test
  void itResolvesSpeedsWithinTheRange() {
    Grid grid = grid();
    assertThat(grid.resolves(0, 0, 0x1.fp502)).isTrue();
    assertThat(grid.resolves(0, 0, 0x1p503)).isFalse();
    assertThat(grid.resolves(0, 0, 0x1.1p-497)).isTrue();
    assertThat(grid.resolves(0, 0, 0x1p-497)).isFalse();
  }

  /** Columns begin at -12, -4, 4 ...: a reach that ends just before 84 is listed beyond it. */
  @Test
  void listsReachBeyondTheirCellByTheMargin() {
    double margin = 0x1p-8 * 8;
    Grid near = gridOf(Scene.builder().peg(0, 0, 0).peg(40 - 0.9 * margin, 0, 0));
    Grid far = gridOf(Scene.builder().peg(0, 0, 0).peg(40 - 1.1 * margin, 0, 0));
    int second = Codes.peg(1);
    assertThat((int) near.lists[near.number(7, 1)]).isEqualTo(second);
    assertThat(far.lists[far.number(7, 1)]).isZero();
    assertThat((int) far.lists[far.number(6, 1)]).isEqualTo(second);
  }

  /** A diagonal: what lies beside it in the box around it is out of reach. */
  @Test
  void cellsBesideALineDoNotListIt() {
    Grid grid = gridOf(Scene.builder().line(0, 0, 80, 80));
    int line = Codes.line(0);
    for (int row = 1; row < 12; row++) {
      for (int column = 1; column < 12; column++) {
        int apart = Math.abs(column - row);
        if (apart < 2) {
          assertThat((int) grid.lists[grid.number(column, row)]).isEqualTo(line);
        } else if (apart > 2) {
          assertThat(grid.lists[grid.number(column, row)]).isZero();
        }
      }
    }
  }

  /** The place of a long list is never 0, so one pair is there in any case. */
  @Test
  void twoInACellNeedNoRoomOfTheirOwn() {
    SceneBuilder scene = Scene.builder().peg(0, 0, 1).peg(0, 0, 2);
    assertThat(gridOf(scene).pairs).hasSize(1);
    assertThat(gridOf(scene.peg(80, 0, 1)).pairs).hasSize(1);
    assertThat(gridOf(scene.peg(0, 0, 1)).pairs).hasSizeGreaterThan(1);
  }

  /** All obstacles in a cell's list are found again, once or twice, lines and pegs apart. */
  @ParameterizedTest
  @CsvSource({
    "0, 0", "1, 0", "2, 0", "3, 0", "4, 0", "5, 0", "0, 1", "0, 2", "0, 3", "1, 1", "2, 1", "3, 2",
    "4, 5"
  })
  void whatIsListedIsFoundAgain(int lines, int pegs) {
    SceneBuilder scene = Scene.builder().peg(80, 40, 1).peg(-80, -40, 1);
    List<Integer> there = new ArrayList<>();
    for (int i = 0; i < lines; i++) {
      scene.line(0, 0, 1, i + 1);
      there.add(Codes.line(i));
    }
    for (int i = 0; i < pegs; i++) {
      scene.peg(1, i, 1);
      there.add(Codes.peg(2) + i);
    }
    Grid grid = gridOf(scene);
    int cell = grid.number(grid.column(grid.columns(1)), grid.row(grid.rows(1)));
    assertThat(listed(grid, grid.lists[cell])).containsExactlyElementsOf(there);
  }

  private static List<Integer> listed(Grid grid, long list) {
    List<Integer> codes = new ArrayList<>();
    if (list == 0) {
      return codes;
    }
    if (CellList.isPairOfLines(list) || CellList.areOthers(list)) {
      addPair(list, codes);
      return codes;
    }
    int k = CellList.start(list);
    do {
      addPair(grid.pairs[k], codes);
    } while (CellList.isMore(grid.pairs[k++]));
    return codes;
  }

  private static void addPair(long pair, List<Integer> codes) {
    codes.add(CellList.first(pair));
    if (CellList.second(pair) != CellList.first(pair)) {
      codes.add(CellList.second(pair));
    }
    assertThat(CellList.areOthers(pair))
        .isEqualTo(Codes.kind(CellList.second(pair)) == KindNumber.PEG);
  }
}
