// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Scene;

/**
 * The published algorithm (2010), which this library is measured against: in every frame every
 * circle asks every line, in double. The circle moves to the earliest contact, is reflected, and
 * spends the rest of the frame's travel in its new direction. That is one impact per circle and
 * frame: a second one waits for the next frame, which finds the circle overlapping and reflects it
 * at once.
 *
 * <p>Written as well as the publication allows: flat arrays, directions of lines computed once, no
 * allocation, no square root but for the time of contact with an endpoint. It has neither grid nor
 * rejection by distance, since the publication has none. Pegs count as lines of length zero; they
 * and restitution are there so that it can play any scene in which circles ignore each other.
 */
final class Poster extends Circles {

  private static final int NONE = -1;

  private final PosterLines lines;
  private final PosterWalls walls;

  Poster(Scene scene) {
    super(PlainScene.checkCircles(scene));
    lines = new PosterLines(scene);
    walls = new PosterWalls(scene);
  }

  @Override
  public void frame() {
    impacts = 0;
    wallImpacts = 0;
    lines.squareRoots = 0;
    for (int i = 0; i < circles; i++) {
      move(i);
    }
  }

  private void move(int i) {
    double px = x[i];
    double py = y[i];
    double r = radius[i];
    double first = walls.contact(px, py, vx[i], vy[i], r);
    int hit = NONE;
    for (int k = 0; k < lines.count; k++) {
      if (lines.candidate(k, px, py, vx[i], vy[i], r)) {
        double t = lines.contact(k, px, py, vx[i], vy[i], r);
        if (t <= 1 && t < first) {
          first = t;
          hit = k;
        }
      }
    }
    if (hit != NONE) {
      reflect(i, hit, px + first * vx[i], py + first * vy[i], 1 - first);
    } else if (first <= 1) {
      bounce(i, px + first * vx[i], py + first * vy[i], 1 - first);
    } else {
      x[i] = px + vx[i];
      y[i] = py + vy[i];
    }
  }

  /** v -= (1+e) (v.n)/(n.n) n, n from the closest point of the line to the centre at contact. */
  private void reflect(int i, int k, double cx, double cy, double rest) {
    double nx = lines.normalX(k, cx, cy);
    double ny = lines.normalY(k, cx, cy);
    double e = restitution[i] * lines.restitution[k];
    double s = (1 + e) * (vx[i] * nx + vy[i] * ny) / (nx * nx + ny * ny);
    vx[i] -= s * nx;
    vy[i] -= s * ny;
    x[i] = cx + rest * vx[i];
    y[i] = cy + rest * vy[i];
    impacts++;
  }

  /** Turns the component that carried the circle to the wall. */
  private void bounce(int i, double cx, double cy, double rest) {
    double e = restitution[i] * walls.restitution;
    if (walls.isVertical(cx, cy, vx[i], vy[i], radius[i])) {
      vx[i] *= -e;
    } else {
      vy[i] *= -e;
    }
    x[i] = cx + rest * vx[i];
    y[i] = cy + rest * vy[i];
    wallImpacts++;
  }

  @Override
  public int squareRoots() {
    return lines.squareRoots;
  }

  /** Every circle asks every line. */
  @Override
  public long pairTests() {
    return (long) circles * lines.count;
  }
}
