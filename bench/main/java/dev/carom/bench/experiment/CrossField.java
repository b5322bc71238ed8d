// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The canonical scene while it is filled: what stands already, and where the next thing fits. */
final class CrossField {

  private static final double HALF_LINE = 10;
  private static final double CROSS_TO_BOUNDS = 30;
  private static final double CROSS_TO_CROSS = 45;

  private final double width;
  private final double height;
  private final SplitMix random;
  private final SceneBuilder builder = Scene.builder().collide(false);
  private final List<Vec2> centers = new ArrayList<>();
  private final List<Line> lines = new ArrayList<>();

  CrossField(double width, double height, SplitMix random) {
    this.width = width;
    this.height = height;
    this.random = random;
    builder.bounds(0, 0, width, height);
  }

  void addCross(int i, int of) throws CannotPlaceException {
    Vec2 center = place(CROSS_TO_BOUNDS);
    for (int tries = 1; !isClear(center); tries++) {
      giveUpAfter(tries, "cross", i, of);
      center = place(CROSS_TO_BOUNDS);
    }
    centers.add(center);
    double angle = random.between(0, StrictMath.PI / 2);
    double dx = HALF_LINE * StrictMath.cos(angle);
    double dy = HALF_LINE * StrictMath.sin(angle);
    addLine(center, dx, dy);
    addLine(center, -dy, dx);
  }

  private void addLine(Vec2 center, double dx, double dy) {
    Line line = new Line(center.x() - dx, center.y() - dy, center.x() + dx, center.y() + dy);
    lines.add(line);
    builder.line(line.ax(), line.ay(), line.bx(), line.by());
  }

  void addCircle(int i, int of, double radius, double minSpeed, double maxSpeed)
      throws CannotPlaceException {
    Vec2 center = place(radius);
    for (int tries = 1; overlapsLine(center, radius); tries++) {
      giveUpAfter(tries, "circle", i, of);
      center = place(radius);
    }
    double speed = random.between(minSpeed, maxSpeed);
    double angle = random.between(0, 2 * StrictMath.PI);
    double vx = speed * StrictMath.cos(angle);
    double vy = speed * StrictMath.sin(angle);
    builder.circle(center.x(), center.y(), radius, vx, vy);
  }

  Scene scene() {
    return builder.build();
  }

  private Vec2 place(double margin) {
    double x = random.between(margin, width - margin);
    double y = random.between(margin, height - margin);
    return new Vec2(x, y);
  }

  private boolean isClear(Vec2 place) {
    return centers.stream().noneMatch(center -> isNearer(place, center, CROSS_TO_CROSS));
  }

  private boolean overlapsLine(Vec2 place, double radius) {
    return lines.stream().anyMatch(line -> isNearer(place, line.closestPoint(place), radius));
  }

  private static boolean isNearer(Vec2 p, Vec2 q, double distance) {
    double dx = q.x() - p.x();
    double dy = q.y() - p.y();
    return dx * dx + dy * dy < distance * distance;
  }

  private static void giveUpAfter(int tries, String thing, int i, int of)
      throws CannotPlaceException {
    if (tries == Crosses.TRIES) {
      throw new CannotPlaceException(
          String.format(
              Locale.ROOT,
              "no room for %s %d of %d: none of %,d places fits; ask for fewer or smaller ones",
              thing,
              i + 1,
              of,
              tries));
    }
  }
}
