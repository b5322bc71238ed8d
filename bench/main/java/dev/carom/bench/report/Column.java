// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Spread;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * A column of a table that has a row for each standing.
 *
 * @param head its title
 * @param cell the text of each row
 */
record Column(String head, Function<Standing, String> cell) {

  static final Column SETTING = new Column("setting", s -> Glossary.fullName(s.setting()));
  static final Column SHORT_SETTING = new Column("setting", Standing::name);
  static final Column SCENE = new Column("scene", Standing::scene);

  private static final String NOT_MEASURED = "-";
  private static final String FAILED = "failed";

  /** The median over forks of one number. */
  static Column of(String head, String metric, String stat, DoubleFunction<String> text) {
    return new Column(head, s -> cell(s.spread(metric, stat), found -> text.apply(found.middle())));
  }

  /** A time, and in brackets from where to where forks reach. */
  static Column time(String head, String metric, String stat) {
    return new Column(head, s -> cell(s.spread(metric, stat), ReportNumbers::spread));
  }

  /**
   * How many times as much as Carom in the same scene; in brackets the least and the greatest that
   * the forks allow.
   */
  static Column ratio(String head, String metric, String stat) {
    return new Column(
        head,
        s -> {
          Optional<Spread> ours = s.with(Metrics.CAROM).spread(metric, stat);
          return cell(
              s.spread(metric, stat).filter(theirs -> ours.isPresent()),
              theirs -> ReportNumbers.ratio(theirs, ours.get()));
        });
  }

  private static String cell(Optional<Spread> found, Function<Spread, String> text) {
    return found.map(spread -> spread.failed() ? FAILED : text.apply(spread)).orElse(NOT_MEASURED);
  }

  static ReportTable table(List<Standing> rows, Column... columns) {
    return new ReportTable(
        Stream.of(columns).map(Column::head).toList(),
        rows.stream()
            .map(row -> Stream.of(columns).map(column -> column.cell.apply(row)).toList())
            .toList());
  }
}
