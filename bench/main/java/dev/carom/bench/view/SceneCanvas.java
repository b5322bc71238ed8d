// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Circle;
import dev.carom.Filter;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Vec2;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.NoninvertibleTransformException;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;

/** The scene in the window, and the mouse on it. */
final class SceneCanvas extends JComponent {

  private static final long serialVersionUID = 1;

  /** How far beside a line the mouse still takes hold of it, in pixels. */
  private static final double REACH = 7;

  /** How much a notch of the wheel enlarges. */
  private static final double NOTCH = 1.2;

  /** The radius of a first circle, as a part of the width that is shown. */
  private static final double RADIUS = 1.0 / 60;

  private final transient Player player;
  private final transient Consumer<String> changed;
  private final transient ScenePainter painter;
  private Tool tool = Tool.HAND;
  private transient Grip grip;
  private transient Draft draft;
  private Point mouse;
  private Point panned;

  /** Changes are told, with a message if something was refused. */
  SceneCanvas(Player player, Consumer<String> changed) {
    this.player = player;
    this.changed = changed;
    painter = new ScenePainter(player.scene());
    setPreferredSize(new Dimension(1084, 660));
    setMinimumSize(new Dimension(100, 100));
    MouseAdapter adapter = new CanvasMouse();
    addMouseListener(adapter);
    addMouseMotionListener(adapter);
    addMouseWheelListener(adapter);
  }

  /** Hands on what the mouse does. */
  private final class CanvasMouse extends MouseAdapter {

    @Override
    public void mousePressed(MouseEvent e) {
      if (SwingUtilities.isLeftMouseButton(e)) {
        press(e.getPoint());
      } else {
        panned = e.getPoint();
      }
    }

    @Override
    public void mouseDragged(MouseEvent e) {
      hover(e.getPoint());
      drag(e.getPoint(), nanos(e));
    }

    @Override
    public void mouseReleased(MouseEvent e) {
      release(nanos(e));
    }

    /** The time at which the mouse did it: it may be handled later. */
    private long nanos(MouseEvent e) {
      return TimeUnit.MILLISECONDS.toNanos(e.getWhen());
    }

    @Override
    public void mouseClicked(MouseEvent e) {
      if (e.getClickCount() == 2 && tool == Tool.HAND && under(e.getPoint()) == null) {
        fit();
        changed.accept("");
      }
    }

    @Override
    public void mouseMoved(MouseEvent e) {
      hover(e.getPoint());
    }

    @Override
    public void mouseExited(MouseEvent e) {
      hover(null);
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
      zoom(factor(e), e.getPoint());
    }
  }

  /** How much a turn of the wheel enlarges. */
  static double factor(MouseWheelEvent e) {
    return Math.pow(NOTCH, -e.getPreciseWheelRotation());
  }

  /** Takes the size from what is there now. */
  void fit() {
    painter.fit(player.scene());
    grip = null;
    draft = null;
  }

  ScenePainter painter() {
    return painter;
  }

  void setTool(Tool tool) {
    this.tool = tool;
    setCursor(
        Cursor.getPredefinedCursor(
            tool == Tool.HAND ? Cursor.DEFAULT_CURSOR : Cursor.CROSSHAIR_CURSOR));
  }

  private Rectangle area() {
    return new Rectangle(0, 0, getWidth(), getHeight());
  }

  /** Enlarges what is shown, around a point. */
  void zoom(double factor, Point at) {
    painter.viewport().zoom(factor, at, area());
    repaint();
  }

  /** Enlarges what is shown, around the middle. */
  void zoom(double factor) {
    zoom(factor, new Point(getWidth() / 2, getHeight() / 2));
  }

  /** Takes hold of what lies under a point of the canvas, or begins to add something there. */
  void press(Point at) {
    if (tool == Tool.HAND) {
      grip = under(at);
      panned = grip == null ? at : null;
    } else if (tool == Tool.DELETE) {
      deleteAt(at);
    } else {
      draft = new Draft(tool, plane(at), plane(at), usualRadius());
    }
  }

  /** The radius of a circle of the scene: the last one's. */
  private double usualRadius() {
    Scene scene = player.scene();
    int circles = scene.count(Kind.CIRCLE);
    double shown = Math.max(getWidth(), getHeight()) / scale();
    return circles > 0 ? ((Circle) scene.shape(Kind.CIRCLE, circles - 1)).radius() : RADIUS * shown;
  }

  /** Removes what lies under a point. */
  void deleteAt(Point at) {
    Grip found = under(at);
    if (found != null) {
      attempt(() -> player.remove(found.kind(), found.id()));
    }
  }

  /** Removes what lies under the mouse. */
  void deleteUnderMouse() {
    if (mouse != null) {
      deleteAt(mouse);
    }
  }

  private Grip under(Point at) {
    return Grip.at(player, plane(at), REACH / scale());
  }

  /** The height of what is shown. */
  double planeHeight() {
    return getHeight() / scale();
  }

  private double scale() {
    return painter.transform(area()).getScaleX();
  }

  /** Moves what is held, or the view, at a time of the clock in nanoseconds. */
  void drag(Point at, long nanos) {
    if (grip != null) {
      attempt(() -> grip.drag(plane(at), nanos));
    } else if (draft != null) {
      draft = draft.to(plane(at));
      repaint();
    } else if (panned != null) {
      painter.viewport().pan(at.getX() - panned.getX(), at.getY() - panned.getY());
      panned = at;
      repaint();
    }
  }

  /** Lets go, or adds what was drawn, at a time of the clock in nanoseconds. */
  void release(long nanos) {
    if (grip != null) {
      attempt(() -> grip.release(nanos));
    } else if (draft != null) {
      Draft done = draft;
      draft = null;
      attempt(() -> done.add(player));
    }
    grip = null;
    panned = null;
  }

  /** Keeps what is held where it is; before each tick. */
  void hold() {
    if (grip != null) {
      grip.hold();
    }
  }

  private void attempt(Runnable edit) {
    try {
      edit.run();
      changed.accept("");
    } catch (IllegalArgumentException e) {
      changed.accept(e.getMessage());
    }
  }

  /** Tells what is under the mouse; null if the mouse is elsewhere. */
  void hover(Point at) {
    mouse = at;
    repaint();
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
  protected void paintComponent(Graphics to) {
    Graphics2D g = (Graphics2D) to.create();
    try {
      g.setColor(painter.scheme().paper());
      g.fillRect(0, 0, getWidth(), getHeight());
      painter.draw(g, area(), player);
      if (draft != null) {
        painter.draft(g, area(), player, draft);
      }
      Notes.draw(g, hovered(), tipX(), tipY(), area(), painter.scheme());
    } finally {
      g.dispose();
    }
  }

  private double tipX() {
    return mouse == null ? 0 : mouse.getX() + 14;
  }

  private double tipY() {
    return mouse == null ? 0 : mouse.getY() + 18;
  }

  /** The text beside the mouse. */
  List<String> hovered() {
    if (mouse == null || draft != null || panned != null) {
      return List.of();
    }
    Vec2 at = plane(mouse);
    Circle around = new Circle(at.x(), at.y(), 1 / scale());
    int[] circles = player.look().withFilter(Filter.ALL).overlapping(Kind.CIRCLE, around);
    return circles.length == 0 ? List.of() : List.of(under(mouse).about().split("; "));
  }
}
