// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import java.io.IOException;

/** A row of a scene file does not follow the format. The message tells what is wrong. */
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

  /** Where the wrong field begins, from 1, or where the row ends that lacks a field. */
  public int column() {
    return column;
  }
}
