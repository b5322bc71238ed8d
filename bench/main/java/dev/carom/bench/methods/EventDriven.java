// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Scene;
import java.util.Arrays;

/**
 * The event-driven loop: after each impact a circle asks every line for the next one; until then it
 * is not looked at. Every impact of a frame is resolved at its own moment. Which detector answers
 * is the knob.
 *
 * <p>A circle's arrays hold the start of its flight; {@code age} is the time since then.
 */
class EventDriven extends PlainMethod {

  /** More impacts of one circle in one frame than are taken for a scene that comes to an end. */
  static final int MOST_IMPACTS = 4_000_000;

  /** As many of them in a row at one time are no more. */
  static final int MOST_AT_ONCE = 10_000;

  static final double NEVER = Double.POSITIVE_INFINITY;
  private static final int WALL_X = -1;
  private static final int WALL_Y = -2;

  final LineDetector detector;

  private final double[] age;
  final double[] due;
  private final int[] hit;

  EventDriven(Scene scene, LineDetector detector) {
    super(PlainScene.checkCircles(scene));
    this.detector = detector;
    age = new double[circles];
    due = new double[circles];
    hit = new int[circles];
  }

  /** Finds the first impact of each circle: to be called once, before the first frame. */
  final EventDriven started() {
    Arrays.setAll(hit, this::search);
    return this;
  }

  @Override
  public final void frame() {
    impacts = 0;
    wallImpacts = 0;
    detector.squareRoots = 0;
    detector.pairTests = 0;
    for (int i = 0; i < circles; i++) {
      age[i] += 1;
      int atOnce = 0;
      for (int count = 0; due[i] <= age[i]; count++) {
        atOnce = age[i] - due[i] == age[i] ? atOnce + 1 : 0;
        checkEnd(i, count, atOnce);
        impact(i);
      }
    }
  }

  static void checkEnd(int circle, int impacts, int atOnce) {
    if (impacts == MOST_IMPACTS || atOnce == MOST_AT_ONCE) {
      throw new IllegalStateException("circle " + circle + " makes impacts without end");
    }
  }

  private void impact(int i) {
    double t = due[i];
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

  /** The normal is the line's perpendicular over it, and the offset from an end beyond it. */
  private void bounce(int i, int k) {
    double s = nearest(k, x[i], y[i]);
    if (s > 0 && s < 1) {
      reflect(i, k, ay[k] - by[k], bx[k] - ax[k]);
    } else {
      reflect(i, k, x[i] - (s > 0 ? bx[k] : ax[k]), y[i] - (s > 0 ? by[k] : ay[k]));
    }
  }

  /** Finds the next impact: sets when, and returns with what. */
  private int search(int i) {
    double wallX = wall(x[i], vx[i], xmin + radius[i], xmax - radius[i]);
    double wallY = wall(y[i], vy[i], ymin + radius[i], ymax - radius[i]);
    double first = Math.min(wallX, wallY);
    int what = wallX <= wallY ? WALL_X : WALL_Y;
    return search(i, first, what);
  }

  /** Among all lines; sets when, and returns with what. */
  int search(int i, double wallTime, int wall) {
    double first = wallTime;
    int what = wall;
    for (int k = 0; k < lines; k++) {
      double t = test(i, k, first);
      if (t < first) {
        first = t;
        what = k;
      }
    }
    due[i] = first;
    return what;
  }

  /** When a circle touches a line, infinite if not before another impact. */
  double test(int i, int k, double first) {
    return detector.time(x[i], y[i], radius[i], vx[i], vy[i], ax[k], ay[k], bx[k], by[k], first);
  }

  private static double wall(double p, double v, double low, double high) {
    if (v == 0) {
      return NEVER;
    }
    return Math.max(0, ((v < 0 ? low : high) - p) / v);
  }

  @Override
  public double x(int circle) {
    return x[circle] + age[circle] * vx[circle];
  }

  @Override
  public double y(int circle) {
    return y[circle] + age[circle] * vy[circle];
  }

  @Override
  public int squareRoots() {
    return detector.countsRoots() ? detector.squareRoots : UNKNOWN;
  }

  @Override
  public long pairTests() {
    return detector.pairTests;
  }
}
