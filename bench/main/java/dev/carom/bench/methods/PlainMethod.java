// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import static dev.carom.bench.methods.RealDouble.real;

import dev.carom.Bounds;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;

/** State that the methods in plain doubles share: flat arrays of circles, lines and four walls. */
abstract class PlainMethod extends Circles {

  final int lines;
  final double[] ax;
  final double[] ay;
  final double[] bx;
  final double[] by;
  final double[] lineRestitution;
  final double wallRestitution;
  final double xmin;
  final double ymin;
  final double xmax;
  final double ymax;

  PlainMethod(Scene scene) {
    super(PlainScene.checkStraight(PlainScene.checkObstacles(scene)));
    lines = scene.count(Kind.LINE);
    ax = new double[lines];
    ay = new double[lines];
    bx = new double[lines];
    by = new double[lines];
    lineRestitution = new double[lines];
    for (int k = 0; k < lines; k++) {
      lineRestitution[k] = real(scene.traits(Kind.LINE, k).restitution());
      setLine(k, (Line) scene.shape(Kind.LINE, k));
    }
    Bounds bounds = scene.bounds().orElse(null);
    wallRestitution = bounds == null ? 1 : real(scene.traits(Kind.WALL, 0).restitution());
    xmin = bounds == null ? Double.NEGATIVE_INFINITY : real(bounds.xmin());
    ymin = bounds == null ? Double.NEGATIVE_INFINITY : real(bounds.ymin());
    xmax = bounds == null ? Double.POSITIVE_INFINITY : real(bounds.xmax());
    ymax = bounds == null ? Double.POSITIVE_INFINITY : real(bounds.ymax());
  }

  private void setLine(int k, Line line) {
    ax[k] = real(line.ax());
    ay[k] = real(line.ay());
    bx[k] = real(line.bx());
    by[k] = real(line.by());
  }

  /** Where on line k, from 0 at its start to 1 at its end, the point nearest to (px, py) is. */
  final double nearest(int k, double px, double py) {
    double wx = bx[k] - ax[k];
    double wy = by[k] - ay[k];
    double along = wx * (px - ax[k]) + wy * (py - ay[k]);
    double ww = wx * wx + wy * wy;
    return along <= 0 ? 0 : along >= ww ? 1 : along / ww;
  }

  /** v -= (1+e) (v.n)/(n.n) n, off line k */
  final void reflect(int i, int k, double nx, double ny) {
    double e = restitution[i] * lineRestitution[k];
    double s = (1 + e) * (vx[i] * nx + vy[i] * ny) / (nx * nx + ny * ny);
    vx[i] -= s * nx;
    vy[i] -= s * ny;
  }
}
