// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** A small gas: circles of different radii, masses and speeds in bounds, some among lines. */
final class CollidingScene {

  private static final double WIDTH = 100;
  private static final double HEIGHT = 80;
  private static final double CLEARANCE = 0.1;
  private static final Circle PEG = new Circle(80, 25, 4);
  private static final List<Line> LINES =
      List.of(
          new Line(20, 20, 35, 30),
          new Line(70, 50, 60, 65),
          new Line(50, 15, 65, 15),
          new Line(30, 60, 30.5, 45));

  private CollidingScene() {}

  static Scene of(int circles, double restitution, boolean obstacles, long seed) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, WIDTH, HEIGHT).restitution(restitution);
    List<Circle> placed = new ArrayList<>();
    if (obstacles) {
      LINES.forEach(l -> builder.line(l.ax(), l.ay(), l.bx(), l.by()).restitution(restitution));
      builder.peg(PEG.x(), PEG.y(), PEG.radius()).restitution(restitution);
      placed.add(PEG);
    }
    Random random = new Random(seed);
    int left = circles;
    while (left > 0) {
      Circle circle = draw(random);
      if (isFree(circle, placed, obstacles)) {
        placed.add(circle);
        double speed = 1 + 2 * random.nextDouble();
        double angle = 2 * Math.PI * random.nextDouble();
        builder
            .circle(
                circle.x(),
                circle.y(),
                circle.radius(),
                speed * StrictMath.cos(angle),
                speed * StrictMath.sin(angle))
            .mass(0.5 + 3 * random.nextDouble())
            .restitution(restitution);
        left--;
      }
    }
    return builder.build();
  }

  private static Circle draw(Random random) {
    double r = 1 + 4 * random.nextDouble();
    double x = r + (WIDTH - 2 * r) * random.nextDouble();
    return new Circle(x, r + (HEIGHT - 2 * r) * random.nextDouble(), r);
  }

  private static boolean isFree(Circle circle, List<Circle> placed, boolean obstacles) {
    double room = circle.radius() + CLEARANCE;
    boolean free =
        placed.stream().allMatch(c -> distance(circle.center(), c.center()) > room + c.radius());
    return free && (!obstacles || LINES.stream().allMatch(l -> distance(circle, l) > room));
  }

  private static double distance(Circle circle, Line line) {
    return distance(circle.center(), line.closestPoint(circle.center()));
  }

  private static double distance(Vec2 a, Vec2 b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y());
  }
}
