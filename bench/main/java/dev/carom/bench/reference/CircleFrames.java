// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

/**
 * The course of one circle: its state at the end of each frame, correctly rounded, and the rest
 * that rounding cut off.
 */
final class CircleFrames {

  /** x, y, vx, vy; then the tails of these. */
  static final int TAILS = 4;

  /** The states: eight numbers a frame. */
  final double[][] states;

  /** The base-10 logarithm of the conditioning, by frame. */
  final double[] conditioning;

  /** Which of the circle's flights, counted from 0, it is in at the end of a frame. */
  final int[] flights;

  private int next;
  private int flight;

  CircleFrames(int frames) {
    states = new double[frames + 1][];
    conditioning = new double[frames + 1];
    flights = new int[frames + 1];
  }

  /** The number of the last frame. */
  int frames() {
    return states.length - 1;
  }

  /** Writes down the frames of a flight that ends at the given time, which belongs to the next. */
  void recordFlight(Body body, Ball end) {
    while (next < states.length && isBefore(next, end, body.bits)) {
      recordFrame(body);
    }
    flight++;
  }

  /** Writes down the frames of the last flight. */
  void recordRest(Body body) {
    while (next < states.length) {
      recordFrame(body);
    }
  }

  private static boolean isBefore(double frame, Ball end, int bits) {
    return frame + 0.5 < end.head() || Ball.of(frame, bits).compareTo(end) < 0;
  }

  private void recordFrame(Body body) {
    Ball dt = Ball.of(next, body.bits).minus(body.t);
    Vec place = body.at(dt);
    Vec velocity = body.velocityAt(dt);
    Ball[] state = {place.x(), place.y(), velocity.x(), velocity.y()};
    double[] numbers = new double[2 * TAILS];
    for (int i = 0; i < TAILS; i++) {
      numbers[i] = state[i].rounded();
      numbers[TAILS + i] = state[i].tail();
    }
    states[next] = numbers;
    conditioning[next] = body.tangents.log10(dt.head());
    flights[next] = flight;
    next++;
  }

  /** The greatest difference of a place from that of another run, at any frame. */
  double distance(CircleFrames that) {
    double most = 0;
    for (int frame = 0; frame < states.length; frame++) {
      for (int i = 0; i < 2; i++) {
        double head = states[frame][i] - that.states[frame][i];
        double tail = states[frame][TAILS + i] - that.states[frame][TAILS + i];
        most = Math.max(most, Math.abs(head + tail));
      }
    }
    return most;
  }
}
