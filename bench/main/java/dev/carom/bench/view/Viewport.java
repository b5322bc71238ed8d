// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.awt.Point;
import java.awt.geom.Rectangle2D;

/** The part of a scene that is shown, and its scale: wheel and hand change them. */
final class Viewport {

  private static final double LEAST = 0.1;
  private static final double MOST = 1e6;

  /** Pixels around the whole scene that the size leaves as they are. */
  private final double margin;

  private double zoom = 1;
  private double dx;
  private double dy;

  Viewport(double margin) {
    this.margin = margin;
  }

  /** Shows the whole scene again. */
  void reset() {
    zoom = 1;
    dx = 0;
    dy = 0;
  }

  /** Where the whole scene would be drawn, much of it beside the canvas perhaps. */
  Rectangle2D area(Rectangle2D canvas) {
    double width = zoom * Math.max(1, canvas.getWidth() - 2 * margin) + 2 * margin;
    double height = zoom * Math.max(1, canvas.getHeight() - 2 * margin) + 2 * margin;
    return new Rectangle2D.Double(
        canvas.getCenterX() + dx - width / 2, canvas.getCenterY() + dy - height / 2, width, height);
  }

  /** Makes it larger or smaller; what lies under a point stays there. */
  void zoom(double factor, Point at, Rectangle2D canvas) {
    double next = Math.max(LEAST, Math.min(MOST, zoom * factor));
    double x = at.getX() - canvas.getCenterX();
    double y = at.getY() - canvas.getCenterY();
    dx = x - (x - dx) * next / zoom;
    dy = y - (y - dy) * next / zoom;
    zoom = next;
  }

  /** Moves it by pixels. */
  void pan(double byX, double byY) {
    dx += byX;
    dy += byY;
  }
}
