// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.peers.Peers;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.List;

/** Plays a map by all methods; what it finds are rows. */
public final class Survey {

  /** The prefix of the scenes' names. */
  public static final String SCENE = "stability:";

  /**
   * The metric of the classes, as ordinals of {@link CellOutcome}; their stats are {@link #CELL}.
   */
  public static final String OUTCOME = "stability_outcome";

  /** The metric of the limits, as ordinals of {@link CellLimit}. */
  public static final String LIMIT = "stability_limit";

  /** The metric of the values along the lower edge. */
  public static final String X = "stability_x";

  /** The metric of the values along the left edge. */
  public static final String Y = "stability_y";

  /** The name of the series, by cells from the lower left, or by values. */
  public static final String CELL = "at";

  /** The metric of the cells in which no circle was ever farther off than the stat, in radii. */
  public static final String WITHIN = "stability_within";

  private static final List<Double> LIMITS = List.of(CellJudge.RIGHT, 0.1);

  private static final String ONE = "1";

  private final FailureMap map;
  private final List<Cell> cells = new ArrayList<>();

  private Survey(FailureMap map) {
    this.map = map;
    for (int i = 0; i < map.size(); i++) {
      cells.add(map.cell(i));
    }
  }

  /**
   * Plays a map.
   *
   * @param contenders who plays
   * @return the rows: axes and limits under the first of the contenders, classes under each
   */
  public static List<Row> of(FailureMap map, List<Contender> contenders) {
    Survey survey = new Survey(map);
    List<Row> rows = new ArrayList<>();
    Contender first = contenders.get(0);
    survey.series(rows, first, X, map.x().values());
    survey.series(rows, first, Y, map.y().values());
    double[] limits = survey.cells.stream().mapToDouble(c -> c.limit().ordinal()).toArray();
    survey.series(rows, first, LIMIT, limits);
    contenders.forEach(contender -> survey.play(rows, contender));
    return rows;
  }

  /** The methods of the report: this library first. */
  public static List<Contender> contenders() {
    List<Contender> all = new ArrayList<>(List.of(Methods.CAROM, Methods.POSTER));
    all.addAll(List.of(Methods.POSTER_DOUBLE, Methods.TEXTBOOK_FLOAT, Methods.TEXTBOOK_DOUBLE));
    all.add(Methods.PLAIN_GRID);
    all.addAll(List.of(Methods.advancement(-6), Methods.OVERLAP, Methods.substeps(16)));
    all.addAll(Peers.all());
    return List.copyOf(all);
  }

  private void play(List<Row> rows, Contender contender) {
    try {
      contender.start(cells.get(0).scene()).close();
    } catch (UnsupportedOperationException e) {
      rows.add(row(contender, "failure", e.getMessage(), Double.NaN));
    }
    List<CellJudge.Judged> judged =
        cells.stream().map(cell -> CellJudge.of(contender, cell)).toList();
    double[] outcomes = judged.stream().mapToDouble(j -> j.outcome().ordinal()).toArray();
    series(rows, contender, OUTCOME, outcomes);
    for (double radii : LIMITS) {
      long within = judged.stream().filter(j -> j.isWithin(radii)).count();
      rows.add(row(contender, WITHIN, Double.toString(radii), (double) within));
    }
  }

  private void series(List<Row> rows, Contender contender, String metric, double[] values) {
    for (int i = 0; i < values.length; i++) {
      rows.add(row(contender, metric, CELL + "@" + i, values[i]));
    }
  }

  private Row row(Contender contender, String metric, String stat, double value) {
    return new Row(
        SCENE + map.name(),
        contender.method(),
        contender.knob(),
        metric,
        stat,
        value,
        ONE,
        map.size(),
        -1);
  }
}
