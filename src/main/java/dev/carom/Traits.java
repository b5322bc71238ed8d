// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * What is out of the ordinary about a thing, in the bits of a byte: its response, and whether it is
 * a one-way line. Where nothing of a kind has a trait, the array of them is null.
 */
final class Traits {

  // The responses: the ordinals of Response.
  static final int BOUNCE = 0;
  static final int HALT = 1;
  static final int SENSOR = 2;

  private static final int RESPONSE = 3;
  private static final int ONE_WAY = 4;

  private Traits() {}

  static int with(int traits, int response) {
    return (traits & ~RESPONSE) | response;
  }

  static int withOneWay(int traits, boolean oneWay) {
    return oneWay ? traits | ONE_WAY : traits & ~ONE_WAY;
  }

  static int response(int traits) {
    return traits & RESPONSE;
  }

  static boolean isSensor(int traits) {
    return (traits & RESPONSE) == SENSOR;
  }

  static boolean halts(int traits) {
    return (traits & RESPONSE) == HALT;
  }

  static boolean isOneWay(int traits) {
    return (traits & ONE_WAY) != 0;
  }

  /** The traits of thing i among those of its kind. */
  static int of(byte[] traits, int i) {
    return traits == null ? 0 : traits[i];
  }
}
