// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.BarChart;
import dev.carom.bench.charts.BarChart.Bar;
import dev.carom.bench.charts.Marks;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.charts.Picture;
import dev.carom.bench.charts.Sheet;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * A figure of the report: pictures with the numbers behind them, or a table alone.
 *
 * @param id the name of its files, and its place in the page
 * @param heading what it is about
 * @param title what the reader is to take home, without a full stop
 * @param note how to read it
 * @param panels its pictures, of one width
 * @param table the numbers, if they say more than the pictures
 */
public record Figure(
    String id, String heading, String title, String note, List<Panel> panels, ReportTable table) {

  private static final Map<String, List<String>> TEXTS = Texts.table("figures.txt");
  private static final String BREAK = "\n";

  /** What stands behind a factor. */
  static final String TIMES = " x";

  /** Keeps a copy. */
  public Figure {
    panels = panels.stream().map(panel -> untitled(panel, title)).toList();
  }

  /** A panel does not say again what the figure says. */
  private static Panel untitled(Panel panel, String title) {
    return panel.title().equals(title) ? new Panel("", panel.picture()) : panel;
  }

  /**
   * A figure whose heading and note are kept as texts, by its id, or by how that begins.
   *
   * @param words what they leave open
   */
  static Figure of(
      String id, String title, List<Panel> panels, ReportTable table, Object... words) {
    List<String> texts =
        TEXTS.containsKey(id) ? TEXTS.get(id) : TEXTS.get(id.substring(0, id.indexOf('-') + 1));
    String[] filled = String.join(BREAK, texts).formatted(words).split(BREAK, -1);
    return new Figure(id, filled[0], title, filled[1], panels, table);
  }

  /** The figures of these ids, in this order; an id that ends with a hyphen stands for many. */
  static Stream<Figure> named(String ids, List<Figure> figures) {
    return Stream.of(ids.split(" ")).flatMap(id -> figures.stream().filter(f -> f.isOf(id)));
  }

  private boolean isOf(String name) {
    return id.equals(name) || (name.endsWith("-") && id.startsWith(name));
  }

  /** All of it but the table, on one sheet. */
  public Picture picture() {
    return Sheet.of(title, note, panels);
  }

  /** A panel with a bar for each standing, of which there is one at least. */
  static Panel bars(
      String title,
      List<Standing> standings,
      Function<Standing, String> name,
      String metric,
      String stat,
      DoubleFunction<String> text) {
    Marks marks = Settings.marks(standings.get(0).results());
    List<Bar> bars = new ArrayList<>();
    for (Standing s : standings) {
      double value = s.value(metric, stat);
      bars.add(new Bar(name.apply(s), marks.color(s.method()), value, text.apply(value)));
    }
    return new Panel(title, new BarChart(title, bars).picture());
  }
}
