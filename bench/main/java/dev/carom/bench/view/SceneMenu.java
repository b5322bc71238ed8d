// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.bench.duel.Preset;
import dev.carom.bench.examples.ExampleWindow;
import dev.carom.bench.examples.Examples;
import dev.carom.bench.reference.References;
import dev.carom.bench.stability.FailureMap;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.WindowConstants;

/** The menu of scenes: the experiment's, those in which methods fail, and the examples. */
final class SceneMenu {

  private final ViewPanel panel;
  private final Dialogs dialogs;

  SceneMenu(ViewPanel panel, Dialogs dialogs) {
    this.panel = panel;
    this.dialogs = dialogs;
  }

  JMenu menu() {
    JMenu menu = new JMenu("Scenes");
    menu.setMnemonic('S');
    JMenu experiment = new JMenu("The experiment");
    References.SCENES.forEach(name -> experiment.add(item(SceneChoice.stored(name))));
    menu.add(experiment);
    JMenu failures = new JMenu("Where methods fail");
    for (Preset preset : Preset.values()) {
      JMenuItem item = new JMenuItem(preset.about());
      item.addActionListener(event -> panel.duel(preset));
      failures.add(item);
    }
    menu.add(failures);
    JMenu maps = new JMenu("Maps of failures");
    FailureMap.all(true).forEach(map -> maps.add(rows(map)));
    menu.add(maps);
    JMenu examples = new JMenu("Examples");
    for (Examples example : Examples.values()) {
      JMenuItem item = new JMenuItem(example + ": " + example.about());
      item.addActionListener(event -> open(example));
      examples.add(item);
    }
    menu.add(examples);
    return menu;
  }

  private JMenu rows(FailureMap map) {
    JMenu rows = new JMenu(map.heading());
    for (int row = 0; row < map.y().values().length; row++) {
      JMenu cells = new JMenu(map.y().label() + ": " + map.y().text().apply(map.y().values()[row]));
      for (int column = 0; column < map.x().values().length; column++) {
        cells.add(item(SceneChoice.of(map, column, row)));
      }
      rows.add(cells);
    }
    return rows;
  }

  private JMenuItem item(SceneChoice choice) {
    JMenuItem item = new JMenuItem(choice.title());
    item.addActionListener(event -> show(choice));
    return item;
  }

  private void show(SceneChoice choice) {
    try {
      panel.play(choice.title(), choice.scene().get(), choice.truth().get());
    } catch (IllegalArgumentException | IllegalStateException e) {
      dialogs.shows("Cannot be shown", choice.title() + "\n" + e.getMessage());
    }
  }

  private static void open(Examples example) {
    JFrame frame = ExampleWindow.of("Carom: " + example.about(), example.start());
    frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
    frame.setLocationByPlatform(true);
    frame.setVisible(true);
  }
}
