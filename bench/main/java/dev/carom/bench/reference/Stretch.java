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

  Stretch(int start, double[] heads, float[] tails) {
    this.start = start;
    this.heads = heads;
    this.tails = tails;
  }

  /** At the first frame of a course that it is to tell of. */
  static Stretch of(CircleFrames course, int frame) {
    double[] heads = new double[CircleFrames.TAILS];
    float[] tails = new float[CircleFrames.TAILS];
    for (int i = 0; i < CircleFrames.TAILS; i++) {
      heads[i] = course.states[frame][i];
      // + 0 turns -0, what is left of a tie, into 0.
      tails[i] = (float) course.states[frame][CircleFrames.TAILS + i] + 0f;
    }
    return new Stretch(frame, heads, tails);
  }

  /** The coordinate at a frame, {@code x + j v}, rounded once: 0 for x and 1 for y. */
  double place(int axis, int frame) {
    double j = frame - start;
    if (j == 0) {
      return heads[axis];
    }
    double x = heads[axis];
    double v = heads[axis + 2];
    double way = j * v;
    double rest = Math.fma(j, v, -way) + (tails[axis] + j * tails[axis + 2]);
    double sum = x + way;
    double part = sum - x;
    return sum + (((x - (sum - part)) + (way - part)) + rest);
  }

  /** Whether it gives the very state of a course at a frame. */
  boolean tells(CircleFrames course, int frame) {
    double[] state = course.states[frame];
    return state[0] == place(0, frame)
        && state[1] == place(1, frame)
        && state[2] == heads[2]
        && state[3] == heads[3];
  }
}
