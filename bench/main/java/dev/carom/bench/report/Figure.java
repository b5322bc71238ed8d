// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Panel;
import dev.carom.bench.charts.Picture;
import dev.carom.bench.charts.Sheet;
import java.util.List;

/**
 * A figure of the report.
 *
 * @param id the name of its files, and its place in the page
 * @param heading what it is about
 * @param title what the reader is to take home, without a full stop
 * @param note how to read it
 * @param caption what it shows, in words: all that a reader who cannot see it needs
 * @param panels its pictures, of one width
 * @param table the numbers behind it
 */
public record Figure(
    String id,
    String heading,
    String title,
    String note,
    String caption,
    List<Panel> panels,
    ReportTable table) {

  /** Keeps a copy. */
  public Figure {
    panels = List.copyOf(panels);
  }

  /** All of it but the table, on one sheet. */
  public Picture picture() {
    return Sheet.of(title, note, panels);
  }
}
