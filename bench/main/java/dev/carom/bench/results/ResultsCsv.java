// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

import com.fasterxml.jackson.core.io.schubfach.DoubleToDecimal;
import java.io.IOException;
import java.io.Reader;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.csv.CSVException;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVPrinter;
import org.apache.commons.csv.CSVRecord;

/**
 * The rows as a tidy table, one a line, for other programs. Numbers are shortest decimals, {@code
 * NaN} or {@code Infinity}; reading gives the same bits back.
 */
public final class ResultsCsv {

  private static final String[] COLUMNS = {
    "scene", "method", "knob", "metric", "stat", "value", "unit", "n", "fork"
  };
  private static final CSVFormat FORMAT =
      CSVFormat.RFC4180.builder().setRecordSeparator('\n').get();
  private static final int VALUE = 5;
  private static final int N = 7;
  private static final int FORK = 8;

  private ResultsCsv() {}

  /**
   * Writes a table.
   *
   * @param rows what is to stand in it
   * @param file where; one that is there is replaced
   * @throws IOException if the file cannot be written
   */
  public static void write(List<Row> rows, Path file) throws IOException {
    StringWriter text = new StringWriter();
    try (CSVPrinter printer = new CSVPrinter(text, FORMAT)) {
      printer.printRecord((Object[]) COLUMNS);
      for (Row r : rows) {
        String value = DoubleToDecimal.toString(r.value());
        printer.printRecord(
            r.scene(),
            r.method(),
            r.knob(),
            r.metric(),
            r.stat(),
            value,
            r.unit(),
            r.n(),
            r.fork());
      }
    }
    WholeFile.write(file, text.toString());
  }

  /**
   * Reads a table back.
   *
   * @throws IOException if it cannot be read, or is no such table: the message names the file, the
   *     line, and what was expected
   */
  public static List<Row> read(Path file) throws IOException {
    List<Row> rows = new ArrayList<>();
    try (Reader reader = Files.newBufferedReader(file);
        CSVParser parser = CSVParser.parse(reader, FORMAT)) {
      boolean head = true;
      for (CSVRecord row : parser) {
        long line = parser.getCurrentLineNumber();
        if (head) {
          checkHead(file, row);
        } else {
          rows.add(new Cells(file, line, row).row());
        }
        head = false;
      }
      if (head) {
        throw new IOException(file + ":1: empty: expected the line " + String.join(",", COLUMNS));
      }
    } catch (CSVException e) {
      throw new IOException(file + ": " + e.getMessage(), e);
    } catch (UncheckedIOException e) {
      throw new IOException(file + ": " + e.getCause().getMessage(), e);
    }
    return rows;
  }

  private static void checkHead(Path file, CSVRecord head) throws IOException {
    if (!Arrays.equals(head.values(), COLUMNS)) {
      throw new IOException(
          file + ":1: " + String.join(",", head) + ": expected " + String.join(",", COLUMNS));
    }
  }

  /** The cells of one line. */
  private record Cells(Path file, long line, CSVRecord cells) {

    Row row() throws IOException {
      if (cells.size() != COLUMNS.length) {
        throw new IOException(
            "%s:%d: %d cells: expected %d".formatted(file, line, cells.size(), COLUMNS.length));
      }
      return new Row(
          cells.get(0),
          cells.get(1),
          cells.get(2),
          cells.get(3),
          cells.get(4),
          decimal(),
          cells.get(6),
          whole(N, Long.MAX_VALUE),
          (int) whole(FORK, Integer.MAX_VALUE));
    }

    private double decimal() throws IOException {
      try {
        return Double.parseDouble(cells.get(VALUE));
      } catch (NumberFormatException e) {
        throw refused(VALUE, "a number, NaN or Infinity");
      }
    }

    private long whole(int column, long most) throws IOException {
      try {
        long value = Long.parseLong(cells.get(column));
        if (value >= -1 && value <= most) {
          return value;
        }
      } catch (NumberFormatException e) {
        // Refused below, as what is out of range is.
      }
      throw refused(column, "a whole number from -1 to " + most);
    }

    private IOException refused(int column, String expected) {
      return new IOException(
          "%s:%d: %s is \"%s\": expected %s"
              .formatted(file, line, COLUMNS[column], cells.get(column), expected));
    }
  }
}
