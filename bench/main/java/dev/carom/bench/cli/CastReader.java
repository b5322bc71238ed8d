// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.io.IOException;
import java.io.Reader;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;

/**
 * Reads a file of queries as a whole: its header says what is asked. Further columns are found by
 * name; one that is absent counts as 0, and unknown ones are passed over. Everything malformed is
 * an error that names file, line and column (in chars, from 1) and what was expected there.
 */
final class CastReader {

  /** Numbers are never quoted; taken as they stand, columns can be counted. */
  private static final CSVFormat FORMAT = CSVFormat.DEFAULT.builder().setQuote(null).get();

  private static final int QUOTED_CHARS = 60;

  private final String file;
  private final List<double[]> queries = new ArrayList<>();
  private CastQuery kind;
  private List<String> columns;

  /** Where each column stands in a row; negative if the file does not have it. */
  private int[] places;

  private CSVRecord row;
  private long line;

  CastReader(String file) {
    this.file = file;
  }

  /** The kind of question, known by the columns of the header. */
  CastQuery kind() {
    return kind;
  }

  /** One array a row, one number a column. */
  List<double[]> queries() {
    return queries;
  }

  /**
   * Reads to the end.
   *
   * @param in where to read; it is not closed
   * @throws IOException if the text is malformed
   * @throws java.io.UncheckedIOException if reading fails
   */
  void read(Reader in) throws IOException {
    CSVParser parser = CSVParser.builder().setReader(in).setFormat(FORMAT).get();
    Iterator<CSVRecord> rows = parser.iterator();
    if (!rows.hasNext()) {
      throw new IOException(file + ":1:1: the file is empty: expected " + headers());
    }
    row = rows.next();
    line = parser.getCurrentLineNumber();
    readHeader();
    while (rows.hasNext()) {
      row = rows.next();
      line = parser.getCurrentLineNumber();
      readQuery();
    }
  }

  private void readHeader() throws IOException {
    List<String> found =
        row.stream().map(name -> name.replace("\uFEFF", "").strip()).toList(); // of spreadsheets
    for (CastQuery candidate : CastQuery.values()) {
      List<String> first = List.of(candidate.header().split(","));
      if (found.size() >= first.size() && found.subList(0, first.size()).equals(first)) {
        kind = candidate;
        columns = Stream.concat(first.stream(), candidate.optional().stream()).toList();
        places = columns.stream().mapToInt(found::indexOf).toArray();
        return;
      }
    }
    throw malformed(0, "the header is " + quoted(String.join(",", row)), headers());
  }

  private static String headers() {
    return CastQuery.LINE.header() + " or " + CastQuery.PAIR.header();
  }

  private void readQuery() throws IOException {
    double[] query = new double[columns.size()];
    for (int i = 0; i < query.length; i++) {
      query[i] = places[i] < 0 ? 0 : number(columns.get(i), places[i]);
    }
    queries.add(query);
  }

  private double number(String column, int i) throws IOException {
    if (i >= row.size()) {
      throw malformed(i, column + " is missing", CastQuery.expectation(column));
    }
    String text = row.get(i);
    double value;
    try {
      value = hasSuffix(text.strip()) ? Double.NaN : Double.parseDouble(text);
    } catch (NumberFormatException e) {
      value = Double.NaN;
    }
    if (!CastQuery.accepts(column, value)) {
      throw malformed(i, column + " is " + quoted(text), CastQuery.expectation(column));
    }
    return value;
  }

  /** A text with escapes for quotation marks, and for what would break a line or a terminal. */
  private static String quoted(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    for (int i = 0; i < Math.min(text.length(), QUOTED_CHARS); i++) {
      char c = text.charAt(i);
      if (c == '"' || c == '\\') {
        quoted.append('\\').append(c);
      } else if (c >= ' ' && c <= '~') {
        quoted.append(c);
      } else {
        quoted.append(String.format("\\u%04x", (int) c));
      }
    }
    return quoted.append(text.length() > QUOTED_CHARS ? "...\"" : "\"").toString();
  }

  /** That of a type, which Java would take. */
  private static boolean hasSuffix(String number) {
    return !number.isEmpty() && "dDfF".indexOf(number.charAt(number.length() - 1)) >= 0;
  }

  private IOException malformed(int field, String found, String expected) {
    boolean missing = field >= row.size();
    int column = missing ? 0 : 1;
    for (int i = 0; i < Math.min(field, row.size()); i++) {
      column += row.get(i).length() + 1;
    }
    return new IOException(
        file + ":" + line + ":" + column + ": " + found + ": expected " + expected);
  }
}
