// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.awt.Component;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Dialogs over a window. The chooser stays in the folder of the last file. */
final class SwingDialogs implements Dialogs {

  private final Component window;
  private final JFileChooser chooser = new JFileChooser(Path.of("").toAbsolutePath().toFile());

  SwingDialogs(Component window) {
    this.window = window;
    chooser.setFileFilter(new FileNameExtensionFilter("Scenes (*.csv)", "csv"));
  }

  @Override
  public Optional<Path> chooseToOpen() {
    return chosen(chooser.showOpenDialog(window));
  }

  @Override
  public Optional<Path> chooseToSave() {
    return chosen(chooser.showSaveDialog(window));
  }

  private Optional<Path> chosen(int answer) {
    return answer == JFileChooser.APPROVE_OPTION
        ? Optional.of(chooser.getSelectedFile().toPath())
        : Optional.empty();
  }

  @Override
  public boolean replaces(String question) {
    String[] answers = {"Replace", "Keep"};
    int answer =
        JOptionPane.showOptionDialog(
            window,
            question,
            "Carom",
            JOptionPane.YES_NO_OPTION,
            JOptionPane.QUESTION_MESSAGE,
            null,
            answers,
            answers[1]); // what Enter does loses nothing
    return answer == JOptionPane.YES_OPTION;
  }

  @Override
  public void shows(String title, String error) {
    JOptionPane.showMessageDialog(window, error, title, JOptionPane.ERROR_MESSAGE);
  }
}
