// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import java.awt.geom.Rectangle2D;
import java.util.Optional;

/** The part of the plane that is shown: the bounds of a scene, or else all its things at time 0. */
final class SceneExtent {

  private double xmin = Double.POSITIVE_INFINITY;
  private double ymin = Double.POSITIVE_INFINITY;
  private double xmax = Double.NEGATIVE_INFINITY;
  private double ymax = Double.NEGATIVE_INFINITY;

  private SceneExtent() {}

  /** A rectangle, neither side of which is 0. */
  static Rectangle2D of(Scene scene) {
    SceneExtent extent = new SceneExtent();
    Optional<Bounds> bounds = scene.bounds();
    if (bounds.isPresent()) {
      Bounds b = bounds.get();
      extent.include(b.xmin(), b.ymin(), 0);
      extent.include(b.xmax(), b.ymax(), 0);
    }
    if (scene.count(Kind.WALL) < 4) {
      extent.includeAll(scene);
    }
    return extent.rectangle();
  }

  private void includeAll(Scene scene) {
    for (Line line : Sides.of(scene)) {
      include(line.ax(), line.ay(), 0);
      include(line.bx(), line.by(), 0);
    }
    for (int i = 0; i < scene.count(Kind.PEG); i++) {
      include((Circle) scene.shape(Kind.PEG, i));
    }
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      include((Circle) scene.shape(Kind.CIRCLE, i));
    }
  }

  private void include(Circle circle) {
    include(circle.x(), circle.y(), circle.radius());
  }

  private void include(double x, double y, double radius) {
    if (Double.isFinite(x)) { // an open side is not drawn
      xmin = Math.min(xmin, x - radius);
      xmax = Math.max(xmax, x + radius);
    }
    if (Double.isFinite(y)) {
      ymin = Math.min(ymin, y - radius);
      ymax = Math.max(ymax, y + radius);
    }
  }

  private Rectangle2D rectangle() {
    if (!(xmin <= xmax && ymin <= ymax)) {
      return new Rectangle2D.Double(0, 0, 1, 1);
    }
    double least = Math.max(xmax - xmin, ymax - ymin) / 8; // a lone level line still has height
    least = least > 0 ? least : 1;
    double width = Math.max(least, xmax - xmin);
    double height = Math.max(least, ymax - ymin);
    double x = xmin + (xmax - xmin - width) / 2;
    double y = ymin + (ymax - ymin - height) / 2;
    return new Rectangle2D.Double(x, y, width, height);
  }
}
