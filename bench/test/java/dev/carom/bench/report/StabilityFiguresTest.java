// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.stability.CellLimit;
import dev.carom.bench.stability.CellOutcome;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Words, table and picture of a made-up map of two rows and three columns. */
class StabilityFiguresTest {

  private static final int N = 6;

  private final List<Row> rows = new ArrayList<>();

  private void series(String method, String metric, double... values) {
    for (int i = 0; i < values.length; i++) {
      rows.add(new Row("stability:gap", method, "", metric, "at@" + i, values[i], "1", N, -1));
    }
  }

  private void limits(CellLimit last) {
    series("carom", "stability_x", 0.9, 1, 1.1);
    series("carom", "stability_y", 0.01, 1);
    series("carom", "stability_limit", 0, 0, 0, 0, 0, last.ordinal());
  }

  private void outcomes(String method, CellOutcome last) {
    series(method, "stability_outcome", 0, 0, 0, 0, 0, last.ordinal());
  }

  private void engine(String method, String knob, int right, double coarse) {
    for (int i = 0; i < N; i++) {
      double outcome = (i < right ? CellOutcome.RIGHT : CellOutcome.DRIFTED).ordinal();
      rows.add(
          new Row(
              "stability:gap", method, knob, "stability_outcome", "at@" + i, outcome, "1", N, -1));
    }
    rows.add(new Row("stability:gap", method, knob, "stability_within", "0.1", coarse, "1", N, -1));
  }

  @Test
  void theTitleNamesTheBestOfTheOthersAndTheBestEngine() {
    limits(CellLimit.NONE);
    outcomes("carom", CellOutcome.RIGHT);
    engine("gdx-box2d", "setting=best", 2, 2);
    engine("jbox2d", "setting=best", 3, 3);
    outcomes("plain-grid", CellOutcome.RIGHT);
    outcomes("textbook-double", CellOutcome.RIGHT);

    assertThat(figure().title())
        .isEqualTo(
            "Carom is right in 100 % of 6 scenes; plain + grid: 100 %; best engine, JBox2D tuned: 50.0 %");
  }

  @Test
  void ofSettingsThatAreNeverRightTheOneThatIsNearlyRightIsDrawn() {
    limits(CellLimit.NONE);
    outcomes("carom", CellOutcome.RIGHT);
    engine("gdx-box2d", "setting=defaults, 30 px/m", 0, 1);
    engine("gdx-box2d", "setting=best", 0, 3);

    assertThat(figure().title())
        .isEqualTo("Carom is right in 100 % of 6 scenes; best engine, Box2D tuned: 0 %");
    assertThat(svg()).contains(">tuned: 0 %<").doesNotContain(">defaults");
  }

  /** Also one that no other chart has. */
  @Test
  void whomTheTitleNamesHasAPanel() {
    limits(CellLimit.NONE);
    outcomes("carom", CellOutcome.RIGHT);
    outcomes("plain-grid", CellOutcome.NO_ANSWER);
    outcomes("textbook-float", CellOutcome.RIGHT);

    assertThat(figure().title()).endsWith("; textbook float: 100 %");
    assertThat(svg()).contains(">textbook float<", ">plain + grid<");
  }

  private Figure figure() {
    return new StabilityFigures(new Results(Sample.METADATA, rows)).figures().get(0);
  }

  @Test
  void ofTheOthersTheBestIsTold() {
    limits(CellLimit.NONE);
    outcomes("carom", CellOutcome.RIGHT);
    outcomes("overlap", CellOutcome.ESCAPED);
    outcomes("poster", CellOutcome.RIGHT);

    assertThat(figure().picture().title())
        .startsWith("Carom is right in 100 % of 6 scenes; published 2010: 100 %. A ball");
    assertThat(figure().id()).isEqualTo("fails-gap");
  }

  @Test
  void aFailureOfCaromIsTold() {
    limits(CellLimit.NONE);
    outcomes("carom", CellOutcome.FAR_OFF);

    assertThat(figure().title()).startsWith("Carom is right in 83.3 % of 6 scenes");
  }

  @Test
  void theDarkCornerIsInTheLegend() {
    limits(CellLimit.PILE_UP);
    outcomes("carom", CellOutcome.DRIFTED);
    outcomes("overlap", CellOutcome.ESCAPED);

    assertThat(figure().title()).startsWith("Carom is right in 83.3 % of 6 scenes");
    assertThat(svg()).contains(">nobody can be right<");
  }

  private String svg() {
    return new String(figure().picture().svg(), StandardCharsets.UTF_8);
  }

  @Test
  void whoCannotPlayHasNoPanelButALine() {
    limits(CellLimit.NONE);
    outcomes("carom", CellOutcome.RIGHT);
    outcomes("overlap", CellOutcome.NO_ANSWER);
    rows.add(new Row("stability:gap", "overlap", "", "failure", "why", Double.NaN, "1", 1, -1));

    assertThat(figure().picture().title()).endsWith(" overlap test cannot play such scenes.");
    assertThat(svg()).contains(">Carom<").doesNotContain(">overlap test<");
    assertThat(matrix().rows()).extracting(row -> row.get(0)).containsExactly("Carom");
  }

  private ReportTable matrix() {
    return new StabilityMatrix(new Results(Sample.METADATA, rows)).table();
  }

  @Test
  void theTableHasTheSharesAtBothLimits() {
    limits(CellLimit.NONE);
    series("carom", "stability_outcome", 0, 1, 2, 3, 4, 5);
    engine("jbox2d", "setting=best", 3, 6);

    assertThat(matrix().head())
        .containsExactly(
            "right at 0.001 and at 0.1 radius", "gap between two lines and speed", "all it plays");
    assertThat(matrix().rows())
        .containsExactly(
            List.of("Carom", "16.7 %", "16.7 %"),
            List.of("JBox2D tuned", "50.0 % | 100 %", "50.0 % | 100 %"));
  }

  /** Signs tell classes apart on grey paper; and neighbours of one class share a rectangle. */
  @Test
  void classesDifferInMoreThanColour() {
    limits(CellLimit.NONE);
    series("carom", "stability_outcome", 0, 0, 0, 0, 0, 0);
    long none = lines(svg());
    rows.removeIf(row -> row.metric().equals("stability_outcome"));
    series("carom", "stability_outcome", 1, 2, 3, 4, 5, 0);

    assertThat(lines(svg())).isEqualTo(none + 6 - 2 + 2 * (1 + 2 + 1 + 2 + 1));
  }

  /** Moves of the pen: a dot, a bar and a slash have one, a cross and an arrow two. */
  private static long lines(String svg) {
    return Pattern.compile(" d='([^']*)'")
        .matcher(svg)
        .results()
        .flatMapToInt(path -> path.group(1).chars())
        .filter(letter -> letter == 'M')
        .count();
  }
}
