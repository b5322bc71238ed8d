// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * What is out of the ordinary about a thing, in the bits of a byte: its {@link Response}, and
 * whether it is a one-way line. Where nothing of a kind has a trait, the array of them is null.
 */
final class Traits {

  private static final int RESPONSE = 3;
  private static final int ONE_WAY = 4;

  private Traits() {}

  static int with(int traits, Response response) {
    return (traits & ~RESPONSE) | response.ordinal();
  }

  static int withOneWay(int traits, boolean oneWay) {
    return oneWay ? traits | ONE_WAY : traits & ~ONE_WAY;
  }

  static Response response(int traits) {
    return Response.of(traits & RESPONSE);
  }

  static boolean isSensor(int traits) {
    return (traits & RESPONSE) == Response.SENSOR.ordinal();
  }

  static boolean halts(int traits) {
    return (traits & RESPONSE) == Response.HALT.ordinal();
  }

  static boolean isOneWay(int traits) {
    return (traits & ONE_WAY) != 0;
  }

  /** The traits of thing i among those of its kind. */
  static int of(byte[] traits, int i) {
    return traits == null ? 0 : traits[i];
  }
}
