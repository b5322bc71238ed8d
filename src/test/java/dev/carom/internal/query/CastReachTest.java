// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.MovingCircle;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** When the boxes around two circles of radius 1 first touch, by the formulas of one axis. */
class CastReachTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** More than are tested one by one. */
  private static final int COUNT = 20;

  /**
   * A cast with a velocity and an acceleration, and a circle with its place from there, its
   * velocity and its acceleration. Ahead: towards each other; falling together; after it turned
   * back; before, and without, turning back; from rest, straight on and not at all. Above: with no
   * motion aside; while still below it, and no more; falling away aside, and back. Now; and where
   * squares under- and overflow.
   */
  @ParameterizedTest
  @CsvSource({
    "3 0 0 0, 10 0 -1 0 0 0, 2",
    "5 0 1 0, 10 0 5 0 0 0, 4",
    "-3 0 1 0, 10 0 0 0 -1 0, 4.701562118716424",
    "6 0 0 0, 10 0 0 0 2 0, 2",
    "5 0 0 0, 10 0 0 0 2 0, Infinity",
    "0 0 0 0, 10 0 0 0 2 0, Infinity",
    "-9 0 0 0, 10 0 0 0 2 0, Infinity",
    "-1 0 0 0, 10 0 0 0 0 0, Infinity",
    "0 0 0 0, 10 0 0 0 0 0, Infinity",
    "0 4 0 0, 0 10 0 0 0 0, 2",
    "0.5 4 0 0, 0 10 0 0 0 0, 2",
    "0 4 0 0, 0 10 2 0 0 0, Infinity",
    "0.5 4 1 0, 0 10 0 0 0 0, Infinity",
    "0.5 8 0 0, 0 10 0 0 -1 0, 1",
    "0.5 4 -1 0, 0 10 0 0 0 0, 2",
    "0 0 0 0, 1 1 9 9 -1 2, 0",
    "0 0 1e-300 0, 10 0 0 0 0 0, 0",
    "1e200 0 1 0, 10 0 0 0 0 0, 0",
  })
  void isTheTimeOfTheBoxes(String cast, String circle, double expected) {
    double[] own = numbers(cast);
    double[] its = numbers(circle);
    for (int position = 0; position < 16; position++) {
      double[] o = moved(position, own);
      double[] c = moved(position, its);
      double part = position < 8 ? 0 : 1; // the origin is at the cast, or at the circle
      MovingCircle m = new MovingCircle();
      m.start(0, c[0] - part * c[0], c[1] - part * c[1], 1, c[2], c[3], 1);
      m.fall(c[4], c[5]);
      CircleIndex index = index(m);
      m.start(0, -part * c[0], -part * c[1], 1, o[0], o[1], 1);
      m.fall(o[2], o[3]);
      CastReach reach = new CastReach();
      reach.start(m, index);
      assertIs(reach.entry(index.circle(COUNT - 1)), expected);
      for (int node = 0; node < index.velocities().length / 4; node++) {
        assertIs(reach.entry(node), expected);
      }
    }
  }

  /** Never later than that, and earlier by no more than the rounding that is allowed for. */
  private static void assertIs(double entry, double expected) {
    if (expected == 0 || expected == NEVER) {
      assertThat(entry).isEqualTo(expected);
    } else {
      assertThat(entry).isLessThan(expected).isCloseTo(expected, within(1e-9));
    }
  }

  /** An index of many circles that are all the same. */
  private static CircleIndex index(MovingCircle m) {
    CircleTable circles = new CircleTable(COUNT);
    circles.allowGravity();
    for (int i = 0; i < COUNT; i++) {
      circles.put(i, m);
    }
    CircleRegistry registry = new CircleRegistry(IntStream.range(0, COUNT).toArray(), COUNT);
    CircleIndex index = new CircleIndex(circles, registry, true);
    index.expect(COUNT, 0);
    return index;
  }

  private static double[] numbers(String text) {
    return Arrays.stream(text.trim().split(" ")).mapToDouble(Double::parseDouble).toArray();
  }

  /** Vectors in one of the eight positions that a square has on another one. */
  private static double[] moved(int position, double[] xy) {
    double[] moved = new double[xy.length];
    for (int i = 0; i < xy.length; i += 2) {
      double a = (position & 1) == 0 ? xy[i] : -xy[i];
      double b = (position & 2) == 0 ? xy[i + 1] : -xy[i + 1];
      moved[i] = (position & 4) == 0 ? a : b;
      moved[i + 1] = (position & 4) == 0 ? b : a;
    }
    return moved;
  }
}
