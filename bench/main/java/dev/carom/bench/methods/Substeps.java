// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Scene;

/**
 * The method that most games begin with: move, look for overlap, put it right. A frame is cut into
 * k equal parts; with k = 1 it is the overlap test at the end of the frame. A circle that overlaps
 * a line and comes nearer is reflected, and every overlap is undone by moving the circle out along
 * the normal. Contact is noticed late by up to a part's travel, and things between two places are
 * not seen.
 */
class Substeps extends PlainMethod {

  final int k;
  int squareRoots;

  Substeps(Scene scene, int k) {
    super(scene);
    this.k = k;
  }

  @Override
  public void frame() {
    impacts = 0;
    wallImpacts = 0;
    squareRoots = 0;
    double part = 1.0 / k;
    for (int i = 0; i < circles; i++) {
      for (int step = 0; step < k; step++) {
        move(i, part);
      }
    }
  }

  final void move(int i, double part) {
    x[i] += part * vx[i];
    y[i] += part * vy[i];
    for (int line = 0; line < lines; line++) {
      separate(i, line);
    }
    keepInside(i);
  }

  private void separate(int i, int line) {
    double s = nearest(line, x[i], y[i]);
    double dx = x[i] - (ax[line] + s * (bx[line] - ax[line]));
    double dy = y[i] - (ay[line] + s * (by[line] - ay[line]));
    double dd = dx * dx + dy * dy;
    if (dd >= radius[i] * radius[i] || dd == 0) {
      return;
    }
    if (vx[i] * dx + vy[i] * dy < 0) {
      reflect(i, line, dx, dy);
      impacts++;
    }
    double push = radius[i] / Math.sqrt(dd) - 1;
    squareRoots++;
    x[i] += push * dx;
    y[i] += push * dy;
  }

  private void keepInside(int i) {
    double r = radius[i];
    double insideX = Math.max(xmin + r, Math.min(xmax - r, x[i]));
    double insideY = Math.max(ymin + r, Math.min(ymax - r, y[i]));
    if ((insideX - x[i]) * vx[i] < 0) {
      vx[i] *= -restitution[i] * wallRestitution;
      wallImpacts++;
    }
    if ((insideY - y[i]) * vy[i] < 0) {
      vy[i] *= -restitution[i] * wallRestitution;
      wallImpacts++;
    }
    x[i] = insideX;
    y[i] = insideY;
  }

  @Override
  public int squareRoots() {
    return squareRoots;
  }

  @Override
  public long pairTests() {
    return (long) k * circles * lines;
  }
}
