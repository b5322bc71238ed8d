// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Vec2;
import dev.carom.bench.charts.Style;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.NoninvertibleTransformException;
import java.awt.geom.Point2D;
import java.util.function.Consumer;
import javax.swing.JComponent;

/** The scene in the window, and the mouse on it. */
final class SceneCanvas extends JComponent {

  private static final long serialVersionUID = 1;

  /** How far beside a line the mouse still takes hold of it, in pixels. */
  private static final double REACH = 7;

  private final transient Player player;
  private final transient Consumer<String> changed;
  private transient ScenePainter painter;
  private transient Grip grip;

  /** Changes are told, with a message if something was refused. */
  SceneCanvas(Player player, Consumer<String> changed) {
    this.player = player;
    this.changed = changed;
    painter = new ScenePainter(player.scene());
    setPreferredSize(new Dimension(840, 640));
    MouseAdapter mouse =
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent e) {
            press(e.getPoint());
          }

          @Override
          public void mouseDragged(MouseEvent e) {
            drag(e.getPoint());
          }

          @Override
          public void mouseReleased(MouseEvent e) {
            grip = null;
          }
        };
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
  }

  /** Takes the size from what is there now. */
  void fit() {
    ScenePainter fitting = new ScenePainter(player.scene());
    for (ScenePainter.Layer layer : ScenePainter.Layer.values()) {
      fitting.set(layer, painter.shows(layer));
    }
    painter = fitting;
    grip = null;
  }

  ScenePainter painter() {
    return painter;
  }

  private Rectangle area() {
    return new Rectangle(0, 0, getWidth(), getHeight());
  }

  /** Takes hold of what lies under a point of the canvas. */
  void press(Point at) {
    double reach = REACH / painter.transform(area()).getScaleX();
    grip = Grip.at(player, plane(at), reach);
  }

  /** Moves what is held. */
  void drag(Point at) {
    if (grip == null) {
      return;
    }
    try {
      grip.drag(plane(at));
      changed.accept("");
    } catch (IllegalArgumentException e) {
      changed.accept(e.getMessage());
    }
  }

  private Vec2 plane(Point at) {
    try {
      AffineTransform map = painter.transform(area());
      // Not the point itself: what it has room for would be floats.
      Point2D p = map.inverseTransform(new Point2D.Double(at.x, at.y), null);
      return new Vec2(p.getX(), p.getY());
    } catch (NoninvertibleTransformException e) {
      throw new IllegalStateException("the canvas is " + getSize() + ": expected some size", e);
    }
  }

  @Override
  protected void paintComponent(Graphics g) {
    g.setColor(Style.PAPER);
    g.fillRect(0, 0, getWidth(), getHeight());
    painter.draw((Graphics2D) g, area(), player);
  }
}
