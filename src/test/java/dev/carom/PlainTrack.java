// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * A track of lines from left to right, and balls above it. Chosen at random: its bends, whether
 * ends are shared to the bit, whether lines are one-way, and whether the track moves.
 */
final class PlainTrack {

  static final double G = 0.05;

  /** Balls rest at places that they leave by less than this angle of balance. */
  private static final double BALANCE = 0x1p-14;

  /** A contact may hover so many radii. */
  private static final double HOVER = 0x1p-7;

  private final Random random;
  final int lines;
  final int balls;
  final double e;
  final boolean moves;
  private final boolean isOneWay;
  private final boolean isShared;

  PlainTrack(long seed) {
    random = new Random(seed);
    lines = 2 + (int) (69 * Math.pow(random.nextDouble(), 2));
    balls = 1 + random.nextInt(3);
    e = new double[] {0, 0.3, 0.5, 0.9}[random.nextInt(4)];
    moves = random.nextInt(5) == 0;
    isOneWay = random.nextInt(4) == 0;
    isShared = random.nextInt(4) > 0;
  }

  /** Lines go from left to right: their left, which is solid where they are one-way, is above. */
  Scene scene() {
    SceneBuilder scene = Scene.builder().gravity(0, -G);
    double vx = moves ? random.nextDouble() - 0.5 : 0;
    double vy = moves ? random.nextDouble() * 0.4 - 0.2 : 0;
    int bend = random.nextInt(4);
    double x = 0;
    double y = 0;
    double angle = bend == 1 ? -0.9 : bend == 2 ? 0.5 : 0;
    for (int k = 0; k < lines; k++) {
      angle = next(bend, angle);
      double length = 3 + 60 * random.nextDouble() * random.nextDouble();
      double bx = x + length * Math.cos(angle);
      double by = y + length * Math.sin(angle);
      scene.line(x, y, bx, by);
      if (isOneWay) {
        scene.oneWay();
      }
      if (moves) {
        scene.velocity(vx, vy);
      }
      double apart = isShared ? 0 : random.nextBoolean() ? 1e-12 : 0.5;
      x = bx + apart * (random.nextDouble() - 0.5);
      y = by + apart * (random.nextDouble() - 0.5);
    }
    for (int i = 0; i < balls; i++) {
      double at = 5 + 22 * i;
      scene.circle(at, 60 + 25 * i, 10, random.nextDouble(), 0).restitution(e);
    }
    return scene.build();
  }

  /** Concave, convex, level with steps of slope, or any. */
  private double next(int bend, double angle) {
    if (random.nextInt(4) == 0) {
      return angle;
    }
    return switch (bend) {
      case 1 -> Math.min(0.9, angle + 1.8 / lines * random.nextDouble());
      case 2 -> Math.max(-1.2, angle - 1.7 / lines * random.nextDouble());
      default -> random.nextInt(5) == 0 ? 0 : (random.nextDouble() - 0.65) * 1.6;
    };
  }

  /**
   * The balls that rest although nothing holds them, at the end of a run; empty if there is none.
   */
  static List<String> restWithoutSupport(World world) {
    List<String> wrong = new ArrayList<>();
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      if (world.isResting(i) && !isHeld(world, i)) {
        wrong.add("ball " + i + " rests at (" + world.x(i) + ", " + world.y(i) + ")");
      }
    }
    return wrong;
  }

  /**
   * Among the normals of its contacts is the vertical, or one on either side of it, less than half
   * a turn apart: then a sum of forces along them is vertical. One of them may point down.
   */
  private static boolean isHeld(World world, int i) {
    double x = world.x(i);
    double y = world.y(i);
    double r = world.radius(i);
    double left = Math.PI;
    double right = Math.PI;
    List<double[]> points = new ArrayList<>();
    for (int k : world.ids(Kind.LINE)) {
      Vec2 p = world.line(k).closestPoint(new Vec2(x, y));
      points.add(new double[] {p.x(), p.y(), r});
    }
    for (int j = 0; j < world.count(Kind.CIRCLE); j++) {
      if (j != i) {
        points.add(new double[] {world.x(j), world.y(j), r + world.radius(j)});
      }
    }
    for (double[] p : points) {
      double distance = Math.hypot(x - p[0], y - p[1]);
      if (distance < p[2] + r * HOVER) {
        double angle = Math.atan2(x - p[0], y - p[1]);
        right = angle >= -BALANCE ? Math.min(right, Math.abs(angle)) : right;
        left = angle <= BALANCE ? Math.min(left, Math.abs(angle)) : left;
      }
    }
    return right + left < Math.PI - BALANCE;
  }
}
