// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Circle;
import dev.carom.ObstacleKind;
import dev.carom.Scene;
import dev.carom.Vec2;

/** The circles of a method in float: a flat array for each of their numbers. */
abstract class FloatCircles implements Method {

  final int circles;
  final float[] x;
  final float[] y;
  final float[] vx;
  final float[] vy;
  final float[] radius;
  final float[] restitution;

  int impacts;
  int wallImpacts;

  FloatCircles(Scene scene) {
    circles = scene.circleCount();
    x = new float[circles];
    y = new float[circles];
    vx = new float[circles];
    vy = new float[circles];
    radius = new float[circles];
    restitution = new float[circles];
    for (int i = 0; i < circles; i++) {
      Circle circle = scene.circle(i);
      Vec2 velocity = scene.velocity(i);
      x[i] = (float) circle.x();
      y[i] = (float) circle.y();
      vx[i] = (float) velocity.x();
      vy[i] = (float) velocity.y();
      radius[i] = (float) circle.radius();
      restitution[i] = (float) scene.restitution(ObstacleKind.CIRCLE, i);
    }
  }

  @Override
  public int impacts() {
    return impacts;
  }

  @Override
  public int wallImpacts() {
    return wallImpacts;
  }

  @Override
  public double x(int circle) {
    return x[circle];
  }

  @Override
  public double y(int circle) {
    return y[circle];
  }

  @Override
  public double vx(int circle) {
    return vx[circle];
  }

  @Override
  public double vy(int circle) {
    return vy[circle];
  }
}
