// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.util.Refusal;

/**
 * One row of a scene file, split into fields: the word for the kind, the positional fields of that
 * kind, then fields of the form key=value.
 */
final class SceneRow {

  private final int line;
  private final String[] fields;

  /** The column, from 1, at which each field begins; last, the column after the end of the row. */
  private final int[] columns;

  private final SceneRowKind kind;
  private final int plain;

  private SceneRow(int line, String text, int end) throws RowException {
    this.line = line;
    int size = 1 + SceneText.count(',', text, end);
    fields = new String[size];
    columns = new int[size + 1];
    cut(text, end);
    kind = SceneRowKind.of(fields[0]);
    if (kind == null) {
      String reason = SceneText.quoted(fields[0]) + " is unknown: expected ";
      throw error(0, reason + SceneRowKind.words());
    }
    plain = countPlain();
  }

  /** Parses a line of text; null if it is blank or holds only a comment. */
  static SceneRow of(int line, String text) throws RowException {
    int comment = text.indexOf('#');
    int end = SceneText.end(text, 0, comment < 0 ? text.length() : comment);
    return end == 0 ? null : new SceneRow(line, text, end);
  }

  private void cut(String text, int end) {
    int from = 0;
    for (int i = 0; i < fields.length; i++) {
      int comma = i + 1 < fields.length ? text.indexOf(',', from) : end;
      int start = SceneText.start(text, from, comma);
      fields[i] = text.substring(start, SceneText.end(text, start, comma));
      columns[i] = start + 1;
      from = comma + 1;
    }
    columns[fields.length] = end + 1;
  }

  /** Counts the fields before the first key=value, and checks that the kind allows so many. */
  private int countPlain() throws RowException {
    int n = 1;
    while (n < size() && fields[n].indexOf('=') < 0) {
      n++;
    }
    if (n < kind.required()) {
      throw error(n, kind.name(n) + " is missing: expected " + kind.shape());
    }
    if (n > kind.allowed()) {
      String excess = SceneText.quoted(fields[kind.allowed()]) + " is one field too many";
      throw error(kind.allowed(), excess + ": expected " + kind.shape());
    }
    return n;
  }

  SceneRowKind kind() {
    return kind;
  }

  int line() {
    return line;
  }

  int size() {
    return fields.length;
  }

  /** The number of fields before the first key=value. */
  int plain() {
    return plain;
  }

  /** Field i without the spaces around it. */
  String field(int i) {
    return fields[i];
  }

  /** The column, from 1, at which field i begins. */
  int column(int i) {
    return columns[i];
  }

  /** The finite numbers in the plain fields. */
  double[] numbers() throws RowException {
    double[] numbers = new double[plain - 1];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = number(i + 1);
    }
    return numbers;
  }

  /** The finite number in field i. */
  double number(int i) throws RowException {
    return number(i, fields[i]);
  }

  /** The key of field i, which must have the form key=value. */
  String key(int i) throws RowException {
    int equals = fields[i].indexOf('=');
    if (equals < 0) {
      throw error(i, SceneText.quoted(fields[i]) + " is out of place: expected key=value");
    }
    return fields[i].substring(0, SceneText.end(fields[i], 0, equals));
  }

  /** The text after the equals sign of field i. */
  String value(int i) {
    String field = fields[i];
    return field.substring(SceneText.start(field, field.indexOf('=') + 1, field.length()));
  }

  /** The finite number after the equals sign of field i. */
  double option(int i) throws RowException {
    return number(i, value(i));
  }

  private double number(int i, String text) throws RowException {
    double number = SceneText.finite(text);
    if (Double.isNaN(number)) {
      String name = i < plain ? kind.name(i) : key(i);
      throw error(i, name + " is " + SceneText.quoted(text) + ": expected a finite number");
    }
    return number;
  }

  /** An error at field i, or at the end of the row if i is the number of fields. */
  RowException error(int i, String reason) {
    return new RowException(line, columns[i], reason);
  }

  /** The field of a point that is refused, as "points[1]"; the first one of all points. */
  private static int place(String property) {
    int end = property.indexOf(']');
    return end < 0 ? 1 : 1 + 2 * Integer.parseInt(property.substring("points[".length(), end));
  }

  /** Locates a refused value: an error at the field that holds the property. */
  RowException error(IllegalArgumentException refusal) throws RowException {
    String property = Refusal.property(refusal);
    int i = kind.names().indexOf(property);
    if (i < 0) {
      i = plain;
      while (i < size() && !key(i).equals(property)) {
        i++;
      }
    }
    return error(i < size() ? i : place(property), Refusal.reason(refusal));
  }
}
