// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.Timer;

/** The window around a {@link ViewPanel}: its menu, its timer. */
public final class ViewWindow {

  private static final int MILLIS = 1000 / 60;

  private ViewWindow() {}

  /**
   * Makes the window; on the event thread, and where there is a screen.
   *
   * @param title of the window
   * @param player what it shows
   * @return the window, to be shown
   */
  public static JFrame of(String title, Player player) {
    JFrame frame = new JFrame(title);
    ViewPanel panel = new ViewPanel(player);
    frame.add(panel);
    JMenu file = new JMenu("File");
    file.add(item("Open scene...", "ctrl O", frame, JFileChooser.OPEN_DIALOG, panel::load));
    file.add(item("Save as scene...", "ctrl S", frame, JFileChooser.SAVE_DIALOG, panel::save));
    JMenuBar bar = new JMenuBar();
    bar.add(file);
    frame.setJMenuBar(bar);
    frame.pack();
    new Timer(MILLIS, event -> panel.tick()).start();
    return frame;
  }

  private static JMenuItem item(
      String name, String keys, JFrame frame, int dialog, Consumer<Path> action) {
    JMenuItem item = new JMenuItem(name);
    item.setAccelerator(KeyStroke.getKeyStroke(keys));
    item.addActionListener(
        event -> {
          JFileChooser chooser = new JFileChooser(Path.of("").toAbsolutePath().toFile());
          chooser.setDialogType(dialog);
          if (chooser.showDialog(frame, null) == JFileChooser.APPROVE_OPTION) {
            action.accept(chooser.getSelectedFile().toPath());
          }
        });
    return item;
  }
}
