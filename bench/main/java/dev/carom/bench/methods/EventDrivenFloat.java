// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Bounds;
import dev.carom.Line;
import dev.carom.ObstacleKind;
import dev.carom.Scene;

/**
 * The loop of {@link EventDriven} with the test of the textbooks, every double a float. A copy:
 * Java has no type that is a float here and a double there, and one double between would be
 * measured, too.
 */
final class EventDrivenFloat extends FloatCircles {

  private static final int WALL_X = -1;
  private static final int WALL_Y = -2;

  private final TextbookFloatKernel kernel = new TextbookFloatKernel();
  private final int lines;
  private final float[] lineRestitution;
  private final float wallRestitution;
  private final float[] age;
  private final float[] due;
  private final int[] hit;
  private final float[] ax;
  private final float[] ay;
  private final float[] bx;
  private final float[] by;
  private final float xmin;
  private final float ymin;
  private final float xmax;
  private final float ymax;

  EventDrivenFloat(Scene scene) {
    super(PlainScene.check(scene));
    age = new float[circles];
    due = new float[circles];
    hit = new int[circles];
    lines = scene.lineCount();
    lineRestitution = new float[lines];
    ax = new float[lines];
    ay = new float[lines];
    bx = new float[lines];
    by = new float[lines];
    for (int k = 0; k < lines; k++) {
      setLine(k, scene.line(k));
      lineRestitution[k] = (float) scene.restitution(ObstacleKind.LINE, k);
    }
    Bounds bounds = scene.bounds().orElse(null);
    wallRestitution = bounds == null ? 1 : (float) scene.restitution(ObstacleKind.WALL, 0);
    xmin = bounds == null ? Float.NEGATIVE_INFINITY : (float) bounds.xmin();
    ymin = bounds == null ? Float.NEGATIVE_INFINITY : (float) bounds.ymin();
    xmax = bounds == null ? Float.POSITIVE_INFINITY : (float) bounds.xmax();
    ymax = bounds == null ? Float.POSITIVE_INFINITY : (float) bounds.ymax();
    for (int i = 0; i < circles; i++) {
      hit[i] = search(i);
    }
  }

  private void setLine(int k, Line line) {
    ax[k] = (float) line.ax();
    ay[k] = (float) line.ay();
    bx[k] = (float) line.bx();
    by[k] = (float) line.by();
  }

  @Override
  public void frame() {
    impacts = 0;
    wallImpacts = 0;
    kernel.squareRoots = 0;
    kernel.pairTests = 0;
    for (int i = 0; i < circles; i++) {
      age[i] += 1;
      int atOnce = 0;
      for (int count = 0; due[i] <= age[i]; count++) {
        atOnce = age[i] - due[i] == age[i] ? atOnce + 1 : 0;
        EventDriven.checkEnd(i, count, atOnce);
        impact(i);
      }
    }
  }

  private void impact(int i) {
    float t = due[i];
    x[i] += t * vx[i];
    y[i] += t * vy[i];
    age[i] -= t;
    if (hit[i] == WALL_X) {
      vx[i] *= -restitution[i] * wallRestitution;
      wallImpacts++;
    } else if (hit[i] == WALL_Y) {
      vy[i] *= -restitution[i] * wallRestitution;
      wallImpacts++;
    } else {
      bounce(i, hit[i]);
      impacts++;
    }
    hit[i] = search(i);
  }

  private void bounce(int i, int k) {
    float wx = bx[k] - ax[k];
    float wy = by[k] - ay[k];
    float along = wx * (x[i] - ax[k]) + wy * (y[i] - ay[k]);
    if (along <= 0) {
      reflect(i, k, x[i] - ax[k], y[i] - ay[k]);
    } else if (along >= wx * wx + wy * wy) {
      reflect(i, k, x[i] - bx[k], y[i] - by[k]);
    } else {
      reflect(i, k, -wy, wx);
    }
  }

  private void reflect(int i, int k, float nx, float ny) {
    float e = restitution[i] * lineRestitution[k];
    float s = (1 + e) * (vx[i] * nx + vy[i] * ny) / (nx * nx + ny * ny);
    vx[i] -= s * nx;
    vy[i] -= s * ny;
  }

  private int search(int i) {
    float wallX = wall(x[i], vx[i], xmin + radius[i], xmax - radius[i]);
    float wallY = wall(y[i], vy[i], ymin + radius[i], ymax - radius[i]);
    float first = Math.min(wallX, wallY);
    int what = wallX <= wallY ? WALL_X : WALL_Y;
    for (int k = 0; k < lines; k++) {
      float t = kernel.time(x[i], y[i], radius[i], vx[i], vy[i], ax[k], ay[k], bx[k], by[k], first);
      if (t < first) {
        first = t;
        what = k;
      }
    }
    due[i] = first;
    return what;
  }

  private static float wall(float p, float v, float low, float high) {
    if (v == 0) {
      return Float.POSITIVE_INFINITY;
    }
    return Math.max(0, ((v < 0 ? low : high) - p) / v);
  }

  @Override
  public int squareRoots() {
    return kernel.squareRoots;
  }

  @Override
  public long pairTests() {
    return kernel.pairTests;
  }

  @Override
  public double x(int circle) {
    return x[circle] + age[circle] * vx[circle];
  }

  @Override
  public double y(int circle) {
    return y[circle] + age[circle] * vy[circle];
  }
}
