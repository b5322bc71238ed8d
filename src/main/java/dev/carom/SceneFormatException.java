// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.io.RowException;
import java.io.IOException;

/**
 * A {@code SceneFormatException} reports a scene file that does not follow the format of {@link
 * Scene}, or holds what {@link SceneBuilder} refuses. It gives the place of the mistake, so that an
 * editor can point at it.
 *
 * <p>The message names the file, the line, the column, the text found there and what was expected:
 * {@code scene.csv:12:31: radius is "abc": expected a finite number}.
 */
public final class SceneFormatException extends IOException {

  private static final long serialVersionUID = 1;

  /** The name of the file. */
  private final String file;

  /** The line, from 1. */
  private final int line;

  /** The column, from 1. */
  private final int column;

  SceneFormatException(String file, RowException mistake) {
    super(
        file + ":" + mistake.line() + ":" + mistake.column() + ": " + mistake.getMessage(),
        mistake);
    this.file = file;
    line = mistake.line();
    column = mistake.column();
  }

  /**
   * Returns the file that was read.
   *
   * @return its path or name, as given to {@link Scene#read(java.nio.file.Path) Scene.read}
   */
  public String file() {
    return file;
  }

  /**
   * Returns the line of the mistake.
   *
   * @return its number, from 1
   */
  public int line() {
    return line;
  }

  /**
   * Returns the column of the mistake. It is where the wrong field begins, or where the row ends
   * that lacks a field.
   *
   * @return its number in chars, from 1; a byte order mark does not count
   */
  public int column() {
    return column;
  }
}
