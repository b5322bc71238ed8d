// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import static dev.carom.bench.methods.RealDouble.real;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Vec2;

/** The circles of a method in double: a flat array for each of their numbers. */
public abstract class Circles implements Method {

  protected final int circles;
  protected final double[] x;
  protected final double[] y;
  protected final double[] vx;
  protected final double[] vy;
  final double[] radius;
  final double[] restitution;

  int impacts;
  int wallImpacts;

  /** Copies the circles of a scene. */
  protected Circles(Scene scene) {
    circles = scene.count(Kind.CIRCLE);
    x = new double[circles];
    y = new double[circles];
    vx = new double[circles];
    vy = new double[circles];
    radius = new double[circles];
    restitution = new double[circles];
    for (int i = 0; i < circles; i++) {
      Circle circle = (Circle) scene.shape(Kind.CIRCLE, i);
      Vec2 velocity = scene.velocity(Kind.CIRCLE, i);
      x[i] = real(circle.x());
      y[i] = real(circle.y());
      vx[i] = real(velocity.x());
      vy[i] = real(velocity.y());
      radius[i] = real(circle.radius());
      restitution[i] = real(scene.traits(Kind.CIRCLE, i).restitution());
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
