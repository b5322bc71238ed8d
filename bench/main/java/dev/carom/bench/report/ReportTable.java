// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The numbers behind a figure, as text.
 *
 * @param head the titles of the columns
 * @param rows as many cells each
 */
public record ReportTable(List<String> head, List<List<String>> rows) {

  /** Keeps a copy. */
  public ReportTable {
    head = List.copyOf(head);
    rows = rows.stream().map(List::copyOf).toList();
  }

  /**
   * The table in columns, the first one to the left, the others to the right: lines of text, each
   * ended.
   */
  public String text() {
    int[] widths = new int[head.size()];
    Stream.concat(Stream.of(head), rows.stream())
        .forEach(
            row -> {
              for (int i = 0; i < widths.length; i++) {
                widths[i] = Math.max(widths[i], row.get(i).length());
              }
            });
    StringBuilder text = new StringBuilder();
    Stream.concat(Stream.of(head), rows.stream())
        .forEach(row -> text.append(line(row, widths)).append('\n'));
    return text.toString();
  }

  private static String line(List<String> row, int[] widths) {
    StringBuilder line = new StringBuilder();
    for (int i = 0; i < widths.length; i++) {
      String space = " ".repeat(widths[i] - row.get(i).length());
      line.append(i == 0 ? row.get(i) + space : "  " + space + row.get(i));
    }
    return line.toString().stripTrailing();
  }

  /** An empty table that rows are added to. */
  static final class Builder {
    private final List<String> head;
    private final List<List<String>> rows = new ArrayList<>();

    Builder(String... head) {
      this.head = List.of(head);
    }

    Builder(List<String> head) {
      this.head = head;
    }

    void row(List<String> cells) {
      rows.add(cells);
    }

    void row(String... cells) {
      rows.add(List.of(cells));
    }

    ReportTable build() {
      return new ReportTable(head, rows);
    }
  }
}
