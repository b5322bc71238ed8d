// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * The properties of a circle that an edit may change within a flight.
 *
 * @param traits its {@link ContactFlags}
 * @param filter its {@link Filter}
 */
record CircleProperties(double mass, double restitution, int traits, long filter) {

  /** The properties of the circle at a slot. */
  static CircleProperties of(CircleRegistry registry, int slot, double restitution) {
    return new CircleProperties(
        registry.mass(slot), restitution, registry.traits(slot), registry.filter(slot));
  }
}
