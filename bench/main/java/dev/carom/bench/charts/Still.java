// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.World;
import java.awt.Color;
import java.util.BitSet;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;

/** The circles of a scene at one moment, kept: where they are, how they move, which ones glow. */
public final class Still {

  /** Doubles of one circle: x, y, radius, vx, vy. */
  private static final int CIRCLE = 5;

  private final double[] numbers;
  private final BitSet glowing = new BitSet();
  private final Color[] colors;

  private Still(int circles) {
    numbers = new double[CIRCLE * circles];
    colors = new Color[circles];
  }

  /** The circles of a scene at time 0. */
  public static Still of(Scene scene) {
    Still still = new Still(scene.count(Kind.CIRCLE));
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      double radius = ((Circle) scene.shape(Kind.CIRCLE, i)).radius();
      double vx = scene.velocity(Kind.CIRCLE, i).x();
      double vy = scene.velocity(Kind.CIRCLE, i).y();
      still.set(
          i,
          ((Circle) scene.shape(Kind.CIRCLE, i)).x(),
          ((Circle) scene.shape(Kind.CIRCLE, i)).y(),
          radius,
          vx,
          vy);
    }
    return still;
  }

  /**
   * A world as it stands.
   *
   * @param world the world; it may move on
   * @return its circles, without glow
   */
  public static Still of(World world) {
    Still still = new Still(world.count(Kind.CIRCLE));
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      still.set(i, world.x(i), world.y(i), world.radius(i), world.vx(i), world.vy(i));
    }
    return still;
  }

  /**
   * The same circles, some of which glow.
   *
   * @param glows whether the circle of that number does
   * @return its circles; their colours stay
   */
  public Still glowing(IntPredicate glows) {
    Still still = copy();
    for (int i = 0; i < count(); i++) {
      still.glowing.set(i, glows.test(i));
    }
    return still;
  }

  /**
   * The same circles in colours.
   *
   * @param color of the circle of that number; null for the usual one
   * @return its circles; those that glow still do
   */
  public Still colored(IntFunction<Color> color) {
    Still still = copy();
    for (int i = 0; i < count(); i++) {
      still.colors[i] = color.apply(i);
    }
    return still;
  }

  private Still copy() {
    Still still = new Still(count());
    System.arraycopy(numbers, 0, still.numbers, 0, numbers.length);
    System.arraycopy(colors, 0, still.colors, 0, colors.length);
    still.glowing.or(glowing);
    return still;
  }

  private void set(int i, double x, double y, double radius, double vx, double vy) {
    int k = CIRCLE * i;
    numbers[k] = x;
    numbers[k + 1] = y;
    numbers[k + 2] = radius;
    numbers[k + 3] = vx;
    numbers[k + 4] = vy;
  }

  /** The number of circles: at least 0. */
  public int count() {
    return numbers.length / CIRCLE;
  }

  double x(int i) {
    return numbers[CIRCLE * i];
  }

  double y(int i) {
    return numbers[CIRCLE * i + 1];
  }

  double radius(int i) {
    return numbers[CIRCLE * i + 2];
  }

  double vx(int i) {
    return numbers[CIRCLE * i + 3];
  }

  double vy(int i) {
    return numbers[CIRCLE * i + 4];
  }

  /** Null for the usual one. */
  Color color(int i) {
    return colors[i];
  }

  boolean glows(int i) {
    return glowing.get(i);
  }
}
