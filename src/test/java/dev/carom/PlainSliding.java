// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * A ball of restitution 0 slides in a bowl of straight sides, without friction: along each side its
 * centre has the constant acceleration g sin(slope), and at a joint it keeps the part of its
 * velocity along the next side.
 */
final class PlainSliding {

  private final double[] xs;
  private final double[] ys;
  private final double g;
  private int side;
  private double s;
  private double v;

  /**
   * A path of the centre.
   *
   * @param xs,ys its corners
   * @param g the size of gravity, which points down
   */
  PlainSliding(double[] xs, double[] ys, double g) {
    this.xs = xs;
    this.ys = ys;
    this.g = g;
  }

  /** How far the ball has come. */
  double path;

  /** Puts the ball on a side, at a part of its length, at rest. */
  void start(int at, double part) {
    side = at;
    s = part * length(at);
  }

  /** Moves the ball on by a time. */
  void advance(double time) {
    double left = time;
    while (left > 0) {
      double acceleration = -g * (ys[side + 1] - ys[side]) / length(side);
      double ahead = firstRoot(acceleration / 2, v, s - length(side));
      double behind = firstRoot(-acceleration / 2, -v, -s);
      double t = Math.min(left, Math.min(ahead, behind));
      double to = s + t * (v + acceleration * t / 2);
      path += Math.abs(to - s);
      s = to;
      v += acceleration * t;
      left -= t;
      if (left > 0) {
        turn(ahead < behind ? 1 : -1);
      }
    }
  }

  /** Passes a joint, forwards or backwards. */
  private void turn(int way) {
    int next = side + way;
    double x = (xs[side + 1] - xs[side]) * (xs[next + 1] - xs[next]);
    double y = (ys[side + 1] - ys[side]) * (ys[next + 1] - ys[next]);
    v *= (x + y) / (length(side) * length(next));
    side = next;
    s = way > 0 ? 0 : length(side);
  }

  double x() {
    return xs[side] + s / length(side) * (xs[side + 1] - xs[side]);
  }

  double y() {
    return ys[side] + s / length(side) * (ys[side + 1] - ys[side]);
  }

  private double length(int side) {
    return Math.hypot(xs[side + 1] - xs[side], ys[side + 1] - ys[side]);
  }

  /** The first time after 0 at which a t^2 + b t + c, at most 0 at 0, becomes more than 0. */
  private static double firstRoot(double a, double b, double c) {
    double d = b * b - 4 * a * c;
    if (d < 0 || (a <= 0 && b <= 0)) {
      return Double.POSITIVE_INFINITY;
    }
    double q = b + Math.sqrt(d);
    double t = b > 0 ? -2 * c / q : (Math.sqrt(d) - b) / (2 * a);
    return Math.max(0, t);
  }
}
