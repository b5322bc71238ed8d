// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.io.IOException;

/**
 * A scene file does not follow the format of {@link Scene}. The message names the file, the line,
 * the column, what stands there and what was expected: {@code scene.csv:12:31: radius is "abc":
 * expected a finite number, more than 0}.
 */
final class SceneFormatException extends IOException {

  private static final long serialVersionUID = 1;

  /** The name of the file. */
  private final String file;

  /** The line, from 1. */
  private final int line;

  /** The column, from 1. */
  private final int column;

  SceneFormatException(String file, int line, int column, String reason) {
    super(file + ":" + line + ":" + column + ": " + reason);
    this.file = file;
    this.line = line;
    this.column = column;
  }

  /**
   * The file that was read.
   *
   * @return its path or name, as given to the reader
   */
  String file() {
    return file;
  }

  /**
   * The line of the mistake.
   *
   * @return its number, from 1
   */
  int line() {
    return line;
  }

  /**
   * The column of the mistake: where the field begins that is wrong, or where the row ends that
   * lacks a field.
   *
   * @return its number in chars, from 1
   */
  int column() {
    return column;
  }
}
