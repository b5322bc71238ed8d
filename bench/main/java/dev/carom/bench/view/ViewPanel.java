// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Scene;
import dev.carom.bench.view.ScenePainter.Layer;
import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.KeyStroke;

/**
 * A player with its buttons: what stands in the window. Space runs and pauses, the right arrow goes
 * on by one frame, I by one impact; circles, lines and their ends can be dragged.
 */
public final class ViewPanel extends JPanel {

  private static final long serialVersionUID = 1;

  /** Positions of the slider. */
  private static final int SLIDER = 10_000;

  private static final Double[] SPEEDS = {0.01, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 10.0, 100.0};

  private final transient Player player;
  private final SceneCanvas canvas;
  private final JButton run = new JButton();
  private final JSlider slider = new JSlider(0, SLIDER, 0);
  private final JLabel status = new JLabel(" ");
  private boolean refreshing;
  private String message = "";

  /**
   * Makes the panel.
   *
   * @param player what it shows
   */
  public ViewPanel(Player player) {
    super(new BorderLayout());
    this.player = player;
    canvas = new SceneCanvas(player, this::told);
    add(buttons(), BorderLayout.NORTH);
    add(canvas, BorderLayout.CENTER);
    add(foot(), BorderLayout.SOUTH);
    refresh();
  }

  /** Nothing takes the focus, so that the keys always reach the panel. */
  private JComponent buttons() {
    JPanel bar = new JPanel(new FlowLayout(FlowLayout.LEFT, 6, 4));
    run.addActionListener(event -> act(() -> player.setRunning(!player.isRunning())));
    bar.add(run);
    bind(KeyEvent.VK_SPACE, run);
    bar.add(button("Frame", KeyEvent.VK_RIGHT, player::stepFrame));
    bar.add(button("Impact", KeyEvent.VK_I, this::nextImpact));
    bar.add(button("Restart", KeyEvent.VK_R, player::restart));
    JComboBox<Double> speeds = new JComboBox<>(SPEEDS);
    speeds.setSelectedItem(1.0);
    speeds.setFocusable(false);
    speeds.addActionListener(event -> player.setSpeed((Double) speeds.getSelectedItem()));
    bar.add(new JLabel("Speed"));
    bar.add(speeds);
    for (Layer layer : Layer.values()) {
      String name = layer.name().charAt(0) + layer.name().substring(1).toLowerCase(Locale.ROOT);
      JCheckBox box = new JCheckBox(name, canvas.painter().shows(layer));
      box.setFocusable(false);
      box.addActionListener(event -> show(layer, box.isSelected()));
      bar.add(box);
    }
    return bar;
  }

  private JButton button(String name, int key, Runnable action) {
    JButton button = new JButton(name);
    button.addActionListener(event -> act(action));
    bind(key, button);
    return button;
  }

  private void bind(int key, JButton button) {
    button.setFocusable(false);
    String name = "key " + key;
    getInputMap(WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(key, 0), name);
    getActionMap()
        .put(
            name,
            new AbstractAction() {
              private static final long serialVersionUID = 1;

              @Override
              public void actionPerformed(ActionEvent e) {
                button.doClick(0);
              }
            });
  }

  private JComponent foot() {
    JPanel foot = new JPanel(new BorderLayout());
    foot.setBorder(BorderFactory.createEmptyBorder(2, 8, 4, 8));
    slider.setFocusable(false);
    slider.addChangeListener(event -> scrub());
    foot.add(slider, BorderLayout.NORTH);
    foot.add(status, BorderLayout.SOUTH);
    return foot;
  }

  private void act(Runnable action) {
    message = "";
    action.run();
    refresh();
  }

  private void nextImpact() {
    if (!player.nextImpact()) {
      message = "no impact ahead";
    }
  }

  private void scrub() {
    if (!refreshing) {
      double share = slider.getValue() / (double) SLIDER;
      player.seek(player.start() + share * (player.end() - player.start()));
      refresh();
    }
  }

  private void told(String text) {
    message = text;
    refresh();
  }

  private void show(Layer layer, boolean visible) {
    canvas.painter().set(layer, visible);
    refresh();
  }

  /** Goes on by one tick of the timer. */
  public void tick() {
    if (player.isRunning()) {
      player.tick();
      refresh();
    }
  }

  /**
   * Loads a scene file. If that fails, the status line says why, and nothing changes.
   *
   * @param file the file
   */
  public void load(Path file) {
    try {
      player.load(Scene.read(file));
      canvas.fit();
      told("loaded " + file);
    } catch (IOException e) {
      told(e.toString());
    }
  }

  /**
   * Saves what is shown as a scene file. If that fails, the status line says why.
   *
   * @param file the file
   */
  public void save(Path file) {
    try {
      player.scene().write(file);
      told("saved " + file);
    } catch (IOException e) {
      told(e.toString());
    }
  }

  private void refresh() {
    refreshing = true;
    run.setText(player.isRunning() ? "Pause" : "Run");
    double length = player.end() - player.start();
    double share = length > 0 ? (player.shown() - player.start()) / length : 1;
    slider.setValue((int) Math.round(SLIDER * share));
    String moment = player.shown() < player.end() ? " of %.3f (past)".formatted(player.end()) : "";
    status.setText(
        "time %.3f%s, %,d impacts; %s%s"
            .formatted(
                player.shown(),
                moment,
                player.impacts(),
                player.engineDescription(),
                message.isEmpty() ? "" : "; " + message));
    refreshing = false;
    canvas.repaint();
  }

  /** What the status line says. */
  String status() {
    return status.getText();
  }

  /** Where the scene is drawn. */
  SceneCanvas canvas() {
    return canvas;
  }
}
