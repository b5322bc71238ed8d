// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The numbers behind a figure, as text.
 *
 * @param head the titles of the columns
 * @param rows as many cells each
 */
public record ReportTable(List<String> head, List<List<String>> rows) {

  /** The table of a figure that needs none. */
  static final ReportTable NONE = new ReportTable(List.of(), List.of());

  /** Keeps a copy. */
  public ReportTable {
    head = List.copyOf(head);
    rows = rows.stream().map(List::copyOf).toList();
  }

  boolean isEmpty() {
    return rows.isEmpty();
  }

  /**
   * The table in columns, the first one to the left, the others to the right: lines of text, each
   * ended.
   */
  public String text() {
    List<List<String>> lines = Stream.concat(Stream.of(head), rows.stream()).toList();
    List<Integer> widths =
        IntStream.range(0, head.size())
            .mapToObj(i -> lines.stream().mapToInt(line -> line.get(i).length()).max().orElse(0))
            .toList();
    return lines.stream().map(line -> text(line, widths)).collect(Collectors.joining());
  }

  private static String text(List<String> line, List<Integer> widths) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < line.size(); i++) {
      String space = " ".repeat(widths.get(i) - line.get(i).length());
      text.append(i == 0 ? line.get(i) + space : "  " + space + line.get(i));
    }
    return text.toString().stripTrailing() + "\n";
  }
}
