// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.report.ReportTable;
import java.io.PrintWriter;
import java.util.List;

/** Times at places of an axis, on the terminal. */
final class TextTable {

  private TextTable() {}

  /** Writes a table, whose first and third column are words, and sentences below it. */
  static void print(
      ReportTable table, List<String> below, PrintWriter out, String word, String number) {
    print(out, table.head(), word, number);
    table.rows().forEach(row -> print(out, row, word, number));
    out.println();
    below.forEach(out::println);
    out.flush();
  }

  private static void print(PrintWriter out, List<String> cells, String word, String number) {
    StringBuilder line = new StringBuilder();
    for (int i = 0; i < cells.size(); i++) {
      line.append(String.format(i == 0 || i == 2 ? word : number, cells.get(i)));
    }
    out.println(line.toString().stripTrailing());
  }
}
