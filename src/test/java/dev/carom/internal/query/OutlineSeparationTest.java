// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Circle;
import dev.carom.Outline;
import dev.carom.Vec2;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Places that are known by elementary geometry, from all sides. */
class OutlineSeparationTest {

  /**
   * Beside a side, around a vertex; where the lines beside two sides cross, the line beside a side
   * and the circle around a vertex, and the circles around two vertices.
   */
  @ParameterizedTest
  @CsvSource({
    "0, 1, 3, 0, 2, -9 0 9 0",
    "12, 0.5, 3, 0, 2.5, -9 0 12 0 12 -9",
    "-10, 0.5, 3, -2, 0, -9 9 -9 -9 9 -9",
    "9, 0, 10, 3, 4, -9 0 6 -4",
    "1, 1, 3, 2, 2, 0 10 0 0 10 0",
    "1, 2, 3, 2, 1, 0 10 0 0 10 0",
    "8, 4, 5, -2.8989794855663562, 1, -20 0 10 0 10 4",
    "0.5, -1, 5, -0.5, 5, -3 0 -3 -20 3 -20 3 0",
    "0.5, -1, 5, -0.5, 5, -3 0 -4 -20 4 -20 3 0",
    "0, 0, 5, 0, 0, -9 5 9 5 9 -5",
  })
  void isTheNearestFreePlace(double x, double y, double r, double dx, double dy, String points) {
    double[] xy = Arrays.stream(points.split(" ")).mapToDouble(Double::parseDouble).toArray();
    for (int position = 0; position < 8; position++) {
      for (boolean isReversed : new boolean[] {false, true}) {
        double[] placed = isReversed ? reversed(xy) : xy.clone();
        for (int i = 0; i < placed.length; i += 2) {
          put(placed, i, moved(position, placed[i], placed[i + 1]));
        }
        Vec2 at = moved(position, x, y);
        Vec2 way = moved(position, dx, dy);
        Circle circle = new Circle(at.x(), at.y(), r);
        Outline outline = Outline.polyline(placed);
        Vec2 out = circle.separation(outline);
        assertIs(out, way.x(), way.y());
        assertThat(new Circle(at.x() + out.x(), at.y() + out.y(), r).overlaps(outline)).isFalse();
      }
    }
  }

  private static void assertIs(Vec2 out, double x, double y) {
    assertThat(out.x()).isCloseTo(x, within(1e-13));
    assertThat(out.y()).isCloseTo(y, within(1e-13));
  }

  /** One of the eight positions that a square has on another one. */
  private static Vec2 moved(int position, double x, double y) {
    double a = (position & 1) == 0 ? x : -x;
    double b = (position & 2) == 0 ? y : -y;
    return (position & 4) == 0 ? new Vec2(a, b) : new Vec2(b, a);
  }

  private static double[] reversed(double... xy) {
    double[] back = new double[xy.length];
    for (int i = 0; i < xy.length; i += 2) {
      put(back, xy.length - 2 - i, new Vec2(xy[i], xy[i + 1]));
    }
    return back;
  }

  private static void put(double[] xy, int i, Vec2 point) {
    xy[i] = point.x();
    xy[i + 1] = point.y();
  }

  /** From the inside of a polygon, a circle goes to the nearest side, and beyond. */
  @Test
  void leadsOutOfAPolygon() {
    Outline box = Outline.rectangle(0, 0, 10, 20);
    assertIs(new Circle(6, 9, 1).separation(box), 5, 0);
    assertIs(new Circle(5, 4, 1).separation(box), 0, -5);
    assertIs(new Circle(5, 21, 2).separation(box), 0, 1);
  }

  /** At any size it goes no further than rounding asks for. */
  @Test
  void roundingAsksForSomeUlps() {
    for (int exponent = -400; exponent <= 490; exponent += 89) {
      double unit = Math.scalb(1.0, exponent);
      Outline corner = Outline.polyline(0, 0.7 * unit, 0.1 * unit, 0, 0.9 * unit, 0.3 * unit);
      Circle circle = new Circle(0.3 * unit, 0.2 * unit, 0.25 * unit);
      Vec2 out = circle.separation(corner);
      Circle nearer =
          new Circle(
              circle.x() + out.x() * (1 - 0x1p-40),
              circle.y() + out.y() * (1 - 0x1p-40),
              circle.radius());
      assertThat(nearer.overlaps(corner)).as("at 2^%s", exponent).isTrue();
    }
  }

  @Test
  void aSizeThatSquaresBeyondTheDoublesIsRefused() {
    Outline corner = Outline.polyline(0, 1, 0, 0, 0x1p499, 0);
    assertThat(new Circle(1, 1, 0x1p499).separation(corner)).isNotEqualTo(Vec2.ZERO);
    assertThatThrownBy(() -> new Circle(1, 1, 0x1p500).separation(corner))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("2^500");
  }
}
