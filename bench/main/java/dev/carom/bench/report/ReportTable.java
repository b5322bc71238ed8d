// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import java.util.ArrayList;
import java.util.List;

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
