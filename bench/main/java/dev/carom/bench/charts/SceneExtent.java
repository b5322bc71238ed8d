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
      extent.include(bounds.get().xmin(), bounds.get().ymin(), 0);
      extent.include(bounds.get().xmax(), bounds.get().ymax(), 0);
    } else {
      extent.includeAll(scene);
    }
    return extent.rectangle();
  }

  private void includeAll(Scene scene) {
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      Line line = (Line) scene.shape(Kind.LINE, i);
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
    xmin = Math.min(xmin, x - radius);
    ymin = Math.min(ymin, y - radius);
    xmax = Math.max(xmax, x + radius);
    ymax = Math.max(ymax, y + radius);
  }

  private Rectangle2D rectangle() {
    if (!(xmin <= xmax)) {
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
