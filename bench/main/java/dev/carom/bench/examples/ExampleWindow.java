// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Vec2;
import dev.carom.bench.charts.Style;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.Timer;

/** A window in which an example runs. */
public final class ExampleWindow extends JComponent {

  private static final long serialVersionUID = 1;

  private final transient Example example;

  private ExampleWindow(Example example) {
    this.example = example;
    setPreferredSize(example.size());
  }

  /**
   * Makes a window in which an example goes on, with its hint below.
   *
   * @param example what runs in it
   * @return the window, to be shown
   */
  public static JFrame of(String title, Example example) {
    JFrame frame = new JFrame(title);
    JComponent view;
    if (example instanceof GameLoop loop) {
      view = loop.component(); // it brings its own timer
    } else {
      ExampleWindow window = new ExampleWindow(example);
      Timer timer = new Timer(1000 / Example.FRAMES, event -> window.frame());
      timer.start();
      frame.addWindowListener(
          new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent e) {
              timer.stop();
            }
          });
      view = window;
    }
    view.addMouseListener(new Mouse(example));
    view.addMouseMotionListener(new Mouse(example));
    frame.addKeyListener(new Keys(example));
    JLabel hint = new JLabel(example.hint());
    hint.setBorder(BorderFactory.createEmptyBorder(6, 10, 6, 10));
    frame.add(view);
    frame.add(hint, BorderLayout.SOUTH);
    frame.pack();
    return frame;
  }

  private void frame() {
    example.frame();
    repaint();
  }

  @Override
  protected void paintComponent(Graphics g) {
    Style.smooth((Graphics2D) g);
    g.setColor(Style.PAPER);
    g.fillRect(0, 0, getWidth(), getHeight());
    example.draw((Graphics2D) g, getBounds());
  }

  /** Hands on the mouse, in shares of the component. */
  private static final class Mouse extends MouseAdapter {

    private final Example example;

    Mouse(Example example) {
      this.example = example;
    }

    @Override
    public void mouseMoved(MouseEvent e) {
      Component on = e.getComponent();
      example.point(
          new Vec2(e.getX() / (double) on.getWidth(), 1 - e.getY() / (double) on.getHeight()));
    }

    @Override
    public void mouseDragged(MouseEvent e) {
      mouseMoved(e);
    }

    @Override
    public void mousePressed(MouseEvent e) {
      mouseMoved(e);
      example.press();
    }

    @Override
    public void mouseReleased(MouseEvent e) {
      example.release();
    }
  }

  /** Hands on the keys. */
  private static final class Keys extends KeyAdapter {

    private final Example example;

    Keys(Example example) {
      this.example = example;
    }

    @Override
    public void keyPressed(KeyEvent e) {
      example.key(e.getKeyCode(), true);
    }

    @Override
    public void keyReleased(KeyEvent e) {
      example.key(e.getKeyCode(), false);
    }
  }
}
