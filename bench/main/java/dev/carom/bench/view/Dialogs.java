// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.nio.file.Path;
import java.util.Optional;

/** The questions and messages of the window. */
interface Dialogs {

  /** A file to be read; empty if none was chosen. */
  Optional<Path> chooseToOpen();

  /** A file to be written; empty if none was chosen. */
  Optional<Path> chooseToSave();

  /** Whether a file that is there is to be replaced. */
  boolean replaces(String question);

  /** Shows an error until it was read. */
  void shows(String title, String error);
}
