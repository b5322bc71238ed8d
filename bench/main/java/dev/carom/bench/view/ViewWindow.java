// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.bench.charts.Style;
import dev.carom.bench.duel.Rival;
import dev.carom.bench.reference.Reference;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import javax.swing.AbstractAction;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JOptionPane;
import javax.swing.KeyStroke;
import javax.swing.Timer;

/** The window around a {@link ViewPanel}: its menus, its dialogs, its timer. */
public final class ViewWindow {

  private static final int MILLIS = 1000 / 60;
  private static final Dimension SIZE = new Dimension(1100, 800);
  private static final Dimension LEAST = new Dimension(420, 320);
  private static final String NAME = "Carom";
  private static final int ICON = 64;

  private final JFrame frame = new JFrame();
  private final ViewPanel panel;
  private final Dialogs dialogs;
  private final SceneFiles files;

  private ViewWindow(String title, Player player) {
    panel = new ViewPanel(player);
    dialogs = new SwingDialogs(frame);
    files = new SceneFiles(panel, dialogs);
    panel.onTitle(this::setTitle);
    setTitle(title);
    frame.add(panel);
    frame.setJMenuBar(menus());
    frame.setMinimumSize(LEAST);
    frame.setSize(SIZE);
    frame.setIconImage(icon());
  }

  /**
   * Makes the window; on the event thread, and where there is a screen.
   *
   * @param title the name of the scene, such as that of its file
   * @param player what it shows
   * @return the window, to be shown
   */
  public static JFrame of(String title, Player player) {
    return of(title, player, null, null);
  }

  /**
   * Makes the window with a duel in it; on the event thread, and where there is a screen.
   *
   * @param title the name of the scene, such as that of its file
   * @param player what it shows
   * @param truth the true course of its scene; null if that is not known
   * @param rival the method that plays beside it; null for none
   * @return the window, to be shown
   */
  public static JFrame of(String title, Player player, Reference truth, Rival rival) {
    ViewWindow window = new ViewWindow(title, player);
    window.panel.arena().setTruth(player.scene(), truth);
    window.panel.challenge(rival);
    player.setRunning(true);
    Timer timer = new Timer(MILLIS, event -> window.tick());
    window.frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosed(WindowEvent e) {
            timer.stop();
            window.panel.arena().close();
          }
        });
    timer.start();
    return window.frame;
  }

  /** A circle that bounces off a line. */
  private static Image icon() {
    BufferedImage image = new BufferedImage(ICON, ICON, BufferedImage.TYPE_INT_ARGB);
    Graphics2D g = image.createGraphics();
    Style.smooth(g);
    g.setColor(Style.BLUE);
    g.fill(new Ellipse2D.Double(0.3 * ICON, 0.02 * ICON, 0.66 * ICON, 0.66 * ICON));
    g.setColor(Style.VERMILION);
    g.setStroke(Style.line(ICON / 10.0));
    g.draw(new Line2D.Double(0.06 * ICON, 0.6 * ICON, 0.9 * ICON, 0.94 * ICON));
    g.dispose();
    return image;
  }

  private void tick() {
    panel.tick();
    Toolkit.getDefaultToolkit().sync(); // else some desktops show every other frame
  }

  private void setTitle(String title) {
    frame.setTitle(title + " - " + NAME);
  }

  private JMenuBar menus() {
    JMenu file = new JMenu("File");
    file.setMnemonic('F');
    file.add(item("Open scene...", "ctrl O", files::open));
    file.add(item("Save as scene...", "ctrl S", files::save));
    file.addSeparator();
    file.add(item("Close", "ctrl W", frame::dispose));
    JMenu view = new JMenu("View");
    view.setMnemonic('V');
    JCheckBoxMenuItem dark = new JCheckBoxMenuItem("Dark");
    dark.setAccelerator(KeyStroke.getKeyStroke("ctrl D"));
    dark.addActionListener(event -> setDark(dark.isSelected()));
    view.add(dark);
    JMenu help = new JMenu("Help");
    help.setMnemonic('H');
    help.add(item("Keys and mouse", "F1", this::showKeys));
    help.add(item("About", null, this::showAbout));
    bindQuestionMark();
    JMenuBar bar = new JMenuBar();
    bar.add(file);
    bar.add(new SceneMenu(panel, dialogs).menu());
    bar.add(view);
    bar.add(help);
    return bar;
  }

  private static JMenuItem item(String name, String keys, Runnable action) {
    JMenuItem item = new JMenuItem(name);
    item.setAccelerator(KeyStroke.getKeyStroke(keys));
    item.addActionListener(event -> action.run());
    return item;
  }

  private void setDark(boolean dark) {
    Look.set(dark);
    panel.setDark(dark);
  }

  /** By the sign: where it lies differs from keyboard to keyboard. */
  private void bindQuestionMark() {
    panel.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke('?'), "help");
    panel
        .getActionMap()
        .put(
            "help",
            new AbstractAction() {
              private static final long serialVersionUID = 1;

              @Override
              public void actionPerformed(ActionEvent e) {
                showKeys();
              }
            });
  }

  private void showKeys() {
    show("Keys and mouse", HelpPage.html(panel.keys()));
  }

  private void showAbout() {
    show("About", HelpPage.about());
  }

  private void show(String title, String html) {
    JOptionPane.showMessageDialog(frame, html, title, JOptionPane.PLAIN_MESSAGE);
  }
}
