// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Line;

/** The published algorithm's answer, in float: the window is its frame. */
final class PosterDetector extends LineDetector {

  private final FloatPosterLines lines = new FloatPosterLines(1);

  @Override
  public double time(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double ax,
      double ay,
      double bx,
      double by,
      double end) {
    lines.setLine(0, new Line(ax, ay, bx, by), 1);
    float x = (float) px;
    float y = (float) py;
    float dx = (float) (vx * end);
    float dy = (float) (vy * end);
    float radius = (float) r;
    if (!lines.candidate(0, x, y, dx, dy, radius)) {
      return NEVER;
    }
    float share = lines.contact(0, x, y, dx, dy, radius);
    return share <= 1 ? share * end : NEVER;
  }
}
