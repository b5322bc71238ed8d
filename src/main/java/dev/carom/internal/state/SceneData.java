// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The contents of a scene in flat arrays that are never changed. Circles stand in rows in the order
 * of their numbers.
 */
public final class SceneData {

  /** The number of doubles in a row of {@link #circles}. */
  public static final int CIRCLE_ROW = 6;

  // The columns of a row.
  static final int X = 0;
  static final int Y = 1;
  static final int RADIUS = 2;
  static final int VX = 3;
  static final int VY = 4;
  static final int RESTITUTION = 5;

  public final double[] circles;

  /** The circles without their motion. Shared by all users of the scene, so never changed. */
  public final CircleRegistry registry;

  /** Shared by all users of the scene, so never changed. */
  public final ObstacleTable obstacles;

  public final boolean collide;

  // The acceleration of all circles of finite mass; finite, and never -0.
  public final double gx;
  public final double gy;

  SceneData(SceneDataBuilder from) {
    circles = from.circles.toArray();
    registry = from.registry.copy();
    collide = from.collide;
    gx = from.gx;
    gy = from.gy;
    obstacles = from.obstacles();
  }

  public boolean hasGravity() {
    return gx != 0 || gy != 0;
  }

  public int circleCount() {
    return circles.length / CIRCLE_ROW;
  }

  public double x(int circle) {
    return circles[circle * CIRCLE_ROW + X];
  }

  public double y(int circle) {
    return circles[circle * CIRCLE_ROW + Y];
  }

  public double radius(int circle) {
    return circles[circle * CIRCLE_ROW + RADIUS];
  }

  public double vx(int circle) {
    return circles[circle * CIRCLE_ROW + VX];
  }

  public double vy(int circle) {
    return circles[circle * CIRCLE_ROW + VY];
  }

  public double restitution(int circle) {
    return circles[circle * CIRCLE_ROW + RESTITUTION];
  }

  /** The limits of sizes at the start: of all coordinates, those of bounds too, and all radii. */
  public SizeLimits limits() {
    double extent = Math.max(obstacles.extent(), obstacles.extentOfBounds());
    SizeLimits limits = new SizeLimits(extent, Double.POSITIVE_INFINITY);
    for (int i = 0; i < circleCount(); i++) {
      limits.keepPlace(x(i), y(i));
      limits.keepRadius(radius(i));
    }
    return limits;
  }

  /** The number of the first circle whose radius keeps the scene from being built, or -1. */
  int firstTooSmall() {
    double least = SizeLimits.leastRadius(limits().largest());
    boolean arePointsAllowed = obstacles.lines.count() == 0;
    for (int i = 0; i < circleCount(); i++) {
      if (!(radius(i) >= least || (arePointsAllowed && radius(i) == 0))) {
        return i;
      }
    }
    return -1;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof SceneData that
        && Arrays.equals(circles, that.circles)
        && registry.equals(that.registry)
        && collide == that.collide
        && gx == that.gx
        && gy == that.gy
        && obstacles.equals(that.obstacles);
  }

  @Override
  public int hashCode() {
    int things = 31 * Arrays.hashCode(circles) + obstacles.hashCode();
    return 31 * (31 * things + Double.hashCode(gx)) + Double.hashCode(gy);
  }
}
