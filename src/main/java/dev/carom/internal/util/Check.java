// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

/**
 * Checks of arguments and of input data. Each message names the thing, its value and the
 * expectation. Each condition is written so that NaN fails it.
 */
public final class Check {

  private Check() {}

  /**
   * Throws a {@link NullPointerException} that names the argument if it is null; returns it
   * otherwise.
   */
  public static <T> T notNull(String name, T value) {
    if (value == null) {
      throw isNull(name);
    }
    return value;
  }

  public static NullPointerException isNull(String name) {
    return new NullPointerException(name + " is null");
  }

  public static void finite(String name, double value) {
    if (!(Math.abs(value) <= Double.MAX_VALUE)) {
      throw refused(name, value, "a finite number");
    }
  }

  public static void notNegative(String name, double value) {
    if (!(value >= 0 && value <= Double.MAX_VALUE)) {
      throw refused(name, value, "a finite number, at least 0");
    }
  }

  public static void notNegative(String name, int value) {
    if (value < 0) {
      throw refused(name, value, "at least 0");
    }
  }

  /**
   * Checks a mass. Within these limits, the sum and the quotient of two masses neither overflow nor
   * underflow.
   */
  public static void mass(String name, double value) {
    if (!((value >= 0x1p-500 && value <= 0x1p500) || value == Double.POSITIVE_INFINITY)) {
      throw refused(name, value, "a number from 2^-500 to 2^500, or infinity");
    }
  }

  /** Checks the sides of a rectangle, wider and higher than 0; a side at infinity is open. */
  public static void bounds(double xmin, double ymin, double xmax, double ymax) {
    number("xmin", xmin);
    number("ymin", ymin);
    number("xmax", xmax);
    number("ymax", ymax);
    if (!(xmax > xmin)) {
      throw refused("xmax", xmax, "more than xmin, " + xmin);
    }
    if (!(ymax > ymin)) {
      throw refused("ymax", ymax, "more than ymin, " + ymin);
    }
  }

  private static void number(String name, double value) {
    if (Double.isNaN(value)) {
      throw refused(name, value, "a number, or infinity for an open side");
    }
  }

  /** Checks a length of time: 0 or more, {@code +infinity} included. */
  public static void duration(String name, double value) {
    if (!(value >= 0)) {
      throw refused(name, value, "at least 0 (infinity is allowed)");
    }
  }

  /** The exception for a value that is refused; see {@link Refusal}. */
  public static IllegalArgumentException refused(String name, Object value, String expected) {
    return Refusal.of(name, value, expected);
  }
}
