// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/** Double, as the type of the methods that are also made in float. */
final class RealDouble {

  private RealDouble() {}

  static double real(double number) {
    return number;
  }
}
