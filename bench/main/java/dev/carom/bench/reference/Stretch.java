// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

/**
 * Some frames of one flight: the state at the first of them, to 77 bits, which gives the others.
 */
final class Stretch {

  /** The first frame. */
  final int start;

  /** x, y, vx, vy there. */
  final double[] heads;

  /** The rests beside the heads; unused where there is but one frame. */
  final float[] tails;

  /** The acceleration, by axis. */
  private final double[] gravity;

  Stretch(int start, double[] heads, float[] tails, double[] gravity) {
    this.start = start;
    this.heads = heads;
    this.tails = tails;
    this.gravity = gravity;
  }

  /** At the first frame of a course that it is to tell of. */
  static Stretch of(CircleFrames course, int frame, double[] gravity) {
    double[] heads = new double[CircleFrames.TAILS];
    float[] tails = new float[CircleFrames.TAILS];
    for (int i = 0; i < CircleFrames.TAILS; i++) {
      heads[i] = course.states[frame][i];
      // + 0 turns -0, what is left of a tie, into 0.
      tails[i] = (float) course.states[frame][CircleFrames.TAILS + i] + 0f;
    }
    return new Stretch(frame, heads, tails, gravity);
  }

  /**
   * The coordinate at a frame, {@code x + j v + j^2 g / 2}, rounded once: 0 for x and 1 for y. The
   * halves of the squares of frame numbers are doubles.
   */
  double place(int axis, int frame) {
    double j = frame - start;
    if (j == 0) {
      return heads[axis];
    }
    double v = heads[axis + 2];
    double g = gravity[axis];
    double way = j * v;
    double rest = Math.fma(j, v, -way) + (tails[axis] + j * tails[axis + 2]);
    double half = j * j / 2;
    double fall = half * g;
    double sum = way + fall;
    rest += sumTail(way, fall, sum) + Math.fma(half, g, -fall);
    return sum(heads[axis], sum, rest);
  }

  /** The component of the velocity at a frame, {@code v + j g}, rounded once: 0 for x, 1 for y. */
  double velocity(int axis, int frame) {
    double j = frame - start;
    double v = heads[axis + 2];
    double g = gravity[axis];
    if (j == 0 || g == 0) {
      return v;
    }
    double gain = j * g;
    return sum(v, gain, Math.fma(j, g, -gain) + tails[axis + 2]);
  }

  /** The sum of two numbers and of one that is small beside them, rounded once. */
  private static double sum(double a, double b, double rest) {
    double sum = a + b;
    return sum + (sumTail(a, b, sum) + rest);
  }

  /** What rounding takes from a sum. */
  private static double sumTail(double a, double b, double sum) {
    double part = sum - a;
    return (a - (sum - part)) + (b - part);
  }

  /** Whether it gives the very state of a course at a frame. */
  boolean tells(CircleFrames course, int frame) {
    double[] state = course.states[frame];
    return state[0] == place(0, frame)
        && state[1] == place(1, frame)
        && state[2] == velocity(0, frame)
        && state[3] == velocity(1, frame);
  }
}
