// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Vec2;
import java.util.List;

/**
 * The usual method of games, short and readable: a circle among lines, in plain doubles, with an
 * epsilon. CausesTest shows where each of these fails.
 */
final class Naive {

  /** "Not again so soon": what keeps a textbook from hitting the same line twice. */
  static final double EPSILON = 1e-9;

  static final double NEVER = Double.POSITIVE_INFINITY;

  final List<Line> lines;
  final double r;
  double x;
  double y;
  double vx;
  double vy;

  Naive(Circle circle, Vec2 velocity, Line... lines) {
    this.lines = List.of(lines);
    x = circle.x();
    y = circle.y();
    r = circle.radius();
    vx = velocity.x();
    vy = velocity.y();
  }

  /** Moves, then looks: what overlaps at the end of the frame turns the circle round. */
  void overlapTest(double dt) {
    x += vx * dt;
    y += vy * dt;
    for (Line line : lines) {
      if (distance(line, x, y) < r) {
        reflect(line, 1);
      }
    }
  }

  /** The same in shorter frames. */
  void substeps(double dt, int count) {
    for (int i = 0; i < count; i++) {
      overlapTest(dt / count);
    }
  }

  /** The same, and what overlaps is pushed out. */
  void pushOut(double dt, double restitution) {
    x += vx * dt;
    y += vy * dt;
    for (Line line : lines) {
      double d = distance(line, x, y);
      if (d < r) {
        Vec2 foot = line.closestPoint(new Vec2(x, y));
        x += (x - foot.x()) / d * (r - d);
        y += (y - foot.y()) / d * (r - d);
        reflect(line, restitution);
      }
    }
  }

  /** The textbook's time of impact, and so many impacts in a frame: the rest of it is dropped. */
  void impactsPerFrame(double dt, int most) {
    double left = dt;
    for (int i = 0; i < most; i++) {
      Line first = null;
      double least = left;
      for (Line line : lines) {
        double t = time(new Circle(x, y, r), new Vec2(vx, vy), line);
        if (t < least) {
          least = t;
          first = line;
        }
      }
      x += vx * least;
      y += vy * least;
      left -= least;
      if (first == null) {
        return;
      }
      reflect(first, 1);
    }
  }

  /** Along the offset from the nearest point, if the circle approaches it. */
  private void reflect(Line line, double restitution) {
    Vec2 foot = line.closestPoint(new Vec2(x, y));
    double nx = (x - foot.x()) / r;
    double ny = (y - foot.y()) / r;
    double vn = vx * nx + vy * ny;
    if (vn < 0) {
      vx -= (1 + restitution) * vn * nx;
      vy -= (1 + restitution) * vn * ny;
    }
  }

  static double distance(Line line, double x, double y) {
    Vec2 foot = line.closestPoint(new Vec2(x, y));
    return Math.hypot(x - foot.x(), y - foot.y());
  }

  /** The textbook: the strip over the line first, then its ends. */
  static double time(Circle c, Vec2 v, Line line) {
    double side = sideTime(c, v, line);
    double start = pointTime(c.x() - line.ax(), c.y() - line.ay(), c.radius(), v);
    double end = pointTime(c.x() - line.bx(), c.y() - line.by(), c.radius(), v);
    return Math.min(side, Math.min(start, end));
  }

  /** With the unit normal: gap over closing speed, if the foot then lies on the line. */
  static double sideTime(Circle c, Vec2 v, Line line) {
    double length = Math.hypot(line.bx() - line.ax(), line.by() - line.ay());
    double ux = (line.bx() - line.ax()) / length;
    double uy = (line.by() - line.ay()) / length;
    double height = ux * (c.y() - line.ay()) - uy * (c.x() - line.ax());
    double closing = -Math.signum(height) * (ux * v.y() - uy * v.x());
    double t = (Math.abs(height) - c.radius()) / closing;
    double s = ux * (c.x() + v.x() * t - line.ax()) + uy * (c.y() + v.y() * t - line.ay());
    return closing > 0 && t > EPSILON && s >= 0 && s < length ? t : NEVER;
  }

  /** The quadratic (d + v t)^2 = r^2 with its discriminant b^2 - a c. */
  static double pointTime(double dx, double dy, double r, Vec2 v) {
    double a = v.x() * v.x() + v.y() * v.y();
    double b = dx * v.x() + dy * v.y();
    double c = dx * dx + dy * dy - r * r;
    double discriminant = b * b - a * c;
    double t = (-b - Math.sqrt(discriminant)) / a;
    return discriminant >= 0 && t > EPSILON ? t : NEVER;
  }
}
