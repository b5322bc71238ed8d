// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import dev.carom.oracle.Draw.Point;

/** Circles within four walls. Numbers: px, py, r, vx, vy, xmin, ymin, xmax, ymax, end. */
final class WallFamilies {
  private WallFamilies() {}

  static WallQuery uniform(Draw d) {
    Point low = d.place();
    Point size = new Point(d.log(1, 1000), d.log(1, 1000));
    double margin = d.chance(0.1) ? 0.1 : 0;
    double px = low.x() + size.x() * d.in(-margin, 1 + margin);
    double py = low.y() + size.y() * d.in(-margin, 1 + margin);
    Point v = d.direction().times(d.log(0.5, 2000));
    double r = d.chance(0.1) ? 0 : d.log(0.001, 0.5) * Math.min(size.x(), size.y());
    Point high = low.plus(size);
    return WallQuery.of(
        px, py, r, v.x(), v.y(), low.x(), low.y(), high.x(), high.y(), d.pick(0.1, 1, 100));
  }

  /** At a distance of the radius from the left wall, as far as doubles can; any velocity. */
  static WallQuery touching(Draw d) {
    double[] n = uniform(d).numbers();
    n[0] = d.nudge(n[5] + n[2]);
    if (d.chance(0.3)) {
      n[3] = d.pick(0.0, -0.0, Double.MIN_VALUE, -Double.MIN_VALUE);
    }
    return ordered(n);
  }

  static WallQuery far(Draw d) {
    double[] n = uniform(d).numbers();
    Point origin = d.direction().times(d.log(1e6, 1e13));
    for (int i : new int[] {0, 5, 7}) {
      n[i] += origin.x();
      n[i + 1] += origin.y();
    }
    return ordered(n);
  }

  static WallQuery windowEnd(Draw d) {
    double[] n = (d.chance(0.7) ? uniform(d) : lattice(d)).numbers();
    n[9] = Double.POSITIVE_INFINITY;
    double time = WallQuery.of(n).truth().time();
    n[9] = Math.max(0, d.chance(0.4) ? time : Draw.ulps(time, d.whole(-3, 3)));
    return WallQuery.of(n);
  }

  /** Whole numbers in a square: touching starts and corners, where two walls tie. */
  static WallQuery lattice(Draw d) {
    double side = d.whole(1, 20);
    Point low = d.node(5);
    Point p = low.plus(new Point(d.whole(-1, 21), d.whole(-1, 21)));
    Point v = d.node(4);
    Point high = low.plus(new Point(side, side));
    double[] n = {
      p.x(), p.y(), d.whole(0, 4), v.x(), v.y(), low.x(), low.y(), high.x(), high.y(), 0
    };
    double scale = d.binaryScale();
    for (int i = 0; i < 9; i++) {
      n[i] *= scale;
    }
    n[9] = d.pick(0.5, 1, 2, 4, 1e9);
    d.nudgeOne(n, 0.3);
    return ordered(n);
  }

  /** Into a corner: both walls ahead are hit at the same time but for the rounding of places. */
  static WallQuery corner(Draw d) {
    double[] n = (d.chance(0.7) ? uniform(d) : lattice(d)).numbers();
    double t = d.in(0.1, 2);
    for (int i : new int[] {0, 1}) {
      double v = n[i + 3];
      n[i + (v < 0 ? 5 : 7)] = n[i] + v * t + Math.copySign(n[2], v);
    }
    n[9] = 100;
    return ordered(n);
  }

  static WallQuery extreme(Draw d) {
    double[] n = uniform(d).numbers();
    switch (d.whole(0, 4)) {
      case 0 -> Extremes.scale(n, d.whole(-1060, 1018));
      case 1 -> Extremes.scaleTime(d, n, 3, 4);
      case 2 -> n[d.whole(0, 8)] = d.sign() * d.log(1e-320, 1e-200);
      case 3 -> Extremes.mix(d, n);
      default -> n = Extremes.denormal(lattice(d).numbers());
    }
    return ordered(n);
  }

  /** A query with a radius that is not negative and walls in order and apart. */
  private static WallQuery ordered(double... n) {
    n[2] = Math.abs(n[2]);
    for (int i : new int[] {5, 6}) {
      Mirror.order(n, i);
      n[i + 2] = n[i + 2] > n[i] ? n[i + 2] : Math.nextUp(n[i]);
    }
    return WallQuery.of(n);
  }
}
