// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Scene;
import dev.carom.SceneFormatException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Opens and saves scene files for a panel. What fails leaves the panel as it is. */
final class SceneFiles {

  private final ViewPanel panel;
  private final Dialogs dialogs;

  SceneFiles(ViewPanel panel, Dialogs dialogs) {
    this.panel = panel;
    this.dialogs = dialogs;
  }

  /** Lets the user choose a scene and shows it. */
  void open() {
    dialogs.chooseToOpen().ifPresent(this::open);
  }

  /** Shows a scene. */
  void open(Path file) {
    try {
      panel.play(name(file), Scene.read(file), null);
      panel.told("loaded " + file);
    } catch (SceneFormatException e) {
      String place = e.file() + ":" + e.line() + ":" + e.column() + ": ";
      dialogs.shows(
          "This is no scene",
          String.format(
              "%s%nline %d, column %d:%n%s",
              e.file(), e.line(), e.column(), e.getMessage().replace(place, "")));
    } catch (IOException | IllegalArgumentException e) {
      dialogs.shows("Cannot be opened", String.format("%s%n%s", file, reason(e)));
    }
  }

  /** Lets the user choose a file and saves what is shown as a scene. */
  void save() {
    dialogs.chooseToSave().ifPresent(this::save);
  }

  /** Saves what is shown as a scene; a file that is there is replaced only if the user says so. */
  void save(Path file) {
    if (Files.exists(file) && !dialogs.replaces(name(file) + " is there already. Replace it?")) {
      return;
    }
    try {
      panel.player().scene().write(file);
      panel.setTitle(name(file));
      panel.told("saved " + file);
    } catch (IOException e) {
      dialogs.shows("Cannot be saved", String.format("%s%n%s", file, reason(e)));
    }
  }

  private static String name(Path file) {
    return file.getFileName().toString();
  }

  /** The name of an error of files says more than its message, which is the file. */
  private static String reason(Exception e) {
    return e instanceof IOException ? e.getClass().getSimpleName() : e.getMessage();
  }
}
