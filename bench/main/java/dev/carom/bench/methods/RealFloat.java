// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/** Float, as the type of the methods that are also made in float. */
final class RealFloat {

  private RealFloat() {}

  static float real(double number) {
    return (float) number;
  }
}
