// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import java.io.IOException;

/** Thrown when a row of a scene file does not follow the format. The message says what is wrong. */
public final class RowException extends IOException {

  private static final long serialVersionUID = 1;

  private final int line;
  private final int column;

  RowException(int line, int column, String reason) {
    super(reason);
    this.line = line;
    this.column = column;
  }

  /** The line of the mistake, from 1. */
  public int line() {
    return line;
  }

  /**
   * The column, from 1, at which the wrong field begins. If a field is missing, the column after
   * the end of the row.
   */
  public int column() {
    return column;
  }
}
