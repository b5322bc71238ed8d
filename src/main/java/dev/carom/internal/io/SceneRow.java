// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.util.RefusedException;

/**
 * One row of a scene file, cut into fields: the word for its kind, then the plain fields of that
 * kind, then those of the form key=value.
 */
final class SceneRow {

  private final int line;
  private final String[] fields;

  /** Where each field begins, from 1; and at the end where the row ends. */
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

  /** The row that stands on a line of text; null if there is none, or only a comment. */
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

  /** Counts the fields before those of key=value, and checks that there are as many as needed. */
  private int countPlain() throws RowException {
    int n = 1;
    while (n < size() && fields[n].indexOf('=') < 0) {
      n++;
    }
    if (n < kind.required()) {
      throw error(n, kind.names().get(n) + " is missing: expected " + kind.shape());
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

  /** The number of fields. */
  int size() {
    return fields.length;
  }

  /** The number of fields before those of key=value. */
  int plain() {
    return plain;
  }

  /** Field i without the spaces around it. */
  String field(int i) {
    return fields[i];
  }

  /** Where field i begins, from 1. */
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

  /** The key of field i, which stands after the plain ones. */
  String key(int i) throws RowException {
    int equals = fields[i].indexOf('=');
    if (equals < 0) {
      throw error(i, SceneText.quoted(fields[i]) + " is out of place: expected key=value");
    }
    return fields[i].substring(0, SceneText.end(fields[i], 0, equals));
  }

  /** What stands after the key of field i. */
  String value(int i) {
    String field = fields[i];
    return field.substring(SceneText.start(field, field.indexOf('=') + 1, field.length()));
  }

  /** The finite number after the key of field i. */
  double option(int i) throws RowException {
    return number(i, value(i));
  }

  private double number(int i, String text) throws RowException {
    double number = SceneText.finite(text);
    if (Double.isNaN(number)) {
      String name = i < plain ? kind.names().get(i) : key(i);
      throw error(i, name + " is " + SceneText.quoted(text) + ": expected a finite number");
    }
    return number;
  }

  /** A mistake in field i, or at the end of the row if that is the number of fields. */
  RowException error(int i, String reason) {
    return new RowException(line, columns[i], reason);
  }

  /** What a check refused, at the field that holds the property. */
  RowException error(RefusedException refused) throws RowException {
    int i = kind.names().indexOf(refused.property());
    if (i < 0) {
      i = plain;
      while (!key(i).equals(refused.property())) {
        i++;
      }
    }
    return error(i, refused.reason());
  }
}
