// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.function.ToIntFunction;

/** The double nearest to an exact number that is not negative. */
final class Nearest {

  private Nearest() {}

  /**
   * Rounds correctly: of two doubles that are equally near, to the even one.
   *
   * @param guess a double near the number
   * @param compareTo the sign of the number less another one
   * @return the double; infinite beyond range
   */
  static double of(double guess, ToIntFunction<Dyadic> compareTo) {
    double nearest = Math.min(guess, Double.MAX_VALUE);
    while (nearest < Double.POSITIVE_INFINITY && roundsAbove(nearest, compareTo)) {
      nearest = Math.nextUp(nearest);
    }
    while (nearest > 0 && !roundsAbove(Math.nextDown(nearest), compareTo)) {
      nearest = Math.nextDown(nearest);
    }
    return nearest;
  }

  /** Whether the number rounds to a double above the given finite one. */
  private static boolean roundsAbove(double below, ToIntFunction<Dyadic> compareTo) {
    Dyadic above =
        below == Double.MAX_VALUE ? Dyadic.powerOfTwo(1024) : Dyadic.of(Math.nextUp(below));
    int side = compareTo.applyAsInt(Dyadic.of(below).plus(above).shift(-1));
    boolean belowIsEven = (Double.doubleToRawLongBits(below) & 1) == 0;
    return side > 0 || (side == 0 && !belowIsEven);
  }
}
