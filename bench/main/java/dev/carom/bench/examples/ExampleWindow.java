// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Vec2;
import dev.carom.bench.charts.Style;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.Timer;

/** A window in which an example runs. */
public final class ExampleWindow extends JComponent {

  private static final long serialVersionUID = 1;

  private final transient Example example;

  ExampleWindow(Example example) {
    this.example = example;
    setPreferredSize(example.size());
    MouseAdapter mouse =
        new MouseAdapter() {
          @Override
          public void mouseMoved(MouseEvent e) {
            example.point(
                new Vec2(e.getX() / (double) getWidth(), 1 - e.getY() / (double) getHeight()));
          }

          @Override
          public void mousePressed(MouseEvent e) {
            example.press();
          }
        };
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
  }

  /**
   * Makes a window in which an example goes on.
   *
   * @param title of the window
   * @param example what runs in it
   * @return the window, to be shown
   */
  public static JFrame of(String title, Example example) {
    JFrame frame = new JFrame(title);
    if (example instanceof GameLoop loop) {
      frame.add(loop.component()); // it brings its own timer
    } else {
      ExampleWindow window = new ExampleWindow(example);
      frame.add(window);
      new Timer(1000 / Example.FRAMES, event -> window.frame()).start();
    }
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
}
